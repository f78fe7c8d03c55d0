// Memory per particle and per rod, of the scene, of what it is compiled into and of what runs it.
//
// Two sheets differ in the number of their rods only: bytes = a n + b m, solved for a and b.
#include "compile/compile.h"
#include "registered_test.h"
#include "scene/scene.h"
#include "simulation/simulation.h"
#include "step/stepper.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#include <malloc.h>
#define RIPSTOP_MEASURES 1
#else
#define RIPSTOP_MEASURES 0
#endif

namespace ripstop::test_memory {

namespace {

constexpr int side = 300; // particles; each array is large enough to be a mapping of its own

// Bytes that are in use on the heap.
double heapInUse()
{
#if RIPSTOP_MEASURES
    const struct mallinfo2 info = mallinfo2();
    return double(info.uordblks) + double(info.hblkhd);
#else
    return 0.0;
#endif
}

enum class Rods { Structural, All };

// A sheet of rods to the neighbours, or to the diagonal and second neighbours too.
Scene sheet(Rods which)
{
    Scene scene;
    scene.settings.sweeps = 1;
    scene.settings.substeps = 1;
    const Id cloth = takeId(scene);
    scene.items.push_back({cloth, Material()});
    Part part;
    part.particles.reserve(side * side);
    for (int i = 0; i < side * side; ++i) {
        Particle particle;
        particle.id = takeId(scene);
        particle.position = Vec3(0.01 * (i % side), 0.0, 0.01 * (i / side));
        particle.pinned = i == 0 || i == side - 1;
        part.particles.push_back(particle);
    }
    struct Reach
    {
        int rows;
        int columns;
    };
    std::vector<Reach> reaches{{0, 1}, {1, 0}};
    if (which == Rods::All)
        reaches.insert(reaches.end(), {{1, 1}, {1, -1}, {0, 2}, {2, 0}});
    part.links.reserve(reaches.size() * side * side);
    for (const Reach& reach : reaches)
        for (int row = 0; row + reach.rows < side; ++row)
            for (int column = std::max(0, -reach.columns);
                 column < std::min(side, side - reach.columns); ++column) {
                Link link;
                link.id = takeId(scene);
                link.from = part.particles[std::size_t(row * side + column)].id;
                link.to =
                    part.particles[std::size_t((row + reach.rows) * side + column + reach.columns)]
                        .id;
                link.material = cloth;
                link.restLength = 0.01 * std::hypot(reach.rows, reach.columns);
                part.links.push_back(link);
            }
    part.links.shrink_to_fit();
    const Id id = takeId(scene);
    scene.items.push_back({id, std::move(part)});
    return scene;
}

struct Sizes // bytes
{
    double particles = 0.0; // how many
    double rods = 0.0;
    double scene = 0.0;
    double system = 0.0;
    double state = 0.0;
    double stepper = 0.0;    // with its solver, after a step
    double simulation = 0.0; // state, last good state, layout, stepper
    double frame = 0.0;
};

Sizes sizesOf(Rods which)
{
    Sizes sizes;
    double before = heapInUse();
    const auto grown = [&] {
        const double now = heapInUse();
        return now - std::exchange(before, now);
    };
    const Scene scene = sheet(which);
    sizes.scene = grown();
    const auto system = compile(scene);
    if (!system)
        qFatal("%s", system.message().english().c_str());
    sizes.system = grown();
    sizes.particles = double((*system)->key.size());
    sizes.rods = double((*system)->rods.size());
    State state = (*system)->start;
    sizes.state = grown();
    Stepper stepper;
    stepper.step(**system, state);
    sizes.stepper = grown();
    Simulation simulation(*system);
    simulation.step();
    sizes.simulation = grown();
    const auto frame = simulation.frame();
    sizes.frame = grown();
    return sizes;
}

} // namespace

class TestMemory : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_few = sizesOf(Rods::Structural);
        m_many = sizesOf(Rods::All);
    }

    void perElement_data()
    {
        QTest::addColumn<double>("particle"); // bytes at most
        QTest::addColumn<double>("rod");
        // the rows of the tables of a part
        QTest::newRow("scene") << 114.0 << 130.0;
        // rod 48, link 20, whose stuff 16, incidence 16, tension and tears of the start 9; key,
        // masses and start 148, incidence 12
        QTest::newRow("system") << 162.0 << 119.0;
        QTest::newRow("state") << 129.0 << 10.0; // four rows of four; tension, torn
        // lengths 16, multipliers 8, batches 24 to 32 when full, places 17, and to spare
        QTest::newRow("stepper") << 128.0 << 100.0;
        // two states, stepper, layout
        QTest::newRow("simulation") << 362.0 << 145.0;
        QTest::newRow("frame") << 50.0 << 18.0;
    }

    void perElement()
    {
        if (!RIPSTOP_MEASURES)
            return;
        QFETCH(double, particle);
        QFETCH(double, rod);
        const std::string_view what = QTest::currentDataTag();
        const auto pick = [&](const Sizes& sizes) {
            return what == "scene"        ? sizes.scene
                   : what == "system"     ? sizes.system
                   : what == "state"      ? sizes.state
                   : what == "stepper"    ? sizes.stepper
                   : what == "simulation" ? sizes.simulation
                                          : sizes.frame;
        };
        const double perRod = (pick(m_many) - pick(m_few)) / (m_many.rods - m_few.rods);
        const double perParticle = (pick(m_few) - perRod * m_few.rods) / m_few.particles;
        qInfo("%.1f bytes per particle, %.1f per rod", perParticle, perRod);
        QVERIFY(perParticle < particle);
        QVERIFY(perRod < rod);
    }

    // A million particles and six million rods: scene, system and a simulation of it at once.
    void million()
    {
        const auto all = [](const Sizes& sizes) {
            return sizes.scene + sizes.system + sizes.simulation + sizes.frame;
        };
        const double perRod = (all(m_many) - all(m_few)) / (m_many.rods - m_few.rods);
        const double perParticle = (all(m_few) - perRod * m_few.rods) / m_few.particles;
        const double gibibytes = (1e6 * perParticle + 6e6 * perRod) / (1 << 30);
        qInfo("%.2f GiB", gibibytes);
        QVERIFY(gibibytes < 4.0);
    }

private:
    Sizes m_few;
    Sizes m_many;
};

const RegisteredTest registered("test_memory", runPlain<TestMemory>);

} // namespace ripstop::test_memory
#include "test_memory.moc"
