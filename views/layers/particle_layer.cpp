#include "layers/particle_layer.h"

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
    std::vector<std::array<int, 1>> drawn;
    for (std::size_t i = 0; i < picture.look.particleShown.size(); ++i)
        if (picture.look.particleShown[i])
            drawn.push_back({int(i)});
    m_data->SetVerts(cellsOf<1>(drawn));
    m_actor->GetProperty()->SetPointSize(
        float(picture.pixelRatio * (drawn.size() > many ? manySize : particleSize)));
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
