// Sums over the particles, links, panels and forces of one state.
//
// Energies come from three places: velocities, compliant rods (whose stored energy no force knows)
// and the forces that have a potential; air and hands have none, so their work is counted instead
// (energy_ledger.h). Strains and tensions follow the order of the links. Loads of panels and lines
// are computed by the code that the step uses, on one thread. stateHash() feeds the marked fields
// of the state to a hash in the order of their list.
#include "measure/diagnostics.h"

#include "base/bytes.h"
#include "forces/fabric_air.h"
#include "forces/forces.h"
#include "forces/line_drag.h"
#include "forces/spring_force.h"
#include "step/inputs.h"
#include "system/fields.h"
#include "system/membrane.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstring>

namespace ripstop {
namespace {

Vec3 separation(const LinkPlace& link, const State& state)
{
    return state.position[std::size_t(link.b)] - state.position[std::size_t(link.a)];
}

// FNV-1a, 64 bits, fed with words of eight bytes. What has no rule here cannot be hashed.
class Hasher
{
public:
    template <Plain T>
    void add(const T& value)
    {
        addBytes(&value, sizeof value);
    }
    template <Plain T, std::size_t n>
    void add(const std::array<T, n>& values)
    {
        addBytes(values.data(), sizeof values);
    }
    void add(const Vec3& value) { addBytes(value.data(), sizeof(Vec3)); }
    template <typename T>
    void add(const std::vector<T>& values)
    {
        if constexpr (Plain<T>)
            addBytes(values.data(), values.size() * sizeof(T));
        else
            for (const T& value : values)
                add(value);
    }
    template <HasFields T>
    void add(const T& record)
    {
        forEachField<T>([&](auto field) { add(field.of(record)); });
    }
    std::uint64_t value() const { return m_value; }

private:
    void addBytes(const void* data, std::size_t size)
    {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < size; i += sizeof(std::uint64_t)) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes + i, std::min(sizeof word, size - i));
            m_value = (m_value ^ word) * 0x100000001b3u;
            m_value ^= m_value >> 32; // a word's high bits must reach the low ones
        }
    }

    std::uint64_t m_value = 0xcbf29ce484222325u;
};

} // namespace

double kineticEnergy(const System& system, const State& state)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < state.velocity.size(); ++i)
        if (system.inverseMass[i] > 0.0)
            sum += 0.5 * system.mass[i] * state.velocity[i].squaredNorm();
    return sum;
}

Energies energies(const System& system, const State& state)
{
    std::vector<double> restLength(system.rods.size());
    fillRestLengths(system, state, restLength);
    return energies(system, state, restLength);
}

double stretchEnergy(const System& system, const State& state, std::span<const double> restLength)
{
    double sum = 0.0;
    for (const LinkPlace& link : system.links) { // in the author's order
        if (link.kind == LinkKind::Spring || isTorn(link, state))
            continue;
        const auto index = std::size_t(link.index);
        if (const Rod& rod = system.rods[index]; rod.compliance > 0.0)
            sum += elasticEnergy(1.0 / rod.compliance, rod.resists,
                                 separation(link, state).norm() - restLength[index]);
    }
    for (const Membrane& membrane : system.membranes)
        if (!state.panelGone[std::size_t(membrane.panel)])
            sum +=
                membrane.area
                * tensionIn(system, membrane, cornersOf(system, membrane, state.position)).energy;
    return sum;
}

Energies energies(const System& system, const State& state, std::span<const double> restLength)
{
    Energies sum;
    sum.kinetic = kineticEnergy(system, state);
    sum.elastic = stretchEnergy(system, state, restLength);
    for (const auto& force : knownForces())
        switch (force->kind()) {
        case ForceKind::Elastic:
            sum.elastic += force->energy(system, state);
            break;
        case ForceKind::Weight:
            sum.potential += force->energy(system, state);
            break;
        case ForceKind::Air:
        case ForceKind::Hand:
            break; // their work is counted instead
        }
    return sum;
}

Vec3 centerOfMass(const System& system, std::span<const PaddedVec3> position)
{
    Vec3 moment = Vec3::Zero();
    double mass = 0.0;
    for (std::size_t i = 0; i < position.size(); ++i) {
        moment += system.mass[i] * position[i];
        mass += system.mass[i];
    }
    return mass > 0.0 ? Vec3(moment / mass) : Vec3(Vec3::Zero());
}

Vec3 momentum(const System& system, const State& state)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < state.velocity.size(); ++i)
        if (system.inverseMass[i] > 0.0)
            sum += system.mass[i] * state.velocity[i];
    return sum;
}

double totalMass(const System& system)
{
    double sum = 0.0;
    for (const double mass : system.mass)
        sum += mass;
    return sum;
}

