// Kernels that take four panels, springs, particles or rods at a time (parallel/simd_pack.h): with
// and without vector instructions, alone or beside others, each gets the same bits.
//
// Stages: panels, springs, contacts and rods are each computed with and without vector
// instructions and compared by their bits, in numbers that do not fill the last pack; between them
// stand the law of a spring by hand, and work that is shared out among threads.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "constraints/rod_batches.h"
#include "contact/contact.h"
#include "forces/panel_load.h"
#include "forces/spring_force.h"
#include "parallel/simd_pack.h"

#include <QtTest>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <numeric>

namespace ripstop::test_kernels {

namespace {

constexpr int particles = 64;

template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

bool isPadded(const std::vector<PaddedVec3>& rows)
{
    return std::all_of(rows.begin(), rows.end(), [](const PaddedVec3& row) {
        return std::bit_cast<std::uint64_t>(row.padding) == 0;
    });
}

// Particles here and there; the last one is where the first one is.
System scattered(Dice& dice, double speed)
{
    System system = emptySystem(0.01);
    system.wind = {7.0, -1.0, 2.0};
    for (int i = 0; i < particles; ++i)
        addParticle(system, dice.vector(1.0), dice(0.1, 1.0), dice.vector(speed));
    system.start.position.back() = system.start.position.front();
    return system;
}

int another(Dice& dice, int particle)
{
    return (particle + 1 + dice.below(particles - 1)) % particles;
}

// Panels of each law, rough and smooth, some gone, some without area; their number is not a
// multiple of four.
System panels(std::uint32_t seed, double speed, int count = 403)
{
    constexpr std::array laws{AirLaw::None, AirLaw::Paper, AirLaw::LinearNormal, AirLaw::LiftDrag};
    Dice dice(seed);
    System system = scattered(dice, speed);
    for (int i = 0; i < count; ++i) {
        const int a = dice.below(particles);
        const int b = another(dice, a);
        const int c = dice.below(20) ? another(dice, b) : b;
        // runs of one law and mixtures
        const AirLaw law = laws[std::size_t(i < 200 ? i / 50 % 4 : dice.below(4))];
        addPanel(system, a, b, c, law, dice(0.5, 4.0), dice.below(2) ? dice(0.0, 0.1) : 0.0);
        MaterialAir& air = system.materialAir.back();
        if (dice.below(3) == 0)
            air.porosity = dice(0.0, 0.2);
        if (law == AirLaw::LinearNormal && dice.below(2))
            air.saturation = dice(-0.5, 2.0);
        for (int k = 0; law == AirLaw::LiftDrag && k <= polarCells; ++k)
            air.polar.push_back({dice(0.0, 1.0), dice(0.0, 1.0)});
    }
    addPanel(system, 0, particles - 1, 5, AirLaw::Paper, 2.0, 0.02);
    finish(system);
    for (int i = 0; i < 30; ++i)
        system.start.panelGone[std::size_t(dice.below(int(system.panels.size())))] = 1;
    return system;
}

// Springs of each kind, slack and taut, some torn, one without length; their number is not a
// multiple of four.
System springs(std::uint32_t seed, int count = 401)
{
    Dice dice(seed);
    System system = scattered(dice, 3.0);
    for (int i = 0; i < count; ++i) {
        const int a = dice.below(particles);
        Spring& spring = addSpring(system, a, another(dice, a), dice(0.0, 2.0), dice(1.0, 100.0),
                                   dice(0.0, 9.0));
        spring.resists = Resists(i < 100 ? 0 : dice.below(3));
    }
    addSpring(system, 0, particles - 1, 0.5, 10.0, 1.0);
    finish(system);
    for (int i = 0; i < 30; ++i)
        system.start.springTorn[std::size_t(dice.below(int(system.springs.size())))] = 1;
    return system;
}

const MaterialAir& airOf(const System& system, std::size_t panel)
{
    return system.materialAir[std::size_t(system.panels[panel].air)];
}

std::vector<PaddedVec3> loads(const System& system, bool wide, int threads = 1)
{
    std::vector<PaddedVec3> load(system.panels.size(), Vec3(1.0, 2.0, 3.0));
    ThreadPool pool(threads);
    fillPanelLoads(system, system.start, pool, load, wide);
    return load;
}

std::vector<PaddedVec3> forces(const System& system, bool wide, int threads = 1)
{
    std::vector<PaddedVec3> force(system.springs.size(), Vec3(1.0, 2.0, 3.0));
    ThreadPool pool(threads);
    fillSpringForces(system, system.start, pool, force, wide);
    return force;
}

// Rods of three kinds in three colours. Within a colour no two rods share a particle; but the last
// batch of each kind has two rods only, which are repeated.
class Batches
{
public:
    explicit Batches(std::uint32_t seed)
        : m_dice(seed)
    {
        for (int i = 0; i < particles; ++i)
            position.push_back(m_dice.vector(1.0));
        position[particles - 2] = position[particles - 1];
        for (int colour = 0; colour < 3; ++colour)
            addColour();
        batches.evenStretch.resize(batches.even.size());
        batches.plainStretch.resize(batches.plain.size());
        batches.multiplier.resize(batches.soft.size());
    }

