// Gives mass to what is selected, and says what it weighs. The operation "mass" and the targets of
// parts use the first, the totals of the inspector the second. Masses in kg, lengths in m; edits
// set masses and no densities.
#pragma once

#include "base/result.h"
#include "scene/edit.h"

namespace ripstop {

// What the amount is: kg for each particle; kg/m along the links, half of each to either end;
// kg/m^2 over the panels, a third of each to every corner; or kg in all, shared out evenly or in
// the proportions of the masses as they are. Lengths are rest lengths.
enum class MassBy { Particle, Length, Area, TotalEvenly, TotalInProportion };

// New masses of the particles that are meant (see movable.h), in place of the old ones. Links and
// panels count that lie among them; a particle without any keeps its mass. Fails with a sentence
// where there is nothing to spread the mass by.
Result<Edit> massSpread(const Scene& scene, const std::vector<Id>& ids, MassBy by, double amount);

struct MassProperties
{
    double mass = 0.0;           // kg
    Vec3 centre = Vec3::Zero();  // m, of gravity; the origin without mass
    Vec3 inertia = Vec3::Zero(); // kg m^2, about the axes through the centre along x, y and z
    std::size_t particles = 0;
};

// The mass properties of what is selected, or of the whole design when nothing is.
MassProperties massPropertiesOf(const Scene& scene, const std::vector<Id>& ids);

} // namespace ripstop
