// Cuts with a stroke: what breaks, what parts, what is kept.
//
// Stages: a line, a sheet and a slit are cut and their pieces counted; a stroke that misses or is
// told twice changes nothing; panels that vanish; and a flight that is made again from its control
// track.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "check/check.h"
#include "compile/compile.h"
#include "io/control_track.h"
#include "measure/diagnostics.h"
#include "run/pose.h"
#include "simulation/simulation.h"
#include "verify/tear_sheets.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace ripstop::test_cutting {

namespace {

// A stroke seen from above, through all that lies below: points in x and z, m.
Cut stroke(const std::vector<std::pair<double, double>>& points)
{
    Cut cut;
    for (const auto& [x, z] : points)
        cut.edges.push_back({{x, 1.0, z}, {x, -1.0, z}});
    return cut;
}

std::shared_ptr<const System> shared(System system)
{
    return std::make_shared<const System>(std::move(system));
}

void cutWith(Simulation& simulation, const Cut& cut)
{
    HandCommands told;
    told.cuts.push_back(std::make_shared<const Cut>(cut));
    simulation.handle(told);
}

int goneIn(const State& state)
{
    return int(std::count(state.panelGone.begin(), state.panelGone.end(), 1));
}

int tornIn(const System& system, const State& state)
{
    return int(std::count_if(system.links.begin(), system.links.end(),
                             [&](const LinkPlace& link) { return isTorn(link, state); }));
}

// Five particles in a row along x, 0.1 m apart, with rods or springs.
System rope(LinkKind kind)
{
    System system = emptySystem(1.0 / 240.0);
    for (int i = 0; i < 5; ++i)
        addParticle(system, {0.1 * i, 0.0, 0.0}, 0.01);
    for (int i = 0; i + 1 < 5; ++i)
        if (kind == LinkKind::Rod)
            addRod(system, i, i + 1, 0.1);
        else
            addSpring(system, i, i + 1, 0.1, 50.0);
    finish(system);
    return system;
}

} // namespace

class TestCutting : public QObject
{
    Q_OBJECT

private slots:
    void kinds_data()
    {
        QTest::addColumn<LinkKind>("kind");
        QTest::newRow("springs") << LinkKind::Spring;
        QTest::newRow("rods") << LinkKind::Rod;
    }

    // The link that the stroke crosses breaks, where and when it was cut, and no other.
    void line_data() { kinds_data(); }
    void line()
    {
        QFETCH(LinkKind, kind);
        const auto system = shared(rope(kind));
        Simulation simulation(system);
        QVERIFY(simulation.runUntil(0.1));
        cutWith(simulation, stroke({{0.24, -0.1}, {0.26, 0.1}}));
        const auto frame = simulation.frame();
        QCOMPARE(frame->torn, (std::vector<std::uint8_t>{0, 0, 1, 0}));
        QCOMPARE(frame->tears.size(), std::size_t(1));
        QCOMPARE(frame->tears[0].element, system->links[2].key);
        QVERIFY(isNear(frame->tears[0].time, 0.1, 1e-9));
        QVERIFY(isNear(frame->tears[0].place, Vec3(0.25, 0.0, 0.0), 1e-9));
        QCOMPARE(piecesOf(simulation.system(), simulation.state()), 2);
    }

    // What is told again is not cut again, and a new run is whole.
    void isMadeOnce()
    {
        const auto system = shared(rope(LinkKind::Spring));
        Simulation simulation(system);
        HandCommands told;
        told.cuts.push_back(std::make_shared<const Cut>(stroke({{0.05, -0.1}, {0.05, 0.1}})));
        simulation.handle(told);
        simulation.handle(told);
        QCOMPARE(simulation.frame()->tears.size(), std::size_t(1));
        told.cuts.push_back(std::make_shared<const Cut>(stroke({{0.15, -0.1}, {0.15, 0.1}})));
        simulation.handle(told);
        QCOMPARE(simulation.frame()->tears.size(), std::size_t(2));
        auto again = std::make_shared<System>(*system);
        ++again->run;
        simulation.load(std::move(again));
        simulation.handle(HandCommands());
        QVERIFY(simulation.frame()->tears.empty());
        QCOMPARE(tornIn(simulation.system(), simulation.state()), 0);
    }

