#pragma once

#include "core/compute/device.h"

#include <QObject>

#include <vector>

class QAction;
class QMenu;
class QPoint;
class QWidget;

namespace prizma {

class Document;
class RenderSession;
class ViewActions;

/// The right-click menu of the view: devices first, as the thesis had it, then the view's commands.
class ViewportMenu : public QObject {
    Q_OBJECT

  public:
    ViewportMenu(RenderSession& session, ViewActions& view, std::vector<QAction*> selectionActions,
                 QWidget& window);

    void show(const QPoint& globalPosition);

  private:
    void listInBackground();
    void fillDevices(QMenu& menu);
    void choose(const DeviceInfo& device);

    RenderSession& session_;
    ViewActions& view_;
    std::vector<QAction*> selectionActions_;
    QWidget& window_;
    std::vector<DeviceInfo> devices_; ///< Asking the drivers takes too long to do it when the menu opens.
};

} // namespace prizma
