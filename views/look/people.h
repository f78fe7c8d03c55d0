// Who stands, flies and hangs in a scene, as its design says, so that sizes can be compared.
//
// Someone stands where a control moves pinned particles at which nothing but lines ends: the hand
// of a kite. Someone hangs
// - prone, where controls shift a weight below fabric: the pilot of a glider;
// - upright, where three lines or more carry a weight, as heavy as a person or a child, below
//   fabric.
// Names count for nothing, so that a design drawn by hand has its people, too. All of it is found
// once for each layout and edit; where they are in a frame is told by figure.h.
#pragma once

#include "scene/scene.h"
#include "simulation/frame.h"

#include <array>
#include <vector>

namespace ripstop {

enum class Pose { Standing, Prone, Upright };

struct Person
{
    Pose pose = Pose::Standing;
    std::vector<int> holds;   // particles: one for each hand of who stands; what others hang at
    std::vector<int> towards; // particles at the other ends of the lines there
    // Particles that lie farthest ahead, astern, on the left and on the right of what carries them:
    // they turn with it. Empty for who stands.
    std::vector<int> marks;
    // Particle at which the wires below a wing meet, the foot of its control frame; or nothing.
    std::vector<int> bar;
};

std::vector<Person> peopleOf(const Scene& scene, const Layout& layout);

} // namespace ripstop
