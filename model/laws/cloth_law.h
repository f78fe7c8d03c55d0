// How a woven fabric pulls when it is strained in its plane: an orthotropic membrane.
//
// Strain is Green's, (F^T F - 1) / 2, in the frame of the cloth: along the warp, along the weft,
// and the shear between them (twice the tensor's component, about the angle by which threads close
// up). Tension is the second Piola and Kirchhoff's, per width of the flat cloth, N/m. They are
// proportional (St. Venant and Kirchhoff): rotations of any size cost nothing and strains are meant
// to be small; at 2 % of strain the pull per flat width is 2 % more than an engineer's E t times
// strain.
//
//     warp  = warp e1 + coupling e2,   weft = coupling e1 + weft e2,   shear = shear g
//     with warp = E1 / (1 - nu12 nu21), coupling = nu12 E2 / (1 - nu12 nu21), nu21 = nu12 E2 / E1
//     (Jones, Mechanics of Composite Materials, 1975, section 2.6)
//
// Cloth does not push: it wrinkles instead. The tension is then that of the relaxed energy (Pipkin
// 1986; Steigmann 1990), the least over all P >= 0 of the energy of the strain e + P, P being what
// wrinkles take up. It is the projection of the tension onto those that push nowhere. A wrinkled
// cloth pulls along one direction t only, the one in which
//
//     (t.e.t)^2 / (2 D(t)),    D(t) = compliance along t,
//
// is greatest; a slack one not at all. The energy is convex and has one derivative everywhere, so
// that a Newton method with a line search finds its way.
//
// To wrinkle, cloth has to bend. What wrinkles within a piece of a mesh are folds no longer than
// the piece; longer ones are the mesh's own. The longest give way first, at Euler's load of a strip
// of the flexural rigidity B between hinges as far apart as the piece is long,
//
//     N = pi^2 B / l^2.
//
// The relaxed energy counts N (P1 + P2) for what wrinkles take up: it is the one above at the
// strain e + C^-1 (N, N, 0) but for what is linear in e, and the tension is that one less N in each
// direction. Where pieces are short they push and the mesh folds; where they are long N is next to
// nothing.
#pragma once

#include "base/choice_names.h"
#include "base/vec3.h"

namespace ripstop {

// What carries the pull of a fabric: threads are links, panels its triangles by the law below.
enum class FabricKind { Threads, Panels };
template <>
inline constexpr std::array<std::string_view, 2> choiceNames<FabricKind>{"threads", "panels"};

struct ClothLaw
{
    double warp = 0.0; // N/m, above; 0 for what has no law
    double weft = 0.0;
    double coupling = 0.0;
    double shear = 0.0;
    double dampingTime = 0.0; // s, as of rods (system/links.h)
    bool pushes = false;      // as a board does, instead of wrinkling

    // From engineering numbers: E t along warp and weft and G t, N/m, and Poisson's ratio of what
    // is pulled along the warp. Needs poisson^2 < warp / weft.
    static ClothLaw of(double warp, double weft, double poisson, double shear);

    bool isElastic() const { return warp > 0.0; }

    // That of a cloth so many times as stiff; what damps it takes the same time.
    ClothLaw times(double factor) const
    {
        return {warp * factor,  weft * factor, coupling * factor,
                shear * factor, dampingTime,   pushes};
    }

    friend bool operator==(const ClothLaw&, const ClothLaw&) = default;
};

// That of a piece of cloth in a mesh.
struct PieceLaw : ClothLaw
{
    double bucklingLoad = 0.0; // N/m, N above

    PieceLaw(const ClothLaw& law, double load = 0.0)
        : ClothLaw(law)
        , bucklingLoad(load)
    {}
};

// N/m, N above.
//   bendingStiffness  N m, B
//   length            m
double bucklingLoadOf(double bendingStiffness, double length);

enum class ClothState { Slack, Wrinkled, Taut };

// At some strain.
struct ClothTension
{
    ClothState state = ClothState::Slack;
    Vec3 tension = Vec3::Zero();   // N/m: along the warp, the weft, shear
    Mat3 stiffness = Mat3::Zero(); // N/m, its derivative by the strain; never negative
    double energy = 0.0;           // N/m, that is J per m^2 of flat cloth
};

// The law at a strain; `strain` as above: e1, e2 and g.
ClothTension tensionOf(const PieceLaw& law, const Vec3& strain);

// What of a strain the threads have; wrinkles take up the rest. The first is for a strain at which
// the law is known.
Vec3 threadStrain(const PieceLaw& law, const Vec3& strain, const ClothTension& now);
Vec3 pullingStrain(const PieceLaw& law, const Vec3& strain);

// The strain that threads have where the tension is this one; what wrinkles take up is not in it.
Vec3 strainOf(const ClothLaw& law, const Vec3& tension);

// What a tension of the plane pulls most, N/m; negative where it pushes all around.
double largestTension(const Vec3& tension);

} // namespace ripstop
