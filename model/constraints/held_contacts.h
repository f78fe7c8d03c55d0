// Contact with obstacles as the direct solver has it (direct_solver.h): what obstacles do to
// particles is found together with the pulls of their rods and panels.
//
// A contact is a plane that a particle may not get behind. With the depth d below it, it adds
//
//     d^2 / (2 s)      where d > 0
//
// to the sum that is minimised, s being so little that no eye sees d: a particle at rest sinks by a
// ten-thousandth of what it would fall in the substep. Which contacts act is decided anew in each
// iteration: at first by what would press the particle on without rods. One that acts goes on as
// long as its push would bring the particle to the plane; the others begin below it (primal-dual
// active sets: Hintermueller, Ito and Kunisch 2002). By the depth alone, all of a round surface
// would let go whenever what lies on it shifts a little along it. In the end none pulls; the
// multiplier over the square of the substep is the normal force.
//
// Friction is Coulomb's, with the way u along the surface in this substep: a particle sticks, as if
// u were held by the same s, until that takes more than friction times the normal force; then it
// slides against so much. Under loads by which u would be seen to grow from substep to substep, as
// of a heavy weight on a light rope, what sticks is held harder when all else is found. The normal
// force in this bound is that of the iteration before (lagged, as Li et al. 2020, Incremental
// Potential Contact, do it), so the matrix stays symmetric, and iterations go on until it hardly
// changes.
//
// Where planes are is asked of the surface again after each iteration, as are particles that came
// into a surface with it: particles follow what is round.
#pragma once

#include "base/vec3.h"
#include "parallel/simd_pack.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

// How friction finds its balance. What neither slides nor sticks for long sticks where it is firm,
// which a heavy weight on a light rope needs to come to rest. Where it gives, such a contact has
// half of its friction, by which panels find theirs as they land; they are light and pull little.
enum class Friction { Firm, Giving };

struct HeldContact
{
    std::uint32_t row = 0; // of the solver's positions
    int particle = 0;
    int obstacle = 0;
    bool isNew = true;           // since the last iteration
    bool isFirst = true;         // before the first iteration
    bool isNear = true;          // the surface is there still
    Vec3 surface = Vec3::Zero(); // m, on the plane
    Vec3 normal = Vec3::UnitY(); // unit, outwards
    Vec3 start = Vec3::Zero();   // m, where the substep began, carried along by the obstacle
    double friction = 0.0;       // 1, of impulses, so that what bounces back counts
    double inward = 0.0;         // m/s, at which the particle came, or 0 where it was at rest

    double inverseMass = 0.0; // 1/kg
    double softness = 0.0;    // 1/kg, s above
    double hold = 0.0;        // 1/kg, the same of friction, where it sticks
    bool acts = false;        // in this iteration
    bool sticks = true;       // if it acts
    Friction kind = Friction::Firm;
    int turns = 0;               // how often it has slid and come to rest
    double share = 1.0;          // of friction, where it neither slides nor sticks for long
    double depth = 0.0;          // m, below the plane
    Vec3 slip = Vec3::Zero();    // m, u above
    double multiplier = 0.0;     // kg m, that the linear system gave
    double before = 0.0;         // kg m, of the iteration before
    double most = 0.0;           // kg m, what friction may take in this iteration
    Vec3 against = Vec3::Zero(); // unit, the way that it slides in this iteration
    Vec3 rub = Vec3::Zero();     // kg m, friction that the linear system gave

    bool holds() const { return isNear && acts && multiplier > 0.0; }
    // Normal push and friction, kg m.
    Vec3 push() const { return holds() ? Vec3(multiplier * normal + rub) : Vec3(Vec3::Zero()); }
    // How far it is from where it belongs, m.
    double miss() const;
};

// Asked where surfaces are; what stands in contact/ knows.
class ContactSearch
{
public:
    virtual ~ContactSearch() = default;

    // Looks again at the contacts that there are, and adds those of particles that are near a
    // surface, or went through one, and have none with it; no more than fit in. In the order of
    // rows, then of obstacles.
    //   particle  [rows]
    //   position  [rows]  m
    virtual void find(std::span<const int> particle, std::span<const Row> position,
                      std::vector<HeldContact>& contacts) const = 0;
};

class HeldContacts
{
public:
    // Takes memory for particles that touch this many surfaces each; nothing else does.
    void reserve(std::size_t nodes);

    // Before an iteration of the first guess.
    //   guess  [rows]  m, where particles are without rods
    void start(const ContactSearch* search, std::span<const int> particle,
               std::span<const double> mass, std::span<const Row> guess, Friction kind);

    // Looks at all surfaces again; returns whether all is where it was thought to be.
    bool follow(std::span<const int> particle, std::span<const double> mass,
                std::span<const Row> position);

    bool empty() const { return m_contacts.empty(); }
    std::span<const HeldContact> list() const { return m_contacts; }

    // Decides which contacts act, and how, and hands what they add to `add(row, block, pull)`.
    template <typename Add>
    void assemble(Add add)
    {
        for (HeldContact& contact : m_contacts) {
            decide(contact);
            if (contact.acts)
                add(contact.row, stiffnessOf(contact), pullOf(contact));
        }
    }

    // Foresees what surfaces give at the end of a move, before measure().
    void foresee(std::span<const Row> move);
    void settle(double share); // what of the move was foreseen

    // After measure(): puts particles below surfaces that do not act onto them. Whether any were.
    bool lift(std::span<Row> position) const;

    void measure(std::span<const Row> position);
    double energy() const;                                // twice, kg m^2
    double energyAt(std::span<const Row> position) const; // that, of normal pushes alone

    // After measure(): whether all contacts are where the linear system put them, and friction is
    // what the normal forces allow within ten times `accuracy`; after a few iterations that is left
    // as it is.
    bool isSettled(double accuracy, int iteration) const;

    // Holds all that sticks harder, where friction is firm and some of it has given way by more
    // than may add up over substeps; each contact once. Whether there was any, so that another
    // iteration is due.
    bool holdHarder();

    // Whether a particle came in at a speed.
    bool hasImpact() const;

private:
    static void decide(HeldContact& contact);
    static Mat3 stiffnessOf(const HeldContact& contact);
    static Vec3 pullOf(const HeldContact& contact);
    void take(HeldContact& contact, double mass, const Vec3& guess);

    const ContactSearch* m_search = nullptr;
    Friction m_kind = Friction::Firm;
    std::vector<HeldContact> m_contacts;
};

} // namespace ripstop
