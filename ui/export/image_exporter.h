#pragma once

#include "core/diagnostic.h"
#include "core/render/picture.h"

#include <QObject>

class QWidget;

namespace prizma {

class Document;
class RenderSession;

/// Saves what the view has rendered so far, at the view's size and never denoised. Works in the background.
class ImageExporter : public QObject {
    Q_OBJECT

  public:
    /// Keeps references to all of them.
    ImageExporter(Document& document, RenderSession& session, QWidget& window);

    void ask(); ///< Where to and in which format, and saves there.

    /// Takes the picture as soon as each pixel has a sample; `message` tells how it went.
    void exportTo(const QString& file, PictureFormat format);

  Q_SIGNALS:
    void message(const prizma::Diagnostic& diagnostic);

  private:
    void write(const QString& file, PictureFormat format, const Picture& picture);

    Document& document_;
    RenderSession& session_;
    QWidget& window_;
};

} // namespace prizma
