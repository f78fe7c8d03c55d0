// Fabric: its panels, what the air does to them, and what keeps them apart.
//
// Panels hold no numbers but their corners and the place of their air in System::materialAir, so
// that panels of one material share them. The laws stand in forces/panel_load.h and
// laws/vortex_wing.h, the distances in contact/fabric_contact.h.
#pragma once

#include "laws/air_laws.h"
#include "system/key.h"
#include "system/links.h"

#include <array>
#include <vector>

namespace ripstop {

inline constexpr int polarCells = 256; // of a table of lift and drag

struct PolarPoint
{
    double lift; // 1, CL
    double drag; // 1, CD

    friend bool operator==(const PolarPoint&, const PolarPoint&) = default;
};

// What the air does to things of one material: to its panels (panel_load.h) and to its links as
// lines (line_drag.h).
struct MaterialAir
{
    Key key = 0; // of the material; 0 for none
    AirLaw law = AirLaw::LinearNormal;
    double normalCoefficient = 2.0; // 1, Ca
    double saturation = 0.0;        // 1, Ca / C90 - 1; linear normal only
    double skinFriction = 0.0;      // 1, Cs
    double porosity = 0.0;          // 1, c
    double stall = 0.0;             // 1, sine of the stall of a wing; 0 for what is none
    double lineWidth = 0.0;         // m, drag coefficient times diameter
    std::vector<PolarPoint> polar;  // [polarCells + 1] at equal steps of tan(alpha / 2) from 0 to 1

    friend bool operator==(const MaterialAir&, const MaterialAir&) = default;
};

struct FabricPanel // one triangle of fabric
{
    std::array<int, 3> corner;
    int air; // index into System::materialAir

    friend bool operator==(const FabricPanel&, const FabricPanel&) = default;
};

// What an elastic panel is cut like. With x_a, x_b, x_c its corners, the columns of
//     F = (x_b - x_a, x_c - x_a) shape
// are where the warp and the weft have gone, 1 long each at rest.
struct PanelCut
{
    double area = 0.0;             // m^2, flat and at rest
    std::array<double, 4> shape{}; // 1/m, row by row: the inverse of the sides ab and ac at rest,
                                   // as columns, along warp and weft

    friend bool operator==(const PanelCut&, const PanelCut&) = default;
};

// A panel that carries the pull of the fabric: a triangle of constant strain. Its law is that of
// the panel's material in System::cloth, times its factors.
struct Membrane : PanelCut
{
    int panel = 0; // index into System::panels
    ElementFactors factors;

    friend bool operator==(const Membrane&, const Membrane&) = default;
};

// What keeps the particles of a part from its panels and those of others; see fabric_contact.h.
struct FabricLayer
{
    double thickness = 0.0; // m, 0 goes through
    double friction = 0.0;  // 1

    friend bool operator==(const FabricLayer&, const FabricLayer&) = default;
};

} // namespace ripstop
