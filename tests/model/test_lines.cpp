// Wind on lines (validation 4.13).
//
// Stages: forces on a line across and at an angle to the wind, and their shares at its ends; then
// the terminal speed of a stick and the lean of a loaded line; and which links are lines at all.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "builders/network.h"
#include "compile/compile.h"
#include "forces/line_drag.h"
#include "measure/diagnostics.h"

#include <QtTest>

#include <numbers>

namespace ripstop::test_lines {

namespace {

constexpr double density = 1.225; // kg/m^3

DragLine& addLine(System& system, int a, int b, double width)
{
    system.links.push_back(
        {Key(system.links.size()), LinkKind::Rod, int(system.rods.size()), a, b});
    addRod(system, a, b, distance(system, a, b));
    system.of<LineLists>().list.push_back({int(system.links.size()) - 1, a, b, width});
    return system.of<LineLists>().list.back();
}

} // namespace

class TestLines : public QObject
{
    Q_OBJECT

private slots:
    // 1/2 rho Cd d l V^2: 50 m of 1 mm line in 8 m/s, Cd 1.1: 2.2 N, 0.043 N/m.
    void acrossTheWind()
    {
        const Vec3 drag =
            lineDrag(1.1 * 0.001, Vec3::Zero(), {0.0, 50.0, 0.0}, {8.0, 0.0, 0.0}, density);
        QVERIFY2(isNear(drag, Vec3(2.156, 0.0, 0.0), 1e-12), told(drag, Vec3(2.156, 0.0, 0.0)));
        QVERIFY2(isNear(drag.x() / 50.0, 0.043, 0.0005), told(drag.x() / 50.0, 0.043));
    }

    // At an angle only the part across the line counts: sin^2 of the force, across the line.
    void atAnAngle()
    {
        for (const double degrees : {0.0, 20.0, 45.0, 70.0, 90.0}) {
            const double angle = degrees * std::numbers::pi / 180.0;
            const Vec3 along(std::cos(angle), std::sin(angle), 0.0);
            const Vec3 drag = lineDrag(0.002, Vec3::Zero(), 3.0 * along, {7.0, 0.0, 0.0}, density);
            const double s = std::sin(angle);
            const double expected = 0.5 * density * 0.002 * 3.0 * 49.0 * s * s;
            QVERIFY2(isNear(drag.norm(), expected, 1e-12), told(drag.norm(), expected));
            QVERIFY(std::abs(drag.dot(along)) < 1e-12);
            QVERIFY(drag.x() >= 0.0);
        }
        QCOMPARE(lineDrag(1.0, Vec3::Zero(), Vec3::Zero(), {1.0, 0.0, 0.0}, 1.0),
                 Vec3(Vec3::Zero())); // no length
    }

    // Half to each end, none when the line goes with the wind, none when it is torn.
    void ends()
    {
        System system = emptySystem(1.0, Integrator::ExplicitEuler);
        system.wind = {3.0, 0.0, 4.0};
        addParticle(system, {0.0, 0.0, 0.0}, 2.0);
        addParticle(system, {0.0, 5.0, 0.0}, 2.0);
        addLine(system, 0, 1, 0.01);
        finish(system);
        const Vec3 drag = lineDrags(system, system.start)[0];
        QVERIFY2(isNear(drag.norm(), 0.5 * density * 0.01 * 5.0 * 25.0, 1e-12),
                 told(drag.norm(), 0.0));
        for (const Vec3& v : run(system, 1).velocity)
            QVERIFY2(isNear(2.0 * v, 0.5 * drag, 1e-12), told(2.0 * v, 0.5 * drag));

        State carried = system.start;
        for (PaddedVec3& v : carried.velocity)
            v = system.wind;
        QCOMPARE(lineDrags(system, carried)[0], Vec3(Vec3::Zero()));
        State torn = system.start;
        torn.rodTorn[0] = 1;
        QCOMPARE(lineDrags(system, torn)[0], Vec3(Vec3::Zero()));
        QCOMPARE(run(system, torn, 1).velocity[1], PaddedVec3());
    }

    // A stick that falls broadside ends at sqrt(2 m g / (rho Cd d l)).
    void terminal()
    {
        System system = emptySystem(1.0 / 1000.0);
        system.gravity = {0.0, -standardGravity, 0.0};
        addParticle(system, {0.0, 0.0, 0.0}, 0.01);
        addParticle(system, {2.0, 0.0, 0.0}, 0.01);
        addLine(system, 0, 1, 1.1 * 0.004);
        finish(system);
        const double expected =
            std::sqrt(2.0 * 0.02 * standardGravity / (density * 1.1 * 0.004 * 2.0));
        const double got = -run(system, 10000).velocity[1].y();
        QVERIFY2(isNear(got, expected, 1e-6), told(got, expected));
    }

    // A line that wind blows sideways leans by tan = (drag + 2 F) / (weight + 2 W): statics of a
    // line hung up at its upper end, about that end; drag from the share of the wind across it.
    void leans()
    {
        Scene scene;
        scene.settings.viscosity = 2.0;
        Material cord{"cord"};
        cord.diameter = 0.004;
        const Id material = addItem(scene, cord);
        addWind(scene, {6.0, 0.0, 0.0});
        Network network(scene, "line");
        const Id top = network.particle({0.0, 10.0, 0.0}, 0.1);
        const Id bottom = network.particle({0.0, 7.0, 0.0}, 0.1);
        network.row(top).pinned = true;
        network.rod(top, bottom, material);
        network.finish({}, {});
        const auto system = compile(scene);
        QVERIFY(bool(system));
        QCOMPARE((*system)->of<LineLists>().list.size(), std::size_t(1));
        const State state = run(**system, 5000);
        const Vec3 hangs = state.position[1] - state.position[0];
        const double angle = std::atan2(hangs.x(), -hangs.y());
        const double c = std::cos(angle);
        // moments: half of 1/2 rho Cd d l (V cos)^2 at the lower end, across the line
        const double drag = 0.5 * 0.5 * density * 1.1 * 0.004 * 3.0 * 36.0 * c * c;
        const double weight = 0.1 * standardGravity * std::sin(angle);
        QVERIFY2(isNear(drag, weight, 1e-4 * weight), told(drag, weight));
        QVERIFY(angle > 0.05);
    }

    // Only links of a material with a diameter are lines; an edit of the material lists them anew.
    void listed()
    {
        Scene scene;
        Material thin{"thin"};
        thin.diameter = 0.001;
        thin.dragCoefficient = 0.9;
        const Id line = addItem(scene, thin);
        const Id seam = addItem(scene, Material{"seam"});
        Network network(scene, "net");
        std::vector<Id> nodes;
        for (int i = 0; i < 4; ++i)
            nodes.push_back(network.particle({double(i), 0.0, 0.0}, 0.1));
        network.rod(nodes[0], nodes[1], seam);
        network.rod(nodes[1], nodes[2], line);
        network.spring(nodes[2], nodes[3], line);
        network.finish({}, {});
        const auto system = compile(scene);
        QCOMPARE((*system)->of<LineLists>().list.size(), std::size_t(2));
        QCOMPARE((*system)->of<LineLists>().list[0].link, 1);
        QCOMPARE((*system)->of<LineLists>().list[1].link, 2);
        QCOMPARE((*system)->of<LineLists>().list[1].width, 0.9 * 0.001);
    }
};

const RegisteredTest registered("test_lines", runPlain<TestLines>);

} // namespace ripstop::test_lines
#include "test_lines.moc"
