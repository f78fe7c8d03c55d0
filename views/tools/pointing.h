// What the mouse is on and what is drawn there, over the picture: the tool in use and what a click
// would take.
//
// The viewport passes its events on; each function says whether a tool took it. From press to
// release a gesture belongs to the tool that took the press, be it the chosen one or the one for
// Ctrl. What is under the mouse is looked for at intervals and not with each move, as that costs a
// walk over all particles. It lets all events of its own through and belongs to the thread of the
// window.
#pragma once

#include "look/theme.h"
#include "tools/picker.h"
#include "tools/tool.h"

#include <QTimer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

namespace ripstop {

class Pointing final : public QWidget
{
    Q_OBJECT

public:
    // `view` is what is seen now, or nothing before there is a frame.
    Pointing(std::function<std::optional<CameraView>()> view, QWidget* parent);
    ~Pointing() override;

    void setTool(std::unique_ptr<Tool> tool); // null is the pointer
    // Takes what is dragged with Ctrl and the tool in use leaves.
    void setCtrlTool(std::unique_ptr<Tool> tool) { m_ctrlTool = std::move(tool); }
    bool hasTool() const { return m_tool != nullptr; }
    void setTheme(const Theme& theme);
    void moved(); // what is seen has moved

    // What clicks can take; see Picker.
    Pickable pickable;
    Id pick(QPointF place) const; // noId when nothing is there

    // True when the tool takes the event.
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    bool wheel(const QWheelEvent& event);
    bool takesKey(const QKeyEvent& event) const; // so that it is nobody's shortcut
    bool key(const QKeyEvent& event);
    bool holds() const { return m_busy && m_busy->holds(); }
    bool escape(); // true when there was something to give up: a gesture, or the tool

    // The place under the mouse, soon; nothing while the view turns or the mouse is elsewhere.
    void hover(std::optional<QPointF> place);
    Id hovered() const { return m_hovered; }

signals:
    void hoveredChanged(ripstop::Id id); // noId when the mouse is on nothing
    void toolLeft();                     // the pointer is back, by Escape

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void lookUnderMouse();
    Tool* active() const { return m_busy ? m_busy : m_tool.get(); }
    void showCursor();
    void setHovered(Id id);
    void paintHovered(QPainter& painter, const CameraView& view) const;

    std::function<std::optional<CameraView>()> m_view;
    std::unique_ptr<Tool> m_tool;
    std::unique_ptr<Tool> m_ctrlTool;
    Tool* m_busy = nullptr; // the tool with a gesture, from press to release
    Theme m_theme = Theme::light();
    std::optional<QPointF> m_mouse;
    Id m_hovered = noId;
    QTimer m_soon;
};

} // namespace ripstop
