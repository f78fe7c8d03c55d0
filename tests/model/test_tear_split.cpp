// Meshes that split at a tear: who goes where, what is kept, and that it goes on the same way.
//
// Stages: a cut through a sheet, counted row by row; that masses, places and speeds are kept and
// the run goes on alike; edits and exports of a split mesh; then pins, crumbs, lines, canopies and
// second links at a split.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "assembly/split_system.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "export/export_run.h"
#include "measure/diagnostics.h"
#include "shapes/shape_files.h"
#include "simulation/simulation.h"
#include "system/fields.h"
#include "verify/tear_sheets.h"

#include <Eigen/Geometry>

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <set>

namespace ripstop::test_tear_split {

namespace {

std::shared_ptr<const System> shared(System system)
{
    return std::make_shared<const System>(std::move(system));
}

int goneIn(const State& state)
{
    return int(std::count(state.panelGone.begin(), state.panelGone.end(), 1));
}

// Empty when every index is that of something, every link ends where its spring or rod does, and no
// edge of a panel is without a link that is not in `system` itself.
QString wrongIn(const System& system, const State& state)
{
    const int n = int(system.key.size());
    const auto is = [](int i, std::size_t count) { return i >= 0 && i < int(count); };
    if (system.mass.size() != std::size_t(n) || system.inverseMass.size() != std::size_t(n)
        || (!system.fabricLayer.empty() && system.fabricLayer.size() != std::size_t(n)))
        return "sizes of particles";
    bool sized = true;
    forEachSized(system, state, [&](const auto& values, std::size_t count) {
        sized = sized && values.size() == count;
    });
    if (!sized)
        return "sizes of what is kept of particles, links and panels";
    for (const FabricPanel& panel : system.panels) {
        const auto& c = panel.corner;
        if (!is(c[0], n) || !is(c[1], n) || !is(c[2], n) || c[0] == c[1] || c[1] == c[2]
            || c[0] == c[2])
            return "corners";
    }
    for (const LinkPlace& link : system.links) {
        if (!is(link.a, n) || !is(link.b, n) || link.a == link.b)
            return "ends";
        const bool rod = link.kind == LinkKind::Rod;
        if (!is(link.index, rod ? system.rods.size() : system.springs.size()))
            return "places of links";
        const auto index = std::size_t(link.index);
        if ((rod ? system.rods[index].a : system.springs[index].a) != link.a
            || (rod ? system.rods[index].b : system.springs[index].b) != link.b)
            return "ends of springs and rods";
    }
    for (const TearHold& hold : state.tearHolds)
        if (!is(hold.link, system.links.size()))
            return "links that are held";
    for (const Input& input : system.inputs)
        for (const int target : input.targets)
            if (!is(target, n))
                return "targets";
    for (const ProbeSpec& probe : system.probes)
        for (const int particle : probe.particles)
            if (!is(particle, n))
                return "probes";
    if (std::set<Key>(system.key.begin(), system.key.end()).size() != std::size_t(n))
        return "keys";
    return {};
}

bool sameBits(const State& a, const State& b)
{
    const auto same = [](const std::vector<PaddedVec3>& p, const std::vector<PaddedVec3>& q) {
        return p.size() == q.size()
               && std::equal(p.begin(), p.end(), q.begin(), [](const Vec3& x, const Vec3& y) {
                      return std::equal(x.data(), x.data() + 3, y.data());
                  });
    };
    return stateHash(a) == stateHash(b) && same(a.position, b.position)
           && same(a.velocity, b.velocity) && a.splits == b.splits && a.tears == b.tears
           && a.tearHolds == b.tearHolds && a.rodTension == b.rodTension;
}

// A sheet of a scene that is drawn apart and splits.
Scene drawnSheet()
{
    Scene scene;
    scene.settings.tearMesh = TearMesh::Split;
    scene.settings.gravity = Vec3::Zero();
    const Id material = takeId(scene);
    Material fabric;
    fabric.name = "fabric";
    fabric.stiffness = 200.0;
    fabric.damping = 0.02;
    fabric.tearRule = TearRule::Strain;
    fabric.tearLimit = 0.1;
    scene.items.push_back({material, fabric});
    const Id id = takeId(scene);
    Part part;
    part.name = "sheet";
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 4; ++column) {
            Particle particle;
            particle.id = takeId(scene);
            particle.position = {0.1 * column, 1.0 - 0.1 * row, 0.0};
            particle.velocity = {0.0, row > 2 ? -1.5 : 0.0, 0.0};
            particle.mass = 0.02;
            particle.pinned = row == 0;
            part.particles.push_back(particle);
        }
    const auto at = [&](int column, int row) { return std::size_t(row * 4 + column); };
    const auto join = [&](std::size_t a, std::size_t b) {
        Link link;
        link.id = takeId(scene);
        link.from = part.particles[a].id;
        link.to = part.particles[b].id;
        link.material = material;
        link.kind = LinkKind::Spring;
        link.restLength = (part.particles[b].position - part.particles[a].position).norm();
        part.links.push_back(link);
    };
    const auto cover = [&](std::size_t a, std::size_t b, std::size_t c) {
        Panel panel;
        panel.id = takeId(scene);
        panel.a = part.particles[a].id;
        panel.b = part.particles[b].id;
        panel.c = part.particles[c].id;
        panel.material = material;
        part.panels.push_back(panel);
    };
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 4; ++column) {
            if (column < 3)
                join(at(column, row), at(column + 1, row));
            if (row < 4)
                join(at(column, row), at(column, row + 1));
            if (column == 3 || row == 4)
                continue;
            join(at(column, row), at(column + 1, row + 1));
            cover(at(column, row), at(column, row + 1), at(column + 1, row + 1));
            cover(at(column, row), at(column + 1, row + 1), at(column + 1, row));
        }
    scene.items.push_back({id, part});
    return scene;
}

} // namespace

