// Where particles that are solved together with their rods meet obstacles, for the solver to ask
// (constraints/held_contacts.h), and what the solve leaves of their motion.
//
// Particles on guides are left to resolveContacts().
#pragma once

#include "constraints/held_contacts.h"
#include "contact/obstacle_motion.h"

namespace ripstop {

class SurfaceSearch final : public ContactSearch
{
public:
    //   before    [particles]  m, at the start of the substep
    //   velocity  [particles]  m/s, there
    //   placed    [obstacles]  after endMoves()
    //   h         s, the substep
    SurfaceSearch(const System& system, std::span<const PaddedVec3> before,
                  std::span<const PaddedVec3> velocity, std::span<const PlacedObstacle> placed,
                  double h);

    void find(std::span<const int> particle, std::span<const Row> position,
              std::vector<HeldContact>& contacts) const override;

private:
    HeldContact contactOf(std::uint32_t row, std::size_t particle, std::size_t obstacle,
                          const Vec3& place) const;
    void look(HeldContact& contact, const Vec3& place) const;

    const System& m_system;
    std::span<const PaddedVec3> m_before;
    std::span<const PaddedVec3> m_velocity;
    std::span<const PlacedObstacle> m_placed;
    double m_h;         // s
    double m_reach;     // m, from a surface, within which particles are looked at
    double m_restSpeed; // m/s, below which a particle does not bounce
};

// Velocities of particles that the solve has put onto surfaces: what came in goes out with the
// restitution, and what sticks is at rest with its obstacle.
//   contacts  of the solve
//   held      [particles]  1 where the solve has settled all contacts, for resolveContacts()
//   touches   [particles]  adds touchOf() of obstacles that hold
void followHeldContacts(const System& system, State& state, std::span<const HeldContact> contacts,
                        std::span<const PlacedObstacle> placed, double h,
                        std::span<std::uint8_t> held, std::span<std::uint32_t> touches);

} // namespace ripstop
