#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QFileDialog;

namespace prizma {

/// Opens a dialog that deletes itself, in the folder where the last one for this `purpose` was unless it has
/// one already, and calls `use` with what was chosen. Does not wait.
void showFileDialog(QFileDialog* dialog, const QString& purpose, std::function<void(const QStringList&)> use);

} // namespace prizma