class TestTearSplit : public QObject
{
    Q_OBJECT

private slots:
    void cutThrough_data()
    {
        QTest::addColumn<LinkKind>("kind");
        QTest::addColumn<int>("most");
        QTest::newRow("springs, all at once") << LinkKind::Spring << 0;
        QTest::newRow("springs, one in a step") << LinkKind::Spring << 1;
        QTest::newRow("rods, all at once") << LinkKind::Rod << 0;
        QTest::newRow("rods, one in a step") << LinkKind::Rod << 1;
    }

    // 6 x 5 cells whose weak row goes: each of its 7 particles gets a twin, the 6 edges between
    // them are there twice, the 7 links over two cells that crossed the row and the 7 that ended in
    // it from beyond part with it, and all 60 panels stay.
    void cutThrough()
    {
        QFETCH(LinkKind, kind);
        QFETCH(int, most);
        System made = tearSheet(6, 5, 2, kind);
        made.tearsPerStep = most;
        const auto system = shared(std::move(made));
        Simulation simulation(system);
        QCOMPARE(piecesOf(*system, simulation.state()), 1);
        QVERIFY(simulation.runUntil(1.5));

        const System& torn = simulation.system();
        const State& state = simulation.state();
        QCOMPARE(wrongIn(torn, state), QString());
        QCOMPARE(torn.key.size(), system->key.size() + 7);
        QCOMPARE(torn.links.size(), system->links.size() + 6);
        QCOMPARE(torn.panels.size(), system->panels.size());
        QCOMPARE(goneIn(state), 0);
        QCOMPARE(piecesOf(torn, state), 2);
        QVERIFY2(isNear(totalMass(torn), totalMass(*system), 1e-12),
                 told(totalMass(torn), totalMass(*system)));
        // all panels are what they were, as nothing pulls any more
        for (const FabricPanel& panel : torn.panels) {
            const auto x = [&](int k) -> const Vec3& {
                return state.position[std::size_t(panel.corner[std::size_t(k)])];
            };
            const double area = 0.5 * (x(1) - x(0)).cross(x(2) - x(0)).norm();
            QVERIFY2(isNear(area, 0.005, 0.0005), told(area, 0.005));
        }

        const std::shared_ptr<const Frame> frame = simulation.frame();
        QCOMPARE(frame->position.size(), torn.key.size());
        QCOMPARE(frame->layout->particleId.size(), torn.key.size());
        QCOMPARE(frame->layout->links.size(), torn.links.size());
        QCOMPARE(frame->strain.size(), torn.links.size());
        for (const std::uint32_t id : frame->layout->particleId)
            QVERIFY(std::count(system->key.begin(), system->key.end(), id) == 1);
        for (const Layout::Link& link : frame->layout->links)
            QVERIFY(link.id < system->links.size()); // finish() numbers them from 0
    }

