#include "ui/properties/color_editor.h"

#include "core/scene/srgb.h"

#include "ui/document/strings.h"
#include "ui/properties/number_editors.h"
#include "ui/properties/number_field.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace prizma {
namespace {

/// How many times brighter than the screen's white the colour is; at least 1.
double overbright(const glm::dvec3& linear) {
    return std::max({1.0, linear.x, linear.y, linear.z});
}

} // namespace

QColor displayColor(const glm::dvec3& linear) {
    const glm::dvec3 c = glm::max(linear, 0.0) / overbright(linear);
    const auto channel = [](double value) {
        return static_cast<float>(std::clamp(encodeSrgb(value), 0.0, 1.0));
    };
    return QColor::fromRgbF(channel(c.x), channel(c.y), channel(c.z));
}

glm::dvec3 linearColor(const QColor& color) {
    const auto channel = [](float value) { return decodeSrgb(static_cast<double>(value)); };
    return {channel(color.redF()), channel(color.greenF()), channel(color.blueF())};
}

ColorEditor::ColorEditor(const PropertyInfo& property)
    : title_(translated(property.label)), swatch_(new QToolButton) {
    swatch_->setObjectName(QStringLiteral("swatch"));
    swatch_->setIconSize({24, 14});
    swatch_->setToolTip(tr("Choose a colour"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(swatch_);
    fields_ = makeComponentFields(property, 3, this);
    static const char* const tips[] = {QT_TR_NOOP("Red (linear)"), QT_TR_NOOP("Green (linear)"),
                                       QT_TR_NOOP("Blue (linear)")};
    for (int i = 0; i < 3; ++i) {
        NumberField* field = fields_[static_cast<std::size_t>(i)];
        field->setStep(0.05);
        field->setToolTip(tr(tips[i]));
        row->addWidget(field);
        forwardGestures(field);
        connect(field, &NumberField::valueEdited, this, [this, i](double number) {
            Q_EMIT edited([i, number](const PropertyValue& value) -> PropertyValue {
                auto color = std::get<glm::dvec3>(value);
                color[i] = number;
                return color;
            });
        });
    }
    setFocusProxy(swatch_);
    connect(swatch_, &QToolButton::clicked, this, &ColorEditor::openDialog);
}

void ColorEditor::show(const std::vector<PropertyValue>& values) {
    color_ = std::get<glm::dvec3>(values.back());
    for (int i = 0; i < 3; ++i) {
        NumberField& field = *fields_[static_cast<std::size_t>(i)];
        field.setValue(color_[i]);
        field.setMixed(std::any_of(values.begin(), values.end(), [&](const PropertyValue& value) {
            return std::get<glm::dvec3>(value)[i] != color_[i];
        }));
    }
    showSwatch();
}

void ColorEditor::showSwatch() {
    QPixmap pixmap(swatch_->iconSize());
    pixmap.fill(displayColor(color_));
    QPainter painter(&pixmap);
    painter.setPen(QColor(0, 0, 0, 120));
    painter.drawRect(pixmap.rect().adjusted(0, 0, -1, -1));
    painter.end();
    swatch_->setIcon(pixmap);
}

void ColorEditor::openDialog() {
    if (dialog_) {
        dialog_->raise();
        dialog_->activateWindow();
        return;
    }
    const glm::dvec3 before = color_;
    const double brightness = overbright(before); // kept: the dialog chooses hue and shade
    dialog_ = new QColorDialog(displayColor(before), this);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    dialog_->setOption(QColorDialog::DontUseNativeDialog);
    dialog_->setWindowTitle(title_);
    dialog_->setModal(false);
    connect(dialog_, &QColorDialog::currentColorChanged, this,
            [this, brightness](const QColor& color) { editAll(linearColor(color) * brightness); });
    connect(dialog_, &QDialog::rejected, this, [this, before] { editAll(before); });
    connect(dialog_, &QDialog::finished, this, &ColorEditor::gestureFinished);
    Q_EMIT gestureStarted();
    dialog_->show();
}

} // namespace prizma
