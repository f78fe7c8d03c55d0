// What a value is for: whether anything of the present set-up asks for it.
//
// The stiffness of a rod, the sweeps of a solver that makes one, the air of a scene without fabric:
// such numbers can be turned for hours without effect, so forms say that they do nothing, and why.
// The conditions stand in property_needs.h, a column of the table of properties.
#pragma once

#include "scene/edit.h"

#include <map>

namespace ripstop {

// What is made of a material, or of all of them.
struct Use
{
    std::size_t springs = 0;
    std::size_t rods = 0;
    std::size_t panels = 0;
    std::size_t elasticPanels = 0; // of parts of which panels carry the pull
    std::size_t ownStiffness = 0;  // springs that have their own
    std::size_t ownDamping = 0;    // springs that have their own
    std::size_t ownCompliance = 0; // rods that have their own
    std::size_t ownTearLimit = 0;  // links that have their own
    std::size_t lines = 0;         // links with the role line
    std::size_t threads = 0;       // links with the role thread and a width
    std::size_t biases = 0;        // links with the role bias and a width
    std::size_t held = 0;          // links of spars that rigidity particles hold in shape

    std::size_t links() const { return springs + rods; }
};

struct Usage
{
    std::map<Id, Use> ofMaterial;
    Use ofAll;
};

// Goes over all links and panels once.
Usage usageOf(const Scene& scene);

// What a condition of the property table may look at, beside the thing itself.
struct Circumstances
{
    const Scene& scene;
    const Use& all; // of all links and panels
    Use made;       // of the thing, where it is a material
};

// Whether the edit may make a usage stale.
bool changesUsage(const Edit& edit);

// Why the property of this thing does nothing as things are, as half a sentence ("its links are all
// rods, which take the compliance"); nothing where it has an effect.
std::optional<std::string> whyIdle(const Scene& scene, const Usage& usage, const Property& property,
                                   Id id);

} // namespace ripstop
