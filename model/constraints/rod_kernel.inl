// Projection of rods, four at a time; see rod_batches.h.
//
// First the gather and scatter of the ends of four rods, then one project() for each kind of batch,
// then the loops over batches, runs and colours.

RIPSTOP_INLINE Pack& row(PaddedVec3* position, std::uint32_t bytes)
{
    return *reinterpret_cast<Pack*>(reinterpret_cast<char*>(position) + bytes);
}

struct Ends
{
    Pack a0, a1, a2, a3;
    Pack b0, b1, b2, b3;
    Pack d0, d1, d2, d3; // from a to b
};

template <typename Batch>
RIPSTOP_INLINE Ends endsOf(const Batch& batch, PaddedVec3* position)
{
    Ends e;
    e.a0 = row(position, batch.a[0]), e.b0 = row(position, batch.b[0]), e.d0 = e.b0 - e.a0;
    e.a1 = row(position, batch.a[1]), e.b1 = row(position, batch.b[1]), e.d1 = e.b1 - e.a1;
    e.a2 = row(position, batch.a[2]), e.b2 = row(position, batch.b[2]), e.d2 = e.b2 - e.a2;
    e.a3 = row(position, batch.a[3]), e.b3 = row(position, batch.b[3]), e.d3 = e.b3 - e.a3;
    return e;
}

RIPSTOP_INLINE Pack squaredLength(const Ends& e)
{
    const Coordinates d = coordinates(e.d0, e.d1, e.d2, e.d3);
    return dot(d, d);
}

RIPSTOP_INLINE void move(Pack& position, Pack from, Pack separation, Pack share)
{
    position = fused(separation, share, from);
}

// How one number of four is spread over a register. A load is less work, as separations need many
// shuffles already; a shuffle is done sooner, which counts where the next batch waits for this one.
enum class Spread { ByLoad, ByShuffle };

template <Spread way, int lane>
RIPSTOP_INLINE Pack spreadOf(Pack inRegister, const double* inMemory)
{
    return way == Spread::ByLoad ? all(inMemory[lane]) : spread<lane>(inRegister);
}

// Moves the ends towards each other by these shares of their separation.
template <Spread way, typename Batch>
RIPSTOP_INLINE void pull(const Batch& batch, PaddedVec3* position, const Ends& e, Pack shareA,
                         Pack shareB)
{
    const Pack backB = -shareB;
    alignas(32) double a[4];
    alignas(32) double b[4];
    if constexpr (way == Spread::ByLoad) {
        pack(a) = shareA;
        pack(b) = backB;
        asm("" : "+m"(a), "+m"(b)); // without this the compiler makes shuffles of it
    }
    move(row(position, batch.a[0]), e.a0, e.d0, spreadOf<way, 0>(shareA, a));
    move(row(position, batch.a[1]), e.a1, e.d1, spreadOf<way, 1>(shareA, a));
    move(row(position, batch.a[2]), e.a2, e.d2, spreadOf<way, 2>(shareA, a));
    move(row(position, batch.a[3]), e.a3, e.d3, spreadOf<way, 3>(shareA, a));
    move(row(position, batch.b[0]), e.b0, e.d0, spreadOf<way, 0>(backB, b));
    move(row(position, batch.b[1]), e.b1, e.d1, spreadOf<way, 1>(backB, b));
    move(row(position, batch.b[2]), e.b2, e.d2, spreadOf<way, 2>(backB, b));
    move(row(position, batch.b[3]), e.b3, e.d3, spreadOf<way, 3>(backB, b));
}

// Moves both ends of each rod by one share of their separation.
RIPSTOP_INLINE void pullEvenly(const EvenBatch& batch, PaddedVec3* position, const Ends& e,
                               Pack share)
{
    const Pack s0 = spread<0>(share), s1 = spread<1>(share);
    const Pack s2 = spread<2>(share), s3 = spread<3>(share);
    move(row(position, batch.a[0]), e.a0, e.d0, s0);
    move(row(position, batch.a[1]), e.a1, e.d1, s1);
    move(row(position, batch.a[2]), e.a2, e.d2, s2);
    move(row(position, batch.a[3]), e.a3, e.d3, s3);
    move(row(position, batch.b[0]), e.b0, e.d0, -s0);
    move(row(position, batch.b[1]), e.b1, e.d1, -s1);
    move(row(position, batch.b[2]), e.b2, e.d2, -s2);
    move(row(position, batch.b[3]), e.b3, e.d3, -s3);
}

// Whether a share can move its rod: torn rods have no number for a length, and coincident ends no
// direction to move along.
RIPSTOP_INLINE auto canMove(Pack share)
{
    return share > all(std::numeric_limits<double>::lowest());
}

template <Note note>
RIPSTOP_INLINE void add(Lanes& sum, Pack value)
{
    if constexpr (note == Note::Anew)
        pack(sum.value) = value;
    if constexpr (note == Note::More)
        pack(sum.value) += value;
}

