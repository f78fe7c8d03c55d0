// rebuild() makes three actors for each plane: the disc, thin lines and bold lines, with depth
// offsets that put the disc behind the shadow and the shadow behind the lines.
//
// update() finds the place below the middle of what is shown, and returns at once when the disc is
// still near enough. Otherwise it draws the disc (rings and spokes of points whose opacity fades
// outwards) and the lines (multiples of a round step, cut to the disc, in pieces that fade as
// well).
#include "layers/ground_layer.h"

#include "layers/backdrop_layer.h"
#include "look/collider_geometry.h"

#include <vtkRenderer.h>

#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr int squaresToRim = 20;
constexpr int squaresPerBold = 5;
constexpr int rings = 24;
constexpr int spokes = 72;

using Rgba = std::array<std::uint8_t, 4>;

// Points with colours that fade, and cells over them.
struct Drawing
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> colors;

    Drawing() { colors->SetNumberOfComponents(4); }

    vtkIdType add(const Vec3& place, const QColor& color, double opacity)
    {
        const Rgba rgba{std::uint8_t(color.red()), std::uint8_t(color.green()),
                        std::uint8_t(color.blue()),
                        std::uint8_t(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0)))};
        colors->InsertNextTypedTuple(rgba.data());
        return points->InsertNextPoint(place.data());
    }
};

struct Actor
{
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;

    Actor()
    {
        mapper->SetInputData(data);
        mapper->SetResolveCoincidentTopologyToPolygonOffset();
        actor->SetMapper(mapper);
        actor->GetProperty()->LightingOff();
        actor->ForceTranslucentOn();
    }
    void show(const Drawing& drawing)
    {
        data->SetPoints(drawing.points);
        data->GetPointData()->SetScalars(drawing.colors);
    }
};