    void sweep(bool wide)
    {
        const std::array order{2, 0, 1};
        for (int i = 0; i < 20; ++i)
            sweepRuns(batches, order, {i % 2 != 0, Note((i + 1) % 3), wide}, position.data());
    }

    RodBatches batches;
    std::vector<PaddedVec3> position;

private:
    void addColour()
    {
        m_free.resize(particles);
        std::iota(m_free.begin(), m_free.end(), 0);
        // The first colour begins with the two particles that are in one place.
        for (std::size_t i = batches.runs.empty() ? 0 : m_free.size(); i > 1; --i)
            std::swap(m_free[i - 1], m_free[std::size_t(m_dice.below(int(i)))]);
        BatchRun run{};
        run.even = add(batches.even);
        run.plain = add(batches.plain);
        run.soft = add(batches.soft);
        batches.runs.push_back(run);
    }

    template <typename Batch>
    BatchRange add(std::vector<Batch>& kind)
    {
        const auto first = std::uint32_t(kind.size());
        for (const int rods : {4, 2}) {
            Batch& batch = kind.emplace_back();
            for (int lane = 0; lane < 4; ++lane)
                if (lane < rods)
                    fill(batch, lane);
                else
                    repeat(batch, lane, lane % rods);
        }
        return {first, std::uint32_t(kind.size())};
    }

    std::uint32_t take()
    {
        const int particle = m_free.back();
        m_free.pop_back();
        return std::uint32_t(particle) * std::uint32_t(sizeof(PaddedVec3));
    }

    double restOrTorn() // m
    {
        return m_dice.below(6) ? m_dice(0.2, 2.0) : std::numeric_limits<double>::quiet_NaN();
    }

    void fill(EvenBatch& batch, int lane)
    {
        batch.a[lane] = take(), batch.b[lane] = take();
        batch.halfRest[lane] = 0.5 * restOrTorn();
    }

    void fill(PlainBatch& batch, int lane)
    {
        batch.a[lane] = take(), batch.b[lane] = take();
        batch.rest[lane] = restOrTorn();
        batch.shareA[lane] = m_dice(0.0, 1.0);
        batch.shareB[lane] = 1.0 - batch.shareA[lane];
    }

    void fill(SoftBatch& batch, int lane)
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const int resists = m_dice.below(3);
        batch.a[lane] = take(), batch.b[lane] = take();
        batch.rest[lane] = m_dice(0.2, 2.0);
        batch.inverseMassA[lane] = m_dice(0.0, 10.0);
        batch.inverseMassB[lane] = m_dice.below(3) ? m_dice(0.0, 10.0) : 0.0;
        batch.softness[lane] = m_dice.below(2) ? m_dice(0.0, 10.0) : 0.0;
        batch.inverseWeight[lane] =
            1.0 / (batch.inverseMassA[lane] + batch.inverseMassB[lane] + batch.softness[lane]);
        if (m_dice.below(6) == 0)
            batch.inverseWeight[lane] = 0.0;
        batch.lowest[lane] = resists == 1 ? 0.0 : -infinity;
        batch.highest[lane] = resists == 2 ? 0.0 : infinity;
    }

