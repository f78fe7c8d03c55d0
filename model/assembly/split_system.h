// A system whose mesh tears have parted, and whose particles hands have pinned.
//
// What was compiled stays as it is; the splits and pins of a State make another system from it, the
// same one wherever it is made, so that a checkpoint goes on with the same bits. A twin stands at
// the end of the particles, a second link along a lip at the end of the links; all others keep
// their places.
#pragma once

#include "system/system.h"

#include <memory>
#include <span>

namespace ripstop {

// `compiled` with its particles parted, in order, and those of `pins` held in place. What a split
// names and is no longer there is passed over, and the whole split when its particle or all that
// hung on its twin are gone.
//
// A twin takes its share of the mass and is free: pins, hands and probes of a single particle stay
// with the particle it came from. The two links along a lip share stiffness, damping, softness and
// breaking force, so that together they pull as the one did; the line drag stays with the first.
std::shared_ptr<System> splitSystem(const System& compiled, std::span<const Split> splits,
                                    std::span<const Key> pins = {});

// The particles and links that twins came from, in the end: the elements that the author knows.
class TwinOrigins
{
public:
    explicit TwinOrigins(std::span<const Split> splits);

    Key particle(Key key) const; // of the author; any other than a twin is given back as it is
    Key link(Key key) const;     // of the author; any other than a twin is given back as it is

private:
    std::vector<Key> m_particle; // of each twin, in order
    std::vector<Key> m_link;
};

// Keys of twins count up from here, far above the ids of any scene.
inline constexpr Key firstTwinParticle = 0xC0000000u;
inline constexpr Key firstTwinLink = 0xE0000000u;

} // namespace ripstop
