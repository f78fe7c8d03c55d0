// What panels carry, in the numbers that people read (laws/panel_pull.h): of frames, and of probes.
#include "builders/builder.h"
#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "measure/probe.h"
#include "model/systems.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_panel_pull {

namespace {

// A square of kite cloth in two triangles, by its builder; of an E t of 40 kN/m.
Scene square()
{
    return *build(*findBuilder("cloth"), {{"columns", 1},
                                          {"rows", 1},
                                          {"panels", 1},
                                          {"membrane", 40e3},
                                          {"shear", 0.03},
                                          {"density", 0.047},
                                          {"hang", 0},
                                          {"flat", 0},
                                          {"sphere", 0},
                                          {"wind", 0}});
}

Material& materialOf(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Material* material = std::get_if<Material>(&entry.item))
            return *material;
    std::abort();
}

// A sheet that hangs has its warp upright.
std::vector<PanelPull> stretched(const System& system, double along, double across)
{
    State state = system.start;
    const Vec3 first = state.position[0];
    for (PaddedVec3& place : state.position) {
        place.x() = first.x() + across * (place.x() - first.x());
        place.y() = first.y() + along * (place.y() - first.y());
        place.z() = first.z() + across * (place.z() - first.z());
    }
    return panelPulls(system, state);
}

} // namespace

class TestPanelPull : public QObject
{
    Q_OBJECT

private slots:
    // A triangle of E1 = 40 kN/m, E2 = 20 kN/m along warp and weft, without Poisson's ratio. Warp
    // pulled by a stretch s has Green's strain (s^2 - 1) / 2 and carries E1 times that per width of
    // what is stretched, s times as much per width as it was cut; the weft, pushed together,
    // wrinkles. Pushed together both ways it is slack. The strain that is told is s - 1.
    void framesTellPulls()
    {
        Scene scene = square();
        Material& cloth = materialOf(scene);
        cloth.weftStiffness = 20e3;
        cloth.poissonRatio = 0.0;
        const auto system = *compile(scene);
        const auto green = [](double s) { return 0.5 * (s * s - 1.0); };
        struct Row
        {
            double along, across, strain, tension;
            ClothState state;
        };
        for (const Row& row :
             {Row{1.01, 1.001, 0.01, 40e3 * green(1.01) * 1.01, ClothState::Taut},
              Row{1.01, 1.03, 0.03, 20e3 * green(1.03) * 1.03, ClothState::Taut},
              Row{1.001, 1.01, 0.01, 20e3 * green(1.01) * 1.01, ClothState::Taut},
              Row{1.01, 0.9, 0.01, 40e3 * green(1.01) * 1.01, ClothState::Wrinkled},
              Row{0.99, 0.98, 0.0, 0.0, ClothState::Slack}}) {
            const std::vector<PanelPull> pulls = stretched(*system, row.along, row.across);
            QCOMPARE(pulls.size(), std::size_t(2));
            for (const PanelPull& pull : pulls) {
                QVERIFY(pull.carries);
                QCOMPARE(pull.state, row.state);
                QVERIFY2(isNear(pull.strain, row.strain, 1e-9), told(pull.strain, row.strain));
                QVERIFY2(isNear(pull.tension, row.tension, 1e-5), told(pull.tension, row.tension));
            }
        }
        // what the frame of a run has is this; a panel that is gone carries nothing
        Simulation simulation(system);
        QCOMPARE(simulation.frame()->panelPull, panelPulls(*system, system->start));
        State state = system->start;
        state.panelGone[1] = 1;
        QVERIFY(!panelPulls(*system, state)[1].carries);
        const Scene threads = *build(*findBuilder("cloth"), {});
        QVERIFY(Simulation(*compile(threads)).frame()->panelPull.empty());
    }

