// Everything that is drawn, as VTK sees it: renderer, lights, camera and layers.
//
// Setters only note what has changed. prepare() brings the layers up to date, once per picture; it
// returns at once when nothing has changed, so picking and fitting may call it as well. Coordinates
// are those of the frame, in place and without a copy: the stage holds the frame for as long as VTK
// may read them. It belongs to the thread of the window and never asks for a picture by itself;
// that is for the viewport.
#pragma once

#include "camera/camera.h"
#include "layers/backdrop_layer.h"
#include "layers/collider_layer.h"
#include "layers/ghost_layer.h"
#include "layers/grain_layer.h"
#include "layers/ground_layer.h"
#include "layers/guide_layer.h"
#include "layers/highlight_layer.h"
#include "layers/link_layer.h"
#include "layers/panel_layer.h"
#include "layers/particle_layer.h"
#include "layers/person_layer.h"
#include "layers/shadow_layer.h"
#include "layers/streak_layer.h"
#include "layers/trail_layer.h"
#include "layers/vector_layer.h"
#include "layers/weight_layer.h"
#include "layers/wind_layer.h"
#include "look/figure.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkPoints.h>
#include <vtkRenderer.h>

#include <optional>

class vtkRenderWindow;

namespace ripstop {

class Stage
{
public:
    explicit Stage(vtkRenderWindow& window);

    void show(std::shared_ptr<const Frame> frame);
    void setTheme(const Theme& theme);
    void setColorBy(ColorBy colorBy);
    void takeRanges(const Stage& other); // of the colours, of another view
    void forgetRanges();                 // those that were typed for another scene
    // Of the quantity that is shown; without one it follows the values, from this moment on.
    void setFixedRange(std::optional<ValueRange> range);
    void setRangeToPeak(bool toPeak); // lets no value lie beyond what follows; off at first
    void setSelected(std::vector<Id> ids);
    void setSelectionMarked(bool marked); // on at first; trails are left of it in any case
    void setBackdrop(Backdrop backdrop);  // sky and ground at first
    void setPixelRatio(double ratio);
    void sceneChanged() { m_lookIsOld = true; } // what the scene says about looks
    void designChanged() { m_design.reset(); }  // what the scene says about places
    void setDesignShown(bool shown);            // as a ghost; off at first

    void prepare(const Scene& scene);
    void place(const Camera& camera);

    void setPanelsShown(bool shown);     // panels and their shadow
    void setPeopleShown(bool shown);     // on at first; without them, weights are balls
    void setWindShown(bool shown);       // the field of arrows
    void setStreaksShown(bool shown);    // that drift with the wind; on at first
    void setMotionReduced(bool reduced); // without them, whatever was chosen
    void setVectors(Vectors vectors);
    void setPinsShown(bool shown); // marks of particles that are fixed or guided
    void setGrainShown(bool shown);
    void setMeshShown(bool shown); // links that stand for fabric; off at first

    PanelLayer panels;
    LinkLayer links;
    ParticleLayer particles;
    GhostLayer ghost{GhostLayer::Of::Run};
    TrailLayer trails;

    // What follows is as of the last prepare().
    const std::shared_ptr<const Frame>& frame() const { return m_frame; }
    // Places that a designer looks at first, m: the fabric with its bridle and what it carries, or
    // everything when there is no fabric.
    std::vector<Vec3> subjectPoints() const;
    std::vector<Vec3> pointsOf(const Scene& scene, const std::vector<Id>& ids) const;
    // With who hangs there, as they are to be seen as well.
    std::vector<Vec3> fittedPoints(const Scene& scene, const std::vector<Id>& ids) const;
    const Look& look() const { return m_look; }
    const std::vector<ColliderBody>& colliders() const { return m_bodies; }
    const Eigen::AlignedBox3d& bounds() const { return m_bounds; }
    const Theme& theme() const { return m_theme; }
    ColorBy colorBy() const { return m_colorBy; }
    Peak peak() const { return m_frame ? peakOf(*m_frame, m_values) : Peak{}; }
    ValueRange extent() const { return extentOf(m_values); } // of the values, not of the colours
    bool isKnown() const { return m_frame && m_values.isKnown; } // something has that quantity
    ValueRange range() const;
    const ColorMap& colors() const;

    double squares() const { return m_backdrop.squares(); } // m, of the ground, as placed; or 0

    // Places of all that is shown but the ground, m.
    std::vector<Vec3> shownPoints() const;

private:
    const std::optional<ValueRange>& fixedRange() const
    {
        return m_fixedRanges[std::size_t(m_colorBy)];
    }
    void light();
    std::shared_ptr<const Frame> frameWith(const Scene& scene, const std::vector<Id>& ids) const;
    void takePoints();
    void takePeople(const Scene& scene);
    void takeLimbs();
    void takeBounds();
    void takeRange();
    bool somethingBroke() const;
    std::ptrdiff_t lateOnes() const; // colliders whose file is being read
    void takeDesign(const Scene& scene);
    std::array<Layer*, 19> layers();

    BackdropLayer m_backdrop;
    PinLayer m_pins;
    GuideLayer m_guides;
    WeightLayer m_weights;
    HighlightLayer m_highlight;
    GroundLayer m_ground;
    ColliderLayer m_colliders;
    PersonLayer m_person;
    ShadowLayer m_shadow;
    WindLayer m_wind;
    StreakLayer m_streaks;
    VectorLayer m_vectors;
    GrainLayer m_grain;
    GhostLayer m_designGhost{GhostLayer::Of::Design};
    std::shared_ptr<const Frame> m_design; // null until it is made for showing
    bool m_designShown = false;
    bool m_meshShown = false;

    std::shared_ptr<const Frame> m_frame; // keeps the coordinates alive
    std::shared_ptr<const Frame> m_drawn; // what the layers show
    std::shared_ptr<const Layout> m_layout;
    Look m_look;
    std::vector<ColliderBody> m_bodies;
    std::vector<Person> m_people;           // of the design; none while they are not to be seen
    std::vector<std::vector<Limb>> m_limbs; // [people] in the frame
    bool m_peopleShown = true;
    bool m_streaksShown = true;
    bool m_motionReduced = false;
    Theme m_theme = Theme::light();
    ColorBy m_colorBy = ColorBy::Material;
    QuantityValues m_values;
    SteadyRange m_range;
    bool m_rangeToPeak = false;
    std::array<std::optional<ValueRange>, colorByCount> m_fixedRanges;
    std::vector<Id> m_selected;
    bool m_selectionMarked = true;
    Eigen::AlignedBox3d m_bounds;
    Eigen::AlignedBox3d m_landscape; // around the height fields
    double m_pixelRatio = 1.0;
    bool m_lookIsOld = true;
    bool m_layersAreOld = true;
    bool m_selectionIsOld = true; // concerns only the layers that show it

    vtkNew<vtkAOSDataArrayTemplate<double>> m_coordinates;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkRenderer> m_renderer;
};

} // namespace ripstop
