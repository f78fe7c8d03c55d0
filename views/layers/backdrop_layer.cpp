// rebuild() says whether there is a ground and gives colours to the shader; update() follows a
// plane that moves and casts the shadows; place() tells where the eye is, in double precision: over
// the ground it is told within a square of two thousand steps, so that the numbers of the shader
// stay small wherever a glider has gone.
#include "layers/backdrop_layer.h"

#include "layers/backdrop_shader.h"
#include "look/collider_geometry.h"
#include "look/figure.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double levelWithin = 1e-6; // 1 - cosine
constexpr double perHeight = 0.3;    // finest squares over the height of the eye
constexpr double lowest = 1e-3;      // m, of an eye over the ground
constexpr double repeats = 2000.0;   // steps after which the pattern is the same
const Vec3 noPaper = -Vec3::Ones();
const QColor paperShadow(0x70, 0x74, 0x78);
constexpr int limbSides = 8;
constexpr vtkIdType mostPoints = 20'000; // of a collider that throws a shadow

Vec3 colorOf(const QColor& color) { return {color.redF(), color.greenF(), color.blueF()}; }

void give(vtkUniforms& uniforms, const char* name, const Vec3& value)
{
    uniforms.SetUniform3f(name, value.data());
}

void give(vtkUniforms& uniforms, const char* name, double x, double y)
{
    const float values[2] = {float(x), float(y)};
    uniforms.SetUniform2f(name, values);
}

std::string fragmentShader()
{
    std::string text = backdropFragmentShader;
    const Vec3 sun = sunDirection.normalized();
    const std::string gap = "TO_SUN";
    return text.replace(text.find(gap), gap.size(),
                        std::to_string(sun.x()) + ", " + std::to_string(sun.y()) + ", "
                            + std::to_string(sun.z()));
}

double within(double place, double period) { return place - period * std::floor(place / period); }

} // namespace

std::optional<Id> levelPlane(const Scene& scene)
{
    for (const Entry& entry : scene.items) {
        const Collider* plane = std::get_if<Collider>(&entry.item);
        if (plane && plane->shown && plane->shape == ColliderShape::Plane
            && plane->normal.normalized().y() > 1.0 - levelWithin)
            return entry.id;
    }
    return std::nullopt;
}

GroundStep groundStep(double height)
{
    const double power = std::log10(perHeight * std::max(height, lowest));
    return {std::pow(10.0, std::floor(power)), power - std::floor(power)};
}

BackdropLayer::Shadow::Shadow(double depth)
{
    image->SetDimensions(ShadowMap::side, ShadowMap::side, 1);
    constexpr int lightAndOpacity = 2;
    image->AllocateScalars(VTK_UNSIGNED_CHAR, lightAndOpacity);
    texture->SetInputData(image);
    texture->InterpolateOn();
    texture->RepeatOff();
    texture->EdgeClampOn();

    corners->SetDataTypeToDouble();
    corners->SetNumberOfPoints(4);
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    for (const auto& [u, v] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
        places->InsertNextTuple2(u, v);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({0, 1, 2, 3});
    square->SetPoints(corners);
    square->SetPolys(cells);
    square->GetPointData()->SetTCoords(places);
    mapper->SetInputData(square);
    mapper->ScalarVisibilityOff();
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.5, depth);
    actor->SetMapper(mapper);
    actor->SetTexture(texture);
    actor->ForceOpaqueOn(); // blended as it comes: VTK's pass for what is translucent costs a lot
    actor->GetProperty()->LightingOff();
}

// A limb as a spindle of eight sides: what its shadow shows of it.
void BackdropLayer::Shadow::add(const Limb& limb)
{
    const auto& [along, across, third] = LimbAxes(limb);
    const int first = int(places.size());
    places.push_back(limb.from - limb.fromRadius * along);
    places.push_back(limb.to + limb.toRadius * along);
    for (int i = 0; i < limbSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / limbSides;
        const Vec3 out = std::cos(angle) * across + std::sin(angle) * third;
        places.push_back(limb.from + limb.fromRadius * out);
        places.push_back(limb.to + limb.toRadius * out);
    }
    for (int i = 0; i < limbSides; ++i) {
        const int here = first + 2 + 2 * i, next = first + 2 + 2 * ((i + 1) % limbSides);
        triangles.insert(triangles.end(), {{first, here, next},
                                           {here, here + 1, next},
                                           {next, here + 1, next + 1},
                                           {first + 1, here + 1, next + 1}});
    }
}

