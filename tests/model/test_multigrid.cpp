// The multigrid solver against a sparse Cholesky of Eigen: the same solutions, in a number of
// iterations that does not grow with the network.
#include "constraints/multigrid.h"
#include "registered_test.h"

#include <Eigen/SparseCholesky>
#include <QtTest>

#include <cmath>
#include <cstring>
#include <random>
#include <set>

namespace ripstop::test_multigrid {

namespace {

ThreadPool alone(1);

// A network of springs between nodes; what is held comes last.
struct Net
{
    std::size_t nodes = 0;
    std::vector<Row> place;
    std::vector<std::pair<int, int>> pairs, anchors;
};

Row row(double x, double y, double z) { return {{x, y, z, 0.0}}; }

// A sheet with both diagonals, `cells` each way, held along its first edge; its places are shaken
// by a share of a cell in its plane, and across it where it is `rough`; the nodes stand in an order
// of their own when it is `shuffled`.
Net sheet(int cells, double shake = 0.0, bool shuffled = false, bool rough = false)
{
    std::mt19937 random(7);
    const int side = cells + 1;
    std::vector<int> number(std::size_t(side * side));
    const int held = side; // the first row
    std::vector<int> order(std::size_t(side * cells));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size(); shuffled && i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
    Net net;
    net.nodes = order.size();
    net.place.resize(net.nodes + std::size_t(held));
    for (int k = 0; k < side * side; ++k)
        number[std::size_t(k)] = k < held ? int(net.nodes) + k : order[std::size_t(k - held)];
    const auto shaken = [&] { return shake * (double(random() % 1000) / 500.0 - 1.0); };
    for (int k = 0; k < side * side; ++k)
        net.place[std::size_t(number[std::size_t(k)])] =
            row((k % side + shaken()) / cells, 2.0 + (rough ? shaken() / cells : 0.0),
                (k / side + shaken()) / cells);
    const auto join = [&](int a, int b) {
        const int i = number[std::size_t(a)], j = number[std::size_t(b)];
        const bool iFree = std::size_t(i) < net.nodes, jFree = std::size_t(j) < net.nodes;
        if (iFree && jFree)
            net.pairs.emplace_back(i, j);
        else if (iFree || jFree)
            net.anchors.emplace_back(std::min(i, j), std::max(i, j));
    };
    for (int z = 0; z < side; ++z)
        for (int x = 0; x < side; ++x) {
            const int k = z * side + x;
            if (x < cells)
                join(k, k + 1);
            if (z < cells)
                join(k, k + side);
            if (x < cells && z < cells) {
                join(k, k + side + 1);
                join(k + 1, k + side);
            }
        }
    return net;
}

// Mass 1 and stiffness n n^T + a little across, times `stiffness`, of every spring.
struct Problem
{
    Multigrid grid;
    Eigen::SparseMatrix<double> matrix;
    std::vector<Row> right;
};

void fill(Problem& problem, const Net& net, double stiffness)
{
    problem.grid.analyze(net.nodes, net.pairs, net.anchors, net.place);
    problem.grid.setZero(alone);
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](std::size_t i, std::size_t j, const Eigen::Matrix3d& block) {
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                entries.emplace_back(int(3 * i) + r, int(3 * j) + c, block(r, c));
    };
    const auto into = [](BlockCholesky::Block& block, const Eigen::Matrix3d& value) {
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                block.column[c][r] += value(r, c);
    };
    const auto stiffnessOf = [&](int a, int b) -> Eigen::Matrix3d {
        const Row &p = net.place[std::size_t(a)], &q = net.place[std::size_t(b)];
        const Vec3 n = Vec3(q.v[0] - p.v[0], q.v[1] - p.v[1], q.v[2] - p.v[2]).normalized();
        return stiffness * (n * n.transpose() + 1e-4 * Eigen::Matrix3d::Identity());
    };
    for (std::size_t i = 0; i < net.nodes; ++i) {
        into(problem.grid.diagonal(i), Eigen::Matrix3d::Identity());
        add(i, i, Eigen::Matrix3d::Identity());
    }
    for (std::size_t k = 0; k < net.pairs.size(); ++k) {
        const auto [a, b] = net.pairs[k];
        const Eigen::Matrix3d block = stiffnessOf(a, b);
        into(problem.grid.diagonal(std::size_t(a)), block);
        into(problem.grid.diagonal(std::size_t(b)), block);
        into(problem.grid.pair(k), -block);
        add(std::size_t(a), std::size_t(a), block);
        add(std::size_t(b), std::size_t(b), block);
        add(std::size_t(a), std::size_t(b), -block);
        add(std::size_t(b), std::size_t(a), -block);
    }
    for (const auto& [a, b] : net.anchors) {
        const Eigen::Matrix3d block = stiffnessOf(a, b);
        into(problem.grid.diagonal(std::size_t(a)), block);
        add(std::size_t(a), std::size_t(a), block);
    }
    problem.matrix.resize(Eigen::Index(3 * net.nodes), Eigen::Index(3 * net.nodes));
    problem.matrix.setFromTriplets(entries.begin(), entries.end());
    std::mt19937 random(11);
    for (std::size_t i = 0; i < net.nodes; ++i) // a smooth load and a rough one
        problem.right.push_back(
            row(std::sin(3.0 * net.place[i].v[0]), -1.0, double(random() % 1000) / 1000.0));
}

const auto nothingToKeep = [](std::span<Row>) {};

// The energy of the error over that of the solution, roots.
double errorOf(const Problem& problem, std::span<const Row> x)
{
    const auto size = Eigen::Index(3 * x.size());
    Eigen::VectorXd right(size), found(size);
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            right[Eigen::Index(3 * i) + c] = problem.right[i].v[c];
            found[Eigen::Index(3 * i) + c] = x[i].v[c];
        }
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(problem.matrix);
    const Eigen::VectorXd exact = factor.solve(right);
    const Eigen::VectorXd off = found - exact;
    return std::sqrt(off.dot(problem.matrix * off) / exact.dot(right));
}

} // namespace

