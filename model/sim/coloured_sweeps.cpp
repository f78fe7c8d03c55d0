#include "sim/coloured_sweeps.h"

#include "sim/rod_solver.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

// One source for every machine: the compiler lowers these vectors to whatever there is, and GCC
// picks the widest when the program starts. No operation is fused, so that all of them round alike.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)                                \
    && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RIPSTOP_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define RIPSTOP_CLONES
#endif

namespace ripstop {
namespace {

using Four = double __attribute__((vector_size(32)));

#define RIPSTOP_INLINE inline __attribute__((always_inline))

// SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

void shuffleInts(std::span<int> values, std::uint64_t seed)
{
    std::uint64_t random = mixed(seed);
    for (std::size_t i = values.size(); i > 1; --i) {
        random = random * 6364136223846793005u + 1442695040888963407u; // Knuth's MMIX
        std::swap(values[i - 1], values[((random >> 32) * i) >> 32]);
    }
}

double lowestOf(Resists resists)
{
    return resists == Resists::Tension ? 0.0 : -std::numeric_limits<double>::infinity();
}

double highestOf(Resists resists)
{
    return resists == Resists::Compression ? 0.0 : std::numeric_limits<double>::infinity();
}

bool isPlain(const Rod& rod) { return rod.compliance == 0.0 && rod.resists == Resists::Both; }

} // namespace

void ColouredSweeps::project(const RodTask& task, Crew& crew)
{
    if (task.system.serial != m_serial || task.system.valuesSerial != m_valuesSerial
        || task.h != m_h)
        cook(task);
    update(task);

    const std::size_t particles = task.position.size();
    crew.each(particles, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Vec3& x = task.position[i];
            m_rows[i] = {{x.x(), x.y(), x.z(), 0.0}};
        }
    });
    std::fill(m_multipliers.begin(), m_multipliers.end(), Multipliers{});

    // Sweeps always in the same direction feed energy into braced frames: they flutter however many
    // substeps there are. Sweeps there and back do not, and settle without noise. A single sweep
    // per substep needs another order in each, the same in every run.
    putInOrder(task.system);
    if (task.system.sweeps == 1)
        shuffle(task.system, task.seed);
    for (int i = 0; i < task.system.sweeps; ++i)
        sweep(task.system, i % 2 == 0 ? Direction::There : Direction::Back, crew);

    crew.each(particles, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            task.position[i] = Vec3(m_rows[i].x[0], m_rows[i].x[1], m_rows[i].x[2]);
    });
    crew.each(m_lane.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            task.multiplier[i] = m_multipliers[m_lane[i] / 4].value[m_lane[i] % 4];
    });
}

void ColouredSweeps::cook(const RodTask& task)
{
    const System& system = task.system;
    m_serial = system.serial;
    m_valuesSerial = system.valuesSerial;
    m_h = task.h;
    m_batches.clear();
    m_runs.clear();
    m_lane.assign(system.rods.size(), 0);
    m_torn.assign(system.rods.size(), 0);
    m_softness.clear();

    // Idle lanes need rows that no other thread touches: eight for each chunk.
    const std::size_t chunks = system.chunkStart.size() - 1;
    const std::size_t particles = system.inverseMass.size();
    m_rows.assign(particles + 8 * chunks, Row{});
    for (std::size_t c = 0; c < chunks; ++c)
        for (int color = system.chunkStart[c]; color < system.chunkStart[c + 1]; ++color)
            cookRun(task, color, std::uint32_t(particles + 8 * c));
    m_multipliers.resize(m_batches.size());

    m_softness.assign(
        std::all_of(system.rods.begin(), system.rods.end(), isPlain) ? 0 : m_batches.size(),
        Softness{});
    for (std::size_t r = 0; r < system.rods.size() && !m_softness.empty(); ++r) {
        Softness& soft = m_softness[m_lane[r] / 4];
        soft.softness[m_lane[r] % 4] = system.rods[r].compliance / (m_h * m_h);
        soft.lowest[m_lane[r] % 4] = lowestOf(system.rods[r].resists);
        soft.highest[m_lane[r] % 4] = highestOf(system.rods[r].resists);
    }
    for (std::size_t r = 0; r < system.rods.size(); ++r)
        weigh(system, r, false);
}

