// The law of cloth in its plane (laws/cloth_law.h): moduli off the axes, the tension as the
// derivative of the energy, and wrinkling as the least energy that it is.
#include "laws/cloth_bound.h"
#include "laws/cloth_law.h"
#include "laws/cloth_pack.h"
#include "model/systems.h"
#include "registered_test.h"
#include "system/membrane.h"

#include <QtTest>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace ripstop::test_cloth_law {

namespace {

// Test cloth A: E1 t, E2 t, nu12, G t.
const ClothLaw clothA = ClothLaw::of(40e3, 25e3, 0.2, 1.2e3);

Eigen::Matrix2d matrixOf(const Vec3& v, double shearShare)
{
    Eigen::Matrix2d matrix;
    matrix << v[0], shearShare * v[2], shearShare * v[2], v[1];
    return matrix;
}

std::vector<Vec3> someStrains(int count)
{
    std::mt19937 random(7);
    const auto number = [&] { return (double(random()) / 4294967296.0 - 0.5) * 0.04; };
    std::vector<Vec3> strains;
    for (int i = 0; i < count; ++i)
        strains.push_back({number(), number(), 2.0 * number()});
    return strains;
}

std::vector<PieceLaw> someLaws()
{
    const ClothLaw isotropic = ClothLaw::of(40e3, 40e3, 0.3, 40e3 / 2.6);
    return {clothA,
            isotropic,
            ClothLaw::of(30e3, 30e3, 0.1, 100.0),
            ClothLaw::of(500e3, 100e3, 0.4, 40e3),
            PieceLaw(clothA, 3.0),
            PieceLaw(isotropic, 200.0)};
}

} // namespace

class TestClothLaw : public QObject
{
    Q_OBJECT

private slots:
    // Nothing that is passed over by its bound could have torn; and the bound is of use: of cloth
    // pulled along its stiffer threads, by far more than it buckles under, it is at most twice what
    // these pull.
    void noThreadIsBeyondItsBound()
    {
        for (const PieceLaw& law : someLaws()) {
            const ClothBound bound(law);
            for (const Vec3& strain : someStrains(2000)) {
                const double e = largestStrain(strain);
                const ClothTension now = tensionOf(law, strain);
                const Vec3 threads = threadStrain(law, strain, now);
                for (const int i : {0, 1}) {
                    QVERIFY(threads[i] <= bound.stretchAt(e) + 1e-15);
                    QVERIFY(std::sqrt(1.0 + 2.0 * threads[i]) * now.tension[i]
                            <= bound.pullAt(e) * (1.0 + 1e-12));
                }
            }
            const double e = 1e-3 + 10.0 * law.bucklingLoad / law.warp;
            QVERIFY(bound.pullAt(e) < 2.0 * tensionOf(law, Vec3(e, 0.0, 0.0)).tension[0]);
        }
    }

    // 1/E(th) = c^4/E1 + (1/G - 2 nu12/E1) s^2 c^2 + s^4/E2 (Jones 1975, 2.6), worked out for cloth
    // A.
    void modulusOffTheAxes_data()
    {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("modulus"); // N/m
        QTest::addColumn<double>("contraction");
        const auto row = [](double degrees, double modulus, double contraction) {
            QTest::addRow("%g degrees", degrees) << degrees << modulus << contraction;
        };
        row(0, 40000, 0.2000);
        row(15, 13624, 0.7138);
        row(22.5, 8197.5, 0.8180);
        row(30, 5850.1, 0.8611);
        row(45, 4502.8, 0.8762);
        row(60, 5604.2, 0.8249);
        row(75, 11575, 0.6065);
        row(90, 25000, 0.1250);
    }

