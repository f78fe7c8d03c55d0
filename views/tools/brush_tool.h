// The brush: a drag with the left button paints the fabric under it (shaping/brush.h), in the
// design.
//
// A stroke is one step of the history, of which the view shows what has been painted so far; Escape
// gives it up. Ctrl and the wheel make the brush wider, and a ring shows how wide it is where it
// is. The brush itself belongs to the viewport and outlives the tool.
#pragma once

#include "shaping/brush.h"
#include "shaping/mirror_plane.h"
#include "tools/tool.h"

#include <QObject>
#include <QPointF>
#include <QString>

#include <functional>
#include <map>
#include <optional>

namespace ripstop {

class Document;

class BrushTool final : public Tool
{
public:
    struct Calls
    {
        std::function<bool()> begin;              // goes to the design; false when it was not there
        std::function<void()> changed;            // the wheel has changed the brush
        std::function<void(const QString&)> said; // why nothing can be painted
    };

    BrushTool(Document& document, Brush& brush, Calls calls);

    bool press(const QMouseEvent& event, const CameraView& view) override;
    bool move(const QMouseEvent& event, const CameraView& view) override;
    bool release(const QMouseEvent& event, const CameraView& view) override;
    bool wheel(const QWheelEvent& event, const CameraView& view) override;
    bool cancel() override;
    bool holds() const override { return m_stroke.has_value(); }
    bool picks() const override { return false; }
    void paint(QPainter& painter, const Theme& theme, const CameraView& view) override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

private:
    void paintTo(const QMouseEvent& event, const CameraView& view);
    std::optional<Vec3> imageOf(const Vec3& place);

    Document& m_document;
    Brush& m_brush;
    Calls m_calls;
    std::optional<BrushStroke> m_stroke;
    int m_gesture = 0;
    bool m_isDown = false;           // the button is, though Escape may have given the stroke up
    std::optional<QPointF> m_cursor; // pixels, once the mouse has been in the view
    std::optional<Vec3> m_place;     // m, on the fabric under the cursor
    std::optional<Vec3> m_image;     // m, on the other side of it, where the brush mirrors

    // Of parts that the cursor has been over since the design changed; a stroke moves nothing.
    std::map<Id, MirrorPlane> m_planes;
    QObject m_listener;
};

// Why the brush can paint nothing of this scene, as a sentence; empty where it can.
QString whyNothingToPaint(const Scene& scene, const Brush& brush);

// What the brush paints, and how strongly: "strength x 0.5".
QString brushText(const Brush& brush);

} // namespace ripstop
