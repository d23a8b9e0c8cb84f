#include "ui/main_window/recent_files.h"

#include "ui/main_window/theme.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace prizma {
namespace {

constexpr int maximumFiles = 10;
const QString key = QStringLiteral("recentFiles");

} // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {}

QStringList RecentFiles::files() const {
    return QSettings().value(key).toStringList();
}

void RecentFiles::add(const QString& file) {
    QStringList list = files();
    const QString absolute = QFileInfo(file).absoluteFilePath();
    list.removeAll(absolute);
    list.prepend(absolute);
    QSettings().setValue(key, QStringList(list.mid(0, maximumFiles)));
}

void RecentFiles::remove(const QString& file) {
    QStringList list = files();
    list.removeAll(QFileInfo(file).absoluteFilePath());
    QSettings().setValue(key, list);
}

void RecentFiles::clear() {
    QSettings().remove(key);
}

void RecentFiles::attach(QMenu& menu) {
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { fill(menu); });
    fill(menu); // so that it is known to be empty or not
}

void RecentFiles::fill(QMenu& menu) {
    menu.clear();
    const QStringList list = files();
    int number = 0;
    for (const QString& file : list) {
        QString name = QFileInfo(file).fileName();
        name.replace(QLatin1Char('&'), QLatin1String("&&"));
        const QString mnemonic = ++number <= 9 ? QStringLiteral("&%1  ").arg(number) : QStringLiteral("    ");
        QAction* action = menu.addAction(mnemonic + name, this, [this, file] { Q_EMIT chosen(file); });
        action->setToolTip(QDir::toNativeSeparators(file));
        action->setStatusTip(QDir::toNativeSeparators(file));
        action->setEnabled(QFileInfo::exists(file));
    }
    if (list.isEmpty()) {
        menu.addAction(tr("No Recent Files"))->setEnabled(false);
        return;
    }
    menu.setToolTipsVisible(true);
    menu.addSeparator();
    menu.addAction(icon(QStringLiteral("edit-clear")), tr("Clear List"), this, &RecentFiles::clear);
}

} // namespace prizma
