// The fan: while the left button is down a jet of wind blows from before the eye at what is under
// the cursor.
//
// Its nozzle is a tenth of the picture wide there; the wheel makes it blow harder, and with Ctrl
// the jet wider. The jet is an input of the run, as a wind of the scene would be; it ends with the
// button, with Escape and with the tool.
#pragma once

#include "tools/hand_settings.h"
#include "tools/picker.h"
#include "tools/tool.h"

#include <QPointF>

#include <functional>
#include <optional>

namespace ripstop {

class Player;

class FanTool final : public Tool
{
public:
    FanTool(Player& player, HandSettings& settings, std::function<void()> changed);
    ~FanTool() override;

    bool press(const QMouseEvent& event, const CameraView& view) override;
    bool move(const QMouseEvent& event, const CameraView& view) override;
    bool release(const QMouseEvent& event, const CameraView& view) override;
    bool wheel(const QWheelEvent& event, const CameraView& view) override;
    void moved(const CameraView& view) override;
    bool cancel() override;
    bool holds() const override { return m_jet.has_value(); }
    bool picks() const override { return false; }
    void paint(QPainter& painter, const Theme& theme, const CameraView& view) override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

private:
    void blow(const CameraView& view);

    Player& m_player;
    HandSettings& m_settings;
    std::function<void()> m_changed; // called when the wheel has changed the settings
    QPointF m_cursor;                // pixels
    std::optional<Airflow> m_jet;    // while it blows
    bool m_isDown = false;           // the button is down, though Escape may have stopped the jet
    double m_reach = 0.0;            // m, from the nozzle to what it blows at
};

// The jet of a fan at a place of the picture, and how far it is from its nozzle to what is there,
// m.
std::pair<Airflow, double> fanAt(const CameraView& view, QPointF cursor,
                                 const HandSettings& settings);

} // namespace ripstop
