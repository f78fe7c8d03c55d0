// Sums of forces at particles; see lane.h.
//
// Lane after lane goes over a block of particles whose sums stay in the fastest cache, so that each
// loop has one kind of lane and nothing to ask.

struct ParticleBlock // particles first .. last - 1
{
    std::size_t first;
    std::size_t last;
};

RIPSTOP_INLINE void gatherEnds(const Lane& lane, const ParticleBlock& stretch, PaddedVec3* sum)
{
    const int* const start = lane.at->start.data();
    const int* const items = lane.at->items.data();
    constexpr double signs[2] = {1.0, -1.0};
    for (std::size_t i = stretch.first; i < stretch.last; ++i) {
        Pack force = pack(sum[i]);
        for (int k = start[i]; k < start[i + 1]; ++k) {
            const double sign = signs[lane.minus[k]]; // processors would mispredict a branch
            force += all(sign) * pack(lane.load[items[k]]);
        }
        pack(sum[i]) = force;
    }
}

RIPSTOP_INLINE void gatherWeighted(const Lane& lane, const ParticleBlock& stretch, PaddedVec3* sum)
{
    const int* const start = lane.at->start.data();
    const int* const items = lane.at->items.data();
    for (std::size_t i = stretch.first; i < stretch.last; ++i) {
        Pack force = pack(sum[i]);
        for (int k = start[i]; k < start[i + 1]; ++k)
            force += all(lane.weight[k]) * pack(lane.load[items[k]]);
        pack(sum[i]) = force;
    }
}

RIPSTOP_INLINE void gatherParts(const Lane& lane, const ParticleBlock& stretch, PaddedVec3* sum)
{
    const int* const start = lane.at->start.data();
    const int* const items = lane.at->items.data();
    const Pack part = all(1.0 / lane.parts);
    for (std::size_t i = stretch.first; i < stretch.last; ++i) {
        Pack load{};
        for (int k = start[i]; k < start[i + 1]; ++k)
            load += pack(lane.load[items[k]]);
        pack(sum[i]) += load * part;
    }
}

void gather(std::span<const Lane> lanes, const Vec3& common, const double* inverseMass,
            PaddedVec3* acceleration, std::size_t first, std::size_t last)
{
    constexpr std::size_t block = 256; // particles, 8 KB of sums
    const Pack everywhere = {common[0], common[1], common[2], 0.0};
    for (ParticleBlock s{first, std::min(first + block, last)}; s.first < last;
         s = {s.last, std::min(s.last + block, last)}) {
        for (std::size_t i = s.first; i < s.last; ++i)
            pack(acceleration[i]) = Pack{};
        for (const Lane& lane : lanes)
            if (lane.minus)
                gatherEnds(lane, s, acceleration);
            else if (lane.weight)
                gatherWeighted(lane, s, acceleration);
            else
                gatherParts(lane, s, acceleration);
        for (std::size_t i = s.first; i < s.last; ++i)
            pack(acceleration[i]) =
                inverseMass[i] == 0.0
                    ? Pack{}
                    : Pack(everywhere + all(inverseMass[i]) * pack(acceleration[i]));
    }
}
