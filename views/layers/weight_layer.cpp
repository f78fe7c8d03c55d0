#include "layers/weight_layer.h"

#include "look/people.h"

#include <vtkRenderer.h>

namespace ripstop {
namespace {

constexpr double weightSize = 15.0; // pixels

bool isSomeone(const std::vector<Person>& people, int particle)
{
    return std::ranges::any_of(people, [particle](const Person& person) {
        return std::ranges::find(person.holds, particle) != person.holds.end();
    });
}

} // namespace

WeightLayer::WeightLayer()
{
    m_mapper->SetInputData(m_data);
    m_mapper->ScalarVisibilityOff();
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-8.0);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->RenderPointsAsSpheresOn();
    m_actor->GetProperty()->SetAmbient(0.3);
    m_actor->GetProperty()->SetDiffuse(0.75);
}

void WeightLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void WeightLayer::rebuild(const Picture& picture)
{
    std::vector<std::array<int, 1>> drawn;
    for (std::size_t i = 0; i < picture.look.isWeight.size(); ++i)
        if (picture.look.isWeight[i] && picture.look.particleShown[i]
            && !isSomeone(picture.people, int(i)))
            drawn.push_back({int(i)});
    m_data->SetVerts(cellsOf<1>(drawn));
    m_actor->GetProperty()->SetPointSize(float(picture.pixelRatio * weightSize));
    setColor(*m_actor->GetProperty(), picture.theme.particle);
}

void WeightLayer::update(const Picture& picture)
{
    m_data->SetPoints(picture.points);
    m_data->Modified();
}

} // namespace ripstop