    void missesEverything_data()
    {
        QTest::addColumn<Cut>("cut");
        QTest::newRow("beside it") << stroke({{0.24, 0.1}, {0.26, 0.3}});
        QTest::newRow("ends before it") << stroke({{0.25, -0.3}, {0.25, -0.01}});
        QTest::newRow("above it") << Cut{
            {{{0.25, 1.0, -0.1}, {0.25, 0.1, -0.1}}, {{0.25, 1.0, 0.1}, {0.25, 0.1, 0.1}}}};
        QTest::newRow("nothing") << Cut{};
        QTest::newRow("a single point") << stroke({{0.25, 0.0}});
        QTest::newRow("twice the same point") << stroke({{0.25, 0.0}, {0.25, 0.0}});
        QTest::newRow("no knife") << Cut{{{Vec3(0.25, 0.0, -0.1), Vec3(0.25, 0.0, -0.1)},
                                          {Vec3(0.25, 0.0, 0.1), Vec3(0.25, 0.0, 0.1)}}};
    }
    void missesEverything()
    {
        QFETCH(Cut, cut);
        Simulation simulation(shared(rope(LinkKind::Spring)));
        cutWith(simulation, cut);
        QVERIFY(simulation.frame()->tears.empty());
        QCOMPARE(tornIn(simulation.system(), simulation.state()), 0);
    }

    // A sheet that is cut right across is two, whichever way the stroke runs through its mesh. All
    // panels stay as they were; mass, its centre and momentum do not change.
    void acrossASheet_data()
    {
        QTest::addColumn<LinkKind>("kind");
        QTest::addColumn<Cut>("cut");
        for (const LinkKind kind : {LinkKind::Spring, LinkKind::Rod}) {
            const char* const name = kind == LinkKind::Rod ? "rods" : "springs";
            QTest::addRow("%s, straight", name) << kind << stroke({{-0.1, 0.23}, {0.7, 0.23}});
            QTest::addRow("%s, backwards", name) << kind << stroke({{0.7, 0.23}, {-0.1, 0.23}});
            QTest::addRow("%s, aslant", name) << kind << stroke({{-0.1, 0.13}, {0.7, 0.41}});
            QTest::addRow("%s, in waves", name)
                << kind
                << stroke({{-0.1, 0.2}, {0.13, 0.33}, {0.31, 0.17}, {0.44, 0.36}, {0.7, 0.21}});
            QTest::addRow("%s, along the mesh", name) << kind << stroke({{-0.1, 0.2}, {0.7, 0.2}});
        }
    }
    void acrossASheet()
    {
        QFETCH(LinkKind, kind);
        QFETCH(Cut, cut);
        const auto system = shared(tearSheet(6, 5, 2, kind));
        Simulation simulation(system);
        QVERIFY(simulation.runUntil(0.05));
        const State before = simulation.state();
        QCOMPARE(piecesOf(*system, before), 1);
        cutWith(simulation, cut);

        const System& parted = simulation.system();
        const State& state = simulation.state();
        QCOMPARE(piecesOf(parted, state), 2);
        QCOMPARE(parted.panels.size(), system->panels.size());
        QCOMPARE(goneIn(state), 0);
        double mass = 0.0, expected = 0.0;
        for (const double one : parted.mass)
            mass += one;
        for (const double one : system->mass)
            expected += one;
        QVERIFY2(isNear(mass, expected, 1e-12), told(mass, expected));
        QVERIFY(isNear(centerOfMass(parted, state.position), centerOfMass(*system, before.position),
                       1e-12));
        QVERIFY(isNear(momentum(parted, state), momentum(*system, before), 1e-12));
        for (std::size_t i = 0; i < parted.panels.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) // each corner is where it was
                QCOMPARE(Vec3(state.position[std::size_t(parted.panels[i].corner[k])]),
                         Vec3(before.position[std::size_t(system->panels[i].corner[k])]));
        QVERIFY(simulation.runUntil(0.3));
        QCOMPARE(piecesOf(simulation.system(), simulation.state()), 2);
    }

