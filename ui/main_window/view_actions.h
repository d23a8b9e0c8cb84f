#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QPointer>

class QAction;
class QActionGroup;
class QDialog;
class QMainWindow;
class QMenu;

namespace prizma {

class Document;
class RenderSession;
class Viewport;

/// The View and Render menus.
class ViewActions : public QObject {
    Q_OBJECT

  public:
    ViewActions(Document& document, RenderSession& session, Viewport& viewport, QMainWindow& window);

    void fillViewMenu(QMenu& menu, const QList<QAction*>& panelActions, QAction* resetLayout);
    void fillRenderMenu(QMenu& menu);

    QAction* frameSelected() const { return frameSelected_; }
    QAction* frameAll() const { return frameAll_; }
    QAction* pause() const { return pause_; }
    QAction* statistics() const { return statistics_; }

    void showDevices();

  private:
    QAction* makeAction(const char* iconName, const QString& text, const QList<QKeySequence>& keys);
    void makePresets();
    void makeShaders();
    void makeDisplays();
    void showSettings();

    Document& document_;
    RenderSession& session_;
    Viewport& viewport_;
    QMainWindow& window_;
    QAction* frameSelected_;
    QAction* frameAll_;
    QAction* pause_;
    QAction* statistics_;
    QAction* skeletons_;
    QList<QAction*> presets_;
    QActionGroup* shaders_;
    QActionGroup* transforms_;
    QAction* denoise_;
    QPointer<QDialog> devices_;
};

} // namespace prizma
