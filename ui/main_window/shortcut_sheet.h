#pragma once

#include <QDialog>

class QMenuBar;

namespace prizma {

/// The cheat sheet: every command of the menus with its keys, and what the mouse does in the view. It can be
/// searched.
class ShortcutSheet : public QDialog {
    Q_OBJECT

  public:
    explicit ShortcutSheet(QMenuBar& menus, QWidget* parent = nullptr);
};

} // namespace prizma
