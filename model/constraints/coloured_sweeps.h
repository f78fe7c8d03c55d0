// Gauss-Seidel in colours, four rods at a time: the sweeps of Solver::GaussSeidel and SmallSteps.
//
// The rods of a system are put once into batches of four that share no particle (rod_batches.h), in
// the order of the system (rod_order.h); numbers that change in place are put into their lanes
// again. The arithmetic is the same, to the bit, with and without vector instructions, and for any
// number of threads.
//
// RodSolver has one and calls it from the thread that steps; project() spreads its work over the
// pool. It takes memory when it meets a new system, or a rod that has become of another kind, and
// none in other substeps.
#pragma once

#include "constraints/rod_batches.h"
#include "parallel/chunk_scheduler.h"
#include "parallel/wavefront.h"
#include "system/system.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

struct RodTask;

class ColouredSweeps
{
public:
    // Makes all sweeps of one substep: moves task.position [particles], m.
    void project(const RodTask& task, ThreadPool& pool);

    // Fills in the sum of the multipliers that each of its rods took since the last call, kg m,
    // times `scale`; entries of rods that another solver has stay as they are.
    //   multiplier  [rods]
    void takeMultipliers(const System& system, double scale, ThreadPool& pool,
                         std::span<double> multiplier);

private:
    enum class Kind : std::uint8_t { Even, Plain, Soft, Guided };

    struct Place // of a rod among the batches
    {
        bool ours = true;         // false when another solver has it
        Kind nature = Kind::Even; // the simplest kind that would do
        Kind kind = Kind::Even;   // the kind of its batch
        std::uint8_t lanes = 0;   // the lanes that it has, one bit each
        std::uint32_t batch = 0;
    };

    void batch(const RodTask& task);
    void batchColor(const RodTask& task, int color);
    void batchGuided(const RodTask& task, int color);
    void batchKind(const RodTask& task, Kind kind, int color);
    template <typename Batch>
    void addBatch(const RodTask& task, std::vector<Batch>& batches, std::span<const int> four);
    void fill(const RodTask& task, std::size_t rod);
    void fillGuided(const RodTask& task, std::size_t rod);
    void soften(const RodTask& task);
    void renew(const RodTask& task);
    void weigh(const System& system, std::size_t rod);
    void prepareScheduler(const System& system);
    void update(const RodTask& task);
    void putInOrder(const System& system);
    void shuffle(const System& system, std::uint64_t seed);
    void sweepChunk(const System& system, int chunk, int sweep, PaddedVec3* position);
    double taken(std::size_t rod) const;
    void noteMultipliers();

    static Kind kindOf(const System& system, const Rod& rod);

    std::uint64_t m_serial = 0; // of the system that is batched
    std::uint64_t m_valuesSerial = 0;
    std::vector<std::uint8_t> m_direct; // [rods] 1 where another solver has it, or empty
    bool m_noting = true;               // multipliers of this substep are summed
    bool m_anew = true;                 // nothing is noted yet
    double m_h = 0.0;                   // s, for which soft rods are batched
    RodBatches m_batches;
    std::vector<Lanes> m_softSum;        // [soft] kg m, since takeMultipliers()
    std::vector<Place> m_place;          // [rods]
    std::vector<double> m_inverseWeight; // [rods] kg; 0 when pinned at both ends
    std::vector<std::uint8_t> m_torn;    // [rods] as batched
    std::vector<int> m_colorOrder;       // [colours] within each chunk
    std::vector<int> m_classRank;        // [classes] the turn of each class
    Wavefront m_wavefront;
    ChunkScheduler m_scheduler;
    std::uint64_t m_schedulerSerial = 0; // of the system that the scheduler is prepared for
};

} // namespace ripstop
