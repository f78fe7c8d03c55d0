// The picture of a shadow: where it lies, how dark it is, and how its edge softens with height.
#include "look/shadow_map.h"
#include "registered_test.h"

#include <Eigen/Geometry>

namespace ripstop::test_shadow_map {

namespace {

// A level square of this half width, m, in two triangles.
ShadowMap shadowOfSquare(double half, double height)
{
    const std::array places{Vec3(-half, height, -half), Vec3(half, height, -half),
                            Vec3(half, height, half), Vec3(-half, height, half)};
    const std::array<std::array<int, 3>, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
    ShadowMap map;
    map.cast(places, triangles, 0.0);
    return map;
}

// Where the sun throws the place above the origin, m.
Vec3 fallen(double height) { return -height / sunDirection.y() * sunDirection; }

// m, from where the shadow has nine tenths of its darkness to where it has one, along x.
double edgeWidth(const ShadowMap& map, double height)
{
    const Vec3 middle = fallen(height);
    const double full = map.darkAt(middle.x(), middle.z());
    double inner = 0.0, outer = 0.0;
    for (double x = 0.0; x < 10.0; x += 0.001) {
        const double dark = map.darkAt(middle.x() + x, middle.z());
        inner = dark > 0.9 * full ? x : inner;
        outer = dark > 0.1 * full ? x : outer;
    }
    return outer - inner;
}

} // namespace

class TestShadowMap : public QObject
{
    Q_OBJECT

private slots:
    void itLiesWhereTheSunThrowsIt()
    {
        const ShadowMap map = shadowOfSquare(1.0, 5.0);
        const Vec3 middle = fallen(5.0);
        QVERIFY(map.darkAt(middle.x(), middle.z()) > 0.7);
        QVERIFY(map.darkAt(middle.x() + 0.8, middle.z() - 0.8) > 0.7);
        QVERIFY(map.darkAt(middle.x() + 1.3, middle.z()) < 0.02);
        QVERIFY(map.darkAt(0.0, 2.0) < 0.02);
    }

    // The light that is missing is that of the square, however wide its edges are.
    void softEdgesKeepTheLight()
    {
        for (const double height : {1.0, 5.0, 25.0}) {
            const ShadowMap map = shadowOfSquare(1.0, height);
            double sum = 0.0;
            for (const std::uint8_t dark : map.dark())
                sum += dark / 255.0;
            const double pixel = map.size() / ShadowMap::side;
            const Vec3 middle = fallen(height);
            const double full = shadowOfSquare(1.0, 1.0).darkAt(fallen(1.0).x(), fallen(1.0).z());
            QVERIFY(map.darkAt(middle.x(), middle.z()) <= full + 0.01);
            QVERIFY(std::abs(sum * pixel * pixel - full * 4.0) < 0.04 * full * 4.0);
        }
    }

    // A penumbra is as wide as the way along the ray times the width of the sun. Of light from a
    // disc, 80 % of the fall lies within 0.69 of that: the share of a disc beyond a chord at c
    // radii is (acos c - c sqrt(1 - c^2)) / pi, which is 0.1 at c = 0.687.
    void edgesSoftenWithHeight()
    {
        const double slope = sunDirection.norm() / sunDirection.y();
        const double low = edgeWidth(shadowOfSquare(1.0, 5.0), 5.0);
        const double high = edgeWidth(shadowOfSquare(1.0, 25.0), 25.0);
        QVERIFY(low < high);
        const double expected = 0.687 * sunWidth * slope * 25.0;
        QVERIFY(std::abs(high - expected) < 0.2 * expected);
    }

    // What comes near the ground has a foot that what hangs above it lacks.
    void whatTouchesHasADarkFoot()
    {
        const ShadowMap touching = shadowOfSquare(0.5, 0.01), hanging = shadowOfSquare(0.5, 0.5);
        QVERIFY(touching.darkAt(0.0, 0.0)
                > hanging.darkAt(fallen(0.5).x(), fallen(0.5).z()) + 0.05);
    }

    void whatIsBelowThrowsNone()
    {
        QVERIFY(shadowOfSquare(1.0, -2.0).isEmpty());
        ShadowMap map;
        map.cast({}, {}, 0.0);
        QVERIFY(map.isEmpty());
        QCOMPARE(map.darkAt(0.0, 0.0), 0.0);
    }

    // The light that comes through both is that of the darker one.
    void twoShadowsAreNoDarkerThanOne()
    {
        const ShadowMap high = shadowOfSquare(1.0, 5.0), low = shadowOfSquare(0.4, 5.0);
        const std::vector<std::uint8_t> more = low.darkBeside(high), less = high.darkBeside(low);
        QCOMPARE(*std::ranges::max_element(more), std::uint8_t(0)); // it lies within the other
        const double pixel = high.size() / ShadowMap::side;
        for (int row = 0; row < ShadowMap::side; ++row)
            for (int column = 0; column < ShadowMap::side; ++column) {
                const auto i = std::size_t(row * ShadowMap::side + column);
                const double beside =
                    low.darkAt(high.x() + pixel * (column + 0.5), high.z() + pixel * (row + 0.5));
                const double light = (1.0 - less[i] / 255.0) * (1.0 - beside);
                const double darker = std::max(high.dark()[i] / 255.0, beside);
                QVERIFY(std::abs(light - (1.0 - darker)) < 0.01);
            }
        QCOMPARE(high.darkBeside(ShadowMap()), high.dark());
    }

    void whatIsNotAPlaceIsLeftOut()
    {
        const std::array places{Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(0, 1, 1),
                                Vec3(std::nan(""), 1, 1)};
        const std::array<std::array<int, 3>, 2> triangles{{{0, 1, 2}, {1, 2, 3}}};
        ShadowMap map;
        map.cast(places, triangles, 0.0);
        QVERIFY(!map.isEmpty() && map.size() < 3.0);
    }
};

const RegisteredTest registered("test_shadow_map", runPlain<TestShadowMap>);

} // namespace ripstop::test_shadow_map

#include "test_shadow_map.moc"
