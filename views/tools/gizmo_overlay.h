// Draws the handles of the transform tool over the view, and beside them what a drag comes to.
//
// It is a transparent widget that takes no mouse: the tool watches the events of the view itself,
// and this only paints what the tool says. The viewport calls refresh() whenever it places its
// overlays.
#pragma once

#include "look/theme.h"

#include <QPointer>
#include <QWidget>

namespace ripstop {

class TransformTool;

class GizmoOverlay final : public QWidget
{
    Q_OBJECT

public:
    GizmoOverlay(TransformTool& tool, QWidget* parent);

    void setTheme(const Theme& theme);
    void refresh(); // the camera or the tool has changed

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    TransformTool& m_tool;
    Theme m_theme = Theme::light();
};

} // namespace ripstop