class TestMultigrid : public QObject
{
    Q_OBJECT

private slots:
    void solves_data()
    {
        QTest::addColumn<int>("cells");
        QTest::addColumn<double>("shake");
        QTest::addColumn<bool>("shuffled");
        QTest::addColumn<double>("stiffness");
        for (const int cells : {3, 10, 33, 80})
            for (const double stiffness : {1.0, 1e6})
                QTest::addRow("%d cells, stiffness %g", cells, stiffness)
                    << cells << 0.0 << false << stiffness;
        QTest::newRow("shaken") << 40 << 0.2 << false << 1e6;
        QTest::newRow("shaken, larger") << 80 << 0.2 << false << 1e6;
        QTest::newRow("in any order") << 40 << 0.1 << true << 1e6;
    }

    // The number of iterations stays as it is from 10 to 6 500 nodes.
    void solves()
    {
        QFETCH(int, cells);
        QFETCH(double, shake);
        QFETCH(bool, shuffled);
        QFETCH(double, stiffness);
        Problem problem;
        fill(problem, sheet(cells, shake, shuffled), stiffness);
        QVERIFY(problem.grid.factorize(alone));
        std::vector<Row> x = problem.right;
        problem.grid.solve(x, 0.0, 100, nothingToKeep, alone);
        QVERIFY2(errorOf(problem, x) < 1e-4, qPrintable(QString::number(errorOf(problem, x))));
        qInfo("%d iterations", problem.grid.iterations());
        QVERIFY(problem.grid.iterations() <= 12);
    }

    // Where neighbours do not lie in one plane, what is stiff couples with what is soft; that takes
    // more, and still comes to the end.
    void solvesRoughSheets()
    {
        Problem problem;
        fill(problem, sheet(40, 0.2, false, true), 1e6);
        QVERIFY(problem.grid.factorize(alone));
        std::vector<Row> x = problem.right;
        problem.grid.solve(x, 0.0, 200, nothingToKeep, alone);
        qInfo("%d iterations", problem.grid.iterations());
        QVERIFY(problem.grid.iterations() < 200);
        QVERIFY(errorOf(problem, x) < 1e-4);
    }

    // Every node is tied to something that is held: there is no coarser network, and none is
    // needed.
    void solvesWhatIsHeldAllOver()
    {
        Net net = sheet(60);
        const auto anchor = net.anchors.front().second;
        for (std::size_t i = 0; i < net.nodes; ++i)
            net.anchors.emplace_back(int(i), anchor);
        Problem problem;
        fill(problem, net, 1e6);
        QCOMPARE(problem.grid.levels(), std::size_t(1));
        QVERIFY(problem.grid.factorize(alone));
        std::vector<Row> x = problem.right;
        problem.grid.solve(x, 0.0, 400, nothingToKeep, alone);
        qInfo("%d iterations", problem.grid.iterations());
        QVERIFY(problem.grid.iterations() < 400);
        QVERIFY(errorOf(problem, x) < 1e-4);
    }