    void kept_data()
    {
        QTest::addColumn<LinkKind>("kind");
        QTest::newRow("springs") << LinkKind::Spring;
        QTest::newRow("rods") << LinkKind::Rod;
    }

    // Twins are where their particles are and as fast, so nothing changes in the moment.
    void kept()
    {
        QFETCH(LinkKind, kind);
        System made = tearSheet(6, 5, 2, kind);
        made.tearsPerStep = 2;
        const PartingChanges changes = changesAtPartings(made, 360);
        QVERIFY(changes.partings >= 4);
        QVERIFY2(changes.mass <= 1e-15, told(changes.mass, 0.0));
        QVERIFY2(changes.centre <= 1e-15, told(changes.centre, 0.0));
        QVERIFY2(changes.momentum <= 1e-15, told(changes.momentum, 0.0));
        QVERIFY2(changes.spin <= 1e-15, told(changes.spin, 0.0));
        QVERIFY2(changes.energy <= 1e-15, told(changes.energy, 0.0));
    }

    void goesOnTheSame_data() { kept_data(); }

    void goesOnTheSame()
    {
        QFETCH(LinkKind, kind);
        System made = tearSheet(30, 20, 9, kind);
        made.tearsPerStep = 1;
        made.integrator = Integrator::Verlet; // has a memory
        const auto system = shared(std::move(made));
        const auto runTo = [&](Simulation& simulation, int step) {
            while (simulation.state().step < step)
                if (!simulation.step())
                    return false;
            return true;
        };
        Simulation alone(system);
        while (alone.state().splits.size() < 9)
            QVERIFY(alone.step() && alone.state().time < 5.0);
        const State checkpoint = alone.state();
        const int last = int(checkpoint.step) + 30;
        QVERIFY(runTo(alone, last));
        QVERIFY(alone.state().splits.size() > checkpoint.splits.size() + 3);
        QCOMPARE(wrongIn(alone.system(), alone.state()), QString());
        for (const int threads : {1, 2, 3, 8}) {
            Simulation again(system, threads);
            QVERIFY(runTo(again, last));
            QVERIFY2(sameBits(again.state(), alone.state()), "again");
            Simulation resumed(system, checkpoint, threads);
            QVERIFY(runTo(resumed, last));
            QVERIFY2(sameBits(resumed.state(), alone.state()), "from a checkpoint");
            QVERIFY(resumed.system() == alone.system());
        }
    }

    // What an edit changes is found in the split mesh, and the splits stay.
    void edits()
    {
        const Scene scene = drawnSheet();
        LiveSystem live(scene);
        const auto take = [&](std::uint64_t run) {
            auto made = live.update(2, run);
            return std::get<Update>(std::move(made));
        };
        Simulation simulation(take(1).system);
        while (simulation.state().splits.empty() && simulation.state().time < 1.0)
            QVERIFY(simulation.step());
        QVERIFY(!simulation.state().splits.empty());
        const State before = simulation.state();
        const Part& sheet = std::get<Part>(scene.items[1].item);

        // a patch gives what the whole system gives
        const Edit softer{
            Message("Soften"),
            {SetValues{findProperty(Kind::Material, "stiffness"), {scene.items[0].id}, {150.0}}}};
        live.apply(softer);
        Simulation loaded(*compile(scene, 1, 1), before);
        simulation.load(take(1));
        const auto compiled = compile(live.scene(), 2, 1);
        QVERIFY(bool(compiled));
        loaded.load(*compiled);
        QVERIFY(simulation.system() == loaded.system());
        QVERIFY(simulation.state() == loaded.state());
        QVERIFY(simulation.state().splits == before.splits);
        QVERIFY(sameBits(simulation.state(), before));

        // rows go, a panel of a twin among them
        const Id goes{before.splits[0].panels[0]};
        live.apply(removal(live.scene(), {goes}));
        simulation.load(take(1));
        QCOMPARE(wrongIn(simulation.system(), simulation.state()), QString());
        QCOMPARE(simulation.system().panels.size(), sheet.panels.size() - 1);
        QCOMPARE(simulation.state().splits.size(), before.splits.size());

        // the particle itself goes: its twin stands alone, and so the split is passed over
        live.apply(removal(live.scene(), {Id{before.splits[0].from}}));
        simulation.load(take(1));
        QCOMPARE(wrongIn(simulation.system(), simulation.state()), QString());
        for (int i = 0; i < 60; ++i)
            QVERIFY(simulation.step());

        simulation.load(take(2));
        QVERIFY(simulation.state().splits.empty());
        QCOMPARE(simulation.system().key.size(), sheet.particles.size() - 1);
        QVERIFY(simulation.frame()->layout->particleId.size() == sheet.particles.size() - 1);
    }

