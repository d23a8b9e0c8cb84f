#include "ui/properties/simple_editors.h"

#include "ui/document/strings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QWheelEvent>

#include <algorithm>

namespace prizma {
namespace {

bool areMixed(const std::vector<PropertyValue>& values) {
    return std::any_of(values.begin(), values.end(),
                       [&](const PropertyValue& v) { return v != values.back(); });
}

/// A combo box that leaves the wheel to the panel unless it has the focus.
class CalmComboBox : public QComboBox {
  public:
    CalmComboBox() { setFocusPolicy(Qt::StrongFocus); }

  protected:
    void wheelEvent(QWheelEvent* event) override {
        if (hasFocus())
            QComboBox::wheelEvent(event);
        else
            event->ignore();
    }
};

void fill(QWidget* editor, QWidget* content) {
    auto* row = new QHBoxLayout(editor);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(content);
    editor->setFocusProxy(content);
}

} // namespace

BooleanEditor::BooleanEditor() : box_(new QCheckBox) {
    fill(this, box_);
    connect(box_, &QCheckBox::clicked, this, [this](bool checked) { editAll(checked); });
}

void BooleanEditor::show(const std::vector<PropertyValue>& values) {
    const bool mixed = areMixed(values);
    box_->setTristate(mixed);
    box_->setCheckState(mixed                           ? Qt::PartiallyChecked
                        : std::get<bool>(values.back()) ? Qt::Checked
                                                        : Qt::Unchecked);
}

ChoiceEditor::ChoiceEditor(std::vector<ShownChoice> choices)
    : choices_(std::move(choices)), box_(new CalmComboBox) {
    for (const ShownChoice& choice : choices_)
        box_->addItem(choice.label);
    box_->setMinimumContentsLength(6);
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    fill(this, box_);
    connect(box_, &QComboBox::activated, this,
            [this](int index) { editAll(choices_[static_cast<std::size_t>(index)].key); });
}

void ChoiceEditor::show(const std::vector<PropertyValue>& values) {
    const auto& key = std::get<std::string>(values.back());
    const auto found = std::find_if(choices_.begin(), choices_.end(),
                                    [&](const ShownChoice& choice) { return choice.key == key; });
    box_->setPlaceholderText(QStringLiteral("—"));
    box_->setCurrentIndex(
        areMixed(values) || found == choices_.end() ? -1 : static_cast<int>(found - choices_.begin()));
}

TextEditor::TextEditor() : line_(new QLineEdit) {
    fill(this, line_);
    line_->installEventFilter(this);
    line_->setAcceptDrops(false);
    connect(line_, &QLineEdit::editingFinished, this, [this] {
        if (line_->text() == shown_)
            return;
        shown_ = line_->text();
        editAll(toStdString(shown_));
    });
}

void TextEditor::show(const std::vector<PropertyValue>& values) {
    const bool mixed = areMixed(values);
    const bool typing = line_->hasFocus() && line_->text() != shown_;
    shown_ = mixed ? QString() : toQString(std::get<std::string>(values.back()));
    line_->setPlaceholderText(mixed ? QStringLiteral("—") : QString());
    if (!typing)
        line_->setText(shown_);
}

bool TextEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        line_->setText(shown_);
        line_->clearFocus();
        return true;
    }
    return ValueEditor::eventFilter(watched, event);
}

} // namespace prizma
