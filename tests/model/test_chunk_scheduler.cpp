// Chunks of work that go from thread to thread do what one thread would do, in the same order.
//
// Each pair of chunks that touch shares a cell, and each chunk has one of its own. A turn mixes its
// name into all its cells, and mixing does not commute, so each cell tells in what order its chunks
// had their turns. Expected is what nested loops over rounds, classes and chunks leave.
#include "model/systems.h"
#include "parallel/chunk_scheduler.h"
#include "registered_test.h"

#include <QtTest>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <thread>
#include <utility>

namespace ripstop::test_chunk_scheduler {

namespace {

// SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

struct Graph
{
    Rows touching;            // [chunks]
    Rows cells;               // [chunks]
    std::vector<int> classOf; // [chunks]
    int classes = 0;
    int reach = 0; // most between the numbers of two that touch
    std::size_t cellCount = 0;
    std::size_t chunks() const { return classOf.size(); }
};

void append(Rows& rows, const std::vector<int>& row)
{
    rows.items.insert(rows.items.end(), row.begin(), row.end());
    rows.start.push_back(int(rows.items.size()));
}

// Chunks at random that touch about `degree` others within `reach` of their number; greedy classes.
Graph randomGraph(std::size_t chunks, int degree, int reach, Dice& dice)
{
    Graph graph;
    std::vector<std::vector<int>> touching(chunks);
    std::vector<std::vector<int>> cells(chunks);
    for (std::size_t c = 0; c < chunks; ++c)
        cells[c].push_back(int(graph.cellCount++));
    for (int c = 0; c < int(chunks); ++c)
        for (int k = 0; k < degree / 2; ++k) {
            const int other = std::min(c + 1 + dice.below(reach), int(chunks) - 1);
            auto& mine = touching[std::size_t(c)];
            if (other == c || std::find(mine.begin(), mine.end(), other) != mine.end())
                continue;
            mine.push_back(other);
            touching[std::size_t(other)].push_back(c);
            cells[std::size_t(c)].push_back(int(graph.cellCount));
            cells[std::size_t(other)].push_back(int(graph.cellCount++));
            graph.reach = std::max(graph.reach, other - c);
        }
    graph.classOf.assign(chunks, -1);
    for (std::size_t c = 0; c < chunks; ++c) {
        std::vector<bool> taken(chunks + 1, false);
        for (const int other : touching[c])
            if (const int theirs = graph.classOf[std::size_t(other)]; theirs >= 0)
                taken[std::size_t(theirs)] = true;
        graph.classOf[c] = int(std::find(taken.begin(), taken.end(), false) - taken.begin());
        graph.classes = std::max(graph.classes, graph.classOf[c] + 1);
    }
    graph.touching.start.push_back(0);
    graph.cells.start.push_back(0);
    for (std::size_t c = 0; c < chunks; ++c) {
        append(graph.touching, touching[c]);
        append(graph.cells, cells[c]);
    }
    return graph;
}

struct Trace
{
    std::vector<std::uint64_t> cell;
    std::vector<int> turns; // [chunks] rounds done; -1 when one came out of order

    explicit Trace(const Graph& graph)
        : cell(graph.cellCount, 0)
        , turns(graph.chunks(), 0)
    {}

    void turn(const Graph& graph, int round, int chunk)
    {
        const auto c = std::size_t(chunk);
        turns[c] = turns[c] == round ? round + 1 : -1;
        const std::uint64_t name = (std::uint64_t(round) << 32) + std::uint64_t(chunk);
        // what is read from one neighbour reaches the others
        std::uint64_t hash = name;
        for (int k = graph.cells.start[c]; k < graph.cells.start[c + 1]; ++k)
            hash = mixed(hash ^ cell[std::size_t(graph.cells.items[std::size_t(k)])]);
        for (int k = graph.cells.start[c]; k < graph.cells.start[c + 1]; ++k) {
            std::uint64_t& value = cell[std::size_t(graph.cells.items[std::size_t(k)])];
            value = mixed(value ^ hash);
        }
    }

