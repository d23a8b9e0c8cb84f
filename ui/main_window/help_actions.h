#pragma once

#include <QObject>

class QMainWindow;
class QMenu;

namespace prizma {

/// The Help menu.
class HelpActions : public QObject {
    Q_OBJECT

  public:
    explicit HelpActions(QMainWindow& window);

    void fillMenu(QMenu& menu);

  private:
    void showShortcuts();
    void showAbout();

    QMainWindow& window_;
};

} // namespace prizma
