// The pieces go where VTK 9.1 leaves marks in its programs. `lightDirectionVC0` is that of the
// first light of the stage, the sun, and points away from it; the normal faces the eye.
#include "layers/cloth_shader.h"

#include <vtkDataObject.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace ripstop {
namespace {

constexpr const char* vertexDeclaration = R"(//VTK::TCoord::Dec
in vec4 clothPoint;
in vec3 shade;
out vec4 clothPointVS;
out vec3 shadeVS;
)";

constexpr const char* vertexPass = R"(//VTK::TCoord::Impl
clothPointVS = clothPoint;
shadeVS = shade;
)";

constexpr const char* fragmentDeclaration = R"(//VTK::TCoord::Dec
in vec4 clothPointVS;
in vec3 shadeVS;

// How much darker the weave is here, 0 to 1, at so many metres a pixel.
float weave(vec2 place, float grid, float pixel)
{
  float dark = 0.0;
  float cell = pixel / grid;
  if (grid > 0.0 && cell < 0.45)
    {
    vec2 off = abs(fract(place / grid) - 0.5); // 0 on a thread of the grid
    vec2 thread = 1.0 - smoothstep(0.06, 0.06 + max(cell, 0.02), off);
    dark = 0.16 * (1.0 - smoothstep(0.15, 0.45, cell)) * max(thread.x, thread.y);
    }
  const float yarns = 6e-4; // m, two of them
  float yarn = pixel / yarns;
  if (yarn < 0.45)
    {
    vec2 wave = sin(6.2832 * place / yarns);
    dark += 0.07 * (1.0 - smoothstep(0.1, 0.45, yarn)) * (1.0 - wave.x * wave.y);
    }
  return dark;
}
)";

constexpr const char* fragmentLight = R"(//VTK::Light::Impl
  {
  float facing = clamp(dot(normalVCVSOutput, normalize(-vertexVC.xyz)), 0.0, 1.0);
  if (isCloth == 0)
    {
    gl_FragData[0].rgb = ambientColor * (0.7 + 0.3 * smoothstep(0.0, 0.5, facing));
    }
  else
    {
    vec3 up = normalMatrix * vec3(0.0, 1.0, 0.0);
    vec3 around = mix(vec3(0.30, 0.29, 0.27), vec3(0.46, 0.49, 0.54),
                      0.5 + 0.5 * dot(normalVCVSOutput, up));
    float open = 1.0 - 0.7 * (gl_FrontFacing ? shadeVS.y : shadeVS.z); // cloth in the way has light, too
    float away = dot(normalVCVSOutput, lightDirectionVC0); // of the side that is seen, from the sun
    vec3 sun = (1.0 - 0.8 * shadeVS.x) * lightColor0;     // cloth that is in the way lets some through
    vec3 through = 1.3 * clothPointVS.z * max(0.0, away) * sun * (0.6 + 0.4 * diffuseColor);
    vec3 shaded = max(0.0, -away) * diffuseColor * (lightColor0 - sun);
    float slant = 1.0 - facing;
    float sheen = 0.15 * open * slant * slant * slant * slant;
    float pixel = max(length(dFdx(clothPointVS.xy)), length(dFdy(clothPointVS.xy)));
    vec3 lit = gl_FragData[0].rgb - shaded + diffuseColor * (open * around + through);
    gl_FragData[0].rgb = lit * (1.0 - weave(clothPointVS.xy, clothPointVS.w, pixel))
                         + sheen * (0.5 + 0.5 * diffuseColor);
    }
  }
)";

} // namespace

void joinCloth(vtkPolyData& mesh, vtkPoints& points, vtkFloatArray& normals, vtkFloatArray& onCloth,
               vtkFloatArray& shade)
{
    points.SetDataTypeToFloat();
    normals.SetNumberOfComponents(3);
    onCloth.SetNumberOfComponents(4);
    onCloth.SetName(clothPointArray);
    shade.SetNumberOfComponents(3);
    shade.SetName(shadeArray);
    mesh.SetPoints(&points);
    mesh.GetPointData()->SetNormals(&normals);
    mesh.GetPointData()->AddArray(&onCloth);
    mesh.GetPointData()->AddArray(&shade);
}

void addClothShader(vtkActor& actor, vtkPolyDataMapper& mapper)
{
    constexpr int ofPoints = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    mapper.MapDataArrayToVertexAttribute("clothPoint", clothPointArray, ofPoints, -1);
    mapper.MapDataArrayToVertexAttribute("shade", shadeArray, ofPoints, -1);
    constexpr bool beforeVtk = true, once = false;
    vtkShaderProperty& shader = *actor.GetShaderProperty();
    shader.AddVertexShaderReplacement("//VTK::TCoord::Dec", beforeVtk, vertexDeclaration, once);
    shader.AddVertexShaderReplacement("//VTK::TCoord::Impl", beforeVtk, vertexPass, once);
    shader.AddFragmentShaderReplacement("//VTK::TCoord::Dec", beforeVtk, fragmentDeclaration, once);
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", false, fragmentLight, once);
    showAs(actor, Shown::Cloth);
}

void showAs(vtkActor& actor, Shown shown)
{
    actor.GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("isCloth",
                                                                        shown == Shown::Cloth);
}

} // namespace ripstop
