// rebuild() takes the actor of each body that is shown, or makes one, and gives it its colour;
// landscapes get a haze besides, by a line in VTK's shader. update() puts bodies where they are in
// the frame.
#include "layers/collider_layer.h"

#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <algorithm>

namespace ripstop {
namespace {

// A landscape fades into the haze of the backdrop with the distance from the eye.
constexpr auto hazeAdded =
    "//VTK::Light::Impl\n"
    "  float clear = exp2(-dot(vertexVC.xyz, vertexVC.xyz) * perSquareMetre);\n"
    "  fragOutput0.rgb = mix(hazeColor, fragOutput0.rgb, clear);\n";
constexpr double sizesToHalf = 0.8; // of a landscape, over which half of its colour is left

void haze(vtkActor& actor, const ColliderBody& body, const Theme& theme)
{
    vtkShaderProperty& shader = *actor.GetShaderProperty();
    constexpr bool beforeVtk = true, everywhere = false;
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", beforeVtk, hazeAdded, everywhere);
    const QColor& color = theme.skyBottom;
    const double rgb[3] = {color.redF(), color.greenF(), color.blueF()};
    shader.GetFragmentCustomUniforms()->SetUniform3f("hazeColor", rgb);
    const double reach = sizesToHalf * std::max(body.bounds.sizes().maxCoeff(), 1e-6);
    shader.GetFragmentCustomUniforms()->SetUniformf("perSquareMetre", float(1.0 / (reach * reach)));
}

} // namespace

void ColliderLayer::setShown(bool shown)
{
    m_shown = shown;
    for (const Drawn& drawn : m_drawn)
        drawn.actor->SetVisibility(shown);
}

ColliderLayer::Drawn ColliderLayer::taken(const ColliderBody& body)
{
    const auto isIt = [&](const Drawn& drawn) {
        return drawn.collider == body.id && drawn.surface == body.surface;
    };
    if (const auto found = std::ranges::find_if(m_drawn, isIt); found != m_drawn.end()) {
        Drawn drawn = std::move(*found);
        m_drawn.erase(found);
        return drawn;
    }
    Drawn drawn{.collider = body.id, .surface = body.surface};
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(body.surface);
    // fabric that lies on a flat face is seen before it
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 16.0);
    drawn.actor->SetMapper(mapper);
    drawn.actor->SetUserMatrix(drawn.matrix);
    m_renderer->AddActor(drawn.actor);
    return drawn;
}

void ColliderLayer::rebuild(const Picture& picture)
{
    std::vector<Drawn> wanted;
    for (const ColliderBody& body : picture.colliders) {
        if (!body.collider.shown || !body.surface)
            continue;
        wanted.push_back(taken(body));
        const bool isSelected = std::ranges::binary_search(picture.selected, body.id);
        const bool isLandscape = isGround(body);
        vtkProperty& property = *wanted.back().actor->GetProperty();
        setColor(property, isSelected    ? picture.theme.accent
                           : isLandscape ? picture.theme.ground
                                         : picture.theme.neutral);
        property.SetInterpolationToPhong();
        property.SetAmbient(0.25);
        property.SetDiffuse(0.75);
        property.SetSpecular(isLandscape ? 0.0 : 0.15);
        if (isLandscape)
            haze(*wanted.back().actor, body, picture.theme);
        property.SetSpecularPower(30.0);
    }
    for (const Drawn& gone : m_drawn)
        m_renderer->RemoveActor(gone.actor);
    m_drawn = std::move(wanted);
    setShown(m_shown);
}

void ColliderLayer::update(const Picture& picture)
{
    for (const Drawn& drawn : m_drawn) {
        const Collider* collider = findItem<Collider>(picture.scene, drawn.collider);
        if (!collider)
            continue;
        const Eigen::Matrix3d turn = turnAndScale(*collider);
        const Vec3 place = placeOf(picture.frame, drawn.collider, *collider);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                drawn.matrix->SetElement(row, column, turn(row, column));
            drawn.matrix->SetElement(row, 3, place[row]);
        }
    }
}

} // namespace ripstop