// Most of what stands on the ground does not move, and nothing does in a run that is paused.
bool BackdropLayer::Shadow::cast(double ground)
{
    if (ground == shownGround && places == shownPlaces && triangles == shownTriangles)
        return false;
    shownGround = ground;
    shownPlaces = places;
    shownTriangles = triangles;
    map.cast(places, triangles, ground);
    return true;
}

void BackdropLayer::Shadow::draw(const std::vector<std::uint8_t>& dark)
{
    if (map.isEmpty())
        return;
    auto* pixels = static_cast<std::uint8_t*>(image->GetScalarPointer());
    for (const std::uint8_t pixel : dark) {
        *pixels++ = 255;
        *pixels++ = pixel;
    }
    image->Modified();
    const double ground = shownGround;
    const double x = map.x(), z = map.z(), size = map.size();
    corners->SetPoint(0, x, ground, z);
    corners->SetPoint(1, x + size, ground, z);
    corners->SetPoint(2, x + size, ground, z + size);
    corners->SetPoint(3, x, ground, z + size);
    corners->Modified();
}

BackdropLayer::BackdropLayer()
{
    vtkNew<vtkPoints> corners;
    for (const auto& [x, y] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
        corners->InsertNextPoint(x, y, 0.0);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({0, 1, 2, 3});
    m_data->SetPoints(corners);
    m_data->SetPolys(cells);
    m_mapper->SetInputData(m_data);
    m_mapper->ScalarVisibilityOff();
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
    m_actor->UseBoundsOff();
    m_actor->ForceOpaqueOn();
    m_actor->GetShaderProperty()->SetVertexShaderCode(backdropVertexShader);
    m_actor->GetShaderProperty()->SetFragmentShaderCode(fragmentShader().c_str());
}

void BackdropLayer::addTo(vtkRenderer& renderer)
{
    for (vtkActor* actor : {m_actor.Get(), m_flying.actor.Get(), m_standing.actor.Get()})
        renderer.AddActor(actor);
}

void BackdropLayer::setShown(bool shown)
{
    m_shown = shown;
    m_actor->SetVisibility(m_shown && m_kind != Kind::Plain && m_backdrop != Backdrop::Transparent);
    showShadows();
}

void BackdropLayer::showShadows()
{
    for (Shadow* shadow : {&m_flying, &m_standing}) {
        shadow->actor->SetVisibility(m_shown && m_isAbove && m_kind == Kind::Ground
                                     && !shadow->map.isEmpty());
        setColor(*shadow->actor->GetProperty(),
                 m_backdrop == Backdrop::Scenery ? m_shadowColor : paperShadow);
    }
}

void BackdropLayer::setBackdrop(Backdrop backdrop)
{
    m_backdrop = backdrop;
    give(uniforms(), "paper", backdrop == Backdrop::White ? Vec3(Vec3::Ones()) : noPaper);
    setShown(m_shown);
}

void BackdropLayer::setFabricShown(bool shown) { m_fabricShown = shown; }

vtkUniforms& BackdropLayer::uniforms()
{
    return *m_actor->GetShaderProperty()->GetFragmentCustomUniforms();
}

void BackdropLayer::rebuild(const Picture& picture)
{
    const auto plane = levelPlane(picture.scene);
    m_plane = plane.value_or(noId);
    const bool hasLandscape = std::ranges::any_of(picture.colliders, [](const ColliderBody& body) {
        return body.collider.shown && isGround(body);
    });
    m_kind = plane ? Kind::Ground : hasLandscape ? Kind::Haze : Kind::Plain;
    paint(picture.theme);
    setBackdrop(m_backdrop);

    m_fabric.clear();
    for (std::size_t i = 0; i < picture.layout().panelCorners.size(); ++i)
        if (m_fabricShown && picture.look.panelShown[i] && !picture.frame.gone[i])
            m_fabric.push_back(picture.layout().panelCorners[i]);
}

void BackdropLayer::paint(const Theme& theme)
{
    give(uniforms(), "skyColor", colorOf(theme.skyTop));
    give(uniforms(), "hazeColor", colorOf(theme.skyBottom));
    give(uniforms(), "sunColor", colorOf(theme.sun));
    give(uniforms(), "groundColor", colorOf(theme.ground));
    give(uniforms(), "squareColor", colorOf(theme.groundSquare));
    give(uniforms(), "lineColor", colorOf(theme.groundLine));
    m_shadowColor = theme.shadow;
    uniforms().SetUniformf("groundIsSolid", m_kind == Kind::Ground ? 1.0F : 0.0F);
}

void BackdropLayer::update(const Picture& picture)
{
    uniforms().SetUniformf("lineWidth", float(picture.pixelRatio));
    m_height = 0.0;
    if (const Collider* plane = findItem<Collider>(picture.scene, m_plane))
        m_height = placeOf(picture.frame, m_plane, *plane).y();
    else if (m_kind == Kind::Haze)
        m_height = -1e6; // an eye between hills has the horizon before it, too
    if (m_kind != Kind::Ground)
        return;
    const bool isOther = castStanding(picture);
    if (isOther)
        m_standing.draw(m_standing.map.dark());
    if (castFlying(picture) || isOther)
        m_flying.draw(m_flying.map.darkBeside(m_standing.map));
}

bool BackdropLayer::castFlying(const Picture& picture)
{
    m_flying.places.assign(picture.frame.position.begin(), picture.frame.position.end());
    m_flying.triangles = m_fabric;
    for (std::size_t i = 0; i < picture.people.size(); ++i)
        if (picture.people[i].pose != Pose::Standing)
            for (const Limb& limb : picture.limbs[i])
                m_flying.add(limb);
    return m_flying.cast(m_height);
}

bool BackdropLayer::castStanding(const Picture& picture)
{
    m_standing.places.clear();
    m_standing.triangles.clear();
    for (std::size_t i = 0; i < picture.people.size(); ++i)
        if (picture.people[i].pose == Pose::Standing)
            for (const Limb& limb : picture.limbs[i])
                m_standing.add(limb);
    for (const ColliderBody& body : picture.colliders) {
        if (!body.collider.shown || !body.surface || isGround(body)
            || body.surface->GetNumberOfPoints() > mostPoints)
            continue;
        const Eigen::Matrix3d turn = turnAndScale(body.collider);
        const Vec3 place = placeOf(picture.frame, body.id, body.collider);
        const int first = int(m_standing.places.size());
        for (vtkIdType i = 0; i < body.surface->GetNumberOfPoints(); ++i)
            m_standing.places.push_back(place + turn * Vec3(body.surface->GetPoint(i)));
        vtkNew<vtkIdList> face;
        for (vtkIdType i = 0; i < body.surface->GetNumberOfCells(); ++i) {
            body.surface->GetCellPoints(i, face);
            for (vtkIdType k = 2; k < face->GetNumberOfIds(); ++k)
                m_standing.triangles.push_back({first + int(face->GetId(0)),
                                                first + int(face->GetId(k - 1)),
                                                first + int(face->GetId(k))});
        }
    }
    return m_standing.cast(m_height);
}

double BackdropLayer::squares() const
{
    const bool areSeen = m_kind == Kind::Ground && m_backdrop == Backdrop::Scenery;
    return areSeen ? m_step.mostSeen() : 0.0;
}

void BackdropLayer::place(vtkCamera& camera)
{
    const Vec3 eye(camera.GetPosition());
    const Vec3 back = (eye - Vec3(camera.GetFocalPoint())).normalized();
    const Vec3 right = Vec3(camera.GetViewUp()).cross(back).normalized();
    give(uniforms(), "axisX", right);
    give(uniforms(), "axisY", back.cross(right));
    give(uniforms(), "axisZ", back);
    const double height = eye.y() - m_height;
    // without perspective the eye may stand anywhere: what is seen has a height of its own
    m_step = groundStep(camera.GetParallelProjection() ? 3.0 * camera.GetParallelScale() : height);
    const double period = repeats * m_step.fine;
    uniforms().SetUniformf("eyeHeight", float(height));
    uniforms().SetUniformf("isParallel", camera.GetParallelProjection() ? 1.0F : 0.0F);
    const double* const clip = camera.GetClippingRange();
    give(uniforms(), "clip", clip[0], clip[1]);
    give(uniforms(), "eyePlace", within(eye.x(), period), within(eye.z(), period));
    const double coarse = std::clamp((m_step.coarse - 0.35) / 0.5, 0.0, 1.0); // with rests between
    give(uniforms(), "groundStep", Vec3(m_step.fine, coarse, 1.0 / m_step.fine));
    m_isAbove = camera.GetParallelProjection() ? back.y() > 0.0 : height > 0.0;
    showShadows();
}

} // namespace ripstop
