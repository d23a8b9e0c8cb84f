#include "ui/properties/texture_editor.h"

#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/properties/color_editor.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QToolButton>

#include <algorithm>

namespace prizma {
namespace {

constexpr int thumbnailSize = 22;

/// Linear floats, sampled at the thumbnail's own size: an environment map has far more pixels than are shown.
QImage sampleFloats(const Image& image, int width, int height) {
    QImage picture(width, height, QImage::Format_RGB32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto column = static_cast<std::size_t>(x) * static_cast<std::size_t>(image.width) /
                                static_cast<std::size_t>(width);
            const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.height) /
                             static_cast<std::size_t>(height);
            const float* pixel = &image.floats[(row * static_cast<std::size_t>(image.width) + column) * 4];
            picture.setPixelColor(x, y, displayColor({pixel[0], pixel[1], pixel[2]}));
        }
    return picture;
}

QString localFile(const QMimeData* data) {
    return data->urls().size() == 1 ? data->urls().first().toLocalFile() : QString();
}

bool isPicture(const QString& file) {
    static const QStringList kinds{QStringLiteral("png"), QStringLiteral("jpg"), QStringLiteral("jpeg"),
                                   QStringLiteral("bmp"), QStringLiteral("tga"), QStringLiteral("gif"),
                                   QStringLiteral("psd"), QStringLiteral("hdr"), QStringLiteral("exr")};
    return kinds.contains(QFileInfo(file).suffix().toLower());
}

} // namespace

QPixmap thumbnailOf(const ImagePtr& image, int size) {
    if (!image || image->width <= 0 || image->height <= 0)
        return {};
    if (image->bytes.empty()) {
        const int longest = std::max(image->width, image->height);
        return QPixmap::fromImage(sampleFloats(*image, std::max(1, image->width * size / longest),
                                               std::max(1, image->height * size / longest)));
    }
    const QImage whole(image->bytes.data(), image->width, image->height, image->width * 4,
                       QImage::Format_RGBA8888);
    return QPixmap::fromImage(whole.scaled(size, size, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

TextureEditor::TextureEditor() : thumbnail_(new QLabel), path_(new QLineEdit), clear_(new QToolButton) {
    setAcceptDrops(true);
    thumbnail_->setFixedSize(thumbnailSize, thumbnailSize);
    thumbnail_->setAlignment(Qt::AlignCenter);
    path_->setObjectName(QStringLiteral("texturePath"));
    path_->setPlaceholderText(tr("None"));
    path_->setAcceptDrops(false);
    auto* choose = new QToolButton;
    choose->setIcon(icon(QStringLiteral("document-open")));
    choose->setToolTip(tr("Choose a picture…"));
    choose->setAutoRaise(true);
    clear_->setIcon(icon(QStringLiteral("clear")));
    clear_->setToolTip(tr("Remove the picture"));
    clear_->setAutoRaise(true);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(3);
    for (QWidget* widget : std::initializer_list<QWidget*>{thumbnail_, path_, choose, clear_})
        row->addWidget(widget);
    setFocusProxy(path_);
    connect(choose, &QToolButton::clicked, this, &TextureEditor::browse);
    connect(clear_, &QToolButton::clicked, this, [this] { editAll(Texture{}); });
    connect(path_, &QLineEdit::editingFinished, this, [this] {
        if (!path_->isModified())
            return;
        path_->setModified(false);
        if (path_->text().trimmed().isEmpty())
            editAll(Texture{});
        else
            Q_EMIT fileChosen(QFileInfo(path_->text().trimmed()).absoluteFilePath());
    });
}

void TextureEditor::show(const std::vector<PropertyValue>& values) {
    const bool mixed =
        std::any_of(values.begin(), values.end(), [&](const PropertyValue& v) { return v != values.back(); });
    showTexture(std::get<Texture>(values.back()), mixed);
}

void TextureEditor::showTexture(const Texture& texture, bool mixed) {
    const QString file = toQString(texture.file);
    if (texture.image != shown_.image || thumbnail_->pixmap().isNull())
        thumbnail_->setPixmap(thumbnailOf(texture.image, thumbnailSize));
    shown_ = texture;
    thumbnail_->setVisible(!thumbnail_->pixmap().isNull());
    clear_->setVisible(texture.isSet() || mixed);
    if (path_->isModified() && path_->hasFocus())
        return; // somebody types
    path_->setPlaceholderText(mixed ? QStringLiteral("—") : tr("None"));
    path_->setText(mixed ? QString() : file);
    path_->setCursorPosition(static_cast<int>(file.size())); // the name matters, not the folder
    const bool lost = texture.isSet() && !texture.image;
    path_->setToolTip(lost ? tr("%1 could not be read.").arg(file) : file);
    QPalette colors = palette();
    if (lost)
        colors.setColor(QPalette::Text, theme::error());
    path_->setPalette(colors);
}

void TextureEditor::browse() {
    auto* dialog =
        new QFileDialog(this, tr("Choose a Picture"), QFileInfo(toQString(shown_.file)).absolutePath());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters(
        {tr("Pictures (*.png *.jpg *.jpeg *.bmp *.tga *.gif *.psd *.hdr *.exr)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &TextureEditor::fileChosen);
    dialog->open();
}

void TextureEditor::dragEnterEvent(QDragEnterEvent* event) {
    if (isPicture(localFile(event->mimeData())))
        event->acceptProposedAction();
}

void TextureEditor::dropEvent(QDropEvent* event) {
    Q_EMIT fileChosen(localFile(event->mimeData()));
    event->acceptProposedAction();
}

} // namespace prizma
