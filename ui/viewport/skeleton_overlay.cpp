#include "ui/viewport/skeleton_overlay.h"

#include "core/animation/bone_places.h"
#include "core/scene/camera_motion.h"
#include "core/scene/hierarchy.h"
#include "ui/document/strings.h"
#include "ui/main_window/theme.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

constexpr double jointRadius = 2.5;
constexpr double widestBone = 4.0; // Half of the width.
constexpr double reach = 7.0;      // Pixels from a bone within which the pointer is on it.

constexpr QColor boneColor{106, 174, 242, 150};
constexpr QColor hoveredColor{240, 201, 90, 220};
constexpr QColor outlineColor{12, 14, 18, 170};
constexpr QColor panelColor{18, 20, 24, 220};
constexpr QColor textColor{245, 247, 250};

bool hasSkeleton(const Hierarchy& hierarchy, const Object& object) {
    return object.mesh && object.mesh->skeleton && hierarchy.isShown(object);
}

double length(const QPointF& v) {
    return std::hypot(v.x(), v.y());
}

double distanceToSegment(const QPointF& point, const QPointF& from, const QPointF& to) {
    const QPointF along = to - from;
    const double square = QPointF::dotProduct(along, along);
    const double t =
        square > 0.0 ? std::clamp(QPointF::dotProduct(point - from, along) / square, 0.0, 1.0) : 0.0;
    return length(point - (from + along * t));
}

} // namespace

SkeletonOverlay::SkeletonOverlay(QWidget& view) : QWidget(&view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Skeletons"));
    view.installEventFilter(this);
    resize(view.size());
}

void SkeletonOverlay::show(const FramePtr& frame, std::span<const EntityRef> selection) {
    joints_.clear();
    hovered_ = -1;
    if (frame) {
        const Scene& scene = frame->scene;
        const Hierarchy hierarchy(scene);
        const auto isSelected = [&](const Object& object) {
            const EntityRef entity{EntityKind::Object, object.id};
            return std::find(selection.begin(), selection.end(), entity) != selection.end();
        };
        const bool anySelected =
            std::any_of(scene.objects.begin(), scene.objects.end(),
                        [&](const Object& o) { return hasSkeleton(hierarchy, o) && isSelected(o); });
        for (const Object& object : scene.objects)
            if (hasSkeleton(hierarchy, object) && (!anySelected || isSelected(object)))
                addSkeleton(object, scene);
    }
    hover(pointer_);
    update();
}

void SkeletonOverlay::addSkeleton(const Object& object, const Scene& scene) {
    const auto first = static_cast<int>(joints_.size());
    const auto& bones = object.mesh->skeleton->bones;
    const auto places = bonePlaces(object, worldMatrix(scene, object), scene.timeline.seconds());
    const double halfHeight = height() * 0.5;
    const auto inView = [&](const glm::dvec3& point) -> std::optional<QPointF> {
        const auto place = placeInPicture(scene.camera, point);
        if (!place)
            return std::nullopt;
        return QPointF(width() * 0.5 + place->x * halfHeight, halfHeight - place->y * halfHeight);
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
        Joint joint{
            bones[i].name, bones[i].parent < 0 ? -1 : first + bones[i].parent, inView(places[i].joint), {}};
        if (places[i].tip)
            joint.tip = inView(*places[i].tip);
        joints_.push_back(std::move(joint));
    }
}

QString SkeletonOverlay::hoveredBone() const {
    return hovered_ < 0 ? QString() : toQString(joints_[static_cast<std::size_t>(hovered_)].name);
}

std::optional<QPointF> SkeletonOverlay::placeOf(const QString& bone) const {
    const auto found = std::find_if(joints_.begin(), joints_.end(),
                                    [&](const Joint& joint) { return toQString(joint.name) == bone; });
    return found == joints_.end() ? std::nullopt : found->place;
}

