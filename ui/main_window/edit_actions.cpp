#include "ui/main_window/edit_actions.h"

#include "core/scene/property_tables.h"
#include "ui/document/document.h"
#include "ui/document/edits.h"
#include "ui/main_window/theme.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/scene_tree/entity_icon.h"

#include <QAction>
#include <QMenu>

namespace prizma {
namespace {

/// One entry for each value of `Enum`.
template <class Enum, class MakeIcon, class Add>
void addChoices(QMenu& menu, MakeIcon makeIcon, Add add) {
    for (std::size_t i = 0; i < choicesOf<Enum>().size(); ++i) {
        const auto value = static_cast<Enum>(i);
        menu.addAction(makeIcon(value), labelOf(value), &menu, [add, value] { add(value); });
    }
}

} // namespace

EditActions::EditActions(Document& document, QWidget& window)
    : QObject(&window),
      document_(document),
      window_(window),
      delete_(new QAction(icon(QStringLiteral("edit-delete")), tr("&Delete"), this)),
      duplicate_(new QAction(icon(QStringLiteral("edit-duplicate")), tr("D&uplicate"), this)) {
    delete_->setShortcut(Qt::Key_Delete);
    delete_->setStatusTip(tr("Remove what is selected from the scene"));
    duplicate_->setShortcut(Qt::CTRL | Qt::Key_D);
    duplicate_->setStatusTip(tr("Put a copy beside what is selected"));
    connect(delete_, &QAction::triggered, this, [this] { deleteSelected(document_); });
    connect(duplicate_, &QAction::triggered, this, [this] { duplicateSelected(document_); });
    connect(&document_, &Document::selectionChanged, this, &EditActions::updateEnabled);
    updateEnabled();
}

void EditActions::updateEnabled() {
    const bool any = hasRemovableSelection(document_);
    delete_->setEnabled(any);
    duplicate_->setEnabled(any);
}

void EditActions::fillEditMenu(QMenu& menu) {
    QAction* undo = document_.undoStack().createUndoAction(this, tr("&Undo"));
    undo->setIcon(icon(QStringLiteral("edit-undo")));
    undo->setShortcut(Qt::CTRL | Qt::Key_Z);
    QAction* redo = document_.undoStack().createRedoAction(this, tr("&Redo"));
    redo->setIcon(icon(QStringLiteral("edit-redo")));
    redo->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
    menu.addActions({undo, redo});
    menu.addSeparator();
    menu.addActions({duplicate_, delete_});
    QAction* all = menu.addAction(icon(QStringLiteral("edit-select-all")), tr("Select &All"), this,
                                  [this] { selectAll(document_); });
    all->setShortcut(Qt::CTRL | Qt::Key_A);
    all->setStatusTip(tr("Select all objects and lights"));
    QAction* none = menu.addAction(tr("Select &None"), this, [this] { document_.setSelection({}); });
    none->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_A);
    menu.addSeparator();
    QAction* preferences =
        menu.addAction(icon(QStringLiteral("configure")), tr("&Preferences…"), this, [this] {
            auto* dialog = new PreferencesDialog(&window_);
            dialog->open();
        });
    preferences->setShortcut(Qt::CTRL | Qt::Key_Comma);
    preferences->setMenuRole(QAction::PreferencesRole);
}

void EditActions::fillAddMenu(QMenu& menu) {
    QMenu* primitives = menu.addMenu(icon(QStringLiteral("object")), tr("&Primitive"));
    addChoices<PrimitiveType>(*primitives, primitiveIcon,
                              [this](PrimitiveType type) { addPrimitive(document_, type); });
    QMenu* lights = menu.addMenu(icon(QStringLiteral("light-point")), tr("&Light"));
    addChoices<LightType>(*lights, lightIcon, [this](LightType type) { addLight(document_, type); });
    menu.addAction(icon(QStringLiteral("material")), tr("&Material"), this,
                   [this] { addMaterial(document_); });
}

} // namespace prizma
