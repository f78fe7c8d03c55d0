// Edits in flight of panels that carry the pull of a fabric: the law of a material, and the cut and
// the stiffness factor of a panel, go over into what was typed as numbers of links do
// (ramp_curve.h).
//
// A law goes by its compliances, so that what hangs on the cloth goes evenly: its matrix is
//
//     C(s) = ((1 - s) C0^-1 + s C1^-1)^-1,
//
// positive definite with C0 and C1, whatever Poisson's ratios they have. Where one of the two
// carries nothing, stiffness goes evenly instead. Whether a cloth pushes counts at once.
//
// A cut goes by what turns it and what stretches it: with D the sides of a panel at rest, as
// columns along warp and weft, and D1 D0^-1 = R U, R a turn by the angle a and U symmetric,
//
//     D(s) = R(s a) (1 + s (U - 1)) D0.
//
// All that U can be is positive, and so a panel has an area all the way. Warps run both ways: a
// grain of 170 degrees is 10 degrees from one of 0.
//
// A factor goes by its inverse, as the stiffness of a spring does. That of the strength counts at
// once, as tear rules do.
//
// Key: materials and panels are known by theirs, so that an edit may renumber them. A panel that
// gets another material has the law of that one at once.
#pragma once

#include "compile/patch.h"
#include "simulation/ramp_curve.h"
#include "system/system.h"

#include <array>
#include <span>
#include <vector>

namespace ripstop {

// Laws, cuts and factors of all elastic panels at a moment, noted before an edit.
class NotedCloth
{
public:
    // What is under way in the state counts as far as it has come.
    NotedCloth(const System& system, const State& state);

    // What is under way after the edit; what begins has no duration yet, and lengthens the way.
    std::vector<ClothRamp> lawRampsTo(const System& edited, RampWay& way) const;
    void panelRampsTo(const System& edited, State& state, RampWay& way) const;

private:
    struct Law
    {
        Key material;
        ClothLaw law;
    };
    struct Panel
    {
        Key key;
        Key material;
        PanelCut cut;
        double factor;               // 1, of the stiffness
        std::array<Vec3, 3> corners; // m
    };

    void addCutRamp(const Membrane& edited, const Panel& noted, const PanelRamp* underWay,
                    std::vector<PanelRamp>& ramps, RampWay& way) const;
    void addFactorRamp(const Membrane& edited, const Panel& noted, const FactorRamp* underWay,
                       std::vector<FactorRamp>& ramps, RampWay& way) const;

    double m_time; // s
    std::vector<Law> m_laws;
    std::vector<Panel> m_panels; // [membranes]
    std::vector<ClothRamp> m_lawRamps;
    std::vector<PanelRamp> m_cutRamps;
    std::vector<FactorRamp> m_factorRamps;
};

// The law and the cut that are a share of the way from one to the other; at 1 the other itself.
ClothLaw lawBetween(const ClothLaw& from, const ClothLaw& to, double share);
PanelCut cutBetween(const PanelCut& from, const PanelCut& to, double share);

// Adds the numbers of ramps at a time, s, to what is to change of a system.
void addCloth(const System& system, const State& state, double time, Patch& patch);

} // namespace ripstop
