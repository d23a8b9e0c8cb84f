#pragma once

#include <QObject>
#include <QStringList>

class QMenu;

namespace prizma {

/// Files that were opened or saved lately, the latest first; remembered in QSettings.
class RecentFiles : public QObject {
    Q_OBJECT

  public:
    explicit RecentFiles(QObject* parent = nullptr);

    QStringList files() const;
    void add(const QString& file);
    void remove(const QString& file);
    void clear();

    /// Fills `menu` whenever it is about to be shown.
    void attach(QMenu& menu);

  Q_SIGNALS:
    void chosen(const QString& file);

  private:
    void fill(QMenu& menu);
};

} // namespace prizma
