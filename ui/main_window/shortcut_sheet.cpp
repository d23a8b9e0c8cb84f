#include "ui/main_window/shortcut_sheet.h"

#include "ui/main_window/theme.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace prizma {
namespace {

QString plain(QString text) {
    text.remove(QLatin1Char('&'));
    return text;
}

QTreeWidgetItem* addGroup(QTreeWidget& list, const QString& title) {
    auto* group = new QTreeWidgetItem(&list, {title});
    QFont bold = list.font();
    bold.setBold(true);
    group->setFont(0, bold);
    group->setFlags(Qt::ItemIsEnabled);
    return group;
}

void addMenu(QTreeWidgetItem& group, const QMenu& menu, const QString& prefix) {
    for (const QAction* action : menu.actions()) {
        if (action->isSeparator())
            continue;
        const QString text = plain(action->text());
        if (const QMenu* sub = action->menu()) {
            addMenu(group, *sub, prefix + text + QStringLiteral(" › "));
            continue;
        }
        QStringList keys;
        for (const QKeySequence& key : action->shortcuts())
            keys += key.toString(QKeySequence::NativeText);
        auto* item = new QTreeWidgetItem(&group, {prefix + text, keys.join(QStringLiteral(", "))});
        item->setIcon(0, action->icon());
    }
}

void addGestures(QTreeWidgetItem& group) {
    const QList<QStringList> gestures{
        {ShortcutSheet::tr("Orbit"), ShortcutSheet::tr("Left drag")},
        {ShortcutSheet::tr("Pan"), ShortcutSheet::tr("Middle drag, Shift+left drag")},
        {ShortcutSheet::tr("Zoom to the pointer"), ShortcutSheet::tr("Wheel, right drag")},
        {ShortcutSheet::tr("Select"), ShortcutSheet::tr("Click")},
        {ShortcutSheet::tr("Cancel a drag"), ShortcutSheet::tr("Esc")},
        {ShortcutSheet::tr("Menu of the view"), ShortcutSheet::tr("Right click")},
    };
    for (const QStringList& gesture : gestures)
        new QTreeWidgetItem(&group, gesture);
}

void addTimeline(QTreeWidgetItem& group) {
    const QList<QStringList> gestures{
        {ShortcutSheet::tr("Move in time"), ShortcutSheet::tr("Left drag on the ruler")},
        {ShortcutSheet::tr("… also between frames"), ShortcutSheet::tr("Shift while dragging")},
        {ShortcutSheet::tr("Zoom and move the ruler"), ShortcutSheet::tr("Wheel, middle drag")},
        {ShortcutSheet::tr("Show the whole ruler"), ShortcutSheet::tr("Double click")},
        {ShortcutSheet::tr("See what a clip looks like"), ShortcutSheet::tr("Point at it, Up, Down")},
        {ShortcutSheet::tr("Choose a clip"), ShortcutSheet::tr("Click, Return")},
        {ShortcutSheet::tr("Fit the timeline to a clip"), ShortcutSheet::tr("Double click")},
    };
    for (const QStringList& gesture : gestures)
        new QTreeWidgetItem(&group, gesture);
}

void addFields(QTreeWidgetItem& group) {
    const QList<QStringList> fields{
        {ShortcutSheet::tr("Change a number"), ShortcutSheet::tr("Drag the field or its name")},
        {ShortcutSheet::tr("… finely / in whole steps"), ShortcutSheet::tr("Shift / Ctrl while dragging")},
        {ShortcutSheet::tr("Step a number"), ShortcutSheet::tr("Up, Down, wheel")},
        {ShortcutSheet::tr("Type an expression"), QStringLiteral("2*3+1, sqrt(2), 50%, +=10")},
        {ShortcutSheet::tr("Leave a number as it was"), ShortcutSheet::tr("Esc")},
        {ShortcutSheet::tr("Rename in the scene tree"), ShortcutSheet::tr("F2, double click")},
    };
    for (const QStringList& field : fields)
        new QTreeWidgetItem(&group, field);
}

void filter(QTreeWidget& list, const QString& text) {
    for (int g = 0; g < list.topLevelItemCount(); ++g) {
        QTreeWidgetItem* group = list.topLevelItem(g);
        bool any = false;
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem* item = group->child(i);
            const bool matches = item->text(0).contains(text, Qt::CaseInsensitive) ||
                                 item->text(1).contains(text, Qt::CaseInsensitive);
            item->setHidden(!matches);
            any = any || matches;
        }
        group->setHidden(!any);
    }
}

} // namespace

ShortcutSheet::ShortcutSheet(QMenuBar& menus, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Keyboard Shortcuts"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* search = new QLineEdit;
    search->setPlaceholderText(tr("Search commands and keys"));
    search->setClearButtonEnabled(true);
    search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    auto* list = new QTreeWidget;
    list->setObjectName(QStringLiteral("shortcutList"));
    list->setHeaderLabels({tr("Command"), tr("Keys")});
    list->setRootIsDecorated(false);
    list->setAlternatingRowColors(true);
    list->header()->setStretchLastSection(true);
    for (const QAction* action : menus.actions())
        if (const QMenu* menu = action->menu())
            addMenu(*addGroup(*list, plain(action->text())), *menu, {});
    addGestures(*addGroup(*list, tr("In the view")));
    addTimeline(*addGroup(*list, tr("In the timeline")));
    addFields(*addGroup(*list, tr("In the panels")));
    list->expandAll();
    list->resizeColumnToContents(0);
    connect(search, &QLineEdit::textChanged, list, [list](const QString& text) { filter(*list, text); });
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search);
    layout->addWidget(list);
    layout->addWidget(buttons);
    resize(560, 640);
}

} // namespace prizma
