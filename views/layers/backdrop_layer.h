// Sky, horizon and the ground to it, behind all else.
//
// A scene with a level plane gets a sky, and a ground with squares of round metres whose step goes
// with the height of the eye: 1 m for who stands on it, 10 m from a kite, 100 m from a glider. A
// scene with a landscape gets sky and haze alone. Others keep the plain backdrop of the renderer.
//
// Fabric, people and colliders throw soft shadows on that ground (look/shadow_map.h): what flies
// into one picture, what stands into another, so that each is as sharp as its size allows.
//
// The horizon lies where directions level with the eye are seen, and ground and sky fade into the
// same haze there. All of it is one shader over the picture (backdrop_shader.h), which costs the
// same whatever is seen.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"
#include "look/backdrop.h"
#include "look/shadow_map.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkTexture.h>

#include <optional>

class vtkCamera;
class vtkUniforms;

namespace ripstop {

// The plane that the ground of the picture is: the first level one that is shown.
std::optional<Id> levelPlane(const Scene& scene);

// Squares of the ground for an eye at this height over it, m.
struct GroundStep
{
    double fine;   // m, a power of ten
    double coarse; // 0 .. 1, how far the next step, ten times as wide, has taken over

    double mostSeen() const { return coarse > 0.6 ? 10.0 * fine : fine; }
};
GroundStep groundStep(double height);

class BackdropLayer final : public Layer
{
public:
    BackdropLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

    void setBackdrop(Backdrop backdrop);
    void setFabricShown(bool shown); // without it, it has no shadow
    void place(vtkCamera& camera);   // before each picture
    double squares() const;          // m, of the ground; 0 where there are none

private:
    enum class Kind { Plain, Haze, Ground };

    // What throws a shadow, and the picture of that on a square of ground.
    struct Shadow
    {
        std::vector<Vec3> places; // m
        std::vector<std::array<int, 3>> triangles;
        ShadowMap map;
        double shownGround = 0.0; // m, of what the map shows, as what follows
        std::vector<Vec3> shownPlaces;
        std::vector<std::array<int, 3>> shownTriangles;
        vtkNew<vtkImageData> image;
        vtkNew<vtkTexture> texture;
        vtkNew<vtkPoints> corners;
        vtkNew<vtkPolyData> square;
        vtkNew<vtkPolyDataMapper> mapper;
        vtkNew<vtkActor> actor;

        explicit Shadow(double depth); // behind cloth on the ground, and behind other shadows
        void add(const Limb& limb);
        bool cast(double ground); // whether it is another one now
        void draw(const std::vector<std::uint8_t>& dark);
    };

    vtkUniforms& uniforms();
    void paint(const Theme& theme);
    bool castFlying(const Picture& picture);
    bool castStanding(const Picture& picture);
    void showShadows();

    Kind m_kind = Kind::Plain;
    Backdrop m_backdrop = Backdrop::Scenery;
    Id m_plane = noId;
    double m_height = 0.0;     // m, of the ground
    GroundStep m_step{1, 0.0}; // as seen now
    bool m_shown = true;
    bool m_fabricShown = true;
    bool m_isAbove = true; // the eye, of the ground
    QColor m_shadowColor;
    std::vector<std::array<int, 3>> m_fabric; // panels that are drawn
    Shadow m_flying{8.0}, m_standing{5.0};    // in the order that they are drawn in
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
