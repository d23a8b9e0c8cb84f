#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

class QApplication;

namespace prizma {

/// The editor's looks: Fusion in dark grey with a blue accent.
void applyTheme(QApplication& application);

/// An icon of our own by that name, else one of the desktop's icon theme, else an empty one.
QIcon icon(const QString& name);

/// Colours that are not in the palette.
namespace theme {
QColor accent();
QColor error();
QColor axis(int index); ///< X red, Y green, Z blue; softened for a dark background.
QColor dim();           ///< Text that stands back.
QColor badge();         ///< Behind "Dynamic".
} // namespace theme

} // namespace prizma
