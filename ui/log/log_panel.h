#pragma once

#include "core/diagnostic.h"

#include <QWidget>

#include <vector>

class QTreeWidget;

namespace prizma {

/// All messages of this session, the newest last. Asks to be shown when an error comes.
class LogPanel : public QWidget {
    Q_OBJECT

  public:
    explicit LogPanel(QWidget* parent = nullptr);

    /// A message that equals the last one is counted instead of repeated.
    void add(const Diagnostic& diagnostic);
    void clear();

    int count() const;
    Diagnostic at(int row) const;

  Q_SIGNALS:
    void errorAdded();
    void jumpRequested(const prizma::Diagnostic& diagnostic); ///< Double click: show what it is about.

  private:
    void copy() const;
    void showMenu(const QPoint& position);

    QTreeWidget* list_;
    std::vector<Diagnostic> messages_;
    int repeats_ = 0; ///< Of the last message.
};

} // namespace prizma
