#include "ui/export/animation_export_dialog.h"

#include "ui/document/strings.h"
#include "ui/main_window/theme.h"
#include "ui/properties/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QStandardItemModel>
#include <QStandardPaths>
#include <QToolButton>

#include <array>

namespace prizma {
namespace {

const QString formatKey = QStringLiteral("animation/fileFormat");
const QString widthKey = QStringLiteral("animation/width");
const QString heightKey = QStringLiteral("animation/height");
const QString folderKey = QStringLiteral("folders/animation");
constexpr double largestSide = 32768.0;
constexpr double mostSamples = 1e6;
const QString numberMark = QStringLiteral("####");

NumberField* makeField(double value, double minimum, double maximum, const char* name) {
    auto* field = new NumberField;
    field->setObjectName(QString::fromLatin1(name));
    field->setInteger(true);
    field->setStep(1.0);
    field->setRange(minimum, maximum);
    field->setValue(value);
    return field;
}

/// The same file as another kind of output: with a place for the number if it is a sequence of pictures.
QString renamed(const QString& file, AnimationFormat format) {
    const QFileInfo info(file);
    QString base = info.completeBaseName();
    if (isVideo(format)) {
        base.remove(QLatin1Char('_') + numberMark).remove(QLatin1Char('#'));
        if (base.isEmpty())
            base = QStringLiteral("animation");
    } else if (!base.contains(QLatin1Char('#'))) {
        base += QLatin1Char('_') + numberMark;
    }
    return info.dir().filePath(base + QLatin1Char('.') + toQString(extensionOf(format)));
}

} // namespace

AnimationExportDialog::AnimationExportDialog(const Scene& scene, const QString& name, QWidget* parent)
    : QDialog(parent),
      fps_(scene.timeline.fps),
      format_(new QComboBox),
      output_(new QLineEdit),
      overwrite_(new QCheckBox(tr("Render frames &again that are there already"))),
      keepPictures_(new QCheckBox(tr("&Keep the pictures that the video is made of"))),
      note_(new QLabel),
      export_(nullptr) {
    setObjectName(QStringLiteral("animationExport"));
    setWindowTitle(tr("Export Animation"));
    setAttribute(Qt::WA_DeleteOnClose);
    makeFields(scene);
    auto* form = new QFormLayout;
    form->addRow(tr("&Format:"), format_);
    form->addRow(tr("F&rames:"), makePair(first_, tr("to"), last_));
    form->addRow(tr("Si&ze:"), makePair(width_, QStringLiteral("×"), height_));
    form->addRow(tr("&Samples a pixel:"), samples_);
    form->addRow(tr("&Output:"), makeOutputRow());
    note_->setObjectName(QStringLiteral("exportNote"));
    note_->setWordWrap(true);
    note_->setMinimumHeight(2 * fontMetrics().height());
    note_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    export_ = buttons->button(QDialogButtonBox::Ok);
    export_->setText(tr("&Export"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addLayout(form);
    layout->addWidget(overwrite_);
    layout->addWidget(keepPictures_);
    layout->addWidget(note_);
    layout->addWidget(buttons);
    setMinimumWidth(480);

    recall(name);
    connect(format_, &QComboBox::currentIndexChanged, this, &AnimationExportDialog::changeFormat);
    connect(output_, &QLineEdit::textChanged, this, &AnimationExportDialog::check);
    connect(overwrite_, &QCheckBox::toggled, this, &AnimationExportDialog::check);
    for (NumberField* field : {first_, last_, width_, height_, samples_})
        connect(field, &NumberField::valueEdited, this, &AnimationExportDialog::check);
    changeFormat();
}

void AnimationExportDialog::makeFields(const Scene& scene) {
    format_->setObjectName(QStringLiteral("format"));
    format_->addItems({tr("PNG pictures"), tr("PNG pictures of 16 bits a channel"),
                       tr("OpenEXR pictures (linear, 32 bits)"), tr("MP4 video (H.264)"),
                       tr("WebM video (VP9)")});
    if (!isVideoEncoderInstalled())
        for (const AnimationFormat video : {AnimationFormat::Mp4, AnimationFormat::WebM}) {
            const auto row = static_cast<int>(video);
            static_cast<QStandardItemModel*>(format_->model())->item(row)->setEnabled(false);
            format_->setItemData(row, tr("Needs the program ffmpeg (on Debian: sudo apt install ffmpeg)"),
                                 Qt::ToolTipRole);
        }
    first_ = makeField(scene.timeline.start, -Timeline::furthestFrame, Timeline::furthestFrame, "firstFrame");
    last_ = makeField(scene.timeline.end, -Timeline::furthestFrame, Timeline::furthestFrame, "lastFrame");
    width_ = makeField(1280.0, 1.0, largestSide, "width");
    height_ = makeField(720.0, 1.0, largestSide, "height");
    samples_ = makeField(scene.render.samples, 1.0, mostSamples, "samples");
    output_->setObjectName(QStringLiteral("output"));
    output_->setToolTip(tr("A run of # stands for the number of the frame"));
}

QWidget* AnimationExportDialog::makePair(NumberField* first, const QString& between, NumberField* second) {
    auto* pair = new QWidget;
    auto* layout = new QHBoxLayout(pair);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(first, 1);
    layout->addWidget(new QLabel(between));
    layout->addWidget(second, 1);
    pair->setFocusProxy(first);
    return pair;
}

QWidget* AnimationExportDialog::makeOutputRow() {
    auto* browse = new QToolButton;
    browse->setIcon(icon(QStringLiteral("document-open")));
    browse->setToolTip(tr("Choose the folder and the name"));
    connect(browse, &QToolButton::clicked, this, &AnimationExportDialog::browse);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(output_, 1);
    layout->addWidget(browse);
    row->setFocusProxy(output_);
    return row;
}

void AnimationExportDialog::recall(const QString& name) {
    const QSettings settings;
    const int format = settings.value(formatKey, 0).toInt();
    const bool possible = format >= 0 && format < format_->count() &&
                          (isVideoEncoderInstalled() || !isVideo(static_cast<AnimationFormat>(format)));
    format_->setCurrentIndex(possible ? format : 0);
    width_->setValue(settings.value(widthKey, 1280).toInt());
    height_->setValue(settings.value(heightKey, 720).toInt());
    QString folder = settings.value(folderKey).toString();
    if (folder.isEmpty() || !QFileInfo(folder).isDir())
        folder = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
    output_->setText(renamed(QDir(folder).filePath(name + QStringLiteral(".png")), this->format()));
}

AnimationFormat AnimationExportDialog::format() const {
    return static_cast<AnimationFormat>(format_->currentIndex());
}

void AnimationExportDialog::setOutput(const QString& file) {
    output_->setText(file);
}

void AnimationExportDialog::browse() {
    auto* dialog = new QFileDialog(this, tr("Export the Animation"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(toQString(extensionOf(format())));
    dialog->setDirectory(QFileInfo(output_->text()).dir());
    dialog->selectFile(QFileInfo(output_->text()).fileName());
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& file) { output_->setText(renamed(file, format())); });
    dialog->open();
}

void AnimationExportDialog::changeFormat() {
    output_->setText(renamed(output_->text(), format()));
    keepPictures_->setEnabled(isVideo(format()));
    check();
}

void AnimationExportDialog::check() {
    const AnimationExport wanted = animation();
    const std::string fault = findFault(wanted);
    export_->setEnabled(fault.empty());
    QPalette palette = note_->palette();
    palette.setColor(QPalette::WindowText, fault.empty() ? theme::dim() : theme::error());
    note_->setPalette(palette);
    if (!fault.empty()) {
        note_->setText(tr("This cannot be exported: %1.").arg(translated(fault)));
        return;
    }
    const int count = wanted.last - wanted.first + 1;
    const int finished = finishedFrames(wanted);
    if (finished > 0)
        note_->setText(
            tr("%1 of %2 frames are there already and stay as they are.").arg(finished).arg(count));
    else
        note_->setText(count == 1 ? tr("One frame will be rendered.")
                                  : tr("%n frames will be rendered.", nullptr, count));
}

AnimationExport AnimationExportDialog::animation() const {
    AnimationExport animation;
    animation.format = format();
    animation.picture.width = static_cast<int>(width_->value());
    animation.picture.height = static_cast<int>(height_->value());
    animation.picture.samples = static_cast<int>(samples_->value());
    animation.first = static_cast<int>(first_->value());
    animation.last = static_cast<int>(last_->value());
    animation.fps = fps_;
    animation.output = toStdString(output_->text());
    animation.overwrite = overwrite_->isChecked();
    animation.keepPictures = keepPictures_->isChecked();
    return animation;
}

void AnimationExportDialog::accept() {
    QSettings settings;
    settings.setValue(formatKey, format_->currentIndex());
    settings.setValue(widthKey, static_cast<int>(width_->value()));
    settings.setValue(heightKey, static_cast<int>(height_->value()));
    settings.setValue(folderKey, QFileInfo(output_->text()).absolutePath());
    QDialog::accept();
}

} // namespace prizma
