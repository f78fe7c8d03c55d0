// The mass of particles from the densities of materials.
#include "model/systems.h"

#include "builders/builder.h"
#include "scene/path.h"
#include "scene/weigh.h"

#include <QtTest>

#include <cmath>

using namespace ripstop;

namespace {

constexpr double density = 0.25; // kg/m^2

// 1 m x 1 m of fabric, loose.
Parameters sheet(int cells)
{
    return {{"columns", cells}, {"rows", cells}, {"hang", 2}, {"density", density}};
}

Part& partOf(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item))
            return *part;
    std::abort();
}

#define NEAR(got, expected, share)                                                                 \
    QVERIFY2(isNear(got, expected, (share)*std::abs(expected)), told(got, expected))

} // namespace

class TestWeigh : public QObject
{
    Q_OBJECT

private slots:
    void anotherDensityWeighsAnew()
    {
        Scene scene = *build(*findBuilder("cloth"), sheet(6));
        const auto mass = [&] {
            double sum = 0.0;
            for (const Particle& particle : partOf(scene).particles)
                sum += particle.mass;
            return sum;
        };
        partOf(scene).particles[5].mass += 1.0; // what somebody hung there
        Scene before = scene;
        const Edit undo = apply(scene, *assignment(scene, "cloth.arealDensity=0.04"));
        NEAR(mass(), 1.04, 1e-12);
        NEAR(partOf(scene).particles[24].mass, partOf(before).particles[24].mass * 0.04 / density,
             1e-12);
        (void)apply(scene, undo);
        QVERIFY(scene == before);
        // of unknown density it is only noted
        (void)apply(scene, *assignment(scene, "cloth.arealDensity="));
        (void)apply(scene, *assignment(scene, "cloth.arealDensity=0.04"));
        NEAR(mass(), density + 1.0, 1e-12);
        // and a density that the particles cannot have had is refused
        for (Particle& particle : partOf(scene).particles)
            particle.mass = 1e-5;
        QVERIFY(assignment(scene, "cloth.arealDensity=0.01").message().find("weighs less")
                != std::string::npos);
    }

    void weighingTakesTheDensities_data()
    {
        QTest::addColumn<int>("cells");
        QTest::newRow("10 x 10") << 10;
        QTest::newRow("20 x 20") << 20;
        QTest::newRow("40 x 40") << 40;
    }
    void weighingTakesTheDensities()
    {
        QFETCH(int, cells);
        Scene scene = *build(*findBuilder("cloth"), sheet(cells));
        const Part before = partOf(scene);
        Part& part = partOf(scene);
        part.particles.push_back({takeId(scene), Vec3(5.0, 5.0, 5.0)}); // of nothing
        for (Particle& particle : part.particles)
            particle.mass = 0.7;
        (void)apply(scene, weighing(scene));
        NEAR(part.particles.back().mass, 0.7, 1e-12);
        double sum = 0.0;
        for (std::size_t i = 0; i + 1 < part.particles.size(); ++i) {
            NEAR(part.particles[i].mass, before.particles[i].mass, 1e-12);
            sum += part.particles[i].mass;
        }
        NEAR(sum, density, 1e-12);
        Scene rope = *build(*findBuilder("rope"), {{"segments", cells}, {"density", 0.05}});
        for (Particle& particle : partOf(rope).particles)
            particle.mass = 3.0;
        (void)apply(rope, weighing(rope));
        NEAR(partOf(rope).particles.front().mass, 0.05 / cells, 1e-9); // 2 m, half a segment
    }
};

QTEST_APPLESS_MAIN(TestWeigh)
#include "test_weigh.moc"
