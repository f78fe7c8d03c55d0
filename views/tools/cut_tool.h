// The knife: a stroke with the left button cuts the links and the fabric that it crosses;
// base/hands.h and tearing/cutting.h say how. It takes what is seen, or all that lies behind it as
// well.
//
// A cut is an input of the run and not an edit: the player hands it to the simulation, which notes
// it with its step. The stroke becomes a cut when the button is released; Escape gives it up until
// then.
#pragma once

#include "tools/picker.h"
#include "tools/region_select.h"
#include "tools/tool.h"

#include <QPointF>

#include <functional>

namespace ripstop {

class Player;

class CutTool final : public Tool
{
public:
    CutTool(Player& player, std::function<Depth()> depth);

    bool press(const QMouseEvent& event, const CameraView& view) override;
    bool move(const QMouseEvent& event, const CameraView& view) override;
    bool release(const QMouseEvent& event, const CameraView& view) override;
    bool cancel() override;
    bool holds() const override { return m_stroke.size() > 1; }
    bool picks() const override { return false; }
    void paint(QPainter& painter, const Theme& theme, const CameraView& view) override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

private:
    Player& m_player;
    std::function<Depth()> m_depth;
    std::vector<QPointF> m_stroke; // pixels; empty when there is none
    bool m_givenUp = false;        // by Escape, while the button is still down
};

// What a stroke over the picture cuts. With Depth::Visible each of its points reaches through the
// first fabric under it, and where there is none as deep as beside it.
Cut cutUnder(const CameraView& view, const std::vector<QPointF>& stroke, Depth depth);

} // namespace ripstop
