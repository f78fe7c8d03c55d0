// Setters note what has changed. prepare() then does, once per picture and only as far as needed:
// looks of the elements and people for another layout or edit, bodies of colliders (again while one
// is late), points, limbs and bounds of the frame, the ghost of the design, values and range of the
// quantity; with these it makes a Picture, rebuilds the layers that are out of date and updates the
// others.
//
// place() puts the VTK camera where ours is, with clipping planes around all that is drawn.
//
// The order of layers() is the order in which they are added to the renderer.
#include "viewport/stage.h"

#include "look/design_ghost.h"
#include "look/element_places.h"
#include "look/scene_frame.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCuller.h>
#include <vtkCullerCollection.h>
#include <vtkLight.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <numbers>

namespace ripstop {
namespace {

constexpr double beyondColors = 0.02; // share of the values that colours need not tell apart

// Leaves out what has no cells. VTK 9.1 may end a measurement of its time that it has not begun,
// and then says so on the standard error with each picture.
class EmptyCuller final : public vtkCuller
{
public:
    static EmptyCuller* New();
    vtkTypeMacro(EmptyCuller, vtkCuller)

        double Cull(vtkRenderer*, vtkProp** props, int& count, int&) override
    {
        count = int(std::remove_if(props, props + count, isEmpty) - props);
        return count;
    }

private:
    static bool isEmpty(vtkProp* prop)
    {
        auto* actor = vtkActor::SafeDownCast(prop);
        auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
        return mapper && mapper->GetInput() && mapper->GetInput()->GetNumberOfCells() == 0;
    }
};

vtkStandardNewMacro(EmptyCuller)

} // namespace

Stage::Stage(vtkRenderWindow& window)
    : m_shadow(panels.mesh())
{
    m_coordinates->SetNumberOfComponents(3);
    m_points->SetData(m_coordinates);
    window.AddRenderer(m_renderer);
    m_renderer->GetCullers()->RemoveAllItems(); // they walk over all cells to save a few actors
    m_renderer->AddCuller(vtkNew<EmptyCuller>());
    light();
    for (Layer* layer : layers())
        layer->addTo(*m_renderer);
}

std::array<Layer*, 19> Stage::layers()
{
    return {&m_backdrop, &m_ground,      &m_shadow, &m_colliders, &panels,   &links,     &particles,
            &m_weights,  &m_highlight,   &m_pins,   &m_guides,    &m_wind,   &m_vectors, &ghost,
            &trails,     &m_designGhost, &m_grain,  &m_person,    &m_streaks};
}

// A sun that stays with the world, so that turning the view does not turn the shading, and a soft
// headlight for what lies in its shade.
void Stage::light()
{
    m_renderer->AutomaticLightCreationOff();
    vtkNew<vtkLight> sun;
    sun->SetLightTypeToSceneLight();
    sun->SetPosition(sunDirection.x(), sunDirection.y(), sunDirection.z());
    sun->SetFocalPoint(0.0, 0.0, 0.0);
    sun->SetColor(1.0, 0.98, 0.94);
    sun->SetIntensity(0.62);
    m_renderer->AddLight(sun);

    vtkNew<vtkLight> head;
    head->SetLightTypeToHeadlight();
    head->SetColor(0.94, 0.97, 1.0);
    head->SetIntensity(0.48);
    m_renderer->AddLight(head);
}

void Stage::show(std::shared_ptr<const Frame> frame) { m_frame = std::move(frame); }

void Stage::setTheme(const Theme& theme)
{
    m_theme = theme;
    setBackdrop(Backdrop::Scenery);
    m_layersAreOld = true;
}

void Stage::setBackdrop(Backdrop backdrop)
{
    const QColor bottom = backdrop == Backdrop::Scenery ? m_theme.skyBottom
                          : backdrop == Backdrop::White
                              ? QColor(Qt::white)
                              : QColor(Qt::black); // black adds nothing to a picture
    m_renderer->SetGradientBackground(backdrop == Backdrop::Scenery);
    m_renderer->SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
    m_renderer->SetBackground2(m_theme.skyTop.redF(), m_theme.skyTop.greenF(),
                               m_theme.skyTop.blueF());
    m_backdrop.setBackdrop(backdrop);
}

void Stage::setColorBy(ColorBy colorBy)
{
    m_colorBy = colorBy;
    m_range.reset();
    m_layersAreOld = true;
}

void Stage::takeRanges(const Stage& other)
{
    m_range = other.m_range;
    m_rangeToPeak = other.m_rangeToPeak;
    m_fixedRanges = other.m_fixedRanges;
    m_layersAreOld = true;
}

void Stage::forgetRanges()
{
    m_fixedRanges = {};
    m_range.reset();
    m_layersAreOld = true;
}

void Stage::setFixedRange(std::optional<ValueRange> range)
{
    m_fixedRanges[std::size_t(m_colorBy)] = range;
    m_range.reset();
    m_layersAreOld = true;
}

void Stage::setRangeToPeak(bool toPeak)
{
    m_rangeToPeak = toPeak;
    m_range.reset();
    m_layersAreOld = true;
}

void Stage::setSelected(std::vector<Id> ids)
{
    m_selected = std::move(ids);
    m_selectionIsOld = true;
}

void Stage::setSelectionMarked(bool marked)
{
    m_selectionMarked = marked;
    m_selectionIsOld = true;
}

void Stage::setPinsShown(bool shown)
{
    m_pins.setShown(shown);
    m_guides.setShown(shown);
}

void Stage::setPixelRatio(double ratio)
{
    m_layersAreOld |= ratio != m_pixelRatio;
    m_pixelRatio = ratio;
}

void Stage::setPanelsShown(bool shown)
{
    panels.setShown(shown);
    m_shadow.setShown(shown);
    m_backdrop.setFabricShown(shown);
    m_layersAreOld = true;
}

void Stage::setPeopleShown(bool shown)
{
    m_peopleShown = shown;
    m_lookIsOld = true;
}

void Stage::setWindShown(bool shown)
{
    m_wind.setShown(shown);
    m_layersAreOld = true;
}

void Stage::setStreaksShown(bool shown)
{
    m_streaksShown = shown;
    m_streaks.setShown(m_streaksShown && !m_motionReduced);
}

void Stage::setMotionReduced(bool reduced)
{
    m_motionReduced = reduced;
    setStreaksShown(m_streaksShown);
}

void Stage::setVectors(Vectors vectors)
{
    m_vectors.setKind(vectors);
    m_layersAreOld = true;
}

void Stage::setGrainShown(bool shown)
{
    m_grain.setShown(shown);
    m_layersAreOld = true;
}

void Stage::setMeshShown(bool shown)
{
    m_meshShown = shown;
    m_layersAreOld = true;
}

void Stage::setDesignShown(bool shown)
{
    m_designShown = shown;
    m_design.reset();
    m_designGhost.show({});
    m_layersAreOld = true;
}

void Stage::takeDesign(const Scene& scene)
{
    if (!m_designShown)
        return;
    if (!m_design)
        m_design = sceneFrame(scene);
    m_designGhost.show({{designGhost(m_design, *m_frame), {}}});
}

ValueRange Stage::range() const
{
    if (isState(m_colorBy))
        return {0.0, highestState};
    if (m_colorBy == ColorBy::Grain)
        return fixedRange().value_or(ValueRange{-farthestGrain, farthestGrain});
    ValueRange followed = m_range.range();
    if (m_colorBy == ColorBy::Margin) // as far as to where things break, at least
        followed.high = std::max(followed.high, 1.0);
    return fixedRange().value_or(followed);
}

const ColorMap& Stage::colors() const
{
    return range().low < 0.0 ? ColorMap::diverging() : ColorMap::sequential();
}

// VTK has no arrays of const; with `save` set it neither frees nor, here, writes this one.
void Stage::takePoints()
{
    auto* x =
        const_cast<double*>(m_frame->position.empty() ? nullptr : m_frame->position.front().data());
    constexpr int save = 1;
    m_coordinates->SetArray(x, 3 * vtkIdType(m_frame->position.size()), save);
    m_coordinates->Modified();
    m_points->Modified();
}

std::vector<Vec3> Stage::shownPoints() const
{
    std::vector<Vec3> points;
    for (std::size_t i = 0; m_frame && i < m_look.particleShown.size(); ++i)
        if (m_look.particleShown[i] && m_frame->position[i].allFinite())
            points.push_back(m_frame->position[i]);
    for (const std::vector<Limb>& body : m_limbs)
        for (const Limb& limb : body)
            points.insert(points.end(), {limb.from, limb.to});
    for (const ColliderBody& body : m_bodies) {
        const Collider& collider = body.collider;
        if (!collider.shown || !m_frame)
            continue;
        if (!isGround(body))
            for (const Vec3& point : extremesOf(body, placeOf(*m_frame, body.id, collider)))
                points.push_back(point);
    }
    return points;
}

std::vector<Vec3> Stage::subjectPoints() const
{
    std::vector<Vec3> points;
    const auto add = [&](int particle) {
        if (const Vec3& place = m_frame->position[std::size_t(particle)]; place.allFinite())
            points.push_back(place);
    };
    for (std::size_t i = 0; m_frame && i < m_look.panelShown.size(); ++i)
        if (m_look.panelShown[i] && !m_frame->gone[i])
            for (const int corner : m_layout->panelCorners[i])
                add(corner);
    if (points.empty())
        return shownPoints();
    for (std::size_t i = 0; i < m_look.isWeight.size(); ++i)
        if ((m_look.isWeight[i] || m_look.isBridle[i]) && m_look.particleShown[i])
            add(int(i));
    for (std::size_t i = 0; i < m_limbs.size(); ++i)
        if (m_people[i].pose != Pose::Standing)
            for (const Limb& limb : m_limbs[i])
                points.insert(points.end(), {limb.from, limb.to});
    return points;
}

// That of the design where they are too new for the one that is shown.
std::shared_ptr<const Frame> Stage::frameWith(const Scene& scene, const std::vector<Id>& ids) const
{
    const bool isOld = !m_frame || (!ids.empty() && placesOf(*m_frame, scene, ids).empty());
    return isOld ? sceneFrame(scene) : m_frame;
}

std::vector<Vec3> Stage::fittedPoints(const Scene& scene, const std::vector<Id>& ids) const
{
    std::vector<Vec3> places = pointsOf(scene, ids);
    const auto frame = frameWith(scene, ids);
    const auto isFitted = [&, fabric = places](int particle) {
        return std::ranges::find(fabric, frame->position[std::size_t(particle)]) != fabric.end();
    };
    for (const Person& person :
         m_peopleShown ? peopleOf(scene, *frame->layout) : std::vector<Person>())
        if (person.pose != Pose::Standing && std::ranges::any_of(person.holds, isFitted))
            for (const Limb& limb : limbsOf(person, *frame, m_bodies))
                places.insert(places.end(), {limb.from, limb.to});
    return places;
}

std::vector<Vec3> Stage::pointsOf(const Scene& scene, const std::vector<Id>& ids) const
{
    std::vector<Vec3> places = placesOf(*frameWith(scene, ids), scene, ids);
    for (const ColliderBody& body : m_bodies)
        if (m_frame && std::ranges::binary_search(ids, body.id))
            for (const Vec3& corner : cornersOf(body, placeOf(*m_frame, body.id, body.collider)))
                places.push_back(corner);
    return places;
}

void Stage::takePeople(const Scene& scene)
{
    m_people = m_peopleShown ? peopleOf(scene, *m_layout) : std::vector<Person>();
}

void Stage::takeLimbs()
{
    m_limbs.clear();
    for (const Person& person : m_people)
        m_limbs.push_back(limbsOf(person, *m_frame, m_bodies));
}

void Stage::takeBounds()
{
    m_bounds.setEmpty();
    for (const Vec3& point : shownPoints())
        m_bounds.extend(point);
    m_landscape.setEmpty();
    for (const ColliderBody& body : m_bodies)
        if (body.collider.shown && isGround(body))
            for (const Vec3& corner : cornersOf(body, placeOf(*m_frame, body.id, body.collider)))
                m_landscape.extend(corner);
}

void Stage::takeRange()
{
    if (isState(m_colorBy) || m_colorBy == ColorBy::Grain)
        return;
    m_range.take(rangedValues(m_values), isSigned(m_colorBy), m_rangeToPeak ? 0.0 : beyondColors,
                 m_drawn ? m_frame->time - m_drawn->time : 0.0);
}

bool Stage::somethingBroke() const
{
    return !m_drawn || m_drawn->torn != m_frame->torn || m_drawn->gone != m_frame->gone;
}

std::ptrdiff_t Stage::lateOnes() const
{
    return std::ranges::count_if(m_bodies, &ColliderBody::isLate);
}

void Stage::prepare(const Scene& scene)
{
    if (!m_frame)
        return;
    // After an edit of values the layout is another object with the same content.
    const bool otherLayout =
        m_layout != m_frame->layout && (!m_layout || *m_layout != *m_frame->layout);
    const bool otherFrame = m_drawn != m_frame;
    if (otherLayout || m_lookIsOld) {
        m_layout = m_frame->layout;
        m_look = lookOf(scene, *m_layout);
        takePeople(scene);
    }
    if (const auto late = lateOnes(); otherLayout || m_lookIsOld || late > 0) {
        m_bodies = bodiesOf(scene, std::move(m_bodies));
        m_layersAreOld |= lateOnes() != late;
    }
    const bool rebuild = otherLayout || m_lookIsOld || m_layersAreOld || somethingBroke();
    if (!rebuild && !otherFrame && !m_selectionIsOld)
        return;

    if (m_drawn && m_drawn->run != m_frame->run)
        m_range.reset();
    takePoints();
    takeLimbs();
    takeBounds();
    takeDesign(scene);
    m_values = valuesOf(*m_frame, m_colorBy, m_look);
    takeRange();

    const auto withSelected = [this, &scene](const std::vector<Id>& ids) {
        return Picture{scene,    *m_frame, m_look,       m_theme,    m_points, ids,
                       m_bodies, m_people, m_limbs,      m_colorBy,  m_values, colors(),
                       range(),  m_bounds, m_pixelRatio, m_meshShown};
    };
    const std::vector<Id> none;
    const Picture marked = withSelected(m_selectionMarked ? m_selected : none);
    const Picture followed = withSelected(m_selected); // or trails would begin anew
    for (Layer* layer : layers()) {
        const Picture& picture = layer == &trails ? followed : marked;
        const bool shows = layer == &m_highlight || layer == &m_colliders // what is selected
                           || layer == &trails;
        if (rebuild || (m_selectionIsOld && shows))
            layer->rebuild(picture);
        if (rebuild || otherFrame || shows)
            layer->update(picture);
    }
    m_selectionIsOld = false;
    m_drawn = m_frame;
    m_lookIsOld = false;
    m_layersAreOld = false;
}

void Stage::place(const Camera& camera)
{
    // Everything that is drawn lies within this distance of the focus.
    const Vec3 middle = m_bounds.isEmpty() ? camera.focus : Vec3(m_bounds.center());
    double reach = (middle - camera.focus).norm() + 1.2 * groundRadius(m_bounds);
    if (!m_landscape.isEmpty())
        reach = std::max(reach, (m_landscape.center() - camera.focus).norm()
                                    + 0.5 * m_landscape.diagonal().norm());
    const double step = camera.orthographic ? reach : 0.0; // an orthographic eye may step back

    const Vec3 eye = camera.eye() + step * camera.back();
    const Vec3 up = camera.up();
    vtkCamera& target = *m_renderer->GetActiveCamera();
    target.SetPosition(eye.x(), eye.y(), eye.z());
    target.SetFocalPoint(camera.focus.x(), camera.focus.y(), camera.focus.z());
    target.SetViewUp(up.x(), up.y(), up.z());
    target.SetViewAngle(Camera::viewAngle * 180.0 / std::numbers::pi);
    target.SetParallelProjection(camera.orthographic);
    target.SetParallelScale(camera.halfHeight());

    const double distance = camera.distance + step;
    const double near = std::max(distance - reach, 0.02 * camera.distance);
    target.SetClippingRange(near, distance + reach);
    m_backdrop.place(target);
    m_streaks.place({camera.focus, 2.0 * camera.halfHeight()});
}

} // namespace ripstop
