#pragma once

#include "sim/crew.h"
#include "sim/system.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

struct RodTask;

// Gauss-Seidel in colours, four rods at a time.
//
// The rods of a system are cooked once into batches of four that share no particle; positions are
// copied into rows of four doubles for the sweeps and back. The arithmetic is the same, to the bit,
// with and without vector instructions, and for any number of threads.
class ColouredSweeps
{
public:
    // All sweeps of one substep.
    void project(const RodTask& task, Crew& crew);

private:
    struct alignas(32) Row // a particle
    {
        double x[4]; // m; the fourth is zero
    };
    struct alignas(32) Batch // four rods
    {
        double rest[4];          // m
        double pullA[4];         // 1/kg, inverse mass of each end; 0 when pinned
        double pullB[4];         // 1/kg
        double inverseWeight[4]; // kg; 0 when the lane is idle, torn or pinned at both ends
        std::uint32_t a[4];      // bytes from the first row
        std::uint32_t b[4];
    };
    struct alignas(32) Softness // what a batch has besides when not all its rods are plain
    {
        double softness[4]; // 1/kg, compliance / h^2
        double lowest[4];   // kg m, range of the multiplier
        double highest[4];
    };
    struct alignas(32) Multipliers
    {
        double value[4]; // kg m
    };
    struct Run // the batches of one colour: plain ones first
    {
        std::uint32_t first;
        std::uint32_t soft;
        std::uint32_t last;
    };

    void cook(const RodTask& task);
    void cookRun(const RodTask& task, int color, std::uint32_t idleRow);
    void update(const RodTask& task);
    void weigh(const System& system, std::size_t rod, bool torn);
    enum class Direction { There, Back };

    void putInOrder(const System& system);
    void shuffle(const System& system, std::uint64_t seed);
    void sweep(const System& system, Direction direction, Crew& crew);
    void sweep(const Run& run);

    static void sweepPlain(const Batch* batch, std::size_t count, Row* row,
                           Multipliers* multiplier);
    static void sweepSoft(const Batch* batch, const Softness* soft, std::size_t count, Row* row,
                          Multipliers* multiplier);

    std::uint64_t m_serial = 0; // of the system that is cooked
    std::uint64_t m_valuesSerial = 0;
    double m_h = 0.0;           // s, for which it is cooked
    std::vector<Batch> m_batches;
    std::vector<Softness> m_softness; // [batches], or empty when every rod is plain
    std::vector<Multipliers> m_multipliers;
    std::vector<Run> m_runs;           // [colours]
    std::vector<std::uint32_t> m_lane; // [rods] 4 x batch + lane
    std::vector<std::uint8_t> m_torn;  // [rods] as cooked
    std::vector<Row> m_rows;           // [particles + idle rows]
    std::vector<int> m_colorOrder;     // [colours] within each chunk
    std::vector<int> m_classOrder;     // [classes]
};

} // namespace ripstop
