#pragma once

#include "core/render/render_thread.h"
#include "core/scene/properties.h"

#include <QPointF>
#include <QString>
#include <QWidget>

#include <optional>
#include <span>
#include <vector>

namespace prizma {

/// Draws the bones of skinned objects over the picture, in the pose that the picture shows; the bone under
/// the pointer tells its name. Lets the mouse through.
class SkeletonOverlay : public QWidget {
    Q_OBJECT

  public:
    /// Covers `view`.
    explicit SkeletonOverlay(QWidget& view);

    /// Shows the skeletons of the selected objects, or of all if none of these has one. `frame` may be null.
    void show(const FramePtr& frame, std::span<const EntityRef> selection);
    using QWidget::show;

    QString hoveredBone() const; ///< Empty if there is none under the pointer.

    /// Where a bone's joint is in the view; nothing if no bone of that name is in the picture.
    std::optional<QPointF> placeOf(const QString& bone) const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    struct Joint {
        std::string name;
        int parent = -1;              ///< Index into `joints_`.
        std::optional<QPointF> place; ///< Nothing behind the camera.
        std::optional<QPointF> tip;   ///< Of a bone without children.
    };

    void addSkeleton(const Object& object, const Scene& scene);
    void hover(const std::optional<QPointF>& position);
    int boneAt(const QPointF& position) const;
    void paintBones(QPainter& painter) const;
    void paintJoints(QPainter& painter) const;
    void paintBone(QPainter& painter, const QPointF& from, const QPointF& to, bool hovered) const;
    void paintName(QPainter& painter) const;

    std::vector<Joint> joints_; ///< Of all skeletons that are shown.
    std::optional<QPointF> pointer_;
    int hovered_ = -1;
};

} // namespace prizma
