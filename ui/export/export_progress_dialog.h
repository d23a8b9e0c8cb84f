#pragma once

#include <QDialog>
#include <QElapsedTimer>

class QLabel;
class QProgressBar;

namespace prizma {

class AnimationExporter;

/// How far an export is and how long it may still take. Closing it lets the export go on.
class ExportProgressDialog : public QDialog {
    Q_OBJECT

  public:
    /// Keeps a reference to `exporter`; closes itself when that is done.
    explicit ExportProgressDialog(AnimationExporter& exporter, QWidget* parent = nullptr);

  private:
    void showProgress(double fraction);
    QString timeLeft(double fraction);

    AnimationExporter& exporter_;
    QLabel* text_;
    QLabel* left_;
    QProgressBar* bar_;
    QElapsedTimer clock_;
    double firstFraction_ = -1.0; ///< When `clock_` started: frames that were there before took no time.
};

} // namespace prizma
