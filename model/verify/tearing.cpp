// Links that break: when, at what length and force, and what is left.
//
// In order: one link that is drawn out until it breaks; rows and meshes, of which one link must
// break first; the bookkeeping of momentum and of what is left; rods, which break by the weight
// that they carry; and meshes that split (verify/tear_sheets.h).
#include "assembly/finish.h"
#include "measure/diagnostics.h"
#include "verify/by_default.h"
#include "verify/tear_sheets.h"

#include <algorithm>

namespace ripstop {
namespace {

TearLimit tearAt(TearRule rule, double limit)
{
    TearLimit tear{};
    tear.rule = rule;
    tear.limit = limit;
    return tear;
}

// A link of 0.5 m between a pin and a hand that draws away at a steady speed.
System pulled(LinkKind kind, const TearLimit& tear, double speed, double timeStep)
{
    System system = emptySystem(timeStep);
    addPin(system, Vec3::Zero());
    addPin(system, {0.5, 0.0, 0.0});
    if (kind == LinkKind::Spring)
        addSpring(system, 0, 1, 0.5, 100.0).tear = tear;
    else
        addRod(system, 0, 1, 0.5).tear = tear;
    Input hand{};
    hand.key = Key(7);
    hand.kind = ControlKind::Move;
    hand.axis = {1.0, 0.0, 0.0};
    hand.limit = hand.rate = 100.0;
    hand.automaticRate = speed;
    hand.targets = {1};
    system.inputs.push_back(hand);
    finish(system);
    return system;
}

// The time step at whose end the first link is torn; 0 when none is.
int firstTornStep(const System& system, int most)
{
    Stepper stepper;
    State state = system.start;
    for (int step = 1; step <= most; ++step) {
        stepper.step(system, state);
        if (!state.tears.empty())
            return step;
    }
    return 0;
}

void addPulls(std::vector<Case>& cases)
{
    for (const LinkKind kind : {LinkKind::Spring, LinkKind::Rod}) {
        const std::string by = ", " + nameOf(kind) + " of 0.5 m drawn at 0.97 m/s";
        const auto system = [=] {
            return pulled(kind, tearAt(TearRule::Length, 0.7), 0.97, 1.0 / 240.0);
        };
        cases.push_back({"T-T1", "first torn step, limit 0.7 m" + by, 50, exactly, "",
                         "floor((Lt - L0) / (v dt)) + 1",
                         [=] { return double(firstTornStep(system(), 100)); }});
        cases.push_back({"T-T1", "length at step 49, whole" + by, 0.698042, within(1e-6), "m",
                         "L0 + 49 v dt", [=] { return run(system(), 49).position[1].x(); }});
        const auto tear = shared([=] {
            const State state = run(system(), 50);
            return state.tears.empty() ? State::Tear{} : state.tears[0];
        });
        cases.push_back({"T-T1", "length at the break" + by, 0.702083, within(1e-6), "m",
                         "L0 + 50 v dt", [=] { return tear().length; }});
        cases.push_back({"T-T1", "strain at the break" + by, 0.97 * 50.0 / 240.0 / 0.5,
                         within(1e-9), "", "50 v dt / L0", [=] { return tear().strain; }});
        cases.push_back({"T-T1", "place of the break" + by, 0.5 * (0.5 + 0.97 * 50.0 / 240.0),
                         within(1e-9), "m", "middle of the link",
                         [=] { return tear().place.x(); }});
        const double stretch = 0.97 * 50.0 / 240.0;
        if (kind == LinkKind::Spring)
            cases.push_back({"T-T1", "force at the break" + by, 100.0 * stretch, within(1e-9), "N",
                             "k (L - L0)", [=] { return tear().force; }});
        cases.push_back({"T-T1", "energy released" + by,
                         kind == LinkKind::Spring ? 0.5 * 100.0 * stretch * stretch : 0.0,
                         within(1e-9), "J", kind == LinkKind::Spring ? "k (L - L0)^2 / 2" : "stiff",
                         [=] { return tear().energy; }});
        // 1/32 m per step is exact in binary; the limit itself is met at step 8 and holds
        cases.push_back({"T-T1", "first torn step when step 8 is at the limit, " + nameOf(kind), 9,
                         exactly, "", "> and not >=", [=] {
                             return double(firstTornStep(
                                 pulled(kind, tearAt(TearRule::Length, 0.75), 0.25, 0.125), 20));
                         }});
    }
}

// `cells` springs in a row, 0.5 m in all, that are drawn out evenly.
System drawnRow(int cells, const TearLimit& tear)
{
    System system = emptySystem(1.0 / 240.0);
    for (int i = 0; i <= cells; ++i)
        addParticle(system, {0.5 * i / cells, 0.0, 0.0}, 1.0, {0.97 * i / cells, 0.0, 0.0});
    for (int i = 0; i < cells; ++i)
        addSpring(system, i, i + 1, 0.5 / cells, 0.0).tear = tear;
    finish(system);
    return system;
}

void addMeshes(std::vector<Case>& cases)
{
    for (const int cells : {1, 4}) {
        const std::string by = ", 0.5 m of " + std::to_string(cells) + " links";
        cases.push_back(
            {"T-T2", "first torn step, limit of strain 0.4" + by, 50, exactly, "",
             "a strain does not see the mesh", [=] {
                 return double(firstTornStep(drawnRow(cells, tearAt(TearRule::Strain, 0.4)), 100));
             }});
        cases.push_back(
            {"T-T2", "first torn step, limit of length 0.7 m" + by, cells == 1 ? 50.0 : 0.0,
             exactly, "", "a quarter would have to reach 0.7 m; 0 is never", [=] {
                 return double(firstTornStep(drawnRow(cells, tearAt(TearRule::Length, 0.7)), 100));
             }});
    }
}

// 3 x 3 particles, 0.1 m apart, springs along all edges of eight panels; that from the middle to
// the right may tear.
System torn3x3()
{
    System system = emptySystem(1.0 / 240.0);
    system.airDensity = 0.0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            addParticle(system, {0.1 * i, 0.0, 0.1 * j}, 0.01 + 0.001 * i + 0.002 * j,
                        {0.0, 0.1 * i * j, 0.0});
    const int ends[][2] = {{4, 5}, {0, 1}, {1, 2}, {3, 4}, {6, 7}, {7, 8}, {0, 3}, {3, 6},
                           {1, 4}, {4, 7}, {2, 5}, {5, 8}, {1, 5}, {0, 4}, {3, 7}, {4, 8}};
    for (const auto& [a, b] : ends)
        addSpring(system, a, b, 0.8 * distance(system, a, b), 50.0);
    for (const int corner : {0, 1, 3, 4}) {
        addPanel(system, corner, corner + 3, corner + 4, AirLaw::LinearNormal, 2.0);
        addPanel(system, corner, corner + 4, corner + 1, AirLaw::LinearNormal, 2.0);
    }
    system.springs[0].tear = tearAt(TearRule::Strain, 0.1);
    finish(system);
    return system;
}

// Largest change of momentum while two weights fly apart on a chain of rods until it breaks.
double momentumChange(Solver solver)
{
    System system = emptySystem(1.0 / 240.0);
    system.solver = solver;
    system.sweeps = 20;
    for (int i = 0; i < 5; ++i) {
        addParticle(system, {0.1 * i, 0.0, 0.0}, i == 4 ? 2.0 : 0.1 + 0.3 * i,
                    {i == 4 ? 3.0 : 0.0, 0.2, 0.0});
        if (i > 0)
            addRod(system, i - 1, i, 0.1).tear = tearAt(TearRule::Force, 200.0);
    }
    finish(system);
    const Vec3 before = momentum(system, system.start);
    Stepper stepper;
    State state = system.start;
    double most = 0.0;
    for (int i = 0; i < 100; ++i) {
        stepper.step(system, state);
        most = std::max(most, (momentum(system, state) - before).norm());
    }
    return state.tears.empty() ? std::nan("") : most;
}

void addBookkeeping(std::vector<Case>& cases)
{
    const auto after = shared([] { return run(torn3x3(), 1); });
    cases.push_back({"T-T3", "3 x 3 sheet, springs that tear", 1, exactly, "", "one may", [=] {
                         return double(
                             std::count(after().springTorn.begin(), after().springTorn.end(), 1));
                     }});
    cases.push_back({"T-T3", "3 x 3 sheet, panels that go", 2, exactly, "", "those beside it", [=] {
                         return double(
                             std::count(after().panelGone.begin(), after().panelGone.end(), 1));
                     }});
    cases.push_back({"T-T3", "3 x 3 sheet, change of momentum in the step of the break", 0.0,
                     within(1e-15), "kg m/s", "action and reaction", [=] {
                         const System system = torn3x3();
                         return (momentum(system, after()) - momentum(system, system.start)).norm();
                     }});
    cases.push_back({"T-T3", "3 x 3 sheet, energy released less elastic energy lost", 0.0,
                     within(1e-15), "J", "k s^2 / 2", [=] {
                         const System system = torn3x3();
                         State whole = after();
                         whole.springTorn[0] = 0;
                         return after().tears.at(0).energy
                                - (energies(system, whole).elastic
                                   - energies(system, after()).elastic);
                     }});
    for (const Solver solver : {Solver::AveragedJacobi, Solver::GaussSeidel, Solver::Direct})
        cases.push_back({"T-T3", "chain that breaks, largest change of momentum, " + nameOf(solver),
                         0.0, within(1e-12), "kg m/s", "action and reaction",
                         [=] { return momentumChange(solver); }});
}

// J, of a rod that breaks under the 2 kg that hang still on it.
double energyOfBreak(Stepping stepping)
{
    System system = heavySystem(1.0 / 240.0);
    if (stepping == Stepping::ByDefault)
        solveByDefault(system);
    addPin(system, Vec3::Zero());
    addParticle(system, {0.0, -1.0 - 2e-3 * standardGravity, 0.0}, 2.0);
    addRod(system, 0, 1, 1.0, 1e-3).tear = tearAt(TearRule::Force, 19.0);
    finish(system);
    const State state = run(system, 2); // by default it breaks in the second
    return state.tears.empty() ? std::nan("") : state.tears[0].energy;
}

// 2 kg hang still on a rod of 1 m: 19.6133 N. Each time step of 1/240 s, gravity draws the rod out
// by g h^2 = 0.17 mm before it is projected back; after projection no rod is ever long.
void addRodBreaks(std::vector<Case>& cases)
{
    struct Break
    {
        TearRule rule;
        double limit;
        int tears;
        const char* source;
    };
    const auto hang = [](TearRule rule, double limit) {
        System system = heavySystem(1.0 / 240.0);
        addPin(system, Vec3::Zero());
        addParticle(system, {0.0, -1.0, 0.0}, 2.0);
        addRod(system, 0, 1, 1.0).tear = tearAt(rule, limit);
        finish(system);
        return run(system, 240);
    };
    for (const Break& one : {Break{TearRule::Force, 19.0, 1, "m g = 19.61 N"},
                             {TearRule::Force, 20.2, 0, "m g = 19.61 N"},
                             {TearRule::Strain, 1e-4, 1, "g h^2 / L = 1.7e-4"},
                             {TearRule::Strain, 2e-4, 0, "g h^2 / L = 1.7e-4"},
                             {TearRule::Length, 1.0001, 1, "L + g h^2 = 1.00017 m"},
                             {TearRule::Length, 1.0002, 0, "L + g h^2 = 1.00017 m"}}) {
        char title[80];
        std::snprintf(title, sizeof title, "2 kg on a rod with a limit of %s %g, breaks",
                      nameOf(one.rule).c_str(), one.limit);
        cases.push_back({"T-T4", title, double(one.tears), exactly, "", one.source,
                         [=] { return double(hang(one.rule, one.limit).tears.size()); }});
    }
    cases.push_back({"T-T4", "2 kg on a rod, force at the break", 2.0 * standardGravity,
                     within(1e-6), "N", "m g", [=] {
                         const State state = hang(TearRule::Force, 19.0);
                         return state.tears.empty() ? std::nan("") : state.tears[0].force;
                     }});
    for (const Stepping stepping : {Stepping::Fine, Stepping::ByDefault})
        cases.push_back({"T-T4",
                         std::string("2 kg still on a rod of 0.001 m/N, energy released")
                             + (stepping == Stepping::Fine ? "" : ", by default"),
                         0.5 * 4.0 * standardGravity * standardGravity * 1e-3, within(1e-9), "J",
                         "(m g)^2 alpha / 2", [=] { return energyOfBreak(stepping); }});
    for (const Solver solver :
         {Solver::AveragedJacobi, Solver::PaperJacobi, Solver::GaussSeidel, Solver::Direct})
        cases.push_back({"T-T4", "torn rod holds nothing, height after 1 s, " + nameOf(solver),
                         -1.0 - 0.5 * standardGravity, within(1e-12), "m", "free fall", [=] {
                             System system = heavySystem(0.01, Integrator::VelocityVerlet);
                             system.solver = solver;
                             addPin(system, Vec3::Zero());
                             addParticle(system, {0.0, -1.0, 0.0}, 2.0);
                             addRod(system, 0, 1, 1.0);
                             finish(system);
                             system.start.rodTorn[0] = 1;
                             return run(system, 100).position[1].y();
                         }});
}

// 6 x 5 cells that split along a row of seven particles.
void addSplits(std::vector<Case>& cases)
{
    for (const LinkKind kind : {LinkKind::Spring, LinkKind::Rod}) {
        const std::string by = "sheet that splits, " + nameOf(kind) + "s, ";
        struct Torn
        {
            double twins, secondLinks, panelsGone, pieces;
        };
        const auto torn = shared([=] {
            const auto whole = std::make_shared<const System>(tearSheet(6, 5, 2, kind));
            Simulation simulation(whole);
            simulation.runUntil(1.5);
            const System& system = simulation.system();
            const auto& gone = simulation.state().panelGone;
            return Torn{double(system.key.size() - whole->key.size()),
                        double(system.links.size() - whole->links.size()),
                        double(std::count(gone.begin(), gone.end(), 1)),
                        double(piecesOf(system, simulation.state()))};
        });
        cases.push_back({"T-T5", by + "twins of particles", 7, exactly, "", "one for each",
                         [=] { return torn().twins; }});
        cases.push_back({"T-T5", by + "second links along the lips", 6, exactly, "", "one for each",
                         [=] { return torn().secondLinks; }});
        cases.push_back({"T-T5", by + "panels that go", 0, exactly, "", "each stays on its side",
                         [=] { return torn().panelsGone; }});
        cases.push_back({"T-T5", by + "pieces", 2, exactly, "", "a cut from hem to hem",
                         [=] { return torn().pieces; }});
        const auto changes =
            shared([=] { return changesAtPartings(tearSheet(6, 5, 2, kind), 360); });
        cases.push_back({"T-T5", by + "largest change of mass at an opening", 0.0, within(1e-12),
                         "kg", "shared out", [=] { return changes().mass; }});
        cases.push_back({"T-T5", by + "of the centre of mass", 0.0, within(1e-12), "m",
                         "twins are in place", [=] { return changes().centre; }});
        cases.push_back({"T-T5", by + "of momentum", 0.0, within(1e-12), "kg m/s",
                         "twins are as fast", [=] { return changes().momentum; }});
        cases.push_back({"T-T5", by + "of angular momentum", 0.0, within(1e-12), "kg m^2/s",
                         "twins are as fast", [=] { return changes().spin; }});
        cases.push_back({"T-T5", by + "of energy", 0.0, within(1e-12), "J",
                         "halves of a link hold what it held", [=] { return changes().energy; }});
    }
}

} // namespace

std::vector<Case> tearingCases()
{
    std::vector<Case> cases;
    addPulls(cases);
    addMeshes(cases);
    addBookkeeping(cases);
    addRodBreaks(cases);
    addSplits(cases);
    return cases;
}

} // namespace ripstop
