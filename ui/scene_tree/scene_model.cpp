#include "ui/scene_tree/scene_model.h"

#include "ui/document/document.h"
#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/scene_tree/entity_icon.h"

#include <algorithm>

namespace prizma {
namespace {

/// The internal id of a top-level index; a child's is the number of its group.
constexpr quintptr topLevel = ~quintptr(0);

QString groupName(EntityKind kind) {
    switch (kind) {
    case EntityKind::Object:
        return SceneModel::tr("Objects");
    case EntityKind::Light:
        return SceneModel::tr("Lights");
    default:
        return SceneModel::tr("Materials");
    }
}

} // namespace

SceneModel::SceneModel(Document& document, QObject* parent)
    : QAbstractItemModel(parent), document_(document), shown_(document.scene()) {
    for (const EntityKind kind : {EntityKind::Object, EntityKind::Light, EntityKind::Material})
        groups_.push_back({std::nullopt, kind, rowsOf(shown_, kind)});
    for (const EntityKind kind :
         {EntityKind::Camera, EntityKind::Background, EntityKind::Render, EntityKind::Timeline})
        groups_.push_back({EntityRef{kind}, kind, {}});
    connect(&document_, &Document::sceneChanged, this, &SceneModel::refresh);
}

std::vector<SceneModel::Row> SceneModel::rowsOf(const Scene& scene, EntityKind kind) {
    std::vector<Row> rows;
    if (kind == EntityKind::Object)
        for (const Object& object : scene.objects)
            rows.push_back({{kind, object.id}, object.name, object.visible, object.dynamic, {}});
    else if (kind == EntityKind::Light)
        for (const Light& light : scene.lights)
            rows.push_back({{kind, light.id}, light.name, light.enabled, false, light.type});
    else if (kind == EntityKind::Material)
        for (const Material& material : scene.materials)
            rows.push_back({{kind, material.id}, material.name, true, false, {}});
    return rows;
}

void SceneModel::refresh() {
    const Scene scene = document_.scene();
    if (!scene.objects.shares(shown_.objects))
        refreshGroup(0, rowsOf(scene, EntityKind::Object));
    if (!scene.lights.shares(shown_.lights))
        refreshGroup(1, rowsOf(scene, EntityKind::Light));
    if (!scene.materials.shares(shown_.materials))
        refreshGroup(2, rowsOf(scene, EntityKind::Material));
    shown_ = scene;
}

void SceneModel::refreshGroup(int group, std::vector<Row> rows) {
    const QModelIndex parent = index(group, 0);
    auto& shown = groups_[static_cast<std::size_t>(group)].rows;
    std::vector<Id> wanted;
    for (const Row& row : rows)
        wanted.push_back(row.entity.id);
    std::sort(wanted.begin(), wanted.end());
    for (int i = static_cast<int>(shown.size()) - 1; i >= 0; --i) {
        if (std::binary_search(wanted.begin(), wanted.end(), shown[static_cast<std::size_t>(i)].entity.id))
            continue;
        beginRemoveRows(parent, i, i);
        shown.erase(shown.begin() + i);
        endRemoveRows();
    }
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        Row& row = rows[static_cast<std::size_t>(i)];
        const bool isThere =
            i < static_cast<int>(shown.size()) && shown[static_cast<std::size_t>(i)].entity == row.entity;
        if (!isThere) {
            beginInsertRows(parent, i, i);
            shown.insert(shown.begin() + i, std::move(row));
            endInsertRows();
        } else if (shown[static_cast<std::size_t>(i)] != row) {
            shown[static_cast<std::size_t>(i)] = std::move(row);
            Q_EMIT dataChanged(index(i, 0, parent), index(i, ColumnCount - 1, parent));
        }
    }
    // Whatever stood in another order was inserted anew above; its old rows are left over at the end.
    if (shown.size() > rows.size()) {
        beginRemoveRows(parent, static_cast<int>(rows.size()), static_cast<int>(shown.size()) - 1);
        shown.resize(rows.size());
        endRemoveRows();
    }
    Q_EMIT dataChanged(parent, parent); // the group's count
}

std::optional<EntityRef> SceneModel::entityAt(const QModelIndex& index) const {
    if (const Row* row = rowAt(index))
        return row->entity;
    return index.isValid() ? groups_[static_cast<std::size_t>(index.row())].entity : std::nullopt;
}

