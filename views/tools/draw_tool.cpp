// spotAt() finds the place under the mouse: a particle that is there, else a place on the panel
// under the mouse, else the place where the ray meets the plane (inPlane(), with the grid).
//
// click() acts on it by shape: a particle, a link from the last particle of the chain, or the next
// corner of a panel. New particles, parts and materials are made only where the settings name none.
// Each click is pushed as one edit, and a sentence says what has been drawn.
//
// paint() shows the chain, the place under the mouse, and its coordinates or the length from the
// last particle.
#include "tools/draw_tool.h"

#include "document/document.h"
#include "document/words.h"
#include "scene/particle_of.h"
#include "select/elements.h"
#include "tools/picker.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double spotRadius = 5.0; // pixels
constexpr double wordsGap = 14.0;  // pixels, from the mouse

// Where the ray meets the plane through a point, m; nothing where it runs along the plane or away
// from it.
std::optional<Vec3> meeting(const CameraProjection::Ray& ray, const Vec3& point, const Vec3& normal)
{
    const double slope = ray.direction.dot(normal);
    if (std::abs(slope) < 1e-3) // a plane on edge: places would be far away
        return std::nullopt;
    const double distance = (point - ray.origin).dot(normal) / slope;
    if (distance <= 0.0)
        return std::nullopt;
    return ray.origin + distance * ray.direction;
}

QString placeText(const Vec3& place)
{
    const auto number = [](double value) { return QLocale().toString(value, 'f', 3); };
    return QStringLiteral("%1  %2  %3 m")
        .arg(number(place.x()), number(place.y()), number(place.z()));
}

} // namespace

DrawTool::DrawTool(Shape shape, Document& document, DrawSettings& settings,
                   std::function<void()> begin, std::function<void(const QString&)> drawn)
    : m_shape(shape)
    , m_document(document)
    , m_settings(settings)
    , m_begin(std::move(begin))
    , m_drawn(std::move(drawn))
{}

bool DrawTool::press(const QMouseEvent& event, const CameraView& view)
{
    if (event.button() != Qt::LeftButton)
        return false;
    m_begin();
    dropLost();
    m_spot = spotAt(event.position(), event.modifiers(), view);
    if (m_spot)
        click(*m_spot);
    else
        m_drawn(words("The plane is seen on edge here: turn the view, or choose another plane."));
    return true;
}

bool DrawTool::move(const QMouseEvent& event, const CameraView& view)
{
    if (event.buttons() & ~Qt::LeftButton)
        return false;
    dropLost();
    m_spot = spotAt(event.position(), event.modifiers(), view);
    return event.buttons().testFlag(Qt::LeftButton);
}

bool DrawTool::release(const QMouseEvent& event, const CameraView&)
{
    return event.button() == Qt::LeftButton;
}

bool DrawTool::cancel()
{
    const bool was = !m_chain.empty();
    m_chain.clear();
    if (was)
        m_drawn({}); // what it has asked for is not wanted any more
    return was;
}

// An undo may have taken particles away that were clicked.
void DrawTool::dropLost()
{
    std::erase_if(m_chain, [&](Id id) { return !particleOf(m_document.scene(), id); });
}

std::optional<DrawTool::Spot> DrawTool::spotAt(QPointF at, Qt::KeyboardModifiers keys,
                                               const CameraView& view) const
{
    const Scene& scene = m_document.scene();
    const Picker points{view, {{true, false, false}, {true, false, false}}};
    if (const Particle* particle = particleOf(scene, points.at(at.x(), at.y())))
        return Spot{particle->position, particle->id};
    const CameraProjection projection(view);
    const bool snaps = m_settings.snaps != keys.testFlag(Qt::ControlModifier);
    if (m_settings.onMesh) {
        const Picker panels{view, {{false, false, true}, {false, false, true}}};
        const auto under = std::uint32_t(panels.at(at.x(), at.y()));
        const Layout& layout = *view.frame.layout;
        const auto found = std::ranges::find(layout.panelId, under);
        if (under != std::uint32_t(noId) && found != layout.panelId.end()) {
            const auto& corners = layout.panelCorners[std::size_t(found - layout.panelId.begin())];
            const auto place = [&](int k) {
                return view.frame.position[std::size_t(corners[std::size_t(k)])];
            };
            const Vec3 normal = (place(1) - place(0)).cross(place(2) - place(0)).normalized();
            if (const auto spot = meeting(projection.rayAt(at.x(), at.y()), place(0), normal))
                return Spot{*spot, noId};
        }
    }
    const auto spot = inPlane(at, snaps, projection);
    return spot ? std::optional(Spot{*spot, noId}) : std::nullopt;
}

// The place in the plane through the last particle that was clicked, or through the origin, m.
std::optional<Vec3> DrawTool::inPlane(QPointF at, bool snaps,
                                      const CameraProjection& projection) const
{
    const CameraProjection::Ray ray = projection.rayAt(at.x(), at.y());
    int axis = 0;
    switch (m_settings.plane) {
    case DrawSettings::Plane::Facing:
        ray.direction.cwiseAbs().maxCoeff(&axis);
        break;
    case DrawSettings::Plane::Ground:
        axis = 1;
        break;
    case DrawSettings::Plane::Front:
        axis = 2;
        break;
    case DrawSettings::Plane::Side:
        axis = 0;
        break;
    }
    const Particle* last =
        m_chain.empty() ? nullptr : particleOf(m_document.scene(), m_chain.back());
    const Vec3 through = last ? last->position : Vec3(Vec3::Zero());
    auto spot = meeting(ray, through, Vec3::Unit(axis));
    if (spot && snaps && m_settings.grid > 0.0)
        for (int k = 0; k < 3; ++k)
            if (k != axis)
                (*spot)[k] = std::round((*spot)[k] / m_settings.grid) * m_settings.grid;
    if (spot)
        (*spot)[axis] = through[axis];
    return spot;
}

