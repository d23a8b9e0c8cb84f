#pragma once

#include "core/scene/properties.h"

#include <QWidget>

#include <vector>

class QAction;
class QLineEdit;
class QModelIndex;
class QSortFilterProxyModel;
class QTreeView;

namespace prizma {

class Document;
class SceneModel;

/// The list of everything in the scene: select, rename, show and hide, filter.
class SceneTree : public QWidget {
    Q_OBJECT

  public:
    explicit SceneTree(Document& document, QWidget* parent = nullptr);

    /// Commands of the right-click menu beside Rename.
    void setMenuActions(const std::vector<QAction*>& actions) { menuActions_ = actions; }

    void renameCurrent();

    QTreeView& view() { return *view_; }

    /// Where `entity` is in `view()`; invalid if the filter hides it.
    QModelIndex indexOf(EntityRef entity) const;

  Q_SIGNALS:
    void refused(const QString& reason);

  private:
    void setFilter(const QString& text);
    void spanGroups();
    void takeSelection(); ///< From the view to the document.
    void showSelection(); ///< From the document to the view.
    void showMenu(const QPoint& position);
    void clicked(const QModelIndex& index);

    Document& document_;
    SceneModel* model_;
    QSortFilterProxyModel* filtered_;
    QTreeView* view_;
    QLineEdit* filter_;
    std::vector<QAction*> menuActions_;
    bool syncing_ = false;
};

} // namespace prizma
