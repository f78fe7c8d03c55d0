// Sweeps over rods in colours: project() for one substep, takeMultipliers() after the last.
//
// project() first brings the batches up to date, as little as is needed: batch() for another
// system, renew() for numbers that changed in place, soften() for another substep, update() for
// torn rods and shifted lengths. It then puts the classes of chunks and the colours in order,
// shuffled where there is a single sweep, and sweeps: on one thread along a wavefront, or with the
// scheduler where there is work enough for threads. Below stand, after the sweeps, how batches are
// filled, and the order.
//
// The batches hold the numbers of rods in the order in which sweeps read them.
#include "constraints/coloured_sweeps.h"

#include "base/split_mix.h"
#include "constraints/guides.h"
#include "constraints/rod_damping.h"
#include "constraints/rod_solver.h"
#include "parallel/simd_pack.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace ripstop {
namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

// Handing a substep to threads costs about as much as so many projections.
constexpr std::size_t worthThreads = 30000;

void shuffleInts(std::span<int> values, std::uint64_t seed)
{
    std::uint64_t random = splitMix(seed);
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

std::uint32_t bytesTo(int particle)
{
    return std::uint32_t(particle) * std::uint32_t(sizeof(PaddedVec3));
}

// Chunks that share a particle with each chunk.
Rows touchingChunks(const System& system)
{
    const std::size_t chunks = system.chunkStart.size() - 1;
    std::vector<std::vector<int>> at(system.inverseMass.size()); // chunks of each particle
    const auto forEachEnd = [&](std::size_t chunk, auto&& visit) {
        const int first = system.colorStart[std::size_t(system.chunkStart[chunk])];
        const int last = system.colorStart[std::size_t(system.chunkStart[chunk + 1])];
        for (int r = first; r < last; ++r)
            for (const int end : {system.rods[std::size_t(r)].a, system.rods[std::size_t(r)].b})
                visit(std::size_t(end));
    };
    for (std::size_t c = 0; c < chunks; ++c)
        forEachEnd(c, [&](std::size_t end) {
            if (at[end].empty() || at[end].back() != int(c))
                at[end].push_back(int(c));
        });
    Rows rows;
    rows.start.push_back(0);
    for (std::size_t c = 0; c < chunks; ++c) {
        std::vector<int> touching;
        forEachEnd(c, [&](std::size_t end) {
            touching.insert(touching.end(), at[end].begin(), at[end].end());
        });
        std::sort(touching.begin(), touching.end());
        touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
        std::erase(touching, int(c));
        rows.items.insert(rows.items.end(), touching.begin(), touching.end());
        rows.start.push_back(int(rows.items.size()));
    }
    return rows;
}

} // namespace

void ColouredSweeps::project(const RodTask& task, ThreadPool& pool)
{
    const System& system = task.system;
    if (system.serial != m_serial || !std::ranges::equal(task.direct, m_direct))
        batch(task);
    if (system.valuesSerial != m_valuesSerial)
        renew(task);
    if (task.h != m_h)
        soften(task);
    update(task);
    m_noting = task.note;
    std::fill(m_batches.multiplier.begin(), m_batches.multiplier.end(), Lanes{});
    for (GuidedRod& rod : m_batches.guided)
        rod.multiplier = 0.0;

    // Sweeps always in the same direction feed energy into braced frames: they flutter however many
    // substeps there are. Sweeps there and back do not, and settle without noise. A single sweep
    // per substep needs another order in each, the same in every run.
    putInOrder(system);
    if (task.sweeps == 1)
        shuffle(system, task.seed);

    PaddedVec3* const position = task.position.data();
    const std::size_t projections = system.rods.size() * std::size_t(task.sweeps);
    const bool shared =
        pool.threads() > 1 && system.chunkClass.size() > 1 && projections >= worthThreads;
    if (shared) {
        if (m_schedulerSerial != m_serial)
            prepareScheduler(system);
        m_scheduler.run(pool, task.sweeps, m_classRank,
                        [&](int sweep, int chunk) { sweepChunk(system, chunk, sweep, position); });
    } else {
        const auto chunks = int(system.chunkClass.size());
        m_wavefront.arrange(system.chunkClass, system.chunkReach, m_classRank, 0, chunks);
        for (int sweep = 0; sweep < task.sweeps; ++sweep)
            for (int i = 0; i < chunks; ++i) {
                const int at = sweep % 2 == 0 ? i : chunks - 1 - i;
                sweepChunk(system, m_wavefront.chunks()[std::size_t(at)], sweep, position);
            }
    }
    if (task.note)
        noteMultipliers();
    m_anew = m_anew && !task.note;
}