QModelIndex SceneModel::indexOf(EntityRef entity) const {
    for (int g = 0; g < static_cast<int>(groups_.size()); ++g) {
        const Group& group = groups_[static_cast<std::size_t>(g)];
        if (group.kind != entity.kind)
            continue;
        if (group.entity)
            return index(g, 0);
        const auto found = std::find_if(group.rows.begin(), group.rows.end(),
                                        [&](const Row& row) { return row.entity == entity; });
        if (found != group.rows.end())
            return index(static_cast<int>(found - group.rows.begin()), 0, index(g, 0));
    }
    return {};
}

void SceneModel::toggle(const QModelIndex& index) {
    const Row* row = rowAt(index);
    if (!row)
        return;
    if (row->entity.kind == EntityKind::Object)
        document_.setProperty({row->entity}, "visible", !row->on);
    else if (row->entity.kind == EntityKind::Light)
        document_.setProperty({row->entity}, "enabled", !row->on);
}

QModelIndex SceneModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) : topLevel);
}

QModelIndex SceneModel::parent(const QModelIndex& child) const {
    if (!child.isValid() || child.internalId() == topLevel)
        return {};
    return createIndex(static_cast<int>(child.internalId()), 0, topLevel);
}

int SceneModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid())
        return static_cast<int>(groups_.size());
    if (parent.internalId() != topLevel || parent.column() != 0)
        return 0;
    return static_cast<int>(groups_[static_cast<std::size_t>(parent.row())].rows.size());
}

int SceneModel::columnCount(const QModelIndex&) const {
    return ColumnCount;
}

const SceneModel::Row* SceneModel::rowAt(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == topLevel)
        return nullptr;
    return &groups_[index.internalId()].rows[static_cast<std::size_t>(index.row())];
}

QVariant SceneModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    if (index.column() == NameColumn)
        return nameData(index, role);
    const Row* row = rowAt(index);
    if (!row)
        return {};
    if (index.column() == SwitchColumn)
        return switchData(*row, role);
    if (row->entity.kind != EntityKind::Object)
        return {};
    if (role == BadgeRole)
        return row->dynamic;
    if (role == Qt::ToolTipRole)
        return row->dynamic ? tr("Dynamic: its vertices move") : tr("Static: its shape does not change");
    return {};
}

QVariant SceneModel::nameData(const QModelIndex& index, int role) const {
    const Row* row = rowAt(index);
    const Group* group = row ? nullptr : &groups_[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        if (row)
            return toQString(row->name);
        if (group->entity)
            return nameOf(shown_, *group->entity);
        return QStringLiteral("%1 (%2)").arg(groupName(group->kind)).arg(group->rows.size());
    case Qt::EditRole:
        return row ? toQString(row->name) : QVariant();
    case Qt::DecorationRole:
        if (row && row->entity.kind == EntityKind::Light)
            return lightIcon(row->lightType);
        return entityIcon(shown_, {row ? row->entity.kind : group->kind});
    default:
        return {};
    }
}

QVariant SceneModel::switchData(const Row& row, int role) const {
    const bool isObject = row.entity.kind == EntityKind::Object;
    if (!isObject && row.entity.kind != EntityKind::Light)
        return {};
    if (role == Qt::DecorationRole) {
        if (isObject)
            return icon(row.on ? QStringLiteral("visible") : QStringLiteral("hidden"));
        return icon(row.on ? QStringLiteral("light-on") : QStringLiteral("light-off"));
    }
    if (role == Qt::ToolTipRole) {
        if (isObject)
            return row.on ? tr("Hide it") : tr("Show it");
        return row.on ? tr("Switch it off") : tr("Switch it on");
    }
    return {};
}

bool SceneModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const auto entity = entityAt(index);
    if (role != Qt::EditRole || index.column() != NameColumn || !entity)
        return false;
    const QString fault = document_.setProperty({*entity}, "name", toStdString(value.toString()));
    if (!fault.isEmpty())
        Q_EMIT refused(fault);
    return fault.isEmpty();
}

Qt::ItemFlags SceneModel::flags(const QModelIndex& index) const {
    if (!index.isValid())
        return Qt::NoItemFlags;
    if (!entityAt(index))
        return Qt::ItemIsEnabled;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (rowAt(index) && index.column() == NameColumn)
        flags |= Qt::ItemIsEditable;
    return flags;
}

} // namespace prizma
