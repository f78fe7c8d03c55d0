// The hand: takes hold of fabric, lines and colliders and drags them.
//
// What a control moves is steered by that control. A collider is carried. All else is pulled by a
// spring between the place that was gripped and the cursor, in the plane of the picture through
// that place; the wheel moves the plane nearer and farther. P pins what is held, or lets it go
// again.
//
// These are inputs of the run (base/hands.h), not edits: they are recorded with it, and a reset is
// without them.
#pragma once

#include "tools/hand.h"
#include "tools/hand_settings.h"
#include "tools/picker.h"
#include "tools/tool.h"

#include <QObject>
#include <QPointF>

#include <functional>
#include <variant>

namespace ripstop {

class Document;
class Player;

class GrabTool final : public Tool
{
public:
    GrabTool(const Document& document, Player& player, const HandSettings& settings,
             std::function<Pickable()> pickable);
    ~GrabTool() override;

    bool press(const QMouseEvent& event, const CameraView& view) override;
    bool move(const QMouseEvent& event, const CameraView& view) override;
    bool release(const QMouseEvent& event, const CameraView& view) override;
    bool wheel(const QWheelEvent& event, const CameraView& view) override;
    bool takesKey(const QKeyEvent& event) const override;
    void key(const QKeyEvent& event, const CameraView& view) override;
    bool holds() const override { return m_held && m_drags; }
    bool cancel() override;
    void paint(QPainter& painter, const Theme& theme, const CameraView& view) override;
    Qt::CursorShape cursor() const override;

private:
    struct Steered
    {
        Hand hand;
        std::vector<double> from; // m, where it found the controls
    };
    struct Pulled
    {
        Grip grip;
    };
    struct Carried
    {
        Id collider;
        Vec3 from; // m, how far it had been carried before
    };
    struct Held
    {
        std::variant<Pulled, Steered, Carried> what;
        Vec3 place;   // m, where it was gripped
        Vec3 plane;   // m, a point of the plane that the cursor moves in
        Vec3 to;      // m, the cursor in that plane
        QPointF from; // pixels
        QPointF at;
    };

    std::optional<Held> take(QPointF cursor, const CameraView& view) const;
    void pull(const CameraView& view);
    void letGo();
    void paintPull(QPainter& painter, const Theme& theme, const CameraView& view) const;
    void paintCarry(QPainter& painter, const Theme& theme, const CameraView& view) const;
    bool isPinned(const Grip& grip) const;

    const Document& m_document;
    Player& m_player;
    const HandSettings& m_settings;
    std::function<Pickable()> m_pickable;
    std::optional<Held> m_held;
    bool m_drags = false;   // it has gone farther than a hand trembles
    bool m_givenUp = false; // by Escape, while the button is still down
};

} // namespace ripstop
