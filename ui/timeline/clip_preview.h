#pragma once

#include "core/scene/id.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <string>

namespace prizma {

class Document;
class TimelineController;

/// Lets the view show how an object plays a clip that it does not play (yet): from the clip's beginning in
/// real time, or as the timeline goes while that is playing. The rest of the scene stands still or plays on,
/// and the document is not altered.
class ClipPreview : public QObject {
    Q_OBJECT

  public:
    /// Keeps references to both.
    ClipPreview(Document& document, const TimelineController& controller, QObject* parent = nullptr);

    void show(Id object, const std::string& clip); ///< Empty: the bind pose.
    void end();

  private:
    void apply();

    Document& document_;
    const TimelineController& controller_;
    QTimer timer_; ///< Runs while there is a preview only.
    QElapsedTimer elapsed_;
    Id object_ = noId;
    std::string clip_;
};

} // namespace prizma
