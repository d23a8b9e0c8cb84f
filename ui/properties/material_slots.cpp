#include "ui/properties/material_slots.h"

#include "core/scene/edits.h"
#include "ui/document/document.h"
#include "ui/document/edits.h"
#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/properties/color_editor.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace prizma {
namespace {

/// A ball in the material's colour: enough to tell materials apart in a list.
QIcon materialIcon(const Material& material) {
    QPixmap pixmap(16, 16);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QColor(0, 0, 0, 120));
    painter.setBrush(displayColor(material.baseColor));
    painter.drawEllipse(QRectF(2.0, 2.0, 12.0, 12.0));
    return pixmap;
}

QToolButton* makeButton(const QString& iconName, const QString& tip) {
    auto* button = new QToolButton;
    button->setIcon(icon(iconName));
    button->setToolTip(tip);
    button->setAutoRaise(true);
    return button;
}

} // namespace

MaterialSlots::MaterialSlots(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->setSpacing(6);
    auto* heading = new QLabel(tr("Materials"));
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    layout->addWidget(heading);
}

void MaterialSlots::show(const std::vector<Id>& objects) {
    objects_ = objects;
    const Object* object = objects.empty() ? nullptr : document_.scene().findObject(objects.back());
    setVisible(object && !object->materials.empty());
    if (!object)
        return;
    std::vector<std::string> names = object->mesh ? object->mesh->slots : std::vector<std::string>();
    names.resize(object->materials.size());
    if (names != names_ || !content_)
        rebuild(names);
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        fill(*boxes_[i], object->materials[i]);
}

void MaterialSlots::rebuild(const std::vector<std::string>& names) {
    names_ = names;
    boxes_.clear();
    if (content_) {
        content_->hide();
        content_->deleteLater(); // it may be one of its own signals that led here
    }
    content_ = new QWidget;
    auto* grid = new QGridLayout(content_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    grid->setColumnMinimumWidth(0, 92);
    grid->setColumnStretch(1, 1);
    for (int slot = 0; slot < static_cast<int>(names.size()); ++slot) {
        const QString name = toQString(names[static_cast<std::size_t>(slot)]);
        auto* label = new QLabel(name.isEmpty() ? tr("Slot %1").arg(slot + 1) : name);
        label->setText(label->fontMetrics().elidedText(label->text(), Qt::ElideMiddle, 110));
        label->setToolTip(name);
        auto* box = new QComboBox;
        box->setObjectName(QStringLiteral("slot%1").arg(slot));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(6);
        box->setFocusPolicy(Qt::StrongFocus);
        connect(box, &QComboBox::activated, this, [this, slot](int index) { chosen(slot, index); });
        auto* jumpButton = makeButton(QStringLiteral("go-jump"), tr("Edit this material"));
        connect(jumpButton, &QToolButton::clicked, this, [this, slot] { jump(slot); });
        auto* newButton = makeButton(QStringLiteral("list-add"), tr("Assign a new material"));
        connect(newButton, &QToolButton::clicked, this, [this, slot] { assignNew(slot); });
        grid->addWidget(label, slot, 0);
        grid->addWidget(box, slot, 1);
        grid->addWidget(jumpButton, slot, 2);
        grid->addWidget(newButton, slot, 3);
        boxes_.push_back(box);
    }
    layout()->addWidget(content_);
    content_->show(); // now, not when the event loop comes round
}

void MaterialSlots::fill(QComboBox& box, Id current) {
    const auto& materials = document_.scene().materials;
    box.clear();
    int index = -1;
    for (const Material& material : materials) {
        if (material.id == current)
            index = box.count();
        box.addItem(materialIcon(material), toQString(material.name),
                    QVariant::fromValue<qulonglong>(material.id));
    }
    box.setCurrentIndex(index);
}

void MaterialSlots::chosen(int slot, int index) {
    const Id material = boxes_[static_cast<std::size_t>(slot)]->itemData(index).toULongLong();
    assignMaterial(document_, objects_, slot, material);
}

void MaterialSlots::jump(int slot) {
    const Id material = boxes_[static_cast<std::size_t>(slot)]->currentData().toULongLong();
    document_.setSelection({{EntityKind::Material, material}});
}

void MaterialSlots::assignNew(int slot) {
    document_.edit(tr("Assign a new material"), [&](Scene& scene) {
        const Id material = addMaterial(scene);
        assignMaterial(scene, objects_, slot, material);
    });
}

} // namespace prizma