    // Cloth that is too stiff to fold within a panel pushes; it has folds of the mesh or is about
    // to have them. A board has none.
    void clothThatPushesIsNotTaut()
    {
        for (const bool isBoard : {false, true}) {
            Scene scene = square();
            Material& cloth = materialOf(scene);
            cloth.poissonRatio = 0.0;
            cloth.bendingStiffness = 1e3;
            cloth.resistsPushing = isBoard;
            const auto system = *compile(scene);
            const auto expected = [&](ClothState state) {
                return isBoard ? ClothState::Taut : state;
            };
            QCOMPARE(stretched(*system, 1.01, 1.001)[0].state, ClothState::Taut);
            const PanelPull pull = stretched(*system, 1.01, 0.99)[0];
            QVERIFY(pull.weft < -100.0);
            QCOMPARE(pull.state, expected(ClothState::Wrinkled));
            QCOMPARE(stretched(*system, 0.99, 0.98)[0].state, expected(ClothState::Slack));
        }
    }

    // Two triangles of cloth, one drawn by 2 % along the warp and the other, of three times
    // the area, lies slack: means are by area at rest, and the largest is of the drawn one. Without
    // a Poisson's ratio the threads pull with E t e times their stretch, 1.02, where
    // e = (1.02^2 - 1) / 2 is Green's strain.
    void meansAreByArea()
    {
        Scene scene;
        const Id material = takeId(scene);
        Material cloth;
        cloth.membraneStiffness = 1000.0;
        cloth.shearStiffness = 300.0;
        cloth.poissonRatio = 0.0;
        cloth.airLaw = AirLaw::None;
        scene.items.push_back({material, cloth});
        Part part;
        const auto triangle = [&](const Vec3& at, double size) {
            const std::array corners{at, Vec3(at + Vec3(size, 0, 0)), Vec3(at + Vec3(0, size, 0))};
            Panel panel;
            panel.id = takeId(scene);
            panel.material = material;
            for (const auto& [corner, place] :
                 {std::pair{&Panel::a, 0}, {&Panel::b, 1}, {&Panel::c, 2}}) {
                panel.*corner = takeId(scene);
                part.particles.push_back({.id = panel.*corner,
                                          .position = corners[std::size_t(place)],
                                          .mass = 1.0,
                                          .pinned = true});
            }
            part.panels.push_back(panel);
        };
        triangle(Vec3(0, 0, 0), 1.0);
        triangle(Vec3(5, 0, 0), std::sqrt(3.0));
        part.carrier = FabricKind::Panels;
        scene.items.push_back({takeId(scene), part});
        for (const Quantity quantity : {Quantity::FabricStress, Quantity::MeanStress,
                                        Quantity::WarpStress, Quantity::WrinkledShare})
            scene.items.push_back({takeId(scene), Probe{.quantity = quantity}});
        const auto system = compile(scene);
        QVERIFY(system);
        State state = (*system)->start;
        state.position[1].x() = 1.02;
        state.position[2].y() = 1.001; // which keeps it taut
        state.position[5].y() = 1.0;   // shorter than at rest
        state.position[4].x() = 6.0;
        Readings readings(**system, state);
        const auto read = [&](std::size_t i) { return readings.value((*system)->probes[i]); };
        const double pull = 1000.0 * 0.5 * (1.02 * 1.02 - 1.0) * 1.02;
        QVERIFY2(isNear(read(0), pull, 1e-9 * pull), told(read(0), pull));
        QVERIFY2(isNear(read(1), 0.25 * pull, 1e-9 * pull), told(read(1), 0.25 * pull));
        QVERIFY2(isNear(read(2), 0.25 * pull, 1e-9 * pull), told(read(2), 0.25 * pull));
        QVERIFY2(isNear(read(3), 0.75, 1e-9 * pull), told(read(3), 0.75));
    }
};

const RegisteredTest registered("test_panel_pull", runPlain<TestPanelPull>);

} // namespace ripstop::test_panel_pull
#include "test_panel_pull.moc"
