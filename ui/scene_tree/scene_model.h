#pragma once

#include "core/scene/properties.h"

#include <QAbstractItemModel>

#include <optional>
#include <vector>

namespace prizma {

class Document;

/// The document's scene as a tree: groups of objects, lights and materials, and single entries for the rest.
/// Changes of the scene become the fewest row changes, so that views keep their selection and what is
/// expanded.
class SceneModel : public QAbstractItemModel {
    Q_OBJECT

  public:
    enum Column { NameColumn, BadgeColumn, SwitchColumn, ColumnCount };
    enum Role { BadgeRole = Qt::UserRole }; ///< Bool: Dynamic. Invalid where there is no badge.

    explicit SceneModel(Document& document, QObject* parent = nullptr);

    /// Nothing for a group.
    std::optional<EntityRef> entityAt(const QModelIndex& index) const;
    QModelIndex indexOf(EntityRef entity) const;

    /// Shows or hides an object, switches a light on or off.
    void toggle(const QModelIndex& index);

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  Q_SIGNALS:
    void refused(const QString& reason); ///< A rename that is not possible.

  private:
    /// What a row shows.
    struct Row {
        EntityRef entity;
        std::string name;
        bool on = true;
        bool dynamic = false;
        LightType lightType = LightType::Point;
        glm::dvec3 color{0.0}; ///< Of a material.

        friend bool operator==(const Row&, const Row&) = default;
    };

    struct Group {
        std::optional<EntityRef> entity; ///< Of a single entry.
        EntityKind kind;
        std::vector<Row> rows;
    };

    static std::vector<Row> rowsOf(const Scene& scene, EntityKind kind);
    void refresh();
    void refreshGroup(int group, std::vector<Row> rows);
    const Row* rowAt(const QModelIndex& index) const;
    QVariant nameData(const QModelIndex& index, int role) const;
    QVariant switchData(const Row& row, int role) const;

    Document& document_;
    Scene shown_; ///< For a quick look at which lists are unchanged.
    std::vector<Group> groups_;
};

} // namespace prizma
