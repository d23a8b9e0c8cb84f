#pragma once

#include <QAbstractSpinBox>
#include <QTimer>

namespace prizma {

/// A number that can be typed (also as an expression), dragged, stepped with the arrow keys, and turned with
/// the wheel while it has the focus.
class NumberField : public QAbstractSpinBox {
    Q_OBJECT

  public:
    explicit NumberField(QWidget* parent = nullptr);

    void setRange(double minimum, double maximum);
    void setStep(double step) { step_ = step; }
    void setUnit(const QString& unit);
    void setInteger(bool integer) { integer_ = integer; }
    void setMarkColor(const QColor& color); ///< A stripe at the left edge, for X, Y and Z.

    double value() const { return value_; }
    void setValue(double value); ///< Tells nobody. What is being typed stays.
    void setMixed(bool mixed);   ///< Several values are meant: shown as a dash.

    /// For labels that can be dragged in the field's stead.
    void beginDrag();
    void dragBy(int pixels, Qt::KeyboardModifiers modifiers);
    void endDrag();
    void cancelDrag();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    void stepBy(int steps) override;

  Q_SIGNALS:
    void gestureStarted(); ///< Values until `gestureFinished` belong together.
    void valueEdited(double value);
    void gestureFinished();

  protected:
    StepEnabled stepEnabled() const override { return StepUpEnabled | StepDownEnabled; }
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    bool handleMouse(QEvent* event);
    void startTyping();
    bool commit(); ///< What was typed becomes the value; false if it is no number.
    void revert();
    void edit(double value);
    void showValue();
    void setFaulty(bool faulty);
    QString plainText() const;

    double value_ = 0.0;
    double minimum_ = -1e9;
    double maximum_ = 1e9;
    double step_ = 0.1;
    bool integer_ = false;
    bool mixed_ = false;
    bool typing_ = false;
    bool faulty_ = false;
    QString unit_;
    QColor markColor_;

    bool pressed_ = false;
    bool dragging_ = false;
    QPoint pressPosition_;
    int lastX_ = 0;
    double dragValue_ = 0.0;   ///< Before rounding and clamping, so that slow drags add up.
    double valueBefore_ = 0.0; ///< The drag's or the gesture's start.
    QTimer stepPause_;         ///< Steps in quick succession are one gesture.
};

} // namespace prizma
