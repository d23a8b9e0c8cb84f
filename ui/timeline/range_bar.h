#pragma once

#include <QWidget>

class QBoxLayout;
class QToolButton;

namespace prizma {

class Document;
class NumberField;

/// The timeline's first and last frame and its frame rate.
class RangeBar : public QWidget {
    Q_OBJECT

  public:
    /// Keeps a reference to `document`.
    explicit RangeBar(Document& document, QWidget* parent = nullptr);

  private:
    NumberField* addField(QBoxLayout& layout, const QString& label, const char* key, bool integer);
    void refresh();
    void fit();

    Document& document_;
    NumberField* start_;
    NumberField* rate_;
    NumberField* end_;
    QToolButton* fit_;
    int gesture_ = 0;
};

} // namespace prizma
