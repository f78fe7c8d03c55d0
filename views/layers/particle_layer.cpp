// Points are drawn by the cells that have them: rebuild() makes the cells of all particles that are
// shown and of those that nothing holds, and takeCells() gives the drawing one of the two.
#include "layers/particle_layer.h"

#include "look/loose_particles.h"

#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

namespace ripstop {
namespace {

constexpr double particleSize = 6.0; // pixels
constexpr double manySize = 3.5;     // pixels, when there are many
constexpr std::size_t many = 2000;
constexpr double pinSize = 13.0; // pixels

// A square point becomes a diamond with a light rim.
constexpr const char* diamond = R"(//VTK::Light::Impl
  vec2 fromCentre = 2.0 * abs(gl_PointCoord - vec2(0.5));
  float reach = fromCentre.x + fromCentre.y;
  if (reach > 1.0) discard;
  if (reach > 0.70) gl_FragData[0] = vec4(1.0, 1.0, 1.0, 1.0);
)";

} // namespace

ParticleLayer::ParticleLayer()
{
    m_mapper->SetInputData(m_data);
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-6.0);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->RenderPointsAsSpheresOn();
    m_actor->GetProperty()->SetAmbient(0.35);
    m_actor->GetProperty()->SetDiffuse(0.7);
}

void ParticleLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void ParticleLayer::rebuild(const Picture& picture)
{
    const std::vector<std::uint8_t> isLoose = looseParticles(picture.frame);
    std::vector<std::array<int, 1>> all;
    std::vector<std::array<int, 1>> loose;
    for (std::size_t i = 0; i < picture.look.particleShown.size(); ++i)
        if (picture.look.particleShown[i]) {
            all.push_back({int(i)});
            if (isLoose[i])
                loose.push_back({int(i)});
        }
    m_all = cellsOf<1>(all);
    m_loose = cellsOf<1>(loose);
    m_pixelRatio = picture.pixelRatio;
    takeCells();
}

void ParticleLayer::setShown(bool shown)
{
    m_isShown = shown;
    takeCells();
}

void ParticleLayer::takeCells()
{
    vtkCellArray* const drawn = m_isShown ? m_all : m_loose;
    const vtkIdType count = drawn ? drawn->GetNumberOfCells() : 0; // none before rebuild()
    m_actor->SetVisibility(count > 0);
    if (count == 0)
        return;
    m_data->SetVerts(drawn);
    m_actor->GetProperty()->SetPointSize(
        float(m_pixelRatio * (std::size_t(count) > many ? manySize : particleSize)));
}

void ParticleLayer::update(const Picture& picture)
{
    m_data->SetPoints(picture.points);
    setColor(*m_actor->GetProperty(), picture.theme.particle);
    if (picture.values.particle.empty()) {
        colorByProperty(*m_data, *m_mapper);
    } else {
        const std::span<Color> colors = m_colors.resized(picture.values.particle.size());
        for (std::size_t i = 0; i < colors.size(); ++i)
            colors[i] = picture.colorOf(picture.values.particle[i]);
        colorByPoints(*m_data, *m_mapper, m_colors);
    }
    m_data->Modified();
}

PinLayer::PinLayer()
{
    m_mapper->SetInputData(m_data);
    m_mapper->ScalarVisibilityOff();
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-40.0);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
    m_actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, diamond,
                                                               false);
}

void PinLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void PinLayer::rebuild(const Picture& picture)
{
    const auto& pinned = picture.layout().pinned;
    std::vector<std::array<int, 1>> drawn;
    for (std::size_t i = 0; i < pinned.size(); ++i)
        if (pinned[i] && picture.look.particleShown[i])
            drawn.push_back({int(i)});
    m_data->SetVerts(cellsOf<1>(drawn));
    m_actor->GetProperty()->SetPointSize(float(picture.pixelRatio * pinSize));
    setColor(*m_actor->GetProperty(), picture.theme.pin);
}

void PinLayer::update(const Picture& picture)
{
    m_data->SetPoints(picture.points);
    m_data->Modified();
}

} // namespace ripstop