    static void repeat(EvenBatch& batch, int to, int from)
    {
        batch.a[to] = batch.a[from], batch.b[to] = batch.b[from];
        batch.halfRest[to] = batch.halfRest[from];
    }

    static void repeat(PlainBatch& batch, int to, int from)
    {
        batch.a[to] = batch.a[from], batch.b[to] = batch.b[from];
        for (double* numbers : {batch.rest, batch.shareA, batch.shareB})
            numbers[to] = numbers[from];
    }

    static void repeat(SoftBatch& batch, int to, int from)
    {
        batch.a[to] = batch.a[from], batch.b[to] = batch.b[from];
        for (double* numbers : {batch.rest, batch.inverseMassA, batch.inverseMassB,
                                batch.inverseWeight, batch.softness, batch.lowest, batch.highest})
            numbers[to] = numbers[from];
    }

    Dice m_dice;
    std::vector<int> m_free; // particles that the colour has not used
};

} // namespace

class TestKernels : public QObject
{
    Q_OBJECT

private slots:
    void panelsEitherWay()
    {
        for (std::uint32_t seed = 1; seed < 20; ++seed) {
            const System system = panels(seed, 3.0);
            const std::vector<PaddedVec3> load = loads(system, wideMachine);
            QVERIFY(sameBits(load, loads(system, false)));
            QVERIFY(isPadded(load));
            System windy = system;
            windy.airflows = {Airflow{WindKind::LogLaw, {5.0, 0.0, 1.0}}};
            const std::vector<PaddedVec3> other = loads(windy, wideMachine);
            QVERIFY(sameBits(other, loads(windy, false)));
            QVERIFY(isPadded(other) && !sameBits(other, load));
            for (std::size_t i = 0; i < load.size(); ++i)
                if (system.start.panelGone[i] || airOf(system, i).law == AirLaw::None)
                    QCOMPARE(load[i].norm(), 0.0);
            QCOMPARE(load.back().norm(), 0.0); // no area
        }
    }

    // The panels in the same pack change nothing. Corners are at rest, so that the apparent wind is
    // the wind to the last bit.
    void panelsAlone()
    {
        const System system = panels(21, 0.0);
        const std::vector<PaddedVec3> load = loads(system, wideMachine);
        const auto at = [&](int corner) -> Vec3 {
            return system.start.position[std::size_t(corner)];
        };
        for (std::size_t i = 0; i < load.size(); ++i) {
            if (system.start.panelGone[i])
                continue;
            const auto [a, b, c] = system.panels[i].corner;
            const Vec3 alone =
                panelLoad(airOf(system, i), at(a), at(b), at(c), system.wind, system.airDensity);
            QVERIFY(std::memcmp(alone.data(), load[i].data(), sizeof(Vec3)) == 0);
        }
    }

    void springsEitherWay()
    {
        for (std::uint32_t seed = 1; seed < 20; ++seed) {
            const System system = springs(seed);
            const std::vector<PaddedVec3> force = forces(system, wideMachine);
            QVERIFY(sameBits(force, forces(system, false)));
            QVERIFY(isPadded(force));
            for (std::size_t i = 0; i < force.size(); ++i)
                if (system.start.springTorn[i])
                    QCOMPARE(force[i].norm(), 0.0);
            QCOMPARE(force.back().norm(), 0.0); // no direction
        }
    }