double fabricArea(const System& system, const State& state)
{
    double area = 0.0;
    for (std::size_t i = 0; i < system.panels.size(); ++i) {
        if (state.panelGone[i])
            continue;
        const auto& corner = system.panels[i].corner;
        const Vec3& a = state.position[std::size_t(corner[0])];
        const Vec3 ab = state.position[std::size_t(corner[1])] - a;
        const Vec3 ac = state.position[std::size_t(corner[2])] - a;
        area += 0.5 * ab.cross(ac).norm();
    }
    return area;
}

void fillStrains(const System& system, const State& state, std::vector<double>& restLength,
                 std::vector<double>& strain)
{
    restLength.resize(system.rods.size());
    fillRestLengths(system, state, restLength);
    strain.clear();
    strain.reserve(system.links.size());
    for (const LinkPlace& link : system.links) {
        const auto index = std::size_t(link.index);
        const double rest =
            link.kind == LinkKind::Rod ? restLength[index] : system.springs[index].restLength;
        const bool measurable = rest > 0.0 && !isTorn(link, state);
        strain.push_back(measurable ? separation(link, state).norm() / rest - 1.0 : 0.0);
    }
}

std::vector<double> strains(const System& system, const State& state)
{
    std::vector<double> restLength;
    std::vector<double> strain;
    fillStrains(system, state, restLength, strain);
    return strain;
}

double pullOfRod(const System& system, const State& state, std::size_t index)
{
    const Rod& rod = system.rods[index];
    if (state.step > 0 || !(rod.compliance > 0.0))
        return state.rodTension[index];
    const double stretch =
        (state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)]).norm()
        - rod.restLength;
    return isSlack(rod.resists, stretch) ? 0.0 : stretch / rod.compliance;
}

void fillTensions(const System& system, const State& state, std::vector<double>& tension)
{
    tension.clear();
    tension.reserve(system.links.size());
    for (const LinkPlace& link : system.links) {
        const auto index = std::size_t(link.index);
        if (link.kind == LinkKind::Rod)
            tension.push_back(state.rodTorn[index] ? 0.0 : pullOfRod(system, state, index));
        else
            tension.push_back(state.springTorn[index]
                                  ? 0.0
                                  : springTension(system.springs[index], separation(link, state),
                                                  state.velocity[std::size_t(link.b)]
                                                      - state.velocity[std::size_t(link.a)]));
    }
}

std::vector<double> tensions(const System& system, const State& state)
{
    std::vector<double> tension;
    fillTensions(system, state, tension);
    return tension;
}

double largestPanelStrain(const System& system, const State& state)
{
    double most = 0.0;
    for (const Membrane& membrane : system.membranes)
        if (!state.panelGone[std::size_t(membrane.panel)])
            most = std::max(most, threadElongation(system, membrane,
                                                   cornersOf(system, membrane, state.position)));
    return most;
}

double largestPanelStrain(const System& system, const State& state, std::span<const int> panels)
{
    double most = 0.0;
    for (const int panel : panels) {
        const auto found = std::ranges::lower_bound(system.membranes, panel, {}, &Membrane::panel);
        if (found == system.membranes.end() || found->panel != panel
            || state.panelGone[std::size_t(panel)])
            continue;
        most = std::max(
            most, threadElongation(system, *found, cornersOf(system, *found, state.position)));
    }
    return most;
}

void fillPanelPulls(const System& system, const State& state, std::vector<PanelPull>& pulls)
{
    pulls.assign(system.membranes.empty() ? 0 : system.panels.size(), {});
    for (const Membrane& membrane : system.membranes)
        if (!state.panelGone[std::size_t(membrane.panel)])
            pulls[std::size_t(membrane.panel)] =
                pullOf(system, membrane, cornersOf(system, membrane, state.position));
}

std::vector<PanelPull> panelPulls(const System& system, const State& state)
{
    std::vector<PanelPull> pulls;
    fillPanelPulls(system, state, pulls);
    return pulls;
}

std::vector<Vec3> panelLoads(const System& system, const State& state)
{
    std::vector<PaddedVec3> load(system.panels.size());
    ThreadPool alone(1);
    WingLoads wings;
    fillFabricLoads(system, state, alone, wings, load);
    return {load.begin(), load.end()};
}

std::vector<Vec3> lineDrags(const System& system, const State& state)
{
    std::vector<PaddedVec3> drag(system.of<LineLists>().list.size());
    ThreadPool alone(1);
    fillLineDrags(system, state, alone, drag);
    return {drag.begin(), drag.end()};
}

std::uint64_t stateHash(const State& state)
{
    Hasher hash;
    forEachField<State>([&](auto field) {
        if constexpr (field.mark(Hash::Out) == Hash::In)
            hash.add(field.of(state));
    });
    return hash.value();
}

} // namespace ripstop
