#include "ui/properties/number_field.h"

#include "ui/main_window/theme.h"
#include "ui/properties/expression.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace prizma {

NumberField::NumberField(QWidget* parent) : QAbstractSpinBox(parent) {
    setButtonSymbols(NoButtons);
    setKeyboardTracking(false);
    // A click may be the start of a drag: the focus comes with its release.
    setFocusPolicy(Qt::TabFocus);
    lineEdit()->setFocusPolicy(Qt::TabFocus);
    lineEdit()->installEventFilter(this);
    lineEdit()->setCursor(Qt::SizeHorCursor);
    lineEdit()->setAcceptDrops(false);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    stepPause_.setSingleShot(true);
    stepPause_.setInterval(700);
    connect(&stepPause_, &QTimer::timeout, this, &NumberField::gestureFinished);
    showValue();
}

void NumberField::setRange(double minimum, double maximum) {
    minimum_ = minimum;
    maximum_ = maximum;
}

void NumberField::setUnit(const QString& unit) {
    unit_ = unit;
    showValue();
}

void NumberField::setMarkColor(const QColor& color) {
    markColor_ = color;
    lineEdit()->setTextMargins(color.isValid() ? 3 : 0, 0, 0, 0);
}

void NumberField::setValue(double value) {
    value_ = value;
    if (!typing_)
        showValue();
}

void NumberField::setMixed(bool mixed) {
    mixed_ = mixed;
    if (!typing_)
        showValue();
}

QSize NumberField::sizeHint() const {
    return {fontMetrics().horizontalAdvance(QStringLiteral("-000.000")) + 16,
            QAbstractSpinBox::sizeHint().height()};
}

QSize NumberField::minimumSizeHint() const {
    return {36, QAbstractSpinBox::minimumSizeHint().height()};
}

QString NumberField::plainText() const {
    if (integer_)
        return QString::number(std::llround(value_));
    // Six digits are what fits and what anybody means; -0 is nothing that one wants to see.
    return QString::number(value_ == 0.0 ? 0.0 : value_, 'g', 6);
}

void NumberField::showValue() {
    QString text = mixed_ ? QStringLiteral("—") : plainText();
    if (!mixed_ && !unit_.isEmpty())
        text += unit_ == QStringLiteral("°") ? unit_ : QLatin1Char(' ') + unit_;
    lineEdit()->setText(text);
    lineEdit()->setCursorPosition(0);
    setFaulty(false);
}

void NumberField::setFaulty(bool faulty) {
    faulty_ = faulty;
    update();
}

void NumberField::edit(double value) {
    value = std::clamp(integer_ ? std::round(value) : value, minimum_, maximum_);
    const bool changed = value != value_ || mixed_;
    value_ = value;
    mixed_ = false;
    showValue();
    if (changed)
        Q_EMIT valueEdited(value);
}

void NumberField::startTyping() {
    typing_ = true;
    lineEdit()->setCursor(Qt::IBeamCursor);
    lineEdit()->setText(mixed_ ? QString() : plainText());
    lineEdit()->selectAll();
}

bool NumberField::commit() {
    if (!typing_ || !lineEdit()->isModified())
        return true;
    const auto typed = evaluate(lineEdit()->text(), unit_, value_);
    if (!typed)
        return false;
    edit(*typed);
    return true;
}

void NumberField::revert() {
    setFaulty(false);
    lineEdit()->setText(mixed_ ? QString() : plainText());
    lineEdit()->selectAll();
}

void NumberField::stepBy(int steps) {
    if (!commit())
        return;
    if (!stepPause_.isActive())
        Q_EMIT gestureStarted();
    stepPause_.start();
    double size = integer_ ? std::max(1.0, std::round(step_)) : step_;
    if (QApplication::keyboardModifiers().testFlag(Qt::ShiftModifier) && !integer_)
        size *= 0.1;
    edit(value_ + steps * size);
    if (typing_)
        revert(); // the plain number, selected
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!commit()) {
            setFaulty(true);
            return;
        }
        revert();
        return;
    case Qt::Key_Escape:
        revert();
        clearFocus();
        return;
    default:
        setFaulty(false);
        QAbstractSpinBox::keyPressEvent(event);
    }
}

void NumberField::wheelEvent(QWheelEvent* event) {
    // Scrolling a panel must not change what the pointer happens to pass.
    if (!hasFocus()) {
        event->ignore();
        return;
    }
    stepBy(event->angleDelta().y() > 0 ? 1 : event->angleDelta().y() < 0 ? -1 : 0);
    event->accept();
}