    void modulusOffTheAxes()
    {
        QFETCH(double, degrees);
        QFETCH(double, modulus);
        QFETCH(double, contraction);
        const double c = std::cos(degrees * std::numbers::pi / 180.0);
        const double s = std::sin(degrees * std::numbers::pi / 180.0);
        const double pull = 10.0; // N/m, along (c, s)
        const Vec3 strain = strainOf(clothA, {pull * c * c, pull * s * s, pull * c * s});
        const double along = strain[0] * c * c + strain[1] * s * s + strain[2] * c * s;
        const double across = strain[0] * s * s + strain[1] * c * c - strain[2] * c * s;
        QVERIFY2(isNear(pull / along, modulus, 1e-4 * modulus), told(pull / along, modulus));
        QVERIFY2(isNear(-across / along, contraction, 1e-3), told(-across / along, contraction));
        // It is the edge of wrinkling: nothing is relaxed away.
        const Vec3 back = tensionOf(clothA, strain).tension;
        QVERIFY((back - Vec3(pull * c * c, pull * s * s, pull * c * s)).norm() < 1e-6);
    }

    void isDerivativeOfEnergy()
    {
        for (const PieceLaw& law : someLaws())
            for (const Vec3& strain : someStrains(300)) {
                const ClothTension now = tensionOf(law, strain);
                constexpr double step = 1e-8;
                for (int k = 0; k < 3; ++k) {
                    const auto at = [&](double way) {
                        return tensionOf(law, strain + way * Vec3::Unit(k));
                    };
                    const double slope = (at(step).energy - at(-step).energy) / (2.0 * step);
                    QVERIFY2(isNear(now.tension[k], slope, 1e-6 * law.warp * 0.04),
                             told(now.tension[k], slope));
                    if (at(step).state != now.state || at(-step).state != now.state)
                        continue; // the derivative jumps there
                    const Vec3 column = (at(step).tension - at(-step).tension) / (2.0 * step);
                    QVERIFY2((now.stiffness.col(k) - column).norm() < 1e-4 * law.warp,
                             told(Vec3(now.stiffness.col(k)), column));
                }
            }
    }

    // Least energy over what wrinkles take up, P: P >= 0, s + N >= 0 and P : (s + N) = 0 are
    // necessary and, the energy being convex, enough (Karush, Kuhn and Tucker).
    void isTheLeastEnergy()
    {
        int wrinkled = 0;
        for (const PieceLaw& law : someLaws())
            for (const Vec3& strain : someStrains(2000)) {
                const ClothTension now = tensionOf(law, strain);
                const Vec3 taken = strainOf(law, now.tension) - strain;
                const Eigen::Matrix2d pull =
                    matrixOf(now.tension, 1.0) + law.bucklingLoad * Eigen::Matrix2d::Identity();
                const Eigen::Matrix2d wrinkles = matrixOf(taken, 0.5);
                const auto least = [](const Eigen::Matrix2d& m) {
                    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(m).eigenvalues()[0];
                };
                QVERIFY2(least(pull) >= -1e-9 * law.warp, told(least(pull), 0.0));
                QVERIFY2(least(wrinkles) >= -1e-9, told(least(wrinkles), 0.0));
                QVERIFY2(isNear((pull * wrinkles).trace(), 0.0, 1e-9 * law.warp * 0.04),
                         told((pull * wrinkles).trace(), 0.0));
                const double eigenvalue =
                    Eigen::SelfAdjointEigenSolver<Mat3>(now.stiffness).eigenvalues()[0];
                QVERIFY2(eigenvalue >= -1e-9 * law.warp, told(eigenvalue, 0.0));
                wrinkled += now.state == ClothState::Wrinkled;
            }
        QVERIFY(wrinkled > 1000);
    }