// The share is (1 - rest / length) of what both ends move. rest / length is taken as
// (rest / square) length, so that root and division need not wait for each other.
template <Spread way, Note note>
RIPSTOP_INLINE void project(const EvenBatch& batch, Lanes& stretch, PaddedVec3* position)
{
    const Ends e = endsOf(batch, position);
    const Pack square = squaredLength(e);
    const Pack length = root(square);
    const Pack halfRest = pack(batch.halfRest);
    const Pack half = all(0.5);
    const Pack share = fused(-(halfRest / square), length, half);
    const auto moves = canMove(share);
    add<note>(stretch, moves ? fused(length, half, -halfRest) : Pack{});
    pullEvenly(batch, position, e, moves ? share : Pack{});
}

template <Spread way, Note note>
RIPSTOP_INLINE void project(const PlainBatch& batch, Lanes& stretch, PaddedVec3* position)
{
    const Ends e = endsOf(batch, position);
    const Pack square = squaredLength(e);
    const Pack length = root(square);
    const Pack rest = pack(batch.rest);
    const Pack share = fused(-(rest / square), length, all(1.0));
    const auto moves = canMove(share);
    add<note>(stretch, moves ? length - rest : Pack{});
    const Pack moved = moves ? share : Pack{};
    pull<way>(batch, position, e, moved * pack(batch.shareA), moved * pack(batch.shareB));
}

template <Spread way, Note>
RIPSTOP_INLINE void project(const SoftBatch& batch, Lanes& multiplier, PaddedVec3* position)
{
    const Ends e = endsOf(batch, position);
    const Pack square = squaredLength(e);
    const Pack length = root(square);
    const Pack old = pack(multiplier.value);
    const Pack stretch = length - pack(batch.rest);
    // Clamp the running total, not the change: a line may give back pull it took.
    Pack total = old + fused(-pack(batch.softness), old, stretch) * pack(batch.inverseWeight);
    total = total < pack(batch.lowest) ? pack(batch.lowest) : total;
    total = total > pack(batch.highest) ? pack(batch.highest) : total;
    const Pack change = square > 0.0 ? total - old : Pack{};
    const Pack perLength = square > 0.0 ? change / length : Pack{};
    pack(multiplier.value) = old + change;
    pull<way>(batch, position, e, perLength * pack(batch.inverseMassA),
              perLength * pack(batch.inverseMassB));
}

// In short runs each batch waits for one of the run before.
constexpr std::uint32_t shortRun = 4; // batches

// Each chunk is a new stretch of memory, shorter than what the processor needs to find out by
// itself that it is read in order. These addresses may lie beyond the arrays: nothing is read from
// them.
constexpr std::uint32_t ahead = 16; // batches

template <typename Batch>
RIPSTOP_INLINE void readAhead(const Batch* batch, const Lanes* lanes)
{
    __builtin_prefetch(batch);
    __builtin_prefetch(lanes);
}

template <Spread way, Note note, typename Batch>
RIPSTOP_INLINE void projectEach(BatchRange range, bool backwards, const Batch* batch, Lanes* lanes,
                                PaddedVec3* position)
{
    if (backwards)
        for (std::uint32_t i = range.last; i-- > range.first;) {
            readAhead(batch + i - ahead, lanes + i - ahead);
            project<way, note>(batch[i], lanes[i], position);
        }
    else
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            readAhead(batch + i + ahead, lanes + i + ahead);
            project<way, note>(batch[i], lanes[i], position);
        }
}

template <Note note, typename Batch>
RIPSTOP_INLINE void projectAll(BatchRange range, bool backwards, const Batch* batch, Lanes* lanes,
                               PaddedVec3* position)
{
    if (range.last - range.first < shortRun)
        projectEach<Spread::ByShuffle, note>(range, backwards, batch, lanes, position);
    else
        projectEach<Spread::ByLoad, note>(range, backwards, batch, lanes, position);
}

// The batches of a run share no particle, so their order does not matter to the result. It does to
// the processor, which reads ahead only where memory is gone through in one direction.
template <Note note>
RIPSTOP_INLINE void sweepRun(RodBatches& batches, const BatchRun& run, bool backwards,
                             PaddedVec3* position)
{
    projectAll<note>(run.even, backwards, batches.even.data(), batches.evenStretch.data(),
                     position);
    projectAll<note>(run.plain, backwards, batches.plain.data(), batches.plainStretch.data(),
                     position);
    projectAll<note>(run.soft, backwards, batches.soft.data(), batches.multiplier.data(), position);
    for (std::uint32_t i = run.guided.first; i < run.guided.last; ++i)
        project(batches.guided[i], position);
}

template <Note note>
RIPSTOP_INLINE void sweepInOrder(RodBatches& batches, std::span<const int> order, bool backwards,
                                 PaddedVec3* position)
{
    const std::size_t count = order.size();
    for (std::size_t i = 0; i < count; ++i)
        sweepRun<note>(batches, batches.runs[std::size_t(order[backwards ? count - 1 - i : i])],
                       backwards, position);
}

void sweepRuns(RodBatches& batches, std::span<const int> order, const SweepHow& how,
               PaddedVec3* position)
{
    switch (how.note) {
    case Note::Nothing:
        return sweepInOrder<Note::Nothing>(batches, order, how.backwards, position);
    case Note::Anew:
        return sweepInOrder<Note::Anew>(batches, order, how.backwards, position);
    case Note::More:
        return sweepInOrder<Note::More>(batches, order, how.backwards, position);
    }
}
