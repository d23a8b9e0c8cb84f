#pragma once

#include "core/scene/clip.h"
#include "core/scene/id.h"

#include <QWidget>

#include <vector>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace prizma {

class ClipPreview;
class Document;
class TimelineController;

/// The clips of the object that the timeline is about. Clicking one (or Return) chooses it, a double click
/// fits the timeline to it; under the pointer, or under the keyboard's cursor, it plays in the view as a
/// preview.
class ClipList : public QWidget {
    Q_OBJECT

  public:
    /// Keeps references to all of them.
    ClipList(Document& document, const TimelineController& controller, ClipPreview& preview,
             QWidget* parent = nullptr);

    QTreeWidget& list() { return *list_; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void refresh();
    void rebuild();
    void showChosen();
    void choose(QTreeWidgetItem* item);
    void fit(QTreeWidgetItem* item);
    void showPreview(QTreeWidgetItem* item);

    Document& document_;
    const TimelineController& controller_;
    ClipPreview& preview_;
    QTreeWidget* list_;
    QLabel* hint_;     ///< In the list's stead while there is nothing to list.
    Id object_ = noId; ///< Whose clips are listed; noId: nobody's.
    std::vector<ClipPtr> clips_;
    bool updating_ = false; ///< The current row changes, but not by a person.
};

} // namespace prizma
