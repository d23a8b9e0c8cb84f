#pragma once

#include "core/import/model_importer.h"

#include <QString>

#include <optional>

namespace prizma {

/// How model files of one kind (extension) in one folder are to be read, as the user chose it before.
/// Remembered in QSettings.
std::optional<ImportOptions> rememberedImportOptions(const QString& file);
void rememberImportOptions(const QString& file, const ImportOptions& options);
void forgetImportOptions();

/// What was chosen for the folder and kind; else what is usual for the kind.
ImportOptions importOptionsFor(const QString& file);

} // namespace prizma
