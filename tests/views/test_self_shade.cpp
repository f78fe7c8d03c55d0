// The shade that fabric throws on itself: none on what lies alone, and what is behind as the sun
// sees it, or as it is seen from all around.
#include "look/shadow_map.h"
#include "look/sky_shade.h"
#include "registered_test.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace ripstop::test_self_shade {

namespace {

constexpr double pi = std::numbers::pi;

struct Cloth
{
    std::vector<Vec3> places;
    std::vector<Corners> panels;

    // A square of so many cells a side, in m, laid across `normal`; returns its first place.
    int add(const Vec3& middle, const Vec3& normal, double size, int cells)
    {
        const auto turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), normal);
        const int first = int(places.size());
        for (int row = 0; row <= cells; ++row)
            for (int column = 0; column <= cells; ++column)
                places.push_back(middle
                                 + turn
                                       * Vec3(size * (double(column) / cells - 0.5),
                                              size * (double(row) / cells - 0.5), 0.0));
        for (int row = 0; row < cells; ++row)
            for (int column = 0; column < cells; ++column) {
                const int corner = first + row * (cells + 1) + column;
                panels.push_back({corner, corner + 1, corner + cells + 2});
                panels.push_back({corner, corner + cells + 2, corner + cells + 1});
            }
        return first;
    }

    std::vector<float> shade(std::vector<std::uint8_t> present = {}) const
    {
        present.resize(panels.size(), 1);
        std::vector<float> result(places.size(), -1.0F);
        std::vector<std::array<float, 3>> normals(places.size());
        smoothNormals(panels, present, places, normals);
        SelfShade().cast(sunDirection.normalized(), places, normals, panels, present, result);
        return result;
    }

    std::vector<std::array<float, 2>> fromAround() const
    {
        const std::vector<std::uint8_t> present(panels.size(), 1);
        std::vector<std::array<float, 2>> result(places.size(), {-1.0F, -1.0F});
        std::vector<std::array<float, 3>> normals(places.size());
        smoothNormals(panels, present, places, normals);
        SkyShade().cast(places, normals, panels, present, result);
        return result;
    }
};

float most(const std::vector<float>& shade) { return *std::ranges::max_element(shade); }

} // namespace

class TestSelfShade : public QObject
{
    Q_OBJECT

private slots:
    void aSheetAloneIsInTheSun()
    {
        for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(-1, 1, 0),
                                   Vec3(0.3, 0.2, -1), Vec3(1, -0.4, 0.1)}) {
            Cloth cloth;
            cloth.add(Vec3(3.0, 40.0, -2.0), normal, 2.0, 20);
            QCOMPARE(most(cloth.shade()), 0.0F);
        }
    }

    // A square between the sun and one of twice its size covers a quarter of that.
    void whatIsBehindIsInTheShade()
    {
        Cloth cloth;
        const Vec3 sun = sunDirection.normalized();
        cloth.add(2.0 * sun, sun, 1.0, 4);
        const int behind = cloth.add(Vec3::Zero(), sun, 2.0, 40);
        const std::vector<float> shade = cloth.shade();
        for (int i = 0; i < behind; ++i)
            QCOMPARE(shade[std::size_t(i)], 0.0F);
        QCOMPARE(shade[std::size_t(behind + 20 * 41 + 20)], 1.0F); // the middle
        QCOMPARE(shade[std::size_t(behind)], 0.0F);                // a corner
        const double mean = std::accumulate(shade.begin() + behind, shade.end(), 0.0) / (41 * 41);
        QVERIFY2(std::abs(mean - 0.25) < 0.02, qPrintable(QString::number(mean)));
    }

    void whatIsGoneThrowsNone()
    {
        Cloth cloth;
        const Vec3 sun = sunDirection.normalized();
        cloth.add(2.0 * sun, sun, 1.0, 1);
        cloth.add(Vec3::Zero(), sun, 1.0, 4);
        QVERIFY(most(cloth.shade()) == 1.0F);
        QCOMPARE(most(cloth.shade({0, 0})), 0.0F);
    }

    // Lines that reach far from the cloth do not coarsen its picture.
    void onlyFabricCounts()
    {
        Cloth cloth;
        const Vec3 sun = sunDirection.normalized();
        cloth.add(0.2 * sun, sun, 0.5, 1);
        cloth.add(Vec3::Zero(), sun, 1.0, 20);
        const std::vector<float> alone = cloth.shade();
        cloth.places.push_back(Vec3(900.0, -400.0, 0.0));
        std::vector<float> together = cloth.shade();
        QCOMPARE(together.back(), 0.0F);
        together.pop_back();
        QCOMPARE(together, alone);
    }

    // The middle of a square sees of another one, a half of its side away, a share of
    // 4 / (2 pi) 2 / sqrt(2) atan(1 / sqrt(2)) = 0.554 (Howell's catalogue, B-3). Sixteen
    // directions tell it roughly. Outside, and alone, nothing is seen.
    void betweenTwoSheetsItIsDark()
    {
        Cloth cloth;
        cloth.add(Vec3::Zero(), Vec3::UnitY(), 2.0, 20);
        const int middle = 10 * 21 + 10;
        for (const auto& [along, against] : cloth.fromAround())
            QVERIFY(along == 0.0F && against == 0.0F);
        const int above = cloth.add(Vec3(0.0, 1.0, 0.0), Vec3::UnitY(), 2.0, 20);
        const std::vector<std::array<float, 2>> shade = cloth.fromAround();
        const double expected = 4.0 / (2.0 * pi) * std::sqrt(2.0) * std::atan(std::sqrt(0.5));
        const auto& lower = shade[std::size_t(middle)];
        const auto& upper = shade[std::size_t(above + middle)];
        QVERIFY2(std::abs(lower[0] - expected) < 0.12, qPrintable(QString::number(lower[0])));
        QVERIFY2(std::abs(upper[1] - expected) < 0.12, qPrintable(QString::number(upper[1])));
        QCOMPARE(lower[1], 0.0F);
        QCOMPARE(upper[0], 0.0F);
    }

    void whatIsNotFiniteIsLeftOut()
    {
        Cloth cloth;
        const Vec3 sun = sunDirection.normalized();
        cloth.add(2.0 * sun, sun, 1.0, 1);
        cloth.add(Vec3::Zero(), sun, 1.0, 4);
        cloth.places[0].x() = std::numeric_limits<double>::quiet_NaN();
        cloth.places[8].y() = std::numeric_limits<double>::infinity();
        for (const double far : {1e29, 1e39, 1e300}) { // m, within floats and beyond
            cloth.places[4].z() = far;
            for (const float shade : cloth.shade())
                QVERIFY(shade >= 0.0F && shade <= 1.0F);
        }
        Cloth nothing;
        QVERIFY(nothing.shade().empty());
        for (const auto& [along, against] : cloth.fromAround())
            QVERIFY(along >= 0.0F && along <= 1.0F && against >= 0.0F && against <= 1.0F);
        for (Vec3& place : cloth.places)
            place.setConstant(std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(most(cloth.shade()), 0.0F);
    }
};

const RegisteredTest registered("test_self_shade", runPlain<TestSelfShade>);

} // namespace ripstop::test_self_shade

#include "test_self_shade.moc"