/// A joint comes before the bones that pass it. A bone reaches from its own joint to those of its children.
int SkeletonOverlay::boneAt(const QPointF& position) const {
    int nearest = -1;
    double best = reach;
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if (const auto& place = joints_[i].place; place && length(position - *place) < best) {
            best = length(position - *place);
            nearest = static_cast<int>(i);
        }
    if (nearest >= 0)
        return nearest;
    const auto consider = [&](int bone, const std::optional<QPointF>& from,
                              const std::optional<QPointF>& to) {
        if (const double distance = from && to ? distanceToSegment(position, *from, *to) : reach;
            distance < best) {
            best = distance;
            nearest = bone;
        }
    };
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Joint& joint = joints_[i];
        if (joint.parent >= 0)
            consider(joint.parent, joints_[static_cast<std::size_t>(joint.parent)].place, joint.place);
        consider(static_cast<int>(i), joint.place, joint.tip);
    }
    return nearest;
}

void SkeletonOverlay::hover(const std::optional<QPointF>& position) {
    pointer_ = position;
    const int bone = position ? boneAt(*position) : -1;
    // The name follows the pointer.
    if (bone != hovered_ || bone >= 0)
        update();
    hovered_ = bone;
}

bool SkeletonOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent()) {
        if (event->type() == QEvent::Resize)
            resize(parentWidget()->size());
        else if (event->type() == QEvent::MouseMove && isVisible()) {
            const auto* mouse = static_cast<QMouseEvent*>(event);
            // Names would only be in the way of a drag.
            hover(mouse->buttons() == Qt::NoButton ? std::optional(mouse->position()) : std::nullopt);
        } else if (event->type() == QEvent::Leave)
            hover(std::nullopt);
    }
    return QWidget::eventFilter(watched, event);
}

void SkeletonOverlay::showEvent(QShowEvent* event) {
    parentWidget()->setMouseTracking(true);
    QWidget::showEvent(event);
}

void SkeletonOverlay::hideEvent(QHideEvent* event) {
    parentWidget()->setMouseTracking(false);
    hover(std::nullopt);
    QWidget::hideEvent(event);
}

void SkeletonOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBones(painter);
    paintJoints(painter);
    paintName(painter);
}

void SkeletonOverlay::paintBones(QPainter& painter) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Joint& joint = joints_[i];
        if (!joint.place)
            continue;
        if (joint.tip)
            paintBone(painter, *joint.place, *joint.tip, static_cast<int>(i) == hovered_);
        if (joint.parent < 0)
            continue;
        if (const auto& from = joints_[static_cast<std::size_t>(joint.parent)].place)
            paintBone(painter, *from, *joint.place, joint.parent == hovered_);
    }
}

void SkeletonOverlay::paintJoints(QPainter& painter) const {
    painter.setPen(QPen(outlineColor, 1.0));
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (!joints_[i].place)
            continue;
        const bool hovered = static_cast<int>(i) == hovered_;
        painter.setBrush(hovered ? hoveredColor : boneColor);
        const double radius = hovered ? jointRadius + 1.5 : jointRadius;
        painter.drawEllipse(*joints_[i].place, radius, radius);
    }
}

/// A kite whose thick end is at the bone's own joint, so that one sees which way it goes.
void SkeletonOverlay::paintBone(QPainter& painter, const QPointF& from, const QPointF& to,
                                bool hovered) const {
    const QPointF along = to - from;
    const double size = length(along);
    if (size < 1.0)
        return;
    const QPointF side = QPointF(-along.y(), along.x()) / size * std::min(widestBone, size * 0.15);
    const QPointF shoulder = from + along * 0.15;
    QPainterPath kite(from);
    kite.lineTo(shoulder + side);
    kite.lineTo(to);
    kite.lineTo(shoulder - side);
    kite.closeSubpath();
    painter.setPen(QPen(outlineColor, 1.0));
    painter.setBrush(hovered ? hoveredColor : boneColor);
    painter.drawPath(kite);
}

void SkeletonOverlay::paintName(QPainter& painter) const {
    const QString name = hoveredBone();
    if (name.isEmpty() || !pointer_)
        return;
    const QFontMetricsF metrics(font());
    QRectF panel(0.0, 0.0, metrics.horizontalAdvance(name) + 16.0, metrics.height() + 8.0);
    panel.moveBottomLeft(*pointer_ + QPointF(14.0, -8.0));
    panel.moveRight(std::min(panel.right(), width() - 4.0));
    panel.moveTop(std::max(panel.top(), 4.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(panelColor);
    painter.drawRoundedRect(panel, 4.0, 4.0);
    painter.setPen(textColor);
    painter.drawText(panel, Qt::AlignCenter, name);
}

} // namespace prizma