Id DrawTool::particleFor(const Spot& spot, Drawing& drawing)
{
    if (spot.particle != noId)
        return spot.particle;
    if (!findItem<Part>(m_document.scene(), m_settings.part)) {
        const Particle* last =
            m_chain.empty() ? nullptr : particleOf(m_document.scene(), m_chain.back());
        m_settings.part =
            last ? drawing.partOf(last->id) : drawing.part(words("drawing").toStdString());
    }
    const bool isRope = m_shape == Shape::Links && m_settings.segments > 1;
    return drawing.particle(m_settings.part, spot.place, isRope ? 0.0 : m_settings.mass);
}

Id DrawTool::materialFor(Drawing& drawing) const
{
    if (!findItem<Material>(m_document.scene(), m_settings.material))
        m_settings.material =
            drawing.material(m_shape == Shape::Panels ? plainCloth(words("cloth").toStdString())
                                                      : plainCord(words("cord").toStdString()));
    return m_settings.material;
}

void DrawTool::push(Drawing& drawing, const QString& label)
{
    Edit edit = drawing.finish(Message::verbatim(label.toStdString()));
    if (!edit.changes.empty())
        m_document.push(std::move(edit));
}

void DrawTool::click(const Spot& spot)
{
    Drawing drawing(m_document.scene());
    if (m_shape == Shape::Particles) {
        if (spot.particle != noId)
            return m_drawn(words("There is a particle here already."));
        particleFor(spot, drawing);
        push(drawing, words("Draw a particle"));
        return m_drawn(words("A particle at %1.").arg(placeText(spot.place)));
    }
    if (!m_chain.empty() && spot.particle == m_chain.back()) { // a double click, too
        m_chain.clear();
        return m_drawn(words("Ended."));
    }
    const Id particle = particleFor(spot, drawing);
    if (m_shape == Shape::Links && !m_chain.empty()) {
        const LinkStroke stroke{materialFor(drawing), m_settings.kind, m_settings.resists};
        const Id from = m_chain.back();
        if (m_settings.segments > 1)
            drawing.rope(from, particle, m_settings.segments, m_settings.mass, 0.0, stroke);
        else
            drawing.link(from, particle, stroke);
    }
    m_chain.push_back(particle);
    if (m_shape == Shape::Panels && m_chain.size() == 3) {
        drawing.panel(m_chain[0], m_chain[1], m_chain[2], materialFor(drawing));
        push(drawing, words("Draw a panel"));
        m_chain.clear();
        return m_drawn(words("A panel. The next one begins with the next click."));
    }
    push(drawing, m_shape == Shape::Links && m_chain.size() > 1 ? words("Draw a link")
                                                                : words("Draw a particle"));
    if (m_shape == Shape::Links)
        m_chain.erase(m_chain.begin(), m_chain.end() - 1);
    m_drawn(m_shape == Shape::Links
                ? words("Click where the link ends; click the last particle again to stop.")
                : words("Click the other corners of the panel."));
}

QString DrawTool::told(const Spot& spot) const
{
    QString text = spot.particle != noId ? words("on a particle") : placeText(spot.place);
    const Particle* last =
        m_chain.empty() ? nullptr : particleOf(m_document.scene(), m_chain.back());
    if (last)
        text += words("\n%1 m long").arg(compactNumber((spot.place - last->position).norm()));
    return text;
}

void DrawTool::paint(QPainter& painter, const Theme& theme, const CameraView& view)
{
    if (!m_spot)
        return;
    const CameraProjection projection(view);
    const auto at = [&](const Vec3& place) {
        const OnScreen seen = projection(place);
        return seen.isSeen() ? QPointF(seen.x, seen.y) : QPointF(-1e4, -1e4);
    };
    painter.setPen(QPen(theme.accent, 2.0, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    QPolygonF line;
    for (const Id id : m_chain)
        if (const Particle* particle = particleOf(m_document.scene(), id))
            line << at(particle->position);
    line << at(m_spot->place);
    if (m_shape == Shape::Panels && line.size() == 3)
        painter.drawPolygon(line);
    else
        painter.drawPolyline(line);

    painter.setPen(QPen(theme.accent, 2.0));
    painter.setBrush(m_spot->particle != noId ? QBrush(theme.accent) : QBrush(Qt::NoBrush));
    painter.drawEllipse(line.back(), spotRadius, spotRadius);

    const QString words = told(*m_spot);
    QRectF box = painter.boundingRect(QRectF(0, 0, 400, 100), Qt::AlignLeft, words);
    box.moveTopLeft(line.back() + QPointF(wordsGap, wordsGap));
    box.moveRight(std::min(box.right(), view.width - wordsGap));
    box.moveBottom(std::min(box.bottom(), view.height - wordsGap));
    QColor card = theme.card;
    card.setAlphaF(0.85F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(card);
    painter.drawRoundedRect(box.adjusted(-6, -4, 6, 4), 4, 4);
    painter.setPen(theme.text);
    painter.drawText(box, Qt::AlignLeft, words);
}

} // namespace ripstop
