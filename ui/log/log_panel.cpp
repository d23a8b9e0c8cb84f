#include "ui/log/log_panel.h"

#include "ui/document/strings.h"
#include "ui/main_window/theme.h"

#include <QAction>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QTime>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace prizma {
namespace {

enum Column { MessageColumn, FileColumn, TimeColumn };

/// A log that grows for ever would slow down: the oldest lines go.
constexpr int maximumLines = 2000;

QIcon iconOf(Severity severity) {
    switch (severity) {
    case Severity::Error:
        return icon(QStringLiteral("dialog-error"));
    case Severity::Warning:
        return icon(QStringLiteral("dialog-warning"));
    case Severity::Information:
        break;
    }
    return icon(QStringLiteral("dialog-information"));
}

QString place(const Diagnostic& diagnostic) {
    const QString name = QFileInfo(toQString(diagnostic.file)).fileName();
    return diagnostic.line > 0 ? QStringLiteral("%1:%2").arg(name).arg(diagnostic.line) : name;
}

/// Core's sentences may begin in lower case, because programs on a terminal put the file in front.
QString sentence(const std::string& message) {
    QString text = toQString(message);
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text;
}

} // namespace

LogPanel::LogPanel(QWidget* parent) : QWidget(parent), list_(new QTreeWidget) {
    list_->setObjectName(QStringLiteral("logList"));
    list_->setHeaderLabels({tr("Message"), tr("File"), tr("Time")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(MessageColumn, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(FileColumn, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(TimeColumn, QHeaderView::ResizeToContents);
    connect(list_, &QWidget::customContextMenuRequested, this, &LogPanel::showMenu);
    connect(list_, &QTreeWidget::itemDoubleClicked, this,
            [this](QTreeWidgetItem* item) { Q_EMIT jumpRequested(at(list_->indexOfTopLevelItem(item))); });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(list_);
}

void LogPanel::add(const Diagnostic& diagnostic) {
    if (!messages_.empty() && messages_.back() == diagnostic) {
        ++repeats_;
        list_->topLevelItem(count() - 1)
            ->setText(MessageColumn, tr("%1 (%2 times)").arg(sentence(diagnostic.message)).arg(repeats_ + 1));
    } else {
        repeats_ = 0;
        messages_.push_back(diagnostic);
        auto* item = new QTreeWidgetItem(list_);
        item->setIcon(MessageColumn, iconOf(diagnostic.severity));
        item->setText(MessageColumn, sentence(diagnostic.message));
        item->setToolTip(MessageColumn, toQString(describe(diagnostic)));
        item->setText(FileColumn, place(diagnostic));
        item->setToolTip(FileColumn, toQString(diagnostic.file));
        item->setText(TimeColumn, QTime::currentTime().toString(QStringLiteral("HH:mm:ss")));
    }
    if (count() > maximumLines) {
        delete list_->takeTopLevelItem(0);
        messages_.erase(messages_.begin());
    }
    list_->scrollToBottom();
    if (diagnostic.severity == Severity::Error)
        Q_EMIT errorAdded();
}

void LogPanel::clear() {
    messages_.clear();
    list_->clear();
}

int LogPanel::count() const {
    return static_cast<int>(messages_.size());
}

Diagnostic LogPanel::at(int row) const {
    return messages_.at(static_cast<std::size_t>(row));
}

void LogPanel::copy() const {
    QStringList lines;
    for (int row = 0; row < count(); ++row)
        if (list_->selectedItems().isEmpty() || list_->topLevelItem(row)->isSelected())
            lines += toQString(describe(at(row)));
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

void LogPanel::showMenu(const QPoint& position) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (auto* item = list_->itemAt(position))
        menu->addAction(icon(QStringLiteral("go-jump")), tr("Show What It Is About"), this,
                        [this, item] { Q_EMIT jumpRequested(at(list_->indexOfTopLevelItem(item))); });
    menu->addAction(icon(QStringLiteral("edit-copy")), tr("Copy"), this, &LogPanel::copy)
        ->setEnabled(count() > 0);
    menu->addAction(icon(QStringLiteral("edit-clear")), tr("Clear"), this, &LogPanel::clear)
        ->setEnabled(count() > 0);
    menu->popup(list_->viewport()->mapToGlobal(position));
}

} // namespace prizma
