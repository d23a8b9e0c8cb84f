#pragma once

#include "core/scene/properties.h"
#include "ui/document/document.h"
#include "ui/document/strings.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/theme.h"
#include "ui/properties/number_field.h"

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include <memory>

namespace prizma::test {

/// Keeps the settings of the person who runs the tests out of them, and the tests' out of theirs.
class Isolation {
  public:
    Isolation() {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("PrizmaTests"));
        QCoreApplication::setApplicationName(QStringLiteral("prizma-tests"));
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
        applyTheme(*qApp);
    }

    QString path(const QString& name) const { return folder_.filePath(name); }

    /// Writes a file for a test and gives its path.
    QString write(const QString& name, const QByteArray& content) const {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(file.fileName()));
        return file.fileName();
    }

  private:
    QTemporaryDir folder_;
};

inline std::unique_ptr<MainWindow> showWindow() {
    auto window = std::make_unique<MainWindow>();
    window->show();
    if (!QTest::qWaitForWindowExposed(window.get()))
        qFatal("the window does not appear");
    return window;
}

/// The action "Add/Light/Point" of the menu bar; null if there is none. Mnemonics do not count.
inline QAction* findAction(const QMenuBar& bar, const QString& path) {
    QList<QAction*> actions = bar.actions();
    QAction* found = nullptr;
    for (const QString& part : path.split(QLatin1Char('/'))) {
        found = nullptr;
        for (QAction* action : actions) {
            QString text = action->text();
            text.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
            // "Undo Add light" is found as "Undo".
            if (text == part || text.startsWith(part + QLatin1Char(' ')))
                found = found && found->text().size() < action->text().size() ? found : action;
        }
        if (!found)
            return nullptr;
        actions = found->menu() ? found->menu()->actions() : QList<QAction*>();
    }
    return found;
}

inline void trigger(MainWindow& window, const QString& path) {
    QAction* action = findAction(*window.menuBar(), path);
    QVERIFY2(action, qPrintable(path));
    QVERIFY2(action->isEnabled(), qPrintable(path));
    action->trigger();
}

/// The field called `name` among the widgets that can be seen.
inline NumberField* visibleField(QWidget& root, const QString& name) {
    for (NumberField* field : root.findChildren<NumberField*>(name))
        if (field->isVisible())
            return field;
    return nullptr;
}

/// Clicks into a field, types, and presses Return.
inline void typeInto(NumberField& field, const QString& text) {
    auto* line = field.findChild<QLineEdit*>();
    QTest::mouseClick(line, Qt::LeftButton);
    QTRY_VERIFY(field.hasFocus());
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

/// Drags from the middle of a widget by `pixels` to the right, in steps, as a hand does.
inline void dragHorizontally(QWidget& widget, int pixels) {
    const QPoint start = widget.rect().center();
    QTest::mousePress(&widget, Qt::LeftButton, Qt::NoModifier, start);
    constexpr int steps = 10;
    for (int i = 1; i <= steps; ++i) {
        QMouseEvent move(QEvent::MouseMove, start + QPoint(pixels * i / steps, 0),
                         widget.mapToGlobal(start + QPoint(pixels * i / steps, 0)), Qt::LeftButton,
                         Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&widget, &move);
    }
    QTest::mouseRelease(&widget, Qt::LeftButton, Qt::NoModifier, start + QPoint(pixels, 0));
}

inline void drag(NumberField& field, int pixels) {
    dragHorizontally(*field.findChild<QLineEdit*>(), pixels);
}

} // namespace prizma::test
