#include "ui/main_window/theme.h"

#include <QApplication>
#include <QFile>
#include <QPalette>
#include <QStyleFactory>

// A static library's resources have to be asked for, from outside of any namespace.
static void initResources() {
    Q_INIT_RESOURCE(prizma);
}

namespace prizma {
namespace {

QPalette darkPalette() {
    const QColor window(0x2b, 0x2d, 0x30);
    const QColor base(0x1f, 0x20, 0x23);
    const QColor button(0x38, 0x3b, 0x3f);
    const QColor text(0xdf, 0xe1, 0xe5);
    const QColor disabled(0x7c, 0x80, 0x86);

    QPalette palette(button, window);
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, QColor(0x24, 0x26, 0x29));
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::PlaceholderText, disabled);
    palette.setColor(QPalette::Button, button);
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::ToolTipBase, QColor(0x3a, 0x3d, 0x42));
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::Highlight, QColor(0x35, 0x6f, 0xb8));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(0x6a, 0xae, 0xf2));
    palette.setColor(QPalette::LinkVisited, QColor(0xa0, 0x8c, 0xe0));
    palette.setColor(QPalette::Light, QColor(0x4a, 0x4d, 0x52));
    palette.setColor(QPalette::Midlight, QColor(0x40, 0x43, 0x47));
    palette.setColor(QPalette::Mid, QColor(0x26, 0x28, 0x2b));
    palette.setColor(QPalette::Dark, QColor(0x1a, 0x1b, 0x1d));
    palette.setColor(QPalette::Shadow, QColor(0x10, 0x11, 0x12));
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        palette.setColor(QPalette::Disabled, role, disabled);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(0x45, 0x48, 0x4d));
    palette.setColor(QPalette::Disabled, QPalette::Base, window);
    return palette;
}

constexpr auto styleSheet = R"(
QToolTip { color: #dfe1e5; background: #3a3d42; border: 1px solid #55595f; padding: 4px; }
QMainWindow::separator { background: #1a1b1d; width: 4px; height: 4px; }
QMainWindow::separator:hover { background: #356fb8; }
QDockWidget { titlebar-close-icon: url(:/icons/close.svg); titlebar-normal-icon: url(:/icons/float.svg); }
QDockWidget::title { background: #323539; padding: 6px 8px; }
QStatusBar::item { border: none; }
)";

} // namespace

void applyTheme(QApplication& application) {
    initResources();
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    application.setPalette(darkPalette());
    application.setStyleSheet(QString::fromLatin1(styleSheet));
    const QString systemIcons = QStringLiteral("/usr/share/icons");
    if (QStringList paths = QIcon::themeSearchPaths(); !paths.contains(systemIcons))
        QIcon::setThemeSearchPaths(paths << systemIcons);
    QIcon::setFallbackSearchPaths(QIcon::fallbackSearchPaths() << systemIcons);
    QIcon::setThemeName(QStringLiteral("breeze-dark"));
    QIcon::setFallbackThemeName(QStringLiteral("breeze"));
    application.setWindowIcon(icon(QStringLiteral("prizma")));
}

QIcon icon(const QString& name) {
    initResources();
    const QString own = QStringLiteral(":/icons/%1.svg").arg(name);
    return QFile::exists(own) ? QIcon(own) : QIcon::fromTheme(name);
}

namespace theme {

QColor accent() {
    return {0x6a, 0xae, 0xf2};
}
QColor error() {
    return {0xf0, 0x6a, 0x64};
}
QColor axis(int index) {
    return index == 0   ? QColor(0xe8, 0x6a, 0x6a)
           : index == 1 ? QColor(0x8c, 0xc8, 0x5a)
                        : QColor(0x6a, 0xa4, 0xf0);
}
QColor dim() {
    return {0x9a, 0x9e, 0xa5};
}
QColor badge() {
    return {0x7a, 0x56, 0x1e};
}

} // namespace theme

} // namespace prizma
