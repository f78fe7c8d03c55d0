// What a pin draws that a control moves: cloth of panels and a line, both damped. The same pull
// goes through all of either, and what the hand does there is in the ledger.
#include "builders/builder.h"
#include "compile/compile.h"
#include "model/chain.h"
#include "model/systems.h"
#include "registered_test.h"
#include "simulation/simulation.h"
#include "system/membrane.h"

#include <QtTest>

#include <algorithm>

namespace ripstop::test_drawn_cloth {

namespace {

constexpr double speed = 0.1;     // m/s
constexpr double seconds = 0.25;  // s
constexpr double width = 0.25;    // m
constexpr double height = 0.1;    // m
constexpr double stiffness = 4e4; // N/m

// A sheet between two edges, of which one is drawn away.
Scene drawnSheet(int columns, int rows)
{
    Scene scene = *build(*findBuilder("cloth"), {{"columns", columns},
                                                 {"rows", rows},
                                                 {"width", width},
                                                 {"height", height},
                                                 {"cloth", 2.0}, // 0.75 oz
                                                 {"hang", 3.0},  // by both edges
                                                 {"sphere", 0.0},
                                                 {"flat", 0.0},
                                                 {"level", 3.0},
                                                 {"balance", 1.0}});
    for (Entry& entry : scene.items) {
        if (Material* material = std::get_if<Material>(&entry.item)) {
            material->membraneStiffness = material->weftStiffness = stiffness;
            material->poissonRatio = 0.0;
            material->tearRule = TearRule::Never;
        }
        Control* const control = std::get_if<Control>(&entry.item);
        if (control && control->axis == Vec3::UnitX())
            control->automaticRate = speed;
    }
    return scene;
}

} // namespace

class TestDrawnCloth : public QObject
{
    Q_OBJECT

    static void meshes()
    {
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::newRow("10 x 4") << 10 << 4;
        QTest::newRow("20 x 8") << 20 << 8;
    }

private slots:
    // Strained by e all over, whatever damping adds: E t e_Green (1 + e) N/m.
    void sheetIsPulledAlike_data() { meshes(); }
    void sheetIsPulledAlike()
    {
        QFETCH(int, columns);
        QFETCH(int, rows);
        Simulation simulation(*compile(drawnSheet(columns, rows)));
        QVERIFY(simulation.runUntil(seconds));
        const double strain = speed * seconds / width;
        const double pull = stiffness * (strain + 0.5 * strain * strain) * (1.0 + strain);
        const System& system = simulation.system();
        for (const Membrane& membrane : system.membranes) {
            const PanelPull found =
                pullOf(system, membrane, cornersOf(system, membrane, simulation.state().position));
            const double most = std::max(found.warp, found.weft);
            QVERIFY2(isNear(most, pull, 0.01 * pull), told(most, pull));
        }
        QVERIFY(simulation.frame()->accuracy.isMet());
    }

    // The hand brings what the cloth holds, E t A e_Green^2 / 2, and what its damping takes,
    // E t A T e'^2 for the damping time T.
    void handWorksOnTheSheet_data() { meshes(); }
    void handWorksOnTheSheet()
    {
        QFETCH(int, columns);
        QFETCH(int, rows);
        Simulation simulation(*compile(drawnSheet(columns, rows)));
        QVERIFY(simulation.runUntil(seconds));
        const double strain = speed * seconds / width;
        const double green = strain + 0.5 * strain * strain;
        const double held = 0.5 * stiffness * width * height * green * green;
        const Work& work = simulation.state().work;
        qInfo("hands %.4f J, held %.4f J, dampers %.4f J, residual %.4f J", work.hands, held,
              work.damping, work.residual);
        QVERIFY(work.damping < 0.0 && work.damping > -0.02 * held);
        QVERIFY2(isNear(work.hands + work.damping, held, 0.01 * held), told(work.hands, held));
        QVERIFY(std::abs(work.residual) < 0.01 * held);
    }

    // All links of a line are as long.
    void lineIsStretchedAlike()
    {
        constexpr int links = 5;
        std::vector<Vec3> places;
        for (int i = 0; i <= links; ++i)
            places.push_back({width * i / links, 0.0, 0.0});
        Chain chain(places, 1, 1e-3, line({}));
        chain.scene.settings.gravity = Vec3::Zero();
        chain.scene.settings.viscosity = 0.0; // slows all but the pins
        Particle& end = chain.row().particles.back();
        end.pinned = true;
        Control control;
        control.targets = {end.id};
        control.automaticRate = speed;
        chain.scene.items.push_back({takeId(chain.scene), control});
        const auto frame = chain.after(seconds);
        const double strain = speed * seconds / width;
        QCOMPARE(frame->strain.size(), std::size_t(links));
        for (const double found : frame->strain)
            QVERIFY2(isNear(found, strain, 0.01 * strain), told(found, strain));
    }
};

const RegisteredTest registered("test_drawn_cloth", runPlain<TestDrawnCloth>);

} // namespace ripstop::test_drawn_cloth
#include "test_drawn_cloth.moc"