    // As many faces come back, and two meshes that share no vertex.
    void exported()
    {
        Simulation simulation(shared(tearSheet(6, 5, 2, LinkKind::Spring)));
        QVERIFY(simulation.runUntil(1.5));
        QCOMPARE(simulation.state().splits.size(), std::size_t(7));
        QTemporaryDir folder;
        const auto path = folder.filePath("torn.obj").toStdString();
        QVERIFY(!writeMoment(*simulation.frame(), MeshAppearance(), path));
        const auto mesh = meshFromFile(path);
        QVERIFY2(bool(mesh), mesh ? "" : mesh.message().english().c_str());
        QCOMPARE((*mesh)->faces().size(), std::size_t(60));
    }

    // A patch of fabric on a pin, drawn away at its far end: the pin stays, the fabric goes.
    void offThePin()
    {
        System made = emptySystem(1.0 / 240.0);
        made.tearMesh = TearMesh::Split;
        addPin(made, Vec3::Zero(), 0.01);
        addParticle(made, {0.1, 0.0, 0.1}, 0.01, {0.0, 0.0, 3.0});
        addParticle(made, {-0.1, 0.0, 0.1}, 0.01, {0.0, 0.0, 3.0});
        for (const auto& [a, b] : {std::pair(0, 1), {0, 2}, {1, 2}})
            addSpring(made, a, b, distance(made, a, b), 100.0, 0.3).tear = {TearRule::Strain, 0.1};
        addPanel(made, 0, 1, 2, AirLaw::None, 0.0);
        finish(made);
        const auto system = shared(std::move(made));
        Simulation simulation(system);
        QVERIFY(simulation.runUntil(0.5));
        const System& torn = simulation.system();
        const State& state = simulation.state();
        QCOMPARE(wrongIn(torn, state), QString());
        QCOMPARE(torn.key.size(), std::size_t(4));
        QCOMPARE(torn.inverseMass[0], 0.0);
        QVERIFY(torn.inverseMass[3] > 0.0);
        QVERIFY(torn.panels[0].corner == (std::array{3, 1, 2}));
        QCOMPARE(goneIn(state), 0);
        QVERIFY(state.position[0].isZero(0.0));
        QVERIFY(state.position[3].z() > 0.1);
    }

    // Nothing can come off a single panel: it goes with its link, as where panels vanish.
    void crumb()
    {
        System made = emptySystem(1.0 / 240.0);
        made.tearMesh = TearMesh::Split;
        addParticle(made, {0.0, 0.0, 0.0}, 0.01);
        addParticle(made, {0.1, 0.0, 0.0}, 0.01, {5.0, 0.0, 0.0});
        addParticle(made, {0.0, 0.1, 0.0}, 0.01);
        for (const auto& [a, b] : {std::pair(0, 1), {0, 2}, {1, 2}})
            addSpring(made, a, b, distance(made, a, b), 1.0).tear = {TearRule::Strain, 0.3};
        addPanel(made, 0, 1, 2, AirLaw::None, 0.0);
        finish(made);
        Simulation simulation(shared(std::move(made)));
        QVERIFY(simulation.runUntil(0.2));
        QVERIFY(simulation.state().splits.empty());
        QVERIFY(!simulation.state().tears.empty());
        QCOMPARE(goneIn(simulation.state()), 1);
    }

