// Draws by clicks: particles in a plane, on panels or where particles are already; links from click
// to click, until the last particle is clicked again; panels by three clicks.
//
// Each click is one step of the history. The tool draws in the design, so `begin` takes the
// simulation back there before it changes. What is drawn is put together by Drawing of the model;
// sentences about it go to `drawn`. The settings outlive the tool and are changed by the bar above
// the view.
#pragma once

#include "shaping/drawing.h"
#include "tools/tool.h"

#include <QPointF>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace ripstop {

class Document;
class CameraProjection;

// What the draw tool draws, and where.
struct DrawSettings
{
    enum class Shape { Particles, Links, Panels };
    enum class Plane { Facing, Ground, Front, Side }; // across what faces the eye, y, z, x

    Plane plane = Plane::Facing;
    double grid = 0.1;  // m, in the plane
    bool snaps = true;  // to the grid; Ctrl does the opposite
    bool onMesh = true; // a place on a panel is taken as it is
    Id part{};          // where new particles go; noId: a new part
    Id material{};      // of links and panels; noId: a new one
    LinkKind kind = LinkKind::Rod;
    Resists resists = Resists::Both;
    int segments = 1;   // of a link between two clicks
    double mass = 0.01; // kg, as Drawing::particle() and rope() have it
};

// The tool for one of the shapes; it is made anew when another shape is chosen.
class DrawTool final : public Tool
{
public:
    using Shape = DrawSettings::Shape;

    // `begin` is called before the design changes; `drawn` says what has been, and what comes next.
    // With an empty text, what was said last holds no more.
    DrawTool(Shape shape, Document& document, DrawSettings& settings, std::function<void()> begin,
             std::function<void(const QString&)> drawn);

    bool press(const QMouseEvent& event, const CameraView& view) override;
    bool move(const QMouseEvent& event, const CameraView& view) override;
    bool release(const QMouseEvent& event, const CameraView& view) override;
    bool cancel() override;
    void paint(QPainter& painter, const Theme& theme, const CameraView& view) override;
    bool picks() const override { return false; }

private:
    struct Spot
    {
        Vec3 place;         // m
        Id particle = noId; // the one that is there already
    };

    std::optional<Spot> spotAt(QPointF at, Qt::KeyboardModifiers keys,
                               const CameraView& view) const;
    std::optional<Vec3> inPlane(QPointF at, bool snaps, const CameraProjection& projection) const;
    void dropLost();
    void click(const Spot& spot);
    Id particleFor(const Spot& spot, Drawing& drawing);
    Id materialFor(Drawing& drawing) const;
    void push(Drawing& drawing, const QString& label);
    QString told(const Spot& spot) const;

    Shape m_shape;
    Document& m_document;
    DrawSettings& m_settings;
    std::function<void()> m_begin;
    std::function<void(const QString&)> m_drawn;
    std::vector<Id> m_chain;    // particles clicked so far, of the link or panel under way
    std::optional<Spot> m_spot; // under the mouse
};

} // namespace ripstop