// Opacity over the distance from the middle: 1 there, 0 at the rim, smooth at both ends.
double fade(double share)
{
    const double t = std::clamp(1.0 - share, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace

double groundRadius(const Eigen::AlignedBox3d& bounds)
{
    const double size = bounds.isEmpty() ? 10.0 : std::max(bounds.diagonal().norm(), 0.2);
    return roundedUp(2.0 * size);
}

struct GroundLayer::Ground
{
    Id collider;
    Vec3 normal = Vec3::UnitY();
    double height = 0.0; // m along the normal
    Vec3 first = Vec3::UnitX();
    Vec3 second = Vec3::UnitZ();

    double radius = 0.0; // m
    Vec3 centre = Vec3::Constant(1e300);
    double step = 0.0; // m between lines

    Actor disc, lines, boldLines;

    void place(const Collider& collider, const Vec3& position);
    void drawDisc(const Theme& theme);
    void drawLines(const Theme& theme);
    void addLine(Drawing& drawing, const Vec3& along, const Vec3& across, double offset,
                 double opacity, const QColor& color) const;
};

void GroundLayer::Ground::place(const Collider& plane, const Vec3& position)
{
    normal = plane.normal.norm() > 0.0 ? Vec3(plane.normal.normalized()) : Vec3::UnitY();
    height = position.dot(normal);
    const Vec3 hint = std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
    first = (hint - hint.dot(normal) * normal).normalized();
    second = first.cross(normal);
}

void GroundLayer::Ground::drawDisc(const Theme& theme)
{
    Drawing drawing;
    const double opacity = 0.92;
    drawing.add(centre, theme.ground, opacity);
    for (int ring = 1; ring <= rings; ++ring)
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double share = double(ring) / rings;
            const double angle = 2.0 * std::numbers::pi * spoke / spokes;
            const Vec3 out = std::cos(angle) * first + std::sin(angle) * second;
            drawing.add(centre + share * radius * out, theme.ground, opacity * fade(share));
        }
    const auto at = [](int ring, int spoke) { return 1 + (ring - 1) * spokes + spoke % spokes; };
    for (int spoke = 0; spoke < spokes; ++spoke)
        drawing.cells->InsertNextCell({0, at(1, spoke), at(1, spoke + 1)});
    for (int ring = 1; ring < rings; ++ring)
        for (int spoke = 0; spoke < spokes; ++spoke)
            drawing.cells->InsertNextCell({at(ring, spoke), at(ring + 1, spoke),
                                           at(ring + 1, spoke + 1), at(ring, spoke + 1)});
    disc.show(drawing);
    disc.data->SetPolys(drawing.cells);
}

void GroundLayer::Ground::addLine(Drawing& drawing, const Vec3& along, const Vec3& across,
                                  double offset, double opacity, const QColor& color) const
{
    const double half = std::sqrt(std::max(0.0, radius * radius - offset * offset));
    constexpr int pieces = 24;
    drawing.cells->InsertNextCell(pieces + 1);
    for (int i = 0; i <= pieces; ++i) {
        const Vec3 local = offset * across + (2.0 * i / pieces - 1.0) * half * along;
        drawing.cells->InsertCellPoint(
            drawing.add(centre + local, color, opacity * fade(local.norm() / radius)));
    }
}

void GroundLayer::Ground::drawLines(const Theme& theme)
{
    Drawing thin, bold;
    for (const auto& [along, across] : {std::pair(first, second), std::pair(second, first)}) {
        const auto middle = std::llround(centre.dot(across) / step);
        for (long long i = middle - squaresToRim; i <= middle + squaresToRim; ++i) {
            const double offset = double(i) * step - centre.dot(across);
            if (i % squaresPerBold == 0)
                addLine(bold, along, across, offset, 0.85, theme.groundLine);
            else
                addLine(thin, along, across, offset, 0.40, theme.groundLine);
        }
    }
    lines.show(thin);
    lines.data->SetLines(thin.cells);
    boldLines.show(bold);
    boldLines.data->SetLines(bold.cells);
}

void GroundLayer::setShown(bool shown)
{
    m_shown = shown;
    for (const auto& ground : m_grounds)
        for (Actor* actor : {&ground->disc, &ground->lines, &ground->boldLines})
            actor->actor->SetVisibility(shown);
}

void GroundLayer::rebuild(const Picture& picture)
{
    for (const auto& ground : m_grounds)
        for (Actor* actor : {&ground->disc, &ground->lines, &ground->boldLines})
            m_renderer->RemoveActor(actor->actor);
    m_grounds.clear();

    const auto ofBackdrop = levelPlane(picture.scene);
    for (const Entry& entry : picture.scene.items) {
        const Collider* collider = std::get_if<Collider>(&entry.item);
        if (collider && collider->shown && collider->shape == ColliderShape::Plane
            && entry.id != ofBackdrop)
            add(entry.id, picture.pixelRatio);
    }
    setShown(m_shown);
}

void GroundLayer::add(Id collider, double pixelRatio)
{
    auto ground = std::make_shared<Ground>();
    ground->collider = collider;
    // the disc lies behind the shadow, the shadow behind the lines
    ground->disc.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 16.0);
    ground->lines.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, 2.0);
    ground->boldLines.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, 2.0);
    for (Actor* actor : {&ground->disc, &ground->lines, &ground->boldLines})
        m_renderer->AddActor(actor->actor);
    const auto width = float(pixelRatio);
    ground->lines.actor->GetProperty()->SetLineWidth(width);
    ground->boldLines.actor->GetProperty()->SetLineWidth(1.2F * width);
    m_grounds.push_back(std::move(ground));
}

void GroundLayer::update(const Picture& picture)
{
    const double radius = groundRadius(picture.bounds);
    const Vec3 middle = picture.bounds.isEmpty() ? Vec3(Vec3::Zero()) : picture.bounds.center();
    for (const auto& ground : m_grounds) {
        if (const Collider* plane = findItem<Collider>(picture.scene, ground->collider))
            ground->place(*plane, placeOf(picture.frame, ground->collider, *plane));
        const Vec3 below = middle + (ground->height - middle.dot(ground->normal)) * ground->normal;
        // A disc that follows every sway would seem to swim.
        const Vec3 away = below - ground->centre;
        if (ground->radius == radius && away.norm() < 0.1 * radius
            && std::abs(away.dot(ground->normal)) < 1e-9 * radius)
            continue;
        ground->radius = radius;
        ground->centre = below;
        ground->step = roundedUp(0.8 * radius / squaresToRim);
        ground->drawDisc(picture.theme);
        ground->drawLines(picture.theme);
    }
}

} // namespace ripstop