void ColouredSweeps::cookRun(const RodTask& task, int color, std::uint32_t idleRow)
{
    const System& system = task.system;
    Run run{std::uint32_t(m_batches.size()), 0, 0};
    for (const bool plain : {true, false}) {
        int lane = 4;
        for (int r = system.colorStart[std::size_t(color)];
             r < system.colorStart[std::size_t(color) + 1]; ++r) {
            const Rod& rod = system.rods[std::size_t(r)];
            if (isPlain(rod) != plain)
                continue;
            if (lane == 4) {
                Batch batch{};
                for (std::uint32_t idle = 0; idle < 4; ++idle) {
                    batch.a[idle] = (idleRow + idle) * std::uint32_t(sizeof(Row));
                    batch.b[idle] = (idleRow + 4 + idle) * std::uint32_t(sizeof(Row));
                }
                m_batches.push_back(batch);
                lane = 0;
            }
            Batch& batch = m_batches.back();
            batch.a[lane] = std::uint32_t(rod.a) * std::uint32_t(sizeof(Row));
            batch.b[lane] = std::uint32_t(rod.b) * std::uint32_t(sizeof(Row));
            batch.rest[lane] = task.restLength[std::size_t(r)];
            batch.pullA[lane] = system.inverseMass[std::size_t(rod.a)];
            batch.pullB[lane] = system.inverseMass[std::size_t(rod.b)];
            m_lane[std::size_t(r)] = 4 * std::uint32_t(m_batches.size() - 1) + std::uint32_t(lane);
            ++lane;
        }
        (plain ? run.soft : run.last) = std::uint32_t(m_batches.size());
    }
    m_runs.push_back(run);
}

void ColouredSweeps::weigh(const System& system, std::size_t rod, bool torn)
{
    Batch& batch = m_batches[m_lane[rod] / 4];
    const std::size_t lane = m_lane[rod] % 4;
    const double weight =
        batch.pullA[lane] + batch.pullB[lane] + system.rods[rod].compliance / (m_h * m_h);
    const bool elsewhere = !system.direct.empty() && system.direct[rod];
    // Two rigid pins cannot move.
    batch.inverseWeight[lane] = torn || elsewhere || weight == 0.0 ? 0.0 : 1.0 / weight;
    m_torn[rod] = torn;
}

// What may change from substep to substep: shifted rest lengths and torn rods.
void ColouredSweeps::update(const RodTask& task)
{
    for (const ShiftedRod& shifted : task.system.shiftedRods) {
        const auto rod = std::size_t(shifted.rod);
        m_batches[m_lane[rod] / 4].rest[m_lane[rod] % 4] = task.restLength[rod];
    }
    if (std::memcmp(m_torn.data(), task.torn.data(), m_torn.size()) != 0)
        for (std::size_t r = 0; r < m_torn.size(); ++r)
            if (m_torn[r] != task.torn[r])
                weigh(task.system, r, task.torn[r] != 0);
}

void ColouredSweeps::putInOrder(const System& system)
{
    m_classOrder.resize(system.classStart.size() - 1);
    std::iota(m_classOrder.begin(), m_classOrder.end(), 0);
    m_colorOrder.resize(m_runs.size());
    std::iota(m_colorOrder.begin(), m_colorOrder.end(), 0);
}

void ColouredSweeps::shuffle(const System& system, std::uint64_t seed)
{
    shuffleInts(m_classOrder, seed);
    for (std::size_t c = 0; c + 1 < system.chunkStart.size(); ++c) {
        const auto first = std::size_t(system.chunkStart[c]);
        const auto last = std::size_t(system.chunkStart[c + 1]);
        shuffleInts(std::span(m_colorOrder).subspan(first, last - first), seed + c + 1);
    }
}

void ColouredSweeps::sweep(const System& system, Direction direction, Crew& crew)
{
    const bool back = direction == Direction::Back;
    const std::size_t classes = m_classOrder.size();
    for (std::size_t k = 0; k < classes; ++k) {
        const auto c = std::size_t(m_classOrder[back ? classes - 1 - k : k]);
        const auto begin = std::size_t(system.classStart[c]);
        const auto end = std::size_t(system.classStart[c + 1]);
        crew.tasks(end - begin, [&](std::size_t task) {
            const auto first = std::size_t(system.chunkStart[begin + task]);
            const auto last = std::size_t(system.chunkStart[begin + task + 1]);
            for (std::size_t i = first; i < last; ++i)
                sweep(m_runs[std::size_t(m_colorOrder[back ? first + last - 1 - i : i])]);
        });
    }
}

void ColouredSweeps::sweep(const Run& run)
{
    if (run.soft > run.first)
        sweepPlain(&m_batches[run.first], run.soft - run.first, m_rows.data(),
                   &m_multipliers[run.first]);
    if (run.last > run.soft)
        sweepSoft(&m_batches[run.soft], &m_softness[run.soft], run.last - run.soft, m_rows.data(),
                  &m_multipliers[run.soft]);
}