void ColouredSweeps::sweepChunk(const System& system, int chunk, int sweep, PaddedVec3* position)
{
    const auto first = std::size_t(system.chunkStart[std::size_t(chunk)]);
    const auto last = std::size_t(system.chunkStart[std::size_t(chunk) + 1]);
    const Note note = !m_noting ? Note::Nothing : m_anew && sweep == 0 ? Note::Anew : Note::More;
    sweepRuns(m_batches, std::span(m_colorOrder).subspan(first, last - first),
              {sweep % 2 != 0, note, wideMachine}, position);
}

void ColouredSweeps::noteMultipliers()
{
    for (std::size_t i = 0; i < m_softSum.size(); ++i)
        for (int lane = 0; lane < 4; ++lane)
            m_softSum[i].value[lane] += m_batches.multiplier[i].value[lane];
    for (GuidedRod& rod : m_batches.guided)
        rod.sum += rod.multiplier;
}

void ColouredSweeps::takeMultipliers(const System& system, double scale, ThreadPool& pool,
                                     std::span<double> multiplier)
{
    if (system.serial != m_serial)
        return; // not one substep was made with this system
    pool.parallelFor(m_place.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t r = first; r < last; ++r)
            if (m_place[r].ours)
                multiplier[r] = scale * taken(r);
    });
    std::fill(m_softSum.begin(), m_softSum.end(), Lanes{});
    for (GuidedRod& rod : m_batches.guided)
        rod.sum = 0.0;
    m_anew = true;
}

double ColouredSweeps::taken(std::size_t r) const
{
    const Place& place = m_place[r];
    const int lane = std::countr_zero(place.lanes);
    if (place.kind == Kind::Guided)
        return m_batches.guided[place.batch].sum;
    if (place.kind == Kind::Soft)
        return m_softSum[place.batch].value[lane];
    if (m_torn[r] || m_inverseWeight[r] == 0.0)
        return 0.0;
    if (place.kind == Kind::Plain)
        return m_batches.plainStretch[place.batch].value[lane] * m_inverseWeight[r];
    return m_batches.evenStretch[place.batch].value[lane] * 2.0 * m_inverseWeight[r];
}

// --- batches ------------------------------------------------------------------------------------

ColouredSweeps::Kind ColouredSweeps::kindOf(const System& system, const Rod& rod)
{
    if (guideOf(system, rod.a) || guideOf(system, rod.b))
        return Kind::Guided;
    if (rod.compliance != 0.0 || rod.resists != Resists::Both)
        return Kind::Soft;
    const double wa = system.inverseMass[std::size_t(rod.a)];
    const double wb = system.inverseMass[std::size_t(rod.b)];
    return wa == wb && wa > 0.0 ? Kind::Even : Kind::Plain;
}

void ColouredSweeps::batch(const RodTask& task)
{
    const System& system = task.system;
    m_serial = system.serial;
    m_direct.assign(task.direct.begin(), task.direct.end());
    m_valuesSerial = system.valuesSerial;
    m_h = task.h;
    m_batches = {};
    m_place.resize(system.rods.size());
    m_torn.assign(task.torn.begin(), task.torn.end());
    m_inverseWeight.resize(system.rods.size());
    for (std::size_t r = 0; r < system.rods.size(); ++r)
        weigh(system, r);
    const auto range = [](std::size_t first, std::size_t last) {
        return BatchRange{std::uint32_t(first), std::uint32_t(last)};
    };
    for (int color = 0; color + 1 < int(system.colorStart.size()); ++color) {
        const std::size_t even = m_batches.even.size();
        const std::size_t plain = m_batches.plain.size();
        const std::size_t soft = m_batches.soft.size();
        const std::size_t guided = m_batches.guided.size();
        batchColor(task, color);
        m_batches.runs.push_back(
            {range(even, m_batches.even.size()), range(plain, m_batches.plain.size()),
             range(soft, m_batches.soft.size()), range(guided, m_batches.guided.size())});
    }
    m_batches.evenStretch.assign(m_batches.even.size(), Lanes{});
    m_batches.plainStretch.assign(m_batches.plain.size(), Lanes{});
    m_batches.multiplier.assign(m_batches.soft.size(), Lanes{});
    m_softSum.assign(m_batches.soft.size(), Lanes{});
    for (std::size_t r = 0; r < system.rods.size(); ++r)
        fill(task, r);
}

