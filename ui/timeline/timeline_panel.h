#pragma once

#include <QWidget>

namespace prizma {

class ClipList;
class ClipPreview;
class Document;
class PlaybackActions;
class TimelineController;
class TimelineRuler;

/// The timeline: the clips to choose from, the buttons, and the ruler to scrub on.
class TimelinePanel : public QWidget {
    Q_OBJECT

  public:
    /// Keeps references to `document` and `controller`.
    TimelinePanel(Document& document, TimelineController& controller, const PlaybackActions& actions,
                  QWidget* parent = nullptr);

    TimelineRuler& ruler() { return *ruler_; }
    ClipList& clips() { return *clips_; }

  private:
    ClipPreview* preview_;
    ClipList* clips_;
    TimelineRuler* ruler_;
};

} // namespace prizma
