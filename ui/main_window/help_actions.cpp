#include "ui/main_window/help_actions.h"

#include "ui/main_window/shortcut_sheet.h"
#include "ui/main_window/theme.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>

namespace prizma {

HelpActions::HelpActions(QMainWindow& window) : QObject(&window), window_(window) {}

void HelpActions::fillMenu(QMenu& menu) {
    menu.addAction(icon(QStringLiteral("help-contents")), tr("&Keyboard Shortcuts"), this,
                   &HelpActions::showShortcuts)
        ->setShortcut(Qt::Key_F1);
    menu.addSeparator();
    menu.addAction(icon(QStringLiteral("prizma")), tr("&About Prizma"), this, &HelpActions::showAbout)
        ->setMenuRole(QAction::AboutRole);
    menu.addAction(icon(QStringLiteral("help-about")), tr("About &Qt"), qApp, &QApplication::aboutQt)
        ->setMenuRole(QAction::AboutQtRole);
}

void HelpActions::showShortcuts() {
    auto* sheet = new ShortcutSheet(*window_.menuBar(), &window_);
    sheet->show();
}

void HelpActions::showAbout() {
    auto* box = new QMessageBox(&window_);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("About Prizma"));
    box->setIconPixmap(icon(QStringLiteral("prizma")).pixmap(64, 64));
    box->setText(QStringLiteral("<h3>Prizma %1</h3>").arg(QApplication::applicationVersion()));
    box->setInformativeText(
        tr("A scene editor whose view is ray traced live, on any OpenCL device.<br><br>"
           "It grew out of Zoltán Erdős’ thesis “Valós idejű sugárkövetés” (real-time ray tracing, 2019)."));
    box->open();
}

} // namespace prizma
