#pragma once

#include <QObject>

#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace prizma {

class Document;

/// The Edit and Add menus.
class EditActions : public QObject {
    Q_OBJECT

  public:
    EditActions(Document& document, QWidget& window);

    void fillEditMenu(QMenu& menu);
    void fillAddMenu(QMenu& menu);

    /// Duplicate and Delete, for right-click menus.
    std::vector<QAction*> selectionActions() const { return {duplicate_, delete_}; }

  private:
    void updateEnabled();

    Document& document_;
    QWidget& window_;
    QAction* delete_;
    QAction* duplicate_;
};

} // namespace prizma
