#pragma once

#include "ui/properties/value_editor.h"

#include <QPixmap>

class QLabel;
class QLineEdit;
class QToolButton;

namespace prizma {

/// A picture file: a thumbnail, its path, and buttons to choose and to remove it. Reading the file is left to
/// who listens to `fileChosen`.
class TextureEditor : public ValueEditor {
    Q_OBJECT

  public:
    TextureEditor();
    void show(const std::vector<PropertyValue>& values) override;

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void browse();
    void showTexture(const Texture& texture, bool mixed);

    QLabel* thumbnail_;
    QLineEdit* path_;
    QToolButton* clear_;
    Texture shown_;
};

/// A small picture of `image` of at most `size` pixels each way; a null one for none.
QPixmap thumbnailOf(const ImagePtr& image, int size);

} // namespace prizma