    void slackPushesAsItBuckles()
    {
        for (const PieceLaw& law : someLaws()) {
            const ClothTension slack = tensionOf(law, {-0.01, -0.02, 0.001});
            QVERIFY(slack.state == ClothState::Slack);
            QVERIFY(law.bucklingLoad > 0.0 || (slack.tension.isZero(0.0) && slack.energy == 0.0));
            const Vec3 push(-law.bucklingLoad, -law.bucklingLoad, 0.0);
            QVERIFY2((slack.tension - push).norm() <= 1e-12 * law.warp, told(slack.tension, push));
            // What folds take up costs the push all along the way, and what comes before half.
            const double energy = push.dot(Vec3(-0.01, -0.02, 0.0) - 0.5 * strainOf(law, push));
            QVERIFY2(isNear(slack.energy, energy, 1e-12 * law.warp), told(slack.energy, energy));
        }
    }

    // Euler's load of a strip of the flexural rigidity B = E I per width between two hinges.
    void foldsAsEulersColumn()
    {
        const double rigidity = 2e-5, length = 0.01; // N m, m
        const double load = bucklingLoadOf(rigidity, length);
        QVERIFY2(isNear(load, 1.9739, 1e-4), told(load, 1.9739));
        const PieceLaw law(ClothLaw::of(40e3, 40e3, 0.0, 1e3), load);
        const ClothTension less = tensionOf(law, {-0.9 * load / 40e3, 0.0, 0.0});
        QVERIFY(less.state == ClothState::Taut);
        QVERIFY2(isNear(less.tension[0], -0.9 * load, 1e-9), told(less.tension[0], -0.9 * load));
        const ClothTension more = tensionOf(law, {-0.1, 0.0, 0.0});
        QVERIFY(more.state == ClothState::Wrinkled);
        QVERIFY2(isNear(more.tension[0], -load, 1e-9), told(more.tension[0], -load));
        QVERIFY2(isNear(more.tension[1], 0.0, 1e-9), told(more.tension[1], 0.0));
    }

    // Pure shear of an isotropic panel, wrinkled: the pull is E t g / 2 along the diagonal (Wagner
    // 1929), so that its shear component is E t g / 4.
    void wagnerPanel()
    {
        const ClothLaw law = ClothLaw::of(40e3, 40e3, 0.3, 40e3 / 2.6);
        const ClothTension now = tensionOf(law, {0.0, 0.0, 0.01});
        QVERIFY2(isNear(now.tension[2], 100.0, 1e-6), told(now.tension[2], 100.0));
        QVERIFY2(isNear(now.tension[0], 100.0, 1e-6), told(now.tension[0], 100.0));
    }

    // What is beside a piece of cloth, taut, wrinkled or slack, changes no bit of it.
    void lanesAreApart()
    {
        const std::vector<PieceLaw> laws = someLaws();
        const std::vector<Vec3> strains = someStrains(401);
        std::array<int, 3> seen{};
        for (std::size_t i = 0; i + 4 <= strains.size(); ++i) {
            ClothLawPack law;
            Coordinates strain;
            for (std::size_t k = 0; k < 4; ++k) {
                law.set(int(k), laws[(i + k) % laws.size()]);
                strain.set(int(k), strains[i + k]);
            }
            ClothTensionPack now;
            followLaws(law, strain, now);
            for (std::size_t k = 0; k < 4; ++k) {
                const ClothTension alone = tensionOf(laws[(i + k) % laws.size()], strains[i + k]);
                const ClothTension beside = now.of(int(k));
                ++seen[std::size_t(alone.state)];
                QVERIFY(beside.state == alone.state && beside.energy == alone.energy
                        && beside.tension == alone.tension && beside.stiffness == alone.stiffness);
            }
        }
        QVERIFY(std::ranges::all_of(seen, [](int times) { return times > 100; }));
    }

    void boardsPush()
    {
        ClothLaw law = clothA;
        law.pushes = true;
        const ClothTension now = tensionOf(law, {-0.01, 0.0, 0.0});
        QVERIFY2(isNear(now.tension[0], -0.01 * law.warp, 1e-9), told(now.tension[0], -400.0));
    }
};

const RegisteredTest registered("test_cloth_law", runPlain<TestClothLaw>);

} // namespace ripstop::test_cloth_law
#include "test_cloth_law.moc"
