// Slits in fabric that tears by energy: the load at which one begins to run is that of fracture
// mechanics and hangs on no mesh, and from then on nothing stops it.
#include "check/check.h"
#include "compile/compile.h"
#include "model/systems.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <numbers>

using namespace ripstop;

namespace {

constexpr double side = 0.6;         // m, of the sheet
constexpr double halfSlit = 0.1;     // m
constexpr double stiffness = 4e4;    // N/m, E t
constexpr double poisson = 0.2;      // 1
constexpr double tearStrength = 1.0; // N

struct Slit
{
    int cells = 18; // along a side, a multiple of 6
    TearMesh tearMesh = TearMesh::Vanish;
    bool isBlunt = false; // a row of cells is cut out; else two lips that touch
    bool pushes = true;
    double shear = stiffness / (2.0 * (1.0 + poisson)); // N/m
};

// A sheet in the plane z = 0, held by its upper edge and drawn by its lower one, with a slit amid
// it.
Scene sheet(const Slit& slit, double rate)
{
    const int n = slit.cells;
    const int middle = n / 2, first = n / 2 - n / 6, last = n / 2 + n / 6;
    Scene scene;
    Material cloth;
    cloth.name = "cloth";
    cloth.membraneStiffness = stiffness;
    cloth.shearStiffness = slit.shear;
    cloth.poissonRatio = poisson;
    cloth.resistsPushing = slit.pushes;
    cloth.dampingTime = 1e-3;
    cloth.airLaw = AirLaw::None;
    cloth.tearRule = TearRule::Energy;
    cloth.tearStrength = tearStrength;
    cloth.warpStrength = 3000.0; // N/m, six times the load
    cloth.weftStrength = 3000.0;
    const Id material = takeId(scene);
    scene.items.push_back({material, cloth});
    scene.settings.gravity = Vec3::Zero();
    scene.settings.airDensity = 0.0;
    scene.settings.viscosity = 20.0;
    scene.settings.tearMesh = slit.tearMesh;
    const Id id = takeId(scene);
    Part part;
    part.name = "sheet";
    part.carrier = FabricKind::Panels;
    const auto add = [&](int row, int column) {
        Particle particle;
        particle.id = takeId(scene);
        particle.position = {side * column / n, side * row / n, 0.0};
        particle.mass = 0.05 * side * side / (n * n);
        particle.pinned = row == 0 || row == n;
        part.particles.push_back(particle);
        return particle.id;
    };
    std::vector<Id> at, upperLip(std::size_t(n) + 1, Id{});
    for (int row = 0; row <= n; ++row)
        for (int column = 0; column <= n; ++column)
            at.push_back(add(row, column));
    if (!slit.isBlunt)
        for (int column = first + 1; column < last; ++column)
            upperLip[std::size_t(column)] = add(middle, column);
    const auto cover = [&](Id a, Id b, Id c, double grain) {
        Panel panel;
        panel.id = takeId(scene);
        panel.a = a;
        panel.b = b;
        panel.c = c;
        panel.material = material;
        panel.grain = grain;
        part.panels.push_back(panel);
    };
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            if (slit.isBlunt && row == middle && column >= first && column < last)
                continue;
            const auto corner = [&](int r, int c) {
                const Id lip = upperLip[std::size_t(c)];
                return row == middle && r == middle && lip != Id{}
                           ? lip
                           : at[std::size_t(r * (n + 1) + c)];
            };
            const Id a = corner(row, column), b = corner(row, column + 1);
            const Id c = corner(row + 1, column), d = corner(row + 1, column + 1);
            // the first side of each runs along x, and the warp is across it
            cover(a, b, (row + column) % 2 == 0 ? d : c, 90.0);
            (row + column) % 2 == 0 ? cover(d, c, a, 90.0) : cover(d, c, b, 90.0);
        }
    scene.items.push_back({id, part});
    Control control;
    control.name = "jaw";
    control.kind = ControlKind::Move;
    for (int column = 0; column <= n; ++column)
        control.targets.push_back(at[std::size_t(column)]);
    control.axis = {0.0, -1.0, 0.0};
    control.limit = 1.0;
    control.automaticRate = rate;
    scene.items.push_back({takeId(scene), control});
    return scene;
}

