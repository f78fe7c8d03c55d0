// The figure is drawn once, of strokes in the plane that the first view looks across; rebuild()
// shows it while a scene has nothing and gives it the colour of the theme.
#include "layers/person_layer.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

namespace ripstop {
namespace {

// Heights above the ground over that of the body, after the usual segments of anthropometry
// (Drillis and Contini 1966): hips 0.53, shoulders 0.82, chin 0.87.
constexpr double tall = 1.75; // m
constexpr double hips = 0.53 * tall;
constexpr double shoulders = 0.82 * tall;
constexpr double chin = 0.87 * tall;
constexpr double halfShoulders = 0.129 * tall;
constexpr double hands = 0.48 * tall;
constexpr double halfStep = 0.08 * tall; // between the feet
constexpr double headRadius = 0.5 * (tall - chin);
constexpr int headSides = 24;
constexpr float strokeWidth = 3.0F; // pixels

using Stroke = std::vector<std::array<double, 2>>; // m, across and up

std::vector<Stroke> strokesOfPerson()
{
    Stroke head;
    for (int i = 0; i <= headSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / headSides;
        head.push_back(
            {0.8 * headRadius * std::sin(angle), chin + headRadius * (1.0 - std::cos(angle))});
    }
    return {head,
            {{0.0, chin}, {0.0, hips}},
            {{-halfShoulders - 0.06, hands},
             {-halfShoulders, shoulders},
             {halfShoulders, shoulders},
             {halfShoulders + 0.06, hands}},
            {{-halfStep, 0.0}, {0.0, hips}, {halfStep, 0.0}}};
}

} // namespace

bool hasNothing(const Scene& scene)
{
    return std::ranges::none_of(scene.items, [](const Entry& entry) {
        return std::holds_alternative<Part>(entry.item)
               || std::holds_alternative<Collider>(entry.item);
    });
}

PersonLayer::PersonLayer()
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (const Stroke& stroke : strokesOfPerson()) {
        lines->InsertNextCell(int(stroke.size()));
        for (const auto& [across, up] : stroke)
            lines->InsertCellPoint(points->InsertNextPoint(across * std::numbers::sqrt2 / 2.0, up,
                                                           -across * std::numbers::sqrt2 / 2.0));
    }
    m_data->SetPoints(points);
    m_data->SetLines(lines);
    m_mapper->SetInputData(m_data);
    m_mapper->ScalarVisibilityOff();
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
    setShown(true);
}

void PersonLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void PersonLayer::setShown(bool shown)
{
    m_shown = shown;
    m_actor->SetVisibility(m_shown && m_isWanted);
}

void PersonLayer::rebuild(const Picture& picture)
{
    m_isWanted = hasNothing(picture.scene);
    const QColor& color = picture.theme.text;
    m_actor->GetProperty()->SetColor(color.redF(), color.greenF(), color.blueF());
    m_actor->GetProperty()->SetLineWidth(strokeWidth * float(picture.pixelRatio));
    setShown(m_shown);
}

} // namespace ripstop