namespace {

RIPSTOP_INLINE Four& four(double* p) { return *reinterpret_cast<Four*>(p); }
RIPSTOP_INLINE const Four& four(const double* p) { return *reinterpret_cast<const Four*>(p); }

// XPBD, Macklin, Mueller and Chentanez 2016, equations 17 and 18, without damping. Plain rods,
// which resist both ways and never stretch, are the same with softness 0 and no bounds.
template <bool plain>
RIPSTOP_INLINE void projectFour(const double* rest, const double* pullA, const double* pullB,
                                const double* inverseWeight, const double* softness,
                                const double* lowest, const double* highest, double* const a[4],
                                double* const b[4], double* multiplier)
{
    const Four a0 = four(a[0]), a1 = four(a[1]), a2 = four(a[2]), a3 = four(a[3]);
    const Four b0 = four(b[0]), b1 = four(b[1]), b2 = four(b[2]), b3 = four(b[3]);
    const Four d0 = b0 - a0, d1 = b1 - a1, d2 = b2 - a2, d3 = b3 - a3;

    // from four separations to four x, four y and four z
    const Four xz01 = __builtin_shufflevector(d0, d1, 0, 4, 2, 6);
    const Four xz23 = __builtin_shufflevector(d2, d3, 0, 4, 2, 6);
    const Four yw01 = __builtin_shufflevector(d0, d1, 1, 5, 3, 7);
    const Four yw23 = __builtin_shufflevector(d2, d3, 1, 5, 3, 7);
    const Four x = __builtin_shufflevector(xz01, xz23, 0, 1, 4, 5);
    const Four y = __builtin_shufflevector(yw01, yw23, 0, 1, 4, 5);
    const Four z = __builtin_shufflevector(xz01, xz23, 2, 3, 6, 7);

    const Four square = x * x + y * y + z * z;
    Four length;
    for (int i = 0; i < 4; ++i)
        length[i] = __builtin_sqrt(square[i]);

    const Four stretch = length - four(rest);
    const Four old = four(multiplier);
    Four change;
    if constexpr (plain) {
        change = stretch * four(inverseWeight);
    } else {
        // Clamp the running total, not the change: a line may give back pull it took.
        Four total = old + (stretch - four(softness) * old) * four(inverseWeight);
        total = total < four(lowest) ? four(lowest) : total;
        total = total > four(highest) ? four(highest) : total;
        change = total - old;
    }
    // Coincident ends have no direction to move along.
    change = square > 0.0 ? change : Four{};
    const Four perLength = square > 0.0 ? change / length : Four{};
    four(multiplier) = old + change;

    const Four pa = perLength * four(pullA);
    const Four pb = perLength * four(pullB);
    four(a[0]) = a0 + d0 * __builtin_shufflevector(pa, pa, 0, 0, 0, 0);
    four(a[1]) = a1 + d1 * __builtin_shufflevector(pa, pa, 1, 1, 1, 1);
    four(a[2]) = a2 + d2 * __builtin_shufflevector(pa, pa, 2, 2, 2, 2);
    four(a[3]) = a3 + d3 * __builtin_shufflevector(pa, pa, 3, 3, 3, 3);
    four(b[0]) = b0 - d0 * __builtin_shufflevector(pb, pb, 0, 0, 0, 0);
    four(b[1]) = b1 - d1 * __builtin_shufflevector(pb, pb, 1, 1, 1, 1);
    four(b[2]) = b2 - d2 * __builtin_shufflevector(pb, pb, 2, 2, 2, 2);
    four(b[3]) = b3 - d3 * __builtin_shufflevector(pb, pb, 3, 3, 3, 3);
}

RIPSTOP_INLINE double* at(void* rows, std::uint32_t bytes)
{
    return reinterpret_cast<double*>(static_cast<char*>(rows) + bytes);
}

} // namespace

RIPSTOP_CLONES
void ColouredSweeps::sweepPlain(const Batch* batch, std::size_t count, Row* row,
                                Multipliers* multiplier)
{
    for (std::size_t i = 0; i < count; ++i) {
        const Batch& four = batch[i];
        double* const a[4] = {at(row, four.a[0]), at(row, four.a[1]), at(row, four.a[2]),
                              at(row, four.a[3])};
        double* const b[4] = {at(row, four.b[0]), at(row, four.b[1]), at(row, four.b[2]),
                              at(row, four.b[3])};
        projectFour<true>(four.rest, four.pullA, four.pullB, four.inverseWeight, nullptr, nullptr,
                          nullptr, a, b, multiplier[i].value);
    }
}

RIPSTOP_CLONES
void ColouredSweeps::sweepSoft(const Batch* batch, const Softness* soft, std::size_t count,
                               Row* row, Multipliers* multiplier)
{
    for (std::size_t i = 0; i < count; ++i) {
        const Batch& four = batch[i];
        double* const a[4] = {at(row, four.a[0]), at(row, four.a[1]), at(row, four.a[2]),
                              at(row, four.a[3])};
        double* const b[4] = {at(row, four.b[0]), at(row, four.b[1]), at(row, four.b[2]),
                              at(row, four.b[3])};
        projectFour<false>(four.rest, four.pullA, four.pullB, four.inverseWeight, soft[i].softness,
                           soft[i].lowest, soft[i].highest, a, b, multiplier[i].value);
    }
}

} // namespace ripstop
