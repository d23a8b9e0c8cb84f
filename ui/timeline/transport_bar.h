#pragma once

#include <QWidget>

class QToolButton;

namespace prizma {

class Document;
class NumberField;
class PlaybackActions;
class TimelineController;

/// The timeline's buttons, its speed, and where it is in frames and in seconds.
class TransportBar : public QWidget {
    Q_OBJECT

  public:
    /// Keeps references to `document` and `controller`.
    TransportBar(Document& document, TimelineController& controller, const PlaybackActions& actions,
                 QWidget* parent = nullptr);

  private:
    QToolButton* addButton(QAction* action);
    NumberField* addField(const QString& label, const char* name, const QString& tip, const QString& longest);
    void makeModeButton(const PlaybackActions& actions);
    void makeFields();
    void showPlace();
    void showSettings();

    Document& document_;
    TimelineController& controller_;
    QToolButton* mode_ = nullptr;
    NumberField* speed_ = nullptr;
    NumberField* frame_ = nullptr;
    NumberField* time_ = nullptr;
};

} // namespace prizma
