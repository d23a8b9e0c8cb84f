#include "ui/properties/property_editor.h"

#include "core/import/image_loader.h"
#include "ui/document/document.h"
#include "ui/document/strings.h"
#include "ui/import/background_job.h"
#include "ui/main_window/theme.h"
#include "ui/properties/material_slots.h"
#include "ui/properties/property_row.h"
#include "ui/scene_tree/entity_icon.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace prizma {
namespace {

/// Names of clips are texts in the tables, but only the object's own clips make sense.
std::vector<ShownChoice> clipChoices(const Object& object) {
    std::vector<ShownChoice> choices{{"", PropertyEditor::tr("Bind pose")}};
    for (const ClipPtr& clip : object.clips)
        choices.push_back({clip->name, toQString(clip->name)});
    return choices;
}

std::vector<ShownChoice> choicesFor(const Scene& scene, EntityRef entity, const PropertyInfo& property) {
    const Object* object = entity.kind == EntityKind::Object ? scene.findObject(entity.id) : nullptr;
    return object && namesClip(property.key) ? clipChoices(*object) : std::vector<ShownChoice>();
}

} // namespace

PropertyEditor::PropertyEditor(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      icon_(new QLabel),
      heading_(new QLabel),
      hint_(new QLabel(tr("Select something in the scene tree or in the view to see its properties."))),
      content_(new QVBoxLayout),
      slots_(new MaterialSlots(document)) {
    auto* title = new QHBoxLayout;
    title->setSpacing(8);
    title->addWidget(icon_);
    title->addWidget(heading_, 1);
    QFont large = heading_->font();
    large.setBold(true);
    large.setPointSizeF(large.pointSizeF() * 1.1);
    heading_->setFont(large);
    heading_->setObjectName(QStringLiteral("propertyHeading"));
    hint_->setWordWrap(true);
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setContentsMargins(24, 32, 24, 24);
    QPalette dimmed = hint_->palette();
    dimmed.setColor(QPalette::WindowText, theme::dim());
    hint_->setPalette(dimmed);

    auto* page = new QWidget;
    content_->setContentsMargins(10, 10, 6, 10);
    content_->setSpacing(8);
    content_->addLayout(title);
    content_->addWidget(hint_);
    content_->addWidget(slots_);
    content_->addStretch(1);
    page->setLayout(content_);
    auto* area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(page);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(area);

    connect(&document_, &Document::selectionChanged, this, &PropertyEditor::refresh);
    connect(&document_, &Document::sceneChanged, this, [this](const SceneDiff& changes) {
        // While playing, only the timeline's own properties have anything new to show.
        const bool showsTimeline = !entities_.empty() && entities_.back().kind == EntityKind::Timeline;
        if (!changes.isTimeOnly() || showsTimeline)
            refresh();
    });
    refresh();
}

void PropertyEditor::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

void PropertyEditor::refresh() {
    // Hidden behind another panel there is nothing to keep up to date; showEvent makes up for it.
    if (!isVisible() && !rows_.empty() && entities_ == document_.selection())
        return;
    entities_.clear();
    const auto& selection = document_.selection();
    for (const EntityRef& entity : selection)
        if (entity.kind == selection.back().kind)
            entities_.push_back(entity);

    std::vector<PropertyInfo> shown;
    std::vector<std::string> layoutOfRows;
    if (!entities_.empty()) {
        layoutOfRows.push_back(std::to_string(static_cast<int>(entities_.back().kind)));
        for (const PropertyInfo& property : properties(document_.scene(), entities_.back())) {
            if (!property.applies || (property.key == "name" && entities_.size() > 1))
                continue;
            shown.push_back(property);
            layoutOfRows.emplace_back(property.key);
            for (const ShownChoice& choice : choicesFor(document_.scene(), entities_.back(), property))
                layoutOfRows.push_back(choice.key);
        }
    }
    if (layoutOfRows != layoutOfRows_) {
        layoutOfRows_ = layoutOfRows;
        rebuild(shown);
    }
    showHeading();
    for (PropertyRow* row : rows_) {
        std::vector<PropertyValue> values;
        for (const EntityRef& entity : entities_)
            if (const auto value = getProperty(document_.scene(), entity, row->key()))
                values.push_back(*value);
        if (!values.empty())
            row->show(values);
    }
    std::vector<Id> objects;
    for (const EntityRef& entity : entities_)
        if (entity.kind == EntityKind::Object)
            objects.push_back(entity.id);
    slots_->show(objects);
}

void PropertyEditor::rebuild(const std::vector<PropertyInfo>& properties) {
    for (PropertyRow* row : rows_)
        row->deleteLater();
    rows_.clear();
    gesture_ = 0;
    if (grid_) {
        grid_->hide();
        content_->removeWidget(grid_);
        grid_->deleteLater(); // it may be one of its own signals that led here
    }
    grid_ = new QWidget;
    auto* grid = new QGridLayout(grid_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    grid->setColumnMinimumWidth(0, 92);
    grid->setColumnStretch(1, 1);
    std::string_view section;
    for (const PropertyInfo& property : properties) {
        if (property.section != section)
            addSection(property.section);
        section = property.section;
        addRow(property);
    }
    content_->insertWidget(content_->indexOf(slots_), grid_);
    grid_->show(); // now, not when the event loop comes round
}

void PropertyEditor::addSection(std::string_view section) {
    auto* grid = static_cast<QGridLayout*>(grid_->layout());
    auto* heading = new QLabel(translated(section));
    heading->setObjectName(QStringLiteral("sectionHeading"));
    heading->setContentsMargins(0, 8, 0, 0);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    QPalette dimmed = heading->palette();
    dimmed.setColor(QPalette::WindowText, theme::dim());
    heading->setPalette(dimmed);
    grid->addWidget(heading, grid->rowCount(), 0, 1, grid->columnCount());
}

void PropertyEditor::addRow(const PropertyInfo& property) {
    const std::string key(property.key);
    auto* grid = static_cast<QGridLayout*>(grid_->layout());
    auto* row = new PropertyRow(
        property, makeValueEditor(property, choicesFor(document_.scene(), entities_.back(), property)), *grid,
        this);
    connect(&row->editor(), &ValueEditor::gestureStarted, this,
            [this] { gesture_ = document_.newGesture(); });
    connect(&row->editor(), &ValueEditor::gestureFinished, this, [this] { gesture_ = 0; });
    connect(&row->editor(), &ValueEditor::edited, this, [this, key](const ValueEditor::Change& change) {
        report(document_.changeProperty(entities_, key, change, gesture_));
    });
    connect(&row->editor(), &ValueEditor::fileChosen, this,
            [this, key](const QString& file) { loadTexture(key, file); });
    connect(row, &PropertyRow::resetRequested, this, [this, key](const PropertyValue& value) {
        report(document_.setProperty(entities_, key, value));
    });
    rows_.push_back(row);
}

void PropertyEditor::showHeading() {
    const bool any = !entities_.empty();
    hint_->setVisible(!any);
    icon_->setVisible(any);
    heading_->setVisible(any);
    if (!any)
        return;
    icon_->setPixmap(entityIcon(document_.scene(), entities_.back()).pixmap(16, 16));
    const QString text = describeEntities(document_.scene(), entities_);
    heading_->setText(heading_->fontMetrics().elidedText(text, Qt::ElideRight, 220));
    heading_->setToolTip(text);
}

void PropertyEditor::report(const QString& fault) {
    if (fault.isEmpty())
        return;
    Q_EMIT message({Severity::Warning, toStdString(fault), {}, 0});
    refresh(); // the editor shows what was refused
}

void PropertyEditor::loadTexture(const std::string& key, const QString& file) {
    // The picture is for what is selected now, whatever is selected when it has been read.
    new BackgroundJob(
        tr("Reading %1…").arg(QFileInfo(file).fileName()),
        [this, key, file, entities = entities_](Progress&) -> BackgroundJob::Delivery {
            auto image = loadImage(toStdString(file));
            return [this, key, file, entities, image = std::move(image)] {
                if (image)
                    report(document_.setProperty(entities, key, Texture{toStdString(file), *image}));
                else {
                    Q_EMIT message(image.error());
                    refresh();
                }
            };
        },
        this);
}

} // namespace prizma
