// rebuild() makes three actors for each plane: the squares, thin lines and bold lines, with depth
// offsets that put the squares behind the shadow and the shadow behind the lines.
//
// update() finds the place below the middle of what is shown, and returns at once when the disc is
// still near enough. Otherwise it draws the squares (of two colours in turn, whose corners fade
// outwards) and the lines between them, cut to the disc, in pieces that fade as well.
#include "layers/ground_layer.h"

#include "layers/backdrop_layer.h"
#include "look/collider_geometry.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

constexpr double fewestToRim = 5.0; // squares; at most ten times as many
constexpr int squaresPerBold = 10;
constexpr double opacityOfSquares = 0.92;
constexpr double opacityOfLines = 0.55, opacityOfBoldLines = 0.6; // as in backdrop_shader.h

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

// Opacity over the distance from the middle: 1 within two fifths, 0 at the rim, smooth at both
// ends.
double fade(double share)
{
    const double t = std::clamp((1.0 - share) / 0.6, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace

double groundRadius(const Eigen::AlignedBox3d& bounds)
{
    const double size = bounds.isEmpty() ? 10.0 : std::max(bounds.diagonal().norm(), 0.2);
    return roundedUp(2.0 * size);
}

double groundSquare(double radius)
{
    return std::pow(10.0, std::floor(std::log10(radius / fewestToRim) + 1e-9));
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
    double step = 0.0; // m, side of a square

    Actor squares, lines, boldLines;

    void place(const Collider& collider, const Vec3& position);
    void drawSquares(const Theme& theme);
    void drawLines(const Theme& theme);
    std::pair<long long, long long> squaresAlong(const Vec3& axis) const;
    void addSquare(Drawing& drawing, long long i, long long j, const QColor& color) const;
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

// The numbers of the first and the last square that the disc reaches along an axis.
std::pair<long long, long long> GroundLayer::Ground::squaresAlong(const Vec3& axis) const
{
    const double middle = centre.dot(axis);
    return {std::llround(std::floor((middle - radius) / step)),
            std::llround(std::floor((middle + radius) / step))};
}

// None where it lies beyond the rim.
void GroundLayer::Ground::addSquare(Drawing& drawing, long long i, long long j,
                                    const QColor& color) const
{
    const Vec3 near = (double(i) * step - centre.dot(first)) * first
                      + (double(j) * step - centre.dot(second)) * second;
    const std::array<Vec3, 4> corners{near, near + step * first, near + step * (first + second),
                                      near + step * second};
    if (std::ranges::all_of(corners, [&](const Vec3& one) { return one.norm() >= radius; }))
        return;
    drawing.cells->InsertNextCell(4);
    for (const Vec3& corner : corners)
        drawing.cells->InsertCellPoint(
            drawing.add(centre + corner, color, opacityOfSquares * fade(corner.norm() / radius)));
}

void GroundLayer::Ground::drawSquares(const Theme& theme)
{
    Drawing drawing;
    const auto [firstI, lastI] = squaresAlong(first);
    const auto [firstJ, lastJ] = squaresAlong(second);
    for (long long i = firstI; i <= lastI; ++i)
        for (long long j = firstJ; j <= lastJ; ++j)
            addSquare(drawing, i, j, (i + j) % 2 == 0 ? theme.ground : theme.groundSquare);
    squares.show(drawing);
    squares.data->SetPolys(drawing.cells);
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
        const auto [from, to] = squaresAlong(across);
        for (long long i = from + 1; i <= to; ++i) {
            const double offset = double(i) * step - centre.dot(across);
            if (i % squaresPerBold == 0)
                addLine(bold, along, across, offset, opacityOfBoldLines, theme.groundLine);
            else
                addLine(thin, along, across, offset, opacityOfLines, theme.groundLine);
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
        for (Actor* actor : {&ground->squares, &ground->lines, &ground->boldLines})
            actor->actor->SetVisibility(shown);
}

void GroundLayer::rebuild(const Picture& picture)
{
    for (const auto& ground : m_grounds)
        for (Actor* actor : {&ground->squares, &ground->lines, &ground->boldLines})
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
    // the squares lie behind the shadow, the shadow behind the lines
    ground->squares.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 16.0);
    ground->lines.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, 2.0);
    ground->boldLines.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, 2.0);
    for (Actor* actor : {&ground->squares, &ground->lines, &ground->boldLines})
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
        ground->step = groundSquare(radius);
        ground->drawSquares(picture.theme);
        ground->drawLines(picture.theme);
    }
}

} // namespace ripstop
