// Spars of several materials: which links go on into each other, and how stiffly.
//
// Stages: the bend between two of them in closed form; what crosses or has its own material to go
// on with stays free; and flights: a spar of two materials with one set of numbers is that of one,
// and a spar that is thinner outside sinks as beam theory says.
#include "builders/network.h"
#include "compile/compile.h"
#include "laws/bend.h"
#include "model/systems.h"
#include "registered_test.h"

#include <QtTest>

#include <array>
#include <cmath>

namespace ripstop::test_joined_spars {

namespace {

constexpr double light = 1e-6; // kg, which adds 2e-4 to the sag by the load

using Places = std::vector<Vec3>;

struct Given // a link
{
    int a;
    int b;
    std::uint32_t material;
    double rigidity = 1.0; // N m^2
    double breaking = 0.0; // N m
};

BendingNet netOf(const Places& places, const std::vector<Given>& links)
{
    BendingNet net;
    net.position = places;
    net.pinned.assign(places.size(), 0);
    for (const Given& link : links)
        net.links.push_back({link.a,
                             link.b,
                             (places[std::size_t(link.b)] - places[std::size_t(link.a)]).norm(),
                             link.material,
                             {0.0, link.rigidity, link.breaking}});
    return net;
}

// A row of two links, of 0.3 and 0.5 m.
BendingNet row(const Given& one, const Given& other)
{
    return netOf({{0, 0, 0}, {0.3, 0, 0}, {0.8, 0, 0}}, {one, other});
}

std::array<int, 2> outerEnds(const Bend& bend)
{
    return {std::min(bend.corner[1], bend.corner[2]), std::max(bend.corner[1], bend.corner[2])};
}

// A cantilever along x, clamped by a link before the origin, of which the outer half is of another
// material; its tip bears a load.
struct Cantilever
{
    double length = 1.0; // m
    int links = 20;
    double mass = 0.05; // kg, at the tip
    std::array<double, 2> rigidity{10.0, 10.0};
    bool ofTwoMaterials = true;
};

System systemOf(const Cantilever& given)
{
    Scene scene;
    scene.settings.viscosity = 20.0;
    scene.settings.airDensity = 0.0;
    std::array<Id, 2> material{};
    for (std::size_t half = 0; half < 2; ++half) {
        Material tube;
        tube.axialStiffness = 1e5;
        tube.flexuralRigidity = given.rigidity[half];
        tube.dampingTime = 1e-3;
        material[half] = addItem(scene, tube);
    }
    if (!given.ofTwoMaterials)
        material[1] = material[0];
    Network network(scene, "cantilever");
    const double cell = given.length / given.links;
    Id last = network.particle({-cell, 0.0, 0.0}, light);
    network.row(last).pinned = true;
    for (int i = 0; i <= given.links; ++i) {
        const Id next =
            network.particle({i * cell, 0.0, 0.0}, i == given.links ? given.mass : light);
        network.row(next).pinned = i == 0;
        network.rod(last, next, material[i > given.links / 2 ? 1 : 0]);
        last = next;
    }
    network.finish({}, {});
    return **compile(scene);
}

} // namespace

class TestJoinedSpars : public QObject
{
    Q_OBJECT

private slots:
    // M = theta / (l / (2 EI) + l' / (2 EI')), of links of 0.3 and 0.5 m; where one of them is a
    // clamp, of the other half alone.
    void halvesInSeries_data()
    {
        QTest::addColumn<double>("one"); // N m^2
        QTest::addColumn<double>("other");
        QTest::addColumn<bool>("clamped");
        QTest::newRow("equal") << 10.0 << 10.0 << false;
        QTest::newRow("thinner outside") << 10.0 << 2.0 << false;
        QTest::newRow("thinner inside") << 0.5 << 8.0 << false;
        QTest::newRow("from a clamp") << 3.0 << 8.0 << true;
    }

    void halvesInSeries()
    {
        QFETCH(double, one);
        QFETCH(double, other);
        QFETCH(bool, clamped);
        BendingNet net = row({0, 1, 1, one}, {1, 2, 2, other});
        net.pinned[0] = net.pinned[1] = clamped;
        const auto bends = bendsOf(net);
        QCOMPARE(int(bends.size()), 1);
        const double theta = 1e-4;
        const double moment = momentOf(
            bends[0], {Vec3(-0.3, 0, 0), 0.5 * Vec3(std::cos(theta), std::sin(theta), 0.0)});
        const double gives = (clamped ? 0.0 : 0.15 / one) + 0.25 / other; // 1 / (N m)
        QVERIFY2(isNear(moment, theta / gives, 1e-6 * theta / gives), told(moment, theta / gives));
    }

    // The weaker one snaps; one without a breaking moment never does.
    void weakerOneSnaps()
    {
        const auto breakingOf = [](double one, double other) {
            return bendsOf(row({0, 1, 1, 1.0, one}, {1, 2, 2, 1.0, other}))[0].breaking;
        };
        QCOMPARE(breakingOf(3.0, 2.0), 2.0);
        QCOMPARE(breakingOf(0.0, 2.0), 2.0);
        QCOMPARE(breakingOf(3.0, 0.0), 3.0);
        QCOMPARE(breakingOf(0.0, 0.0), 0.0);
    }

    // Where a link of its own material goes on, that one is taken, even if another is straighter;
    // spars that cross or end at one that goes through stay free of it.
    void ownMaterialFirst()
    {
        const Places places{{0, 0, 0}, {-1, 0, 0}, {1, 0.3, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
        const auto bends =
            bendsOf(netOf(places, {{1, 0, 1}, {0, 2, 1}, {0, 3, 2}, {4, 0, 3}, {0, 5, 3}}));
        QCOMPARE(int(bends.size()), 2);
        QCOMPARE(outerEnds(bends[0]), (std::array{1, 2}));
        QCOMPARE(outerEnds(bends[1]), (std::array{4, 5}));
    }

    // Of those that are left the straightest pair goes on, and a corner is a joint.
    void straightestOfThoseLeft()
    {
        const Places places{{0, 0, 0}, {-1, 0, 0}, {1, 0.3, 0}, {1, 0.1, 0}};
        const auto bends = bendsOf(netOf(places, {{1, 0, 1}, {0, 2, 2}, {0, 3, 3}}));
        QCOMPARE(int(bends.size()), 1);
        QCOMPARE(outerEnds(bends[0]), (std::array{1, 3}));
        QVERIFY(bendsOf(netOf({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, {{0, 1, 1}, {1, 2, 2}})).empty());
    }

    void sameNumbersSameFlight()
    {
        const System one = systemOf({.ofTwoMaterials = false});
        const System two = systemOf({.ofTwoMaterials = true});
        QVERIFY(run(one, 240).position == run(two, 240).position);
    }

    // F / (3 EI) (L^3 - a^3) + F a^3 / (3 EI'), the outer part being a long. What turns at the
    // particles sums that up by trapezoids: half of 1 / n^2 too much, n links to a half.
    void thinnerOutside()
    {
        const Cantilever given{.rigidity = {10.0, 4.0}};
        const State state = run(systemOf(given), 2400);
        const double a = 0.5, load = given.mass * standardGravity;
        const double sag = load * ((1.0 - a * a * a) / 30.0 + a * a * a / 12.0);
        const double tip = -state.position.back().y();
        QVERIFY2(isNear(tip, sag, 0.003 * sag), told(tip, sag));
    }
};

const RegisteredTest registered("test_joined_spars", runPlain<TestJoinedSpars>);

} // namespace ripstop::test_joined_spars
#include "test_joined_spars.moc"
