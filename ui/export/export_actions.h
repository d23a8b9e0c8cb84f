#pragma once

#include "core/diagnostic.h"
#include "core/render/animation_export.h"

#include <QList>
#include <QObject>

class QAction;
class QWidget;

namespace prizma {

class AnimationExporter;
class Document;
class ImageExporter;
class RenderSession;

/// File > Export Image and Export Animation: asks, exports in the background, and shows how far that is.
class ExportActions : public QObject {
    Q_OBJECT

  public:
    /// Keeps references to all of them.
    ExportActions(Document& document, RenderSession& session, QWidget& window);

    QList<QAction*> actions() const { return {exportImage_, exportAnimation_}; }
    ImageExporter& imageExporter() { return *imageExporter_; }
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
    ImageExporter* imageExporter_;
    AnimationExporter* exporter_;
    QAction* exportImage_;
    QAction* exportAnimation_;
};

} // namespace prizma
