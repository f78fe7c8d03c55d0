// Box and lasso: a drag with the left button goes around what is to be selected.
//
// It replaces the selection; with Shift it adds to it, with Ctrl it takes away. Escape gives up the
// drag. What can be taken, and how deep, is asked when the button is released.
#pragma once

#include "tools/region_select.h"
#include "tools/tool.h"

#include <QPointF>

#include <functional>

namespace ripstop {

class Selection;

class RegionTool final : public Tool
{
public:
    enum class Shape { Box, Lasso };

    struct Options
    {
        Pickable pickable;
        Depth depth;
    };
    RegionTool(Shape shape, Selection& selection, std::function<Options()> options);

    bool press(const QMouseEvent& event, const CameraView& view) override;
    bool move(const QMouseEvent& event, const CameraView& view) override;
    bool release(const QMouseEvent& event, const CameraView& view) override;
    bool cancel() override;
    void paint(QPainter& painter, const Theme& theme, const CameraView& view) override;

private:
    void follow(const QMouseEvent& event);
    std::vector<QPointF> outline() const;

    Shape m_shape;
    Selection& m_selection;
    std::function<Options()> m_options;
    std::vector<QPointF> m_path; // of the drag under way, pixels; empty when there is none
    bool m_far = false;          // the drag has gone farther than a hand trembles
    bool m_givenUp = false;      // by Escape, while the button is still down
    Qt::KeyboardModifiers m_keys;
};

} // namespace ripstop
