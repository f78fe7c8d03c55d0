// The parameters of a built part as it stands: of what its cloth, spars and lines are by now.
//
// A builder asks for materials by name. One that was exchanged for another of the library since
// (materials/neighbours.h) stays when the part is built again, and so the form of its parameters
// has to say what is there, not what there was.
#pragma once

#include "builders/builder.h"
#include "materials/preset.h"
#include "scene/scene.h"

#include <string_view>
#include <vector>

namespace ripstop {

// A choice of which all is of a material by now that the builder does not offer.
struct OtherMaterial
{
    std::string_view parameter; // key
    const Preset* preset;
};

struct ChosenNow
{
    Parameters parameters; // a choice follows where its material is another one that is offered
    std::vector<OtherMaterial> others;
};

// Of a part with a builder.
ChosenNow chosenNow(const Scene& scene, Id part);

} // namespace ripstop
