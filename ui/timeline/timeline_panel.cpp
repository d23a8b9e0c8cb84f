#include "ui/timeline/timeline_panel.h"

#include "ui/document/document.h"
#include "ui/timeline/clip_list.h"
#include "ui/timeline/clip_preview.h"
#include "ui/timeline/range_bar.h"
#include "ui/timeline/timeline_ruler.h"
#include "ui/timeline/transport_bar.h"

#include <QHBoxLayout>
#include <QSplitter>
#include <QVBoxLayout>

namespace prizma {

TimelinePanel::TimelinePanel(Document& document, TimelineController& controller,
                             const PlaybackActions& actions, QWidget* parent)
    : QWidget(parent),
      preview_(new ClipPreview(document, controller, this)),
      clips_(new ClipList(document, controller, *preview_)),
      ruler_(new TimelineRuler(document, controller)) {
    auto* right = new QWidget;
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(8, 6, 8, 6);
    column->setSpacing(6);
    column->addWidget(new TransportBar(document, controller, actions));
    column->addWidget(ruler_, 1);
    column->addWidget(new RangeBar(document));

    auto* splitter = new QSplitter(Qt::Horizontal);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(clips_);
    splitter->addWidget(right);
    splitter->setStretchFactor(0, 0);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({230, 500});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(splitter);
}

} // namespace prizma