void NumberField::focusInEvent(QFocusEvent* event) {
    QAbstractSpinBox::focusInEvent(event);
    if (!typing_)
        startTyping();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    commit(); // what is no number is forgotten
    typing_ = event->reason() == Qt::PopupFocusReason && typing_;
    if (stepPause_.isActive()) {
        stepPause_.stop();
        Q_EMIT gestureFinished();
    }
    QAbstractSpinBox::focusOutEvent(event);
    if (!typing_) {
        lineEdit()->setCursor(Qt::SizeHorCursor);
        lineEdit()->deselect();
        showValue();
    }
}

void NumberField::contextMenuEvent(QContextMenuEvent* event) {
    if (!hasFocus())
        setFocus(Qt::MouseFocusReason);
    QAbstractSpinBox::contextMenuEvent(event);
}

void NumberField::paintEvent(QPaintEvent* event) {
    QAbstractSpinBox::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (markColor_.isValid())
        painter.fillRect(QRectF(2.0, 4.0, 2.0, height() - 8.0), markColor_);
    if (maximum_ - minimum_ == 1.0 && !mixed_) { // a share: show how much
        const double width = (QAbstractSpinBox::width() - 6.0) * (value_ - minimum_);
        painter.fillRect(QRectF(3.0, height() - 4.0, width, 2.0), theme::accent());
    }
    if (faulty_) {
        painter.setPen(QPen(theme::error(), 1.5));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 2.0, 2.0);
    }
}

bool NumberField::eventFilter(QObject* watched, QEvent* event) {
    if (dragging_ && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        cancelDrag();
        return true;
    }
    if (watched == lineEdit() && handleMouse(event))
        return true;
    return QAbstractSpinBox::eventFilter(watched, event);
}

bool NumberField::handleMouse(QEvent* event) {
    if (typing_ && !pressed_)
        return false; // the line edit's own business: cursor and selection
    const bool isMouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseMove ||
                         event->type() == QEvent::MouseButtonRelease ||
                         event->type() == QEvent::MouseButtonDblClick;
    if (!isMouse || !isEnabled())
        return false;
    const auto* mouse = static_cast<QMouseEvent*>(event);
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        if (mouse->button() != Qt::LeftButton)
            return dragging_;
        pressed_ = true;
        pressPosition_ = mouse->globalPosition().toPoint();
        return true;
    case QEvent::MouseMove: {
        if (!pressed_)
            return true;
        const int x = mouse->globalPosition().toPoint().x();
        if (!dragging_ && std::abs(x - pressPosition_.x()) >= QApplication::startDragDistance() / 2) {
            beginDrag();
            lastX_ = pressPosition_.x();
        }
        if (dragging_)
            dragBy(x - lastX_, mouse->modifiers());
        lastX_ = x;
        return true;
    }
    case QEvent::MouseButtonRelease:
        if (!pressed_ || mouse->button() != Qt::LeftButton)
            return true;
        pressed_ = false;
        if (dragging_)
            endDrag();
        else
            setFocus(Qt::MouseFocusReason);
        return true;
    default:
        return true; // a double click is two clicks
    }
}

void NumberField::beginDrag() {
    dragging_ = true;
    qApp->installEventFilter(this); // for Esc: a field that is dragged has no focus
    dragValue_ = valueBefore_ = value_;
    Q_EMIT gestureStarted();
}

void NumberField::dragBy(int pixels, Qt::KeyboardModifiers modifiers) {
    if (!dragging_ || pixels == 0)
        return;
    double perPixel = step_ * 0.2;
    if (modifiers.testFlag(Qt::ShiftModifier))
        perPixel *= 0.1;
    dragValue_ = std::clamp(dragValue_ + pixels * perPixel, minimum_, maximum_);
    // Dragging gives round numbers: a tenth of what one pixel means is lost on nobody.
    const double grain = std::pow(10.0, std::floor(std::log10(perPixel)));
    edit(modifiers.testFlag(Qt::ControlModifier) ? std::round(dragValue_ / step_) * step_
                                                 : std::round(dragValue_ / grain) * grain);
}

void NumberField::endDrag() {
    if (!dragging_)
        return;
    dragging_ = false;
    qApp->removeEventFilter(this);
    Q_EMIT gestureFinished();
}

void NumberField::cancelDrag() {
    if (!dragging_)
        return;
    pressed_ = false;
    edit(valueBefore_);
    endDrag();
}

} // namespace prizma
