#pragma once

#include "core/diagnostic.h"
#include "core/render/animation_export.h"

#include <QObject>

class QAction;
class QWidget;

namespace prizma {

class AnimationExporter;
class Document;
class RenderSession;

/// File > Export Animation: asks, exports in the background, and shows how far that is.
class ExportActions : public QObject {
    Q_OBJECT

  public:
    /// Keeps references to all of them.
    ExportActions(Document& document, RenderSession& session, QWidget& window);

    QAction* exportAnimation() const { return exportAnimation_; }
    AnimationExporter& exporter() { return *exporter_; }

  Q_SIGNALS:
    void message(const prizma::Diagnostic& diagnostic);

  private:
    void ask();
    void start(const AnimationExport& animation);
    void showProgress();

    Document& document_;
    RenderSession& session_;
    QWidget& window_;
    AnimationExporter* exporter_;
    QAction* exportAnimation_;
};

} // namespace prizma
