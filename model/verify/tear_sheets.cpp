// tearSheet() makes particles of unequal mass, then the links and panels, of which only those of
// one row can break. piecesOf() joins particles by whole links and panels and counts what is left
// apart. changesAtPartings() steps the sheet; whenever the mesh opens, it compares the state
// before, as if nothing had let go in that step, with the state after, carried over to the split
// system.
#include "verify/tear_sheets.h"

#include "assembly/carry_over.h"
#include "assembly/finish.h"
#include "assembly/split_system.h"
#include "measure/diagnostics.h"
#include "tearing/tear_opening.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace ripstop {
namespace {

void join(System& system, int a, int b, LinkKind kind, double compliance, double tearStrain)
{
    const TearLimit tear{tearStrain > 0.0 ? TearRule::Strain : TearRule::Never, tearStrain};
    if (kind == LinkKind::Spring)
        addSpring(system, a, b, distance(system, a, b), 1.0 / compliance, 0.02).tear = tear;
    else
        addRod(system, a, b, distance(system, a, b), compliance).tear = tear;
}

void setTorn(const LinkPlace& link, State& state, std::uint8_t torn)
{
    (link.kind == LinkKind::Rod ? state.rodTorn : state.springTorn)[std::size_t(link.index)] = torn;
}

Vec3 spin(const System& system, const State& state)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < system.mass.size(); ++i)
        if (system.inverseMass[i] > 0.0)
            sum += system.mass[i] * Vec3(state.position[i]).cross(Vec3(state.velocity[i]));
    return sum;
}

} // namespace

System tearSheet(int columns, int rows, int weak, LinkKind kind, double compliance)
{
    System system = emptySystem(1.0 / 240.0);
    system.substeps = 8;
    system.airDensity = 0.0;
    system.tearMesh = TearMesh::Split;
    const auto at = [&](int column, int row) { return row * (columns + 1) + column; };
    Input hand{};
    hand.key = 1;
    hand.kind = ControlKind::Move;
    hand.axis = Vec3::UnitZ();
    hand.limit = hand.rate = 100.0;
    hand.automaticRate = 0.2;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const Vec3 place(0.1 * column, 0.0, 0.1 * row);
            const double mass = 0.01 + 0.001 * column + 0.002 * (row % 3);
            if (row == 0 || row == rows)
                addPin(system, place, mass);
            else
                addParticle(system, place, mass, {0.0, 0.01 * column, 0.0});
            if (row == rows)
                hand.targets.push_back(at(column, row));
        }
    system.inputs.push_back(hand);
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const int here = at(column, row);
            if (column < columns)
                join(system, here, at(column + 1, row), kind, compliance, 0.0);
            if (row < rows)
                join(system, here, at(column, row + 1), kind, compliance, row == weak ? 0.05 : 0.0);
            if (row + 2 <= rows)
                join(system, here, at(column, row + 2), kind, 10.0 * compliance, 0.0);
            if (row == rows || column == columns)
                continue;
            const int beside = at(column + 1, row), below = at(column, row + 1);
            const int across = at(column + 1, row + 1);
            join(system, here, across, kind, 2.0 * compliance, 0.0);
            join(system, beside, below, kind, 2.0 * compliance, 0.0);
            if ((row + column) % 2 == 0) {
                addPanel(system, here, below, across, AirLaw::LinearNormal, 2.0);
                addPanel(system, here, across, beside, AirLaw::LinearNormal, 2.0);
            } else {
                addPanel(system, here, below, beside, AirLaw::LinearNormal, 2.0);
                addPanel(system, beside, below, across, AirLaw::LinearNormal, 2.0);
            }
        }
    finish(system);
    return system;
}

int piecesOf(const System& system, const State& state)
{
    std::vector<int> root(system.key.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int i) {
        while (root[std::size_t(i)] != i)
            i = root[std::size_t(i)] = root[std::size_t(root[std::size_t(i)])];
        return i;
    };
    const auto unite = [&](int a, int b) { root[std::size_t(find(a))] = find(b); };
    for (const LinkPlace& link : system.links)
        if (!isTorn(link, state))
            unite(link.a, link.b);
    for (std::size_t i = 0; i < system.panels.size(); ++i)
        if (!state.panelGone[i]) {
            unite(system.panels[i].corner[0], system.panels[i].corner[1]);
            unite(system.panels[i].corner[0], system.panels[i].corner[2]);
        }
    int pieces = 0;
    for (std::size_t i = 0; i < root.size(); ++i)
        pieces += find(int(i)) == int(i);
    return pieces;
}

PartingChanges changesAtPartings(const System& compiled, int steps)
{
    PartingChanges changes;
    auto system = std::make_shared<const System>(compiled);
    State state = compiled.start;
    Stepper stepper;
    for (int step = 0; step < steps; ++step) {
        stepper.step(*system, state);
        State whole = state; // as if nothing had let go in this step
        State opened = state;
        if (!openTears(*system, opened))
            continue;
        for (const TearHold& hold : state.tearHolds)
            setTorn(system->links[std::size_t(hold.link)], whole, 0);
        const auto next = splitSystem(compiled, opened.splits);
        const State after = carryOver(*system, opened, *next);
        State held = after; // as if no link across the opening had broken, to count what it held
        for (std::size_t i = 0; i < system->links.size(); ++i)
            if (!isTorn(system->links[i], whole))
                setTorn(next->links[i], held, 0);
        const auto note = [](double& most, double change) {
            most = std::max(most, std::abs(change));
        };
        ++changes.partings;
        note(changes.mass, totalMass(*next) - totalMass(*system));
        note(changes.centre,
             (centerOfMass(*next, after.position) - centerOfMass(*system, whole.position)).norm());
        note(changes.momentum, (momentum(*next, after) - momentum(*system, whole)).norm());
        note(changes.spin, (spin(*next, after) - spin(*system, whole)).norm());
        note(changes.energy, energies(*next, held).total() - energies(*system, whole).total());
        system = next;
        state = after;
    }
    return changes;
}

} // namespace ripstop
