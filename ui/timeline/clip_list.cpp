#include "ui/timeline/clip_list.h"

#include "core/animation/pose_key.h"
#include "ui/document/document.h"
#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/timeline/clip_edits.h"
#include "ui/timeline/clip_preview.h"
#include "ui/timeline/timeline_controller.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QScopedValueRollback>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace prizma {
namespace {

enum Column { NameColumn, FramesColumn, RateColumn };

/// The clip's name in the scene; empty for the bind pose.
std::string clipOf(const QTreeWidgetItem& item) {
    return item.data(NameColumn, Qt::UserRole).toString().toStdString();
}

QTreeWidgetItem* addRow(QTreeWidget& list, const Clip& clip) {
    auto* item = new QTreeWidgetItem(&list);
    item->setText(NameColumn, toQString(clip.name));
    item->setData(NameColumn, Qt::UserRole, toQString(clip.name));
    item->setText(FramesColumn, QString::number(clip.frameCount));
    item->setText(RateColumn, QLocale().toString(clip.fps, 'g', 4));
    const double seconds = clip.fps > 0.0 ? clip.frameCount / clip.fps : 0.0;
    item->setToolTip(NameColumn, ClipList::tr("%1: %2 s%3")
                                     .arg(toQString(clip.name), QLocale().toString(seconds, 'f', 2),
                                          clip.loops ? ClipList::tr(", loops") : QString()));
    for (const Column column : {FramesColumn, RateColumn}) {
        item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        item->setForeground(column, theme::dim());
    }
    return item;
}

} // namespace

ClipList::ClipList(Document& document, const TimelineController& controller, ClipPreview& preview,
                   QWidget* parent)
    : QWidget(parent),
      document_(document),
      controller_(controller),
      preview_(preview),
      list_(new QTreeWidget),
      hint_(new QLabel(tr("No clips. Import a model that has animations, or select it."))) {
    list_->setObjectName(QStringLiteral("clipList"));
    list_->setAccessibleName(tr("Clips"));
    list_->setColumnCount(3);
    list_->headerItem()->setTextAlignment(FramesColumn, Qt::AlignRight | Qt::AlignVCenter);
    list_->headerItem()->setTextAlignment(RateColumn, Qt::AlignRight | Qt::AlignVCenter);
    list_->header()->setStretchLastSection(false);
    list_->header()->setTextElideMode(Qt::ElideRight);
    list_->header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(FramesColumn, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(RateColumn, QHeaderView::ResizeToContents);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setMouseTracking(true);
    list_->setTextElideMode(Qt::ElideMiddle);
    list_->setFrameShape(QFrame::NoFrame);
    list_->installEventFilter(this);
    list_->viewport()->installEventFilter(this);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(list_);
    layout->addWidget(hint_);
    hint_->setWordWrap(true);
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setContentsMargins(12, 8, 12, 8);
    QPalette dimmed = hint_->palette();
    dimmed.setColor(QPalette::WindowText, theme::dim());
    hint_->setPalette(dimmed);

    connect(list_, &QTreeWidget::itemEntered, this, &ClipList::showPreview);
    connect(list_, &QTreeWidget::viewportEntered, this, [this] { preview_.end(); });
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* current) {
        if (!updating_ && list_->hasFocus())
            showPreview(current);
    });
    connect(list_, &QTreeWidget::itemClicked, this, &ClipList::choose);
    connect(list_, &QTreeWidget::itemActivated, this, &ClipList::choose);
    connect(list_, &QTreeWidget::itemDoubleClicked, this, &ClipList::fit);
    connect(&document_, &Document::sceneChanged, this, [this](const SceneDiff& changes) {
        if (!changes.isTimeOnly())
            refresh();
    });
    connect(&document_, &Document::selectionChanged, this, &ClipList::refresh);
    rebuild();
    showChosen();
}

void ClipList::refresh() {
    const Object* object = timelineObject(document_);
    if ((object ? object->id : noId) != object_ || (object && object->clips != clips_))
        rebuild();
    showChosen();
}

void ClipList::rebuild() {
    const QScopedValueRollback guard(updating_, true);
    preview_.end();
    list_->clear();
    const Object* object = timelineObject(document_);
    object_ = object ? object->id : noId;
    clips_ = object ? object->clips : std::vector<ClipPtr>();
    list_->setVisible(object != nullptr);
    hint_->setVisible(object == nullptr);
    if (!object)
        return;
    auto* bindPose = new QTreeWidgetItem(list_, {tr("Bind pose")});
    bindPose->setForeground(NameColumn, theme::dim());
    for (const ClipPtr& clip : clips_)
        addRow(*list_, *clip);
    const QSize rowSize(0, list_->fontMetrics().height() + 6);
    for (int i = 0; i < list_->topLevelItemCount(); ++i)
        list_->topLevelItem(i)->setSizeHint(NameColumn, rowSize);
}

/// The clip that plays is bold and current; the object's name stands above.
void ClipList::showChosen() {
    const Object* object = document_.scene().findObject(object_);
    if (!object)
        return;
    const QScopedValueRollback guard(updating_, true);
    const QString name = toQString(object->name);
    list_->setHeaderLabels({name, tr("Frames"), tr("1/s")});
    list_->headerItem()->setToolTip(NameColumn, tr("Clips of %1").arg(name));
    list_->headerItem()->setToolTip(RateColumn, tr("Frames a second"));
    const std::string chosen = findClip(*object, object->clip) ? object->clip : std::string();
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = list_->topLevelItem(i);
        const bool isChosen = clipOf(*item) == chosen;
        QFont font = list_->font();
        font.setBold(isChosen);
        item->setFont(NameColumn, font);
        if (isChosen && list_->currentItem() != item)
            list_->setCurrentItem(item);
    }
}

void ClipList::choose(QTreeWidgetItem* item) {
    preview_.end();
    chooseClip(document_, object_, clipOf(*item), controller_.isPlaying());
}

void ClipList::fit(QTreeWidgetItem* item) {
    const Object* object = document_.scene().findObject(object_);
    if (const ClipPtr clip = object ? findClip(*object, clipOf(*item)) : nullptr)
        fitTimeline(document_, *object, *clip);
}

void ClipList::showPreview(QTreeWidgetItem* item) {
    const Object* object = document_.scene().findObject(object_);
    if (item && object && clipOf(*item) != object->clip)
        preview_.show(object_, clipOf(*item));
    else
        preview_.end();
}

bool ClipList::eventFilter(QObject* watched, QEvent* event) {
    if ((watched == list_->viewport() && event->type() == QEvent::Leave) ||
        (watched == list_ && event->type() == QEvent::FocusOut)) {
        preview_.end();
        showChosen(); // the keyboard's cursor goes back to it, too
    }
    if (watched == list_->viewport() && event->type() == QEvent::Wheel) {
        // Once it has scrolled, another clip is under the pointer, which has not moved.
        const QPoint place = static_cast<QWheelEvent*>(event)->position().toPoint();
        QTimer::singleShot(0, this, [this, place] { showPreview(list_->itemAt(place)); });
    }
    return QWidget::eventFilter(watched, event);
}

void ClipList::hideEvent(QHideEvent* event) {
    preview_.end();
    QWidget::hideEvent(event);
}

} // namespace prizma