    // A slit within the sheet leaves it in one piece; a second stroke that makes it reach both
    // edges parts it.
    void slit()
    {
        const auto system = shared(tearSheet(6, 5, 2, LinkKind::Spring));
        Simulation simulation(system);
        HandCommands told;
        const auto cut = [&](const Cut& next) {
            told.cuts.push_back(std::make_shared<const Cut>(next));
            simulation.handle(told);
        };
        cut(stroke({{0.15, 0.23}, {0.45, 0.23}}));
        QVERIFY(!simulation.state().splits.empty());
        QCOMPARE(piecesOf(simulation.system(), simulation.state()), 1);
        QVERIFY(simulation.runUntil(0.1));
        cut(stroke({{-0.1, 0.23}, {0.2, 0.23}}));
        cut(stroke({{0.4, 0.23}, {0.7, 0.23}}));
        QCOMPARE(piecesOf(simulation.system(), simulation.state()), 2);
        QCOMPARE(goneIn(simulation.state()), 0);
    }

    // Where tears make panels vanish, the panels under the stroke go.
    void vanishes()
    {
        System sheet = tearSheet(6, 5, 2, LinkKind::Spring);
        sheet.tearMesh = TearMesh::Vanish;
        Simulation simulation(shared(std::move(sheet)));
        cutWith(simulation, stroke({{-0.1, 0.23}, {0.7, 0.23}}));
        QVERIFY(simulation.state().splits.empty());
        QCOMPARE(goneIn(simulation.state()), 12); // those of one row of cells
        QCOMPARE(piecesOf(simulation.system(), simulation.state()), 2);
    }

    // The same bits in a replay of the written track, at any number of threads; and the pose makes
    // a design that is free of errors and has all of the fabric.
    void replays()
    {
        Scene scene = *build(*findBuilder("cloth"), {{"columns", 14.0}, {"rows", 14.0}});
        scene.settings.tearMesh = TearMesh::Split;
        const auto system = compile(scene);
        QVERIFY(system);
        Simulation first(*system);
        HandCommands told;
        const auto placeAt = [&](double u, double v) { // in the box of the cloth
            Vec3 low = first.state().position[0], high = low;
            for (const PaddedVec3& place : first.state().position) {
                low = low.cwiseMin(place);
                high = high.cwiseMax(place);
            }
            const Vec3 size = high - low;
            Eigen::Index thin = 0;
            size.minCoeff(&thin);
            const int across = (int(thin) + 1) % 3, along = (int(thin) + 2) % 3;
            Vec3 place = low;
            place[across] += u * size[across];
            place[along] += v * size[along];
            Vec3 way = Vec3::Zero();
            way[thin] = 2.0;
            return Cut::Edge{place + way, place - way};
        };
        for (int step = 0; step < 60; ++step) {
            if (step == 20 || step == 40) {
                const double v = step == 20 ? 0.43 : 0.77;
                told.cuts.push_back(std::make_shared<const Cut>(
                    Cut{{placeAt(-0.1, v), placeAt(0.4, v + 0.05), placeAt(1.1, v)}}));
            }
            first.handle(told);
            QVERIFY(first.step());
        }
        QVERIFY(first.state().splits.size() > 14);
        const auto frame = first.frame();
        const QTemporaryDir folder;
        const std::string file = folder.filePath("cuts.csv").toStdString();
        QVERIFY(!writeControlTrack(scene, trackOf(*frame), file));
        const auto track = readControlTrack(file, scene);
        QVERIFY2(track, track ? "" : track.message().english().c_str());
        for (const int threads : {1, 2, 4}) {
            Simulation again(*system, threads);
            ControlPlayer hands(*track);
            for (int step = 0; step < 60; ++step) {
                hands.giveTo(again);
                QVERIFY(again.step());
            }
            QCOMPARE(stateHash(again.state()), stateHash(first.state()));
        }

        const Posed made = posed(scene, *frame);
        QVERIFY(!hasErrors(problemsOf(made.scene)));
        const auto design = compile(made.scene);
        QVERIFY2(design, design ? "" : design.message().english().c_str());
        QCOMPARE((*design)->panels.size(), (*system)->panels.size());
        QCOMPARE((*design)->key.size(), first.system().key.size());
        QCOMPARE(piecesOf(**design, (*design)->start), piecesOf(first.system(), first.state()));
    }
};

const RegisteredTest registered("test_cutting", runPlain<TestCutting>);

} // namespace ripstop::test_cutting
#include "test_cutting.moc"