    void stopsAtItsGoal()
    {
        Problem problem;
        fill(problem, sheet(40), 1e6);
        QVERIFY(problem.grid.factorize(alone));
        std::vector<Row> x = problem.right;
        problem.grid.solve(x, 0.0, 100, nothingToKeep, alone);
        double energy = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i)
            for (int c = 0; c < 3; ++c)
                energy += x[i].v[c] * problem.right[i].v[c];
        for (const double share : {0.1, 0.01, 0.001}) {
            std::vector<Row> y = problem.right;
            const double left =
                problem.grid.solve(y, share * std::sqrt(energy), 100, nothingToKeep, alone);
            QVERIFY(left <= share * std::sqrt(energy));
            QVERIFY2(errorOf(problem, y) < 3.0 * share,
                     qPrintable(QString::number(errorOf(problem, y))));
        }
    }

    void hasTheSameBitsAgain()
    {
        const Net net = sheet(30, 0.1);
        std::vector<Row> first;
        for (int again = 0; again < 2; ++again) {
            Problem problem;
            fill(problem, net, 1e5);
            QVERIFY(problem.grid.factorize(alone));
            std::vector<Row> x = problem.right;
            problem.grid.solve(x, 1e-6, 100, nothingToKeep, alone);
            if (again == 0)
                first = x;
            else
                QVERIFY(std::memcmp(first.data(), x.data(), x.size() * sizeof(Row)) == 0);
        }
    }

    // What may not move does not, and the rest is as it would be without it.
    void keepsWhatItIsTold()
    {
        Problem problem;
        fill(problem, sheet(20), 1e4);
        QVERIFY(problem.grid.factorize(alone));
        std::vector<Row> x = problem.right;
        const auto noHeight = [](std::span<Row> rows) {
            for (Row& r : rows)
                r.v[1] = 0.0;
        };
        problem.grid.solve(x, 0.0, 200, noHeight, alone);
        for (const Row& r : x)
            QCOMPARE(r.v[1], 0.0);
        QVERIFY(std::abs(x.back().v[0]) > 0.0);
    }

    void refusesWhatIsNotPositive()
    {
        Problem problem;
        fill(problem, sheet(20), 1e4);
        problem.grid.diagonal(5).column[0][0] = -1e9;
        QVERIFY(!problem.grid.factorize(alone));
        fill(problem, sheet(20), std::nan(""));
        QVERIFY(!problem.grid.factorize(alone));
    }

    // All at one place, in a line, two pieces, none at all.
    void takesAnyNetwork()
    {
        Net heap = sheet(20);
        for (Row& place : heap.place)
            place = row(1.0, 1.0, 1.0);
        Problem problem;
        problem.grid.analyze(heap.nodes, heap.pairs, heap.anchors, heap.place);
        problem.grid.setZero(alone);
        for (std::size_t i = 0; i < heap.nodes; ++i)
            for (int c = 0; c < 3; ++c)
                problem.grid.diagonal(i).column[c][c] = 2.0;
        QVERIFY(problem.grid.factorize(alone));
        std::vector<Row> x(heap.nodes, row(2.0, 4.0, 6.0));
        problem.grid.solve(x, 0.0, 100, nothingToKeep, alone);
        QVERIFY(std::abs(x[3].v[1] - 2.0) < 1e-4);

        Multigrid none;
        none.analyze(0, {}, {}, {});
        none.setZero(alone);
        QVERIFY(none.factorize(alone));
        none.solve({}, 0.0, 10, nothingToKeep, alone);
        QCOMPARE(none.iterations(), 0);
    }

    // Threads that take stripes of one colour touch neither the same rows nor the same blocks of
    // the coarser level.
    void stripesOfAColourDoNotMeet()
    {
        const Net net = sheet(80);
        Problem problem;
        fill(problem, net, 1e4);
        const Stripes& stripes = problem.grid.stripes();
        QVERIFY(stripes.colours.size() > 1);
        std::size_t rows = 0;
        for (const Stripe& stripe : stripes.list) {
            QCOMPARE(stripe.first, rows);
            rows = stripe.last;
        }
        QCOMPARE(rows, net.nodes);
        const auto stripeOf = [&](int node) {
            return std::size_t(
                       std::ranges::upper_bound(stripes.list, std::size_t(node), {}, &Stripe::first)
                       - stripes.list.begin())
                   - 1;
        };
        std::vector<std::set<std::size_t>> touchedBy(net.nodes); // stripes, by row
        for (const auto& [a, b] : net.pairs)
            for (const int row : {a, b})
                touchedBy[std::size_t(row)].insert(stripeOf(std::min(a, b)));
        for (const auto& touching : touchedBy) {
            std::set<int> colours;
            for (const std::size_t stripe : touching)
                QVERIFY(colours.insert(stripes.list[stripe].colour).second);
        }
    }

    void sameBitsAtAnyNumberOfThreads()
    {
        const Net net = sheet(120);
        std::vector<std::vector<Row>> found;
        for (const int threads : {1, 2, 3, 8}) {
            ThreadPool pool(threads);
            Problem problem;
            fill(problem, net, 1e4);
            QVERIFY(problem.grid.factorize(pool));
            std::vector<Row> x = problem.right;
            (void)problem.grid.solve(x, 1e-6, 100, nothingToKeep, pool);
            found.push_back(std::move(x));
        }
        for (const auto& other : found)
            QVERIFY(std::memcmp(other.data(), found[0].data(), net.nodes * sizeof(Row)) == 0);
    }
};

const RegisteredTest registered("test_multigrid", runPlain<TestMultigrid>);

} // namespace ripstop::test_multigrid
#include "test_multigrid.moc"
