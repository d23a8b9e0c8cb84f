#include "ui/properties/property_row.h"

#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/properties/number_field.h"

#include <QGridLayout>
#include <QMouseEvent>
#include <QToolButton>

#include <algorithm>

namespace prizma {
namespace {

constexpr int widestLabel = 128; // longer names take two lines, so that the fields keep their room

} // namespace

PropertyLabel::PropertyLabel(const QString& text, ValueEditor& editor)
    : QLabel(text), field_(editor.labelField()) {
    setBuddy(&editor);
    setWordWrap(true);
    setMaximumWidth(widestLabel);
    if (field_)
        setCursor(Qt::SizeHorCursor);
}

void PropertyLabel::mousePressEvent(QMouseEvent* event) {
    if (!field_ || event->button() != Qt::LeftButton)
        return;
    dragging_ = true;
    lastX_ = event->globalPosition().toPoint().x();
    field_->beginDrag();
}

void PropertyLabel::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging_)
        return;
    const int x = event->globalPosition().toPoint().x();
    field_->dragBy(x - lastX_, event->modifiers());
    lastX_ = x;
}

void PropertyLabel::mouseReleaseEvent(QMouseEvent*) {
    if (!dragging_)
        return;
    dragging_ = false;
    field_->endDrag();
}

PropertyRow::PropertyRow(const PropertyInfo& property, std::unique_ptr<ValueEditor> editor, QGridLayout& grid,
                         QObject* parent)
    : QObject(parent),
      key_(property.key),
      defaultValue_(property.defaultValue),
      editor_(editor.release()),
      reset_(new QToolButton) {
    editor_->setObjectName(toQString(property.key) + QStringLiteral("Editor"));
    auto* label = new PropertyLabel(translated(property.label), *editor_);
    label->setToolTip(translated(property.help));
    reset_->setIcon(icon(QStringLiteral("reset")));
    reset_->setIconSize({12, 12});
    reset_->setAutoRaise(true);
    reset_->setToolTip(tr("Back to the default"));
    reset_->setObjectName(toQString(property.key) + QStringLiteral("Reset"));
    QSizePolicy policy = reset_->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // the fields must not jump
    reset_->setSizePolicy(policy);
    const int row = grid.rowCount();
    grid.addWidget(label, row, 0);
    grid.addWidget(editor_, row, 1);
    grid.addWidget(reset_, row, 2);
    connect(reset_, &QToolButton::clicked, this, [this] { Q_EMIT resetRequested(defaultValue_); });
}

void PropertyRow::show(const std::vector<PropertyValue>& values) {
    editor_->show(values);
    // A thing without a name would not help anybody.
    reset_->setVisible(key_ != "name" &&
                       std::any_of(values.begin(), values.end(),
                                   [this](const PropertyValue& value) { return value != defaultValue_; }));
}

} // namespace prizma