    // F = k (|d| - l) + nu (vb - va).u along u, none when slack.
    void springLaw()
    {
        const System system = springs(22);
        const State& state = system.start;
        const std::vector<PaddedVec3> force = forces(system, wideMachine);
        for (std::size_t i = 0; i < force.size(); ++i) {
            const Spring& s = system.springs[i];
            const Vec3 d = state.position[std::size_t(s.b)] - state.position[std::size_t(s.a)];
            const Vec3 v = state.velocity[std::size_t(s.b)] - state.velocity[std::size_t(s.a)];
            if (state.springTorn[i] || d.norm() == 0.0)
                continue;
            const double stretch = d.norm() - s.restLength;
            double tension = s.stiffness * stretch + s.damping * v.dot(d.normalized());
            if (s.resists == Resists::Tension && (stretch <= 0.0 || tension <= 0.0))
                tension = 0.0;
            if (s.resists == Resists::Compression && (stretch >= 0.0 || tension >= 0.0))
                tension = 0.0;
            QVERIFY2(isNear(springTension(s, d, v), tension, 1e-11),
                     told(springTension(s, d, v), tension));
            const Vec3 expected = tension * d.normalized();
            QVERIFY2(isNear(force[i], expected, 1e-11), told(force[i], expected));
        }
    }

    // There are enough panels to be shared out among threads, in parts that do not end with a pack.
    void threads()
    {
        const System cloth = panels(23, 3.0, 30001);
        const System net = springs(24, 30001);
        const std::vector<PaddedVec3> load = loads(cloth, wideMachine);
        const std::vector<PaddedVec3> force = forces(net, wideMachine);
        for (const int threads : {2, 3, 8}) {
            QVERIFY(sameBits(load, loads(cloth, wideMachine, threads)));
            QVERIFY(sameBits(force, forces(net, wideMachine, threads)));
        }
    }

    // Contact finds each particle that is inside, wherever it stands among the others.
    void contacts()
    {
        for (int count = 1; count <= 9; ++count)
            for (int inside = 0; inside < count; ++inside) {
                System system = emptySystem(0.01);
                for (int i = 0; i < count; ++i)
                    addParticle(system, {0.0, i == inside ? -1.0 : 1.0, double(i)}, 1.0);
                Obstacle ground{};
                ground.shape = ColliderShape::Plane;
                ground.position = Vec3::Zero();
                ground.normal = {0.0, 1.0, 0.0};
                ground.response = Response::Stop;
                system.obstacles = {ground};
                if (count % 2 == 0) { // the same as a wide box
                    system.obstacles[0].shape = ColliderShape::Box;
                    system.obstacles[0].size = Vec3(100.0, 4.0, 100.0);
                    system.obstacles[0].position = Vec3(0.0, -2.0, 0.0);
                }
                finish(system);
                State state = system.start;
                ThreadPool pool(1);
                std::vector<PlacedObstacle> placed(1);
                beginMoves(system, state, 0.0, placed);
                endMoves(system, state, 0.0, placed);
                std::vector<std::uint32_t> touches(std::size_t(count), 0);
                resolveContacts(system, state, system.start.position, placed, 0.01, pool, touches);
                for (int i = 0; i < count; ++i) {
                    QCOMPARE(state.position[std::size_t(i)].y(), i == inside ? 0.0 : 1.0);
                    QCOMPARE(touches[std::size_t(i)], i == inside ? touchOf(0) : 0u);
                }
            }
    }

    void rodsEitherWay()
    {
        for (std::uint32_t seed = 1; seed < 50; ++seed) {
            Batches wide(seed);
            Batches narrow(seed);
            const std::vector<PaddedVec3> before = wide.position;
            wide.sweep(wideMachine);
            narrow.sweep(false);
            QVERIFY(!sameBits(wide.position, before));
            QVERIFY(sameBits(wide.position, narrow.position));
            QVERIFY(sameBits(wide.batches.evenStretch, narrow.batches.evenStretch));
            QVERIFY(sameBits(wide.batches.plainStretch, narrow.batches.plainStretch));
            QVERIFY(sameBits(wide.batches.multiplier, narrow.batches.multiplier));
            QVERIFY(isPadded(wide.position));
            for (const PaddedVec3& x : wide.position)
                QVERIFY(x.allFinite());
        }
    }
};

const RegisteredTest registered("test_kernels", runPlain<TestKernels>);

} // namespace ripstop::test_kernels
#include "test_kernels.moc"