    friend bool operator==(const Trace&, const Trace&) = default;
};

Trace expected(const Graph& graph, int rounds, const std::vector<int>& rank)
{
    Trace trace(graph);
    for (int round = 0; round < rounds; ++round)
        for (int k = 0; k < graph.classes; ++k) {
            const int turn = round % 2 == 0 ? k : graph.classes - 1 - k;
            for (std::size_t c = 0; c < graph.chunks(); ++c)
                if (rank[std::size_t(graph.classOf[c])] == turn)
                    trace.turn(graph, round, int(c));
        }
    return trace;
}

std::vector<int> shuffledRanks(const Graph& graph, Dice& dice)
{
    std::vector<int> rank(std::size_t(graph.classes));
    std::iota(rank.begin(), rank.end(), 0);
    for (std::size_t i = rank.size(); i > 1; --i)
        std::swap(rank[i - 1], rank[std::size_t(dice.below(int(i)))]);
    return rank;
}

enum class Pace { Even, Dawdling, Late };

// What keeps a thread from its turn: nothing, a nap here and there, or a long one at its start.
void delay(Pace pace, int round, int chunk, std::thread::id caller)
{
    using namespace std::chrono_literals;
    thread_local bool hasSlept = false;
    if (pace == Pace::Dawdling
        && mixed(std::uint64_t(round) * 4099 + std::uint64_t(chunk)) % 97 == 0)
        std::this_thread::sleep_for(300us);
    if (pace == Pace::Late && std::this_thread::get_id() != caller
        && !std::exchange(hasSlept, true))
        std::this_thread::sleep_for(5ms);
}

} // namespace

class TestChunkScheduler : public QObject
{
    Q_OBJECT

private slots:
    void order_data()
    {
        QTest::addColumn<int>("chunks");
        QTest::addColumn<int>("degree");
        QTest::addColumn<int>("reach");
        QTest::addColumn<int>("rounds");
        QTest::addColumn<int>("repeats");
        QTest::addColumn<Pace>("pace");
        QTest::newRow("one chunk") << 1 << 0 << 1 << 50 << 5 << Pace::Even;
        QTest::newRow("two chunks that touch") << 2 << 2 << 1 << 200 << 20 << Pace::Even;
        QTest::newRow("chunks apart") << 40 << 0 << 1 << 50 << 5 << Pace::Even;
        QTest::newRow("a chain") << 60 << 2 << 1 << 100 << 10 << Pace::Even;
        QTest::newRow("one round") << 300 << 8 << 20 << 1 << 50 << Pace::Even;
        QTest::newRow("a sheet") << 200 << 8 << 20 << 55 << 10 << Pace::Even;
        QTest::newRow("a tangle of many classes") << 120 << 40 << 120 << 40 << 5 << Pace::Even;
        QTest::newRow("threads that nap") << 60 << 6 << 12 << 20 << 3 << Pace::Dawdling;
        QTest::newRow("threads that come late") << 60 << 6 << 12 << 20 << 3 << Pace::Late;
        QTest::newRow("a chain of late threads") << 40 << 2 << 1 << 30 << 3 << Pace::Late;
    }

    void order()
    {
        QFETCH(int, chunks);
        QFETCH(int, degree);
        QFETCH(int, reach);
        QFETCH(int, rounds);
        QFETCH(int, repeats);
        QFETCH(Pace, pace);
        Dice dice(std::uint32_t(7 * chunks + degree));
        for (const int threads : {1, 2, 3, 4, 5, 6, 7, 8}) {
            ThreadPool pool(threads);
            ChunkScheduler scheduler; // used again, as a solver does
            for (int repeat = 0; repeat < repeats; ++repeat) {
                const Graph graph = randomGraph(std::size_t(chunks), degree, reach, dice);
                scheduler.prepare(graph.touching, graph.classOf, graph.reach);
                for (int again = 0; again < 2; ++again) {
                    const std::vector<int> rank = shuffledRanks(graph, dice);
                    Trace trace(graph);
                    const auto caller = std::this_thread::get_id();
                    scheduler.run(pool, rounds, rank, [&](int round, int chunk) {
                        delay(pace, round, chunk, caller);
                        trace.turn(graph, round, chunk);
                    });
                    QVERIFY2(trace == expected(graph, rounds, rank),
                             qPrintable(QString("%1 threads").arg(threads)));
                }
            }
        }
    }

    // The trace can tell: two chunks that swap turns leave other cells.
    void traceTellsOrder()
    {
        Dice dice(3);
        const Graph graph = randomGraph(20, 6, 6, dice);
        std::vector<int> rank = shuffledRanks(graph, dice);
        const Trace right = expected(graph, 3, rank);
        std::swap(rank[0], rank[1]);
        QVERIFY(!(expected(graph, 3, rank) == right));
        QVERIFY(!(expected(graph, 2, rank) == right));
    }
};

const RegisteredTest registered("test_chunk_scheduler", runPlain<TestChunkScheduler>);

} // namespace ripstop::test_chunk_scheduler
#include "test_chunk_scheduler.moc"
