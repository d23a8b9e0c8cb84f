#pragma once

#include <QObject>

#include <functional>

class QWidget;

namespace prizma {

class Document;

/// Stands between the document and whatever would throw its unsaved work away.
class UnsavedChanges : public QObject {
    Q_OBJECT

  public:
    /// `save` saves the document and calls what it is given once that has worked.
    using Save = std::function<void(std::function<void()> whenSaved)>;

    /// The question is asked in front of `window`.
    UnsavedChanges(Document& document, Save save, QWidget& window);

    /// Calls `proceed` at once if nothing would be lost; else asks first, and calls it after Save or Discard.
    void guard(std::function<void()> proceed);

  private:
    Document& document_;
    Save save_;
    QWidget& window_;
    bool asking_ = false;
};

} // namespace prizma