    // A line that holds fabric at one corner keeps hold of the corner and not of the fabric.
    void offTheLine()
    {
        System made = emptySystem(1.0 / 240.0);
        made.tearMesh = TearMesh::Split;
        addParticle(made, Vec3::Zero(), 0.01);
        addParticle(made, {0.1, 0.0, 0.1}, 0.01, {0.0, 0.0, 3.0});
        addParticle(made, {-0.1, 0.0, 0.1}, 0.01, {0.0, 0.0, 3.0});
        addPin(made, {0.0, 0.0, -0.5});
        for (const auto& [a, b] : {std::pair(0, 1), {0, 2}, {1, 2}})
            addSpring(made, a, b, distance(made, a, b), 100.0).tear = {TearRule::Strain, 0.1};
        addSpring(made, 0, 3, 0.5, 1000.0);
        addPanel(made, 0, 1, 2, AirLaw::None, 0.0);
        finish(made);
        Simulation simulation(shared(std::move(made)));
        QVERIFY(simulation.runUntil(0.3));
        const System& torn = simulation.system();
        QCOMPARE(wrongIn(torn, simulation.state()), QString());
        QCOMPARE(simulation.state().splits.size(), std::size_t(1));
        QCOMPARE(piecesOf(torn, simulation.state()), 2);
        QCOMPARE(torn.links[3].a, 0); // the line
        QVERIFY2(isNear(torn.mass[0] + torn.mass[4], 0.01, 1e-17), told(torn.mass[0], 0.005));
        QVERIFY2(isNear(torn.mass[0], 0.005, 1e-12), told(torn.mass[0], 0.005));
    }

    // The panels of a canopy hold their air with the particles that they have then.
    void canopiesFollow()
    {
        System system = emptySystem(0.01);
        for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 1), Vec3(0, 0, 1)})
            addParticle(system, place, 1.0);
        addPanel(system, 0, 1, 2, AirLaw::None, 0.0);
        addPanel(system, 0, 2, 3, AirLaw::None, 0.0);
        Canopy canopy;
        canopy.particles = {0, 1, 2, 3};
        canopy.facets = {{0, {0, 1, 2}, 0.5}, {1, {0, 2, 3}, 0.5}};
        canopy.mouth = {0, 1, 2, 3};
        system.canopies = {canopy};
        finish(system);
        const Split split{system.key[0], firstTwinParticle, 0.5, {system.panelKey[1]}, {}, {}};
        const auto made = splitSystem(system, std::span(&split, 1));
        QCOMPARE(made->panels[1].corner[0], 4);
        const Canopy& torn = made->canopies[0];
        QCOMPARE(torn.particles.size(), std::size_t(5));
        QCOMPARE(torn.particles[std::size_t(torn.facets[0].corner[0])], 0);
        QCOMPARE(torn.particles[std::size_t(torn.facets[1].corner[0])], 4);
    }

    // Each half of a second link pulls half as hard and breaks at half the force.
    void secondLinks()
    {
        System made = emptySystem(1.0 / 240.0);
        for (int i = 0; i < 3; ++i)
            addParticle(made, {double(i), 0.0, 0.0}, 1.0 + i);
        addSpring(made, 0, 1, 0.9, 50.0, 2.0).tear = {TearRule::Force, 10.0};
        addRod(made, 1, 2, 1.0, 1e-3).tear = {TearRule::Strain, 0.25};
        addPanel(made, 0, 1, 2, AirLaw::None, 0.0);
        finish(made);
        Split split{made.key[1], firstTwinParticle, 0.25, {made.panelKey[0]}, {}, {}};
        split.cut.push_back({made.links[0].key, firstTwinLink, 0.5});
        split.cut.push_back({made.links[1].key, firstTwinLink + 1, 0.25});
        const std::vector<Split> splits{split};
        const auto torn = splitSystem(made, splits);
        QCOMPARE(torn->mass[1], 1.5);
        QCOMPARE(torn->mass[3], 0.5);
        QCOMPARE(torn->springs[0].stiffness + torn->springs[1].stiffness, 50.0);
        QCOMPARE(torn->springs[1].damping, 1.0);
        QCOMPARE(torn->springs[1].tear.limit, 5.0);
        QCOMPARE(torn->springs[1].b, 3);
        const auto rodOf = [&](std::size_t link) {
            return torn->rods[std::size_t(torn->links[link].index)];
        };
        QCOMPARE(1.0 / rodOf(1).compliance + 1.0 / rodOf(3).compliance, 1000.0);
        QCOMPARE(rodOf(3).compliance, 4e-3);
        QCOMPARE(rodOf(3).tear.limit, 0.25);
        const TwinOrigins origins(splits);
        QCOMPARE(origins.particle(firstTwinParticle), made.key[1]);
        QCOMPARE(origins.link(firstTwinLink + 1), made.links[1].key);
        QCOMPARE(origins.link(made.links[0].key), made.links[0].key);
    }
};

const RegisteredTest registered("test_tear_split", runPlain<TestTearSplit>);

} // namespace ripstop::test_tear_split
#include "test_tear_split.moc"