// Even rods that would not fill a batch go with the plain ones.
void ColouredSweeps::batchColor(const RodTask& task, int color)
{
    const auto first = std::size_t(task.system.colorStart[std::size_t(color)]);
    const auto last = std::size_t(task.system.colorStart[std::size_t(color) + 1]);
    std::size_t even = 0;
    for (std::size_t r = first; r < last; ++r) {
        const bool elsewhere = !m_direct.empty() && m_direct[r];
        m_place[r] = Place{};
        m_place[r].ours = !elsewhere;
        m_place[r].nature = m_place[r].kind = kindOf(task.system, task.system.rods[r]);
        even += m_place[r].ours && m_place[r].kind == Kind::Even;
    }
    std::size_t left = even % 4;
    for (std::size_t r = last; left > 0 && r-- > first;)
        if (m_place[r].ours && m_place[r].kind == Kind::Even) {
            m_place[r].kind = Kind::Plain;
            --left;
        }
    for (const Kind kind : {Kind::Even, Kind::Plain, Kind::Soft})
        batchKind(task, kind, color);
    batchGuided(task, color);
}

void ColouredSweeps::batchGuided(const RodTask& task, int color)
{
    for (int r = task.system.colorStart[std::size_t(color)];
         r < task.system.colorStart[std::size_t(color) + 1]; ++r) {
        Place& place = m_place[std::size_t(r)];
        if (!place.ours || place.kind != Kind::Guided)
            continue;
        place.batch = std::uint32_t(m_batches.guided.size());
        m_batches.guided.emplace_back();
    }
}

// The rods of one kind in a colour, four by four; the last batch repeats its last rod.
void ColouredSweeps::batchKind(const RodTask& task, Kind kind, int color)
{
    const auto batchFour = [&](std::span<const int> four) {
        switch (kind) {
        case Kind::Even:
            return addBatch(task, m_batches.even, four);
        case Kind::Plain:
            return addBatch(task, m_batches.plain, four);
        case Kind::Soft:
            return addBatch(task, m_batches.soft, four);
        case Kind::Guided:
            break;
        }
    };
    std::array<int, 4> four;
    std::size_t count = 0;
    for (int r = task.system.colorStart[std::size_t(color)];
         r < task.system.colorStart[std::size_t(color) + 1]; ++r) {
        const Place& place = m_place[std::size_t(r)];
        if (!place.ours || place.kind != kind)
            continue;
        four[count++] = r;
        if (count == four.size()) {
            batchFour(four);
            count = 0;
        }
    }
    if (count > 0)
        batchFour(std::span(four).first(count));
}

template <typename Batch>
void ColouredSweeps::addBatch(const RodTask& task, std::vector<Batch>& batches,
                              std::span<const int> four)
{
    Batch& batch = batches.emplace_back();
    for (std::size_t lane = 0; lane < 4; ++lane) {
        const auto r = std::size_t(four[std::min(lane, four.size() - 1)]);
        const Rod& rod = task.system.rods[r];
        batch.a[lane] = bytesTo(rod.a);
        batch.b[lane] = bytesTo(rod.b);
        m_place[r].batch = std::uint32_t(batches.size() - 1);
        m_place[r].lanes |= std::uint8_t(1u << lane);
    }
}

// Puts the numbers of a rod into its lanes.
void ColouredSweeps::fill(const RodTask& task, std::size_t r)
{
    const Rod& rod = task.system.rods[r];
    const double wa = task.system.inverseMass[std::size_t(rod.a)];
    const double wb = task.system.inverseMass[std::size_t(rod.b)];
    const double rest = task.restLength[r];
    const Place& place = m_place[r];
    if (place.ours && place.kind == Kind::Guided)
        fillGuided(task, r);
    for (std::size_t lane = 0; lane < 4; ++lane) {
        if ((place.lanes & (1u << lane)) == 0)
            continue;
        switch (place.kind) {
        case Kind::Even:
            m_batches.even[place.batch].halfRest[lane] = m_torn[r] ? notANumber : 0.5 * rest;
            break;
        case Kind::Plain: {
            PlainBatch& batch = m_batches.plain[place.batch];
            batch.rest[lane] = m_torn[r] ? notANumber : rest;
            batch.shareA[lane] = wa * m_inverseWeight[r];
            batch.shareB[lane] = wb * m_inverseWeight[r];
            break;
        }
        case Kind::Soft: {
            SoftBatch& batch = m_batches.soft[place.batch];
            batch.rest[lane] = rest;
            batch.inverseMassA[lane] = wa;
            batch.inverseMassB[lane] = wb;
            batch.softness[lane] = complianceOver(rod, m_h) / (m_h * m_h);
            const double weight = wa + wb + batch.softness[lane];
            batch.inverseWeight[lane] = m_torn[r] || weight == 0.0 ? 0.0 : 1.0 / weight;
            batch.lowest[lane] = lowestOf(rod.resists);
            batch.highest[lane] = highestOf(rod.resists);
            break;
        }
        case Kind::Guided:
            break; // in no lane
        }
    }
}