// N/m, over the width, in the row of cells at the upper edge.
double loadOn(const Frame& frame, int cells)
{
    const std::size_t count = 2 * std::size_t(cells);
    double sum = 0.0;
    for (std::size_t i = frame.panelPull.size() - count; i < frame.panelPull.size(); ++i)
        sum += frame.panelPull[i].warp;
    return sum / double(count);
}

struct Torn
{
    double began = 0.0; // N/m
    double most = 0.0;  // N/m, at any time
    double left = 0.0;  // N/m, at the end
    State::Tear first{};
};

Torn drawn(const Slit& slit)
{
    const double rate = 0.004; // m/s, so that at 2 % of strain 3 s have gone
    Simulation simulation(*compile(sheet(slit, rate)));
    Torn torn;
    for (int n = 1; n <= 300; ++n) {
        simulation.runUntil(0.02 * n);
        const double load = loadOn(*simulation.frame(), slit.cells);
        torn.most = std::max(torn.most, load);
        torn.left = load;
        if (simulation.state().tears.empty())
            torn.began = load;
        else if (torn.first.time == 0.0)
            torn.first = simulation.state().tears[0];
        if (torn.first.time > 0.0 && load < 0.4 * torn.began)
            break;
    }
    return torn;
}

} // namespace

class TestTearEnergy : public QObject
{
    Q_OBJECT

private slots:
    // A wide sheet with a slit of 2 a tears at sqrt(G E t / (pi a)) (Griffith 1921), G = 2 F; this
    // one is three times as wide, held by its edges. Cloth that wrinkles beside the slit lets go of
    // more, and a row that is cut out is a longer slit.
    void beginsAlikeOnEachMesh_data()
    {
        QTest::addColumn<TearMesh>("tearMesh");
        QTest::addColumn<bool>("isBlunt");
        QTest::addColumn<bool>("pushes");
        for (const TearMesh mesh : {TearMesh::Vanish, TearMesh::Split})
            for (const bool isBlunt : {false, true})
                for (const bool pushes : {true, false})
                    QTest::addRow("%s, %s, %s", mesh == TearMesh::Split ? "split" : "vanish",
                                  isBlunt ? "cut out" : "two lips", pushes ? "pushes" : "wrinkles")
                        << mesh << isBlunt << pushes;
    }

    void beginsAlikeOnEachMesh()
    {
        QFETCH(TearMesh, tearMesh);
        QFETCH(bool, isBlunt);
        QFETCH(bool, pushes);
        const double expected =
            std::sqrt(2.0 * tearStrength * stiffness / (std::numbers::pi * halfSlit)); // N/m
        const bool mayBlunt = tearMesh == TearMesh::Vanish && !isBlunt; // by the panel that goes
        double least = 1e9, most = 0.0, leastRun = 1e9, mostRun = 0.0;  // N/m
        for (const int cells : {18, 24, 30}) {
            const Torn torn = drawn({cells, tearMesh, isBlunt, pushes});
            QVERIFY(torn.first.time > 0.0);
            QVERIFY2(std::abs(std::abs(torn.first.place.x() - 0.5 * side) - halfSlit)
                         < 1.5 * side / cells,
                     told(torn.first.place.x(), 0.5 * side - halfSlit));
            QVERIFY2(torn.most < (mayBlunt ? 1.15 : 1.02) * torn.began,
                     told(torn.most, torn.began));
            QVERIFY2(torn.left < 0.5 * torn.began, told(torn.left, 0.0));
            least = std::min(least, torn.began);
            most = std::max(most, torn.began);
            leastRun = std::min(leastRun, torn.most);
            mostRun = std::max(mostRun, torn.most);
        }
        QVERIFY2(most < 1.1 * least, told(most, least));
        QVERIFY2(mostRun < 1.1 * leastRun, told(mostRun, leastRun));
        if (pushes)
            QVERIFY2(isNear(least, expected, 0.1 * expected)
                         && isNear(most, expected, 0.1 * expected),
                     told(least, expected));
        else
            QVERIFY2(most < expected && least > 0.8 * expected, told(least, expected));
    }
};

QTEST_APPLESS_MAIN(TestTearEnergy)
#include "test_tear_energy.moc"
