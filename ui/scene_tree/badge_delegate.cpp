#include "ui/scene_tree/badge_delegate.h"

#include "ui/main_window/theme.h"
#include "ui/scene_tree/scene_model.h"

#include <QApplication>
#include <QPainter>

namespace prizma {
namespace {

QFont badgeFont(const QStyleOptionViewItem& option) {
    QFont font = option.font;
    font.setPointSizeF(font.pointSizeF() * 0.8);
    return font;
}

QString badgeText(bool dynamic) {
    return dynamic ? BadgeDelegate::tr("Dynamic") : BadgeDelegate::tr("Static");
}

} // namespace

void BadgeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, option.widget);
    const QVariant badge = index.data(SceneModel::BadgeRole);
    if (!badge.isValid())
        return;
    const bool dynamic = badge.toBool();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(badgeFont(option));
    const int height = painter->fontMetrics().height() + 2;
    const QRectF box(option.rect.left() + 2.0, option.rect.center().y() - height / 2.0 + 0.5,
                     option.rect.width() - 4.0, height);
    painter->setPen(dynamic ? Qt::NoPen : QPen(theme::dim().darker(180)));
    painter->setBrush(dynamic ? QBrush(theme::badge()) : Qt::NoBrush);
    painter->drawRoundedRect(box, 4.0, 4.0);
    painter->setPen(dynamic ? QColor(Qt::white) : theme::dim());
    painter->drawText(box, Qt::AlignCenter, badgeText(dynamic));
    painter->restore();
}

QSize BadgeDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int height = QStyledItemDelegate::sizeHint(option, index).height();
    if (!index.data(SceneModel::BadgeRole).isValid())
        return {0, height};
    const QFontMetrics metrics(badgeFont(option));
    return {
        std::max(metrics.horizontalAdvance(badgeText(true)), metrics.horizontalAdvance(badgeText(false))) +
            14,
        height};
}

} // namespace prizma
