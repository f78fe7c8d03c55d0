// Rods in batches of four that share no particle, and the loop that projects them.
//
// Projection is XPBD without damping (Macklin, Mueller and Chentanez 2016, equations 17 and 18).
// There are three kinds of batch, because most rods need little: even ones join particles of equal
// mass, plain ones never stretch and resist both ways, soft ones are all the rest. Batches that
// are not full repeat a rod: the same numbers are then written twice. The few rods that end on a
// guide are projected one by one (guided_rod.h).
#pragma once

#include "base/vec3.h"
#include "constraints/guided_rod.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

struct alignas(32) EvenBatch
{
    double halfRest[4]; // m; not a number when the rod is torn
    std::uint32_t a[4]; // bytes from the first particle
    std::uint32_t b[4];
};

struct alignas(32) PlainBatch
{
    double rest[4];   // m; not a number when the rod is torn
    double shareA[4]; // of the inverse masses of both ends
    double shareB[4];
    std::uint32_t a[4];
    std::uint32_t b[4];
};

struct alignas(32) SoftBatch
{
    double rest[4];          // m
    double inverseMassA[4];  // 1/kg, 0 when pinned
    double inverseMassB[4];  // 1/kg
    double inverseWeight[4]; // kg; 0 when the rod is torn or pinned at both ends
    double softness[4];      // 1/kg, compliance / h^2
    double lowest[4];        // kg m, range of the multiplier
    double highest[4];
    std::uint32_t a[4];
    std::uint32_t b[4];
};

struct alignas(32) Lanes
{
    double value[4];
};

struct BatchRange
{
    std::uint32_t first;
    std::uint32_t last;
};

struct BatchRun // rods of one colour
{
    BatchRange even;
    BatchRange plain;
    BatchRange soft;
    BatchRange guided;
};

struct RodBatches
{
    std::vector<EvenBatch> even;
    std::vector<PlainBatch> plain;
    std::vector<SoftBatch> soft;
    std::vector<Lanes> evenStretch;  // [even] m, sum over the sweeps of half the stretch found
    std::vector<Lanes> plainStretch; // [plain] m, sum over the sweeps of the stretch found
    std::vector<Lanes> multiplier;   // [soft] kg m, of this substep
    std::vector<GuidedRod> guided;
    std::vector<BatchRun> runs; // [colours]
};

// What becomes of evenStretch and plainStretch in a sweep.
enum class Note { Nothing, Anew, More };

struct SweepHow
{
    bool backwards = false;
    Note note = Note::More;
    bool wide = false; // only on a wide machine (simd_pack.h); the bits are the same
};

// Projects the runs that `order` names, in that order or in the opposite one.
//   order     indices of batches.runs
//   position  [particles]  m, corrected in place
void sweepRuns(RodBatches& batches, std::span<const int> order, const SweepHow& how,
               PaddedVec3* position);

} // namespace ripstop
