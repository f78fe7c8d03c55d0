// The vertex program moves each end across the line and the line of sight, in the coordinates of
// the world, in which the layers draw. The length of the second row of the matrix to the screen is
// the zoom, and the fourth coordinate the distance (1 in an orthographic picture), so that
// 2 w / (zoom height) is how many metres a pixel is there.
#include "layers/tube_set.h"

#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace ripstop {
namespace {

constexpr double leastWidth = 1.5; // pixels

constexpr const char* vertexDeclaration = R"(//VTK::TCoord::Dec
in vec3 thisEnd;
in vec3 otherEnd;
in vec2 sideAndRadius;
uniform mat4 MCVCMatrix;
out vec3 acrossVS; // 1 long at the edges of the strip, 0 on its axis
out vec3 towardsVS;
out float pixelsVS; // half the width of the strip
)";

constexpr const char* vertexPosition = R"(
  vec3 here = thisEnd;
  mat3 turn = mat3(MCVCMatrix);
  vec4 flat_ = MCDCMatrix * vec4(here, 1.0);
  vec3 eye = -(transpose(turn) * MCVCMatrix[3].xyz);
  bool isParallel = abs(MCDCMatrix[0][3]) + abs(MCDCMatrix[1][3]) + abs(MCDCMatrix[2][3]) < 1e-6;
  vec3 towards = isParallel ? transpose(turn) * vec3(0.0, 0.0, 1.0) : normalize(eye - here);
  vec3 across = cross(otherEnd - here, towards);
  float length_ = length(across);
  across = length_ > 0.0 ? across / length_ : vec3(0.0);
  float zoom = length(vec3(MCDCMatrix[0][1], MCDCMatrix[1][1], MCDCMatrix[2][1]));
  float pixel = 2.0 * max(flat_.w, 1e-6) / (zoom * viewHeight);
  float radius = max(sideAndRadius.y, 0.5 * leastWidth * pixel);
  float side = sideAndRadius.x;
  acrossVS = across * side;
  towardsVS = towards;
  pixelsVS = radius / pixel;
  float reach = radius + border * pixel;
  gl_Position = MCDCMatrix * vec4(here + reach * side * across + radius * towards, 1.0);
)";

constexpr const char* fragmentDeclaration = R"(//VTK::TCoord::Dec
in vec3 acrossVS;
in vec3 towardsVS;
in float pixelsVS;
)";

constexpr const char* fragmentLight = R"(//VTK::Light::Impl
  {
  vec3 out_ = normalize(acrossVS + sqrt(max(0.0, 1.0 - dot(acrossVS, acrossVS))) * normalize(towardsVS));
  float sun = max(0.0, dot(out_, normalize(vec3(0.45, 1.0, 0.55))));
  float shade = 0.62 + 0.5 * sun + 0.1 * out_.y;
  gl_FragData[0].rgb *= mix(1.0, shade, shading * smoothstep(0.8, 2.5, pixelsVS));
  }
)";

std::array<float, 3> single(const Vec3& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

} // namespace

TubeSet::TubeSet(double border)
    : m_border(border)
{
    m_points->SetDataTypeToFloat();
    m_ends->SetNumberOfComponents(3);
    m_ends->SetName("thisEnd");
    m_others->SetNumberOfComponents(3);
    m_others->SetName("otherEnd");
    m_sides->SetNumberOfComponents(2);
    m_sides->SetName("sideAndRadius");
    m_mesh->SetPoints(m_points);
    m_mesh->GetPointData()->AddArray(m_ends);
    m_mesh->GetPointData()->AddArray(m_others);
    m_mesh->GetPointData()->AddArray(m_sides);
    m_mapper->SetInputData(m_mesh);
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, border > 0.0 ? 0.0 : -2.0);
    for (const char* name : {"thisEnd", "otherEnd", "sideAndRadius"})
        m_mapper->MapDataArrayToVertexAttribute(name, name, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                                -1);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
    constexpr bool beforeVtk = true, once = false;
    vtkShaderProperty& shader = *m_actor->GetShaderProperty();
    shader.AddVertexShaderReplacement("//VTK::TCoord::Dec", beforeVtk, vertexDeclaration, once);
    shader.AddVertexShaderReplacement("//VTK::PositionVC::Impl", beforeVtk, vertexPosition, once);
    shader.AddFragmentShaderReplacement("//VTK::TCoord::Dec", beforeVtk, fragmentDeclaration, once);
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", false, fragmentLight, once);
    shader.GetVertexCustomUniforms()->SetUniformf("viewHeight", 600.0F);
    shader.GetVertexCustomUniforms()->SetUniformf("leastWidth", float(leastWidth));
    shader.GetVertexCustomUniforms()->SetUniformf("border", float(border));
    setShaded(true);
}

