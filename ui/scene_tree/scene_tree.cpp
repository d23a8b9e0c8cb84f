#include "ui/scene_tree/scene_tree.h"

#include "ui/document/document.h"
#include "ui/main_window/theme.h"
#include "ui/scene_tree/badge_delegate.h"
#include "ui/scene_tree/scene_model.h"

#include <QAction>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace prizma {
namespace {

/// Leaves groups in place while no filter is set, and shows matches with their groups while one is.
class TreeFilter : public QSortFilterProxyModel {
  public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

  protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        if (filterRegularExpression().pattern().isEmpty())
            return true;
        const auto& model = static_cast<const SceneModel&>(*sourceModel());
        const bool isGroup = !model.entityAt(model.index(row, 0, parent)).has_value();
        return !isGroup && QSortFilterProxyModel::filterAcceptsRow(row, parent);
    }
};

} // namespace

SceneTree::SceneTree(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new SceneModel(document, this)),
      filtered_(new TreeFilter(this)),
      view_(new QTreeView),
      filter_(new QLineEdit) {
    filtered_->setSourceModel(model_);
    filtered_->setRecursiveFilteringEnabled(true);
    filtered_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    filter_->setObjectName(QStringLiteral("treeFilter"));
    filter_->setPlaceholderText(tr("Filter"));
    filter_->setClearButtonEnabled(true);
    filter_->setAcceptDrops(false);
    filter_->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);

    view_->setObjectName(QStringLiteral("sceneTree"));
    view_->setModel(filtered_);
    view_->setHeaderHidden(true);
    view_->setUniformRowHeights(true);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    view_->setContextMenuPolicy(Qt::CustomContextMenu);
    view_->setItemDelegateForColumn(SceneModel::BadgeColumn, new BadgeDelegate(view_));
    view_->setIndentation(14);
    view_->header()->setStretchLastSection(false);
    view_->header()->setMinimumSectionSize(24);
    view_->header()->setSectionResizeMode(SceneModel::NameColumn, QHeaderView::Stretch);
    view_->header()->setSectionResizeMode(SceneModel::BadgeColumn, QHeaderView::ResizeToContents);
    view_->header()->setSectionResizeMode(SceneModel::SwitchColumn, QHeaderView::Fixed);
    view_->header()->resizeSection(SceneModel::SwitchColumn, 28);
    view_->expandAll();
    spanGroups();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto* top = new QVBoxLayout;
    top->setContentsMargins(6, 6, 6, 6);
    top->addWidget(filter_);
    layout->addLayout(top);
    layout->addWidget(view_);

    connect(filter_, &QLineEdit::textChanged, this, &SceneTree::setFilter);
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SceneTree::takeSelection);
    connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, &SceneTree::takeSelection);
    connect(view_, &QTreeView::clicked, this, &SceneTree::clicked);
    connect(view_, &QWidget::customContextMenuRequested, this, &SceneTree::showMenu);
    connect(model_, &SceneModel::refused, this, &SceneTree::refused);
    connect(&document_, &Document::selectionChanged, this, &SceneTree::showSelection);
    // Rows come and go before the document tells of the selection: neither must be taken for a click.
    connect(model_, &QAbstractItemModel::rowsAboutToBeRemoved, this, [this] { syncing_ = true; });
    connect(model_, &QAbstractItemModel::rowsAboutToBeInserted, this, [this] { syncing_ = true; });
    connect(&document_, &Document::sceneChanged, this, [this](const SceneDiff& changes) {
        if (changes.isTimeOnly())
            return; // the tree shows no time
        syncing_ = false;
        showSelection();
    });
}

QModelIndex SceneTree::indexOf(EntityRef entity) const {
    return filtered_->mapFromSource(model_->indexOf(entity));
}

void SceneTree::setFilter(const QString& text) {
    syncing_ = true; // what the filter hides stays selected
    filtered_->setFilterFixedString(text);
    view_->expandAll();
    spanGroups();
    syncing_ = false;
    showSelection();
}

void SceneTree::spanGroups() {
    // Their names have no badge beside them to make room for.
    for (int row = 0; row < filtered_->rowCount(); ++row)
        view_->setFirstColumnSpanned(row, {}, true);
}

void SceneTree::takeSelection() {
    if (syncing_)
        return;
    std::vector<EntityRef> selection;
    for (const QModelIndex& index : view_->selectionModel()->selectedRows())
        if (const auto entity = model_->entityAt(filtered_->mapToSource(index)))
            selection.push_back(*entity);
    // The current thing goes last: panels show its values.
    const auto current = model_->entityAt(filtered_->mapToSource(view_->currentIndex()));
    if (const auto found =
            current ? std::find(selection.begin(), selection.end(), *current) : selection.end();
        found != selection.end())
        std::rotate(found, found + 1, selection.end());
    syncing_ = true;
    document_.setSelection(selection);
    syncing_ = false;
}

void SceneTree::showSelection() {
    if (syncing_)
        return;
    syncing_ = true;
    QItemSelection rows;
    QModelIndex current;
    for (const EntityRef& entity : document_.selection()) {
        const QModelIndex index = indexOf(entity);
        if (!index.isValid())
            continue;
        rows.select(index, index);
        current = index;
    }
    auto* selection = view_->selectionModel();
    selection->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    if (current.isValid() && current != view_->currentIndex().siblingAtColumn(0)) {
        selection->setCurrentIndex(current, QItemSelectionModel::NoUpdate);
        view_->scrollTo(current);
    }
    syncing_ = false;
}

void SceneTree::renameCurrent() {
    if (document_.selection().empty())
        return;
    const QModelIndex index = indexOf(document_.selection().back());
    if (index.flags().testFlag(Qt::ItemIsEditable)) {
        view_->setFocus();
        view_->setCurrentIndex(index);
        view_->edit(index);
    }
}

void SceneTree::clicked(const QModelIndex& index) {
    if (index.column() == SceneModel::SwitchColumn)
        model_->toggle(filtered_->mapToSource(index));
}

void SceneTree::showMenu(const QPoint& position) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    auto* rename =
        menu->addAction(icon(QStringLiteral("edit-rename")), tr("Rename"), this, &SceneTree::renameCurrent);
    rename->setShortcut(Qt::Key_F2);
    rename->setEnabled(!document_.selection().empty() &&
                       indexOf(document_.selection().back()).flags().testFlag(Qt::ItemIsEditable));
    for (QAction* action : menuActions_)
        menu->addAction(action);
    menu->popup(view_->viewport()->mapToGlobal(position));
}

} // namespace prizma