void ColouredSweeps::fillGuided(const RodTask& task, std::size_t r)
{
    const System& system = task.system;
    const Rod& rod = system.rods[r];
    GuidedRod& held = m_batches.guided[m_place[r].batch];
    const auto guideAt = [&](int particle) {
        const GuidedParticle* guide = guideOf(system, particle);
        return guide ? *guide : GuidedParticle{};
    };
    held.a = rod.a;
    held.b = rod.b;
    held.inverseMassA = system.inverseMass[std::size_t(rod.a)];
    held.inverseMassB = system.inverseMass[std::size_t(rod.b)];
    held.guideA = guideAt(rod.a);
    held.guideB = guideAt(rod.b);
    held.rest = task.restLength[r];
    held.softness = complianceOver(rod, m_h) / (m_h * m_h);
    held.lowest = lowestOf(rod.resists);
    held.highest = highestOf(rod.resists);
    held.torn = m_torn[r] != 0;
}

// Takes over numbers that changed in place. The order stays. A rod that has become of another kind
// belongs into another batch, and then all batches are filled anew.
void ColouredSweeps::renew(const RodTask& task)
{
    const System& system = task.system;
    const bool known = system.touched.since <= m_valuesSerial;
    m_valuesSerial = system.valuesSerial;
    bool sameKind = known;
    const auto look = [&](int rod) {
        const auto r = std::size_t(rod);
        sameKind = sameKind && kindOf(system, system.rods[r]) == m_place[r].nature;
        weigh(system, r);
        fill(task, r);
    };
    if (known) {
        for (const int rod : system.touched.rods)
            look(rod);
        for (const int particle : system.touched.particles)
            for (int k = system.rodsAt.start[std::size_t(particle)];
                 k < system.rodsAt.start[std::size_t(particle) + 1]; ++k)
                look(system.rodsAt.items[std::size_t(k)]);
    }
    if (!sameKind)
        batch(task);
}

void ColouredSweeps::weigh(const System& system, std::size_t r)
{
    const Rod& rod = system.rods[r];
    const double weight =
        system.inverseMass[std::size_t(rod.a)] + system.inverseMass[std::size_t(rod.b)];
    m_inverseWeight[r] = weight > 0.0 ? 1.0 / weight : 0.0;
}

void ColouredSweeps::soften(const RodTask& task)
{
    m_h = task.h;
    const bool some = !m_batches.soft.empty() || !m_batches.guided.empty();
    for (std::size_t r = 0; some && r < m_place.size(); ++r)
        if (m_place[r].kind == Kind::Soft || m_place[r].kind == Kind::Guided)
            fill(task, r);
}

// What may change from substep to substep: shifted and damped rest lengths, and torn rods.
void ColouredSweeps::update(const RodTask& task)
{
    if (!m_torn.empty() && std::memcmp(m_torn.data(), task.torn.data(), m_torn.size()) != 0)
        for (std::size_t r = 0; r < m_torn.size(); ++r)
            if (m_torn[r] != task.torn[r]) {
                m_torn[r] = task.torn[r];
                fill(task, r);
            }
    for (const ShiftedRod& shifted : task.system.shiftedRods)
        if (task.shifted)
            fill(task, std::size_t(shifted.rod));
    for (const int damped : task.damped)
        if (m_place[std::size_t(damped)].ours)
            fill(task, std::size_t(damped));
}

void ColouredSweeps::prepareScheduler(const System& system)
{
    m_scheduler.prepare(touchingChunks(system), system.chunkClass, system.chunkReach);
    m_schedulerSerial = system.serial;
}

// --- order --------------------------------------------------------------------------------------

void ColouredSweeps::putInOrder(const System& system)
{
    const auto last = std::max_element(system.chunkClass.begin(), system.chunkClass.end());
    m_classRank.resize(last == system.chunkClass.end() ? 0 : std::size_t(*last) + 1);
    std::iota(m_classRank.begin(), m_classRank.end(), 0);
    m_colorOrder.resize(m_batches.runs.size());
    std::iota(m_colorOrder.begin(), m_colorOrder.end(), 0);
}

void ColouredSweeps::shuffle(const System& system, std::uint64_t seed)
{
    shuffleInts(m_classRank, seed);
    for (std::size_t c = 0; c + 1 < system.chunkStart.size(); ++c) {
        const auto first = std::size_t(system.chunkStart[c]);
        const auto last = std::size_t(system.chunkStart[c + 1]);
        shuffleInts(std::span(m_colorOrder).subspan(first, last - first), seed + c + 1);
    }
}

} // namespace ripstop