void TubeSet::addTo(vtkRenderer& renderer)
{
    renderer.AddActor(m_actor);
    renderer.AddObserver(vtkCommand::StartEvent, this, &TubeSet::takeHeight);
}

// Pictures may have another size than the window, and the next one is drawn without any news.
void TubeSet::takeHeight(vtkObject* renderer, unsigned long, void*)
{
    const int height = static_cast<vtkRenderer*>(renderer)->GetSize()[1];
    m_actor->GetShaderProperty()->GetVertexCustomUniforms()->SetUniformf(
        "viewHeight", float(std::max(height, 1)));
}

void TubeSet::rebuild(const std::vector<Tube>& tubes, double pixelRatio)
{
    m_tubes = tubes;
    const auto count = vtkIdType(4 * tubes.size());
    m_points->SetNumberOfPoints(count);
    m_ends->SetNumberOfTuples(count);
    m_others->SetNumberOfTuples(count);
    m_sides->SetNumberOfTuples(count);
    auto* side = reinterpret_cast<std::array<float, 2>*>(m_sides->GetPointer(0));
    std::vector<std::array<int, 3>> cells;
    for (int i = 0; i < int(tubes.size()); ++i) {
        const auto radius = float(0.5 * tubes[i].thickness);
        // seen from its other end a strip has its sides the other way round
        for (const float sign : {1.0F, -1.0F, -1.0F, 1.0F})
            *side++ = {sign, radius};
        // VTK leaves out triangles with corners in one place, so it gets some that have none
        for (int corner = 0; corner < 4; ++corner)
            m_points->SetPoint(4 * i + corner, corner % 2, corner / 2, 0.0);
        cells.push_back({4 * i, 4 * i + 1, 4 * i + 3});
        cells.push_back({4 * i, 4 * i + 3, 4 * i + 2});
    }
    m_sides->Modified();
    m_points->Modified();
    m_mesh->SetPolys(cellsOf<3>(cells));
    vtkUniforms& uniforms = *m_actor->GetShaderProperty()->GetVertexCustomUniforms();
    uniforms.SetUniformf("leastWidth", float(leastWidth * pixelRatio));
    uniforms.SetUniformf("border", float(m_border * pixelRatio));
}

void TubeSet::update(std::span<const Vec3> position)
{
    auto* end = reinterpret_cast<std::array<float, 3>*>(m_ends->GetPointer(0));
    auto* other = reinterpret_cast<std::array<float, 3>*>(m_others->GetPointer(0));
    for (const Tube& tube : m_tubes) {
        const auto a = single(position[tube.a]), b = single(position[tube.b]);
        for (const auto& [here, there] :
             {std::pair(a, b), std::pair(a, b), std::pair(b, a), std::pair(b, a)}) {
            *end++ = here;
            *other++ = there;
        }
    }
    m_ends->Modified();
    m_others->Modified();
    m_mesh->Modified();
}

void TubeSet::setShaded(bool shaded)
{
    m_actor->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("shading",
                                                                           shaded ? 1.0F : 0.0F);
}

void TubeSet::setColor(const QColor& color)
{
    ripstop::setColor(*m_actor->GetProperty(), color);
    colorByProperty(*m_mesh, *m_mapper);
}

} // namespace ripstop
