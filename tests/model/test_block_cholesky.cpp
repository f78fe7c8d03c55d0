// The factorisation by blocks: against a dense one, and shared among threads.
#include "constraints/block_cholesky.h"

#include "model/systems.h"
#include "registered_test.h"

#include <Eigen/Cholesky>

#include <QtTest>

namespace ripstop::test_block_cholesky {

class TestBlockCholesky : public QObject
{
    Q_OBJECT

private slots:
    // The same matrix, factorised without blocks.
    void isThatOfADenseMatrix()
    {
        const int nodes = 20;
        Dice dice(5);
        std::vector<std::pair<int, int>> pairs;
        for (int k = 0; k < 60; ++k) {
            const int i = dice.below(nodes);
            pairs.emplace_back(i, (i + 1 + dice.below(nodes - 1)) % nodes);
        }
        BlockCholesky matrix;
        matrix.analyze(nodes, pairs);
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
        const auto add = [&](BlockCholesky::Block& block, int i, int j, const Eigen::Matrix3d& m) {
            for (int c = 0; c < 3; ++c)
                for (int r = 0; r < 3; ++r)
                    block.column[c][r] += m(r, c);
            dense.block<3, 3>(3 * i, 3 * j) += m;
            if (i != j)
                dense.block<3, 3>(3 * j, 3 * i) += m;
        };
        ThreadPool one(1);
        matrix.setZero(one);
        for (int i = 0; i < nodes; ++i)
            add(matrix.diagonal(std::size_t(i)), i, i,
                dice(0.5, 2.0) * Eigen::Matrix3d::Identity());
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const Vec3 n = dice.vector(1.0);
            const Eigen::Matrix3d block = n * n.transpose();
            const auto [i, j] = pairs[k];
            add(matrix.diagonal(std::size_t(i)), i, i, block);
            add(matrix.diagonal(std::size_t(j)), j, j, block);
            add(matrix.pair(k), i, j, -block);
        }
        std::vector<Row> x(nodes);
        Eigen::VectorXd right(3 * nodes);
        for (int i = 0; i < nodes; ++i)
            for (int c = 0; c < 3; ++c)
                x[std::size_t(i)].v[c] = right[3 * i + c] = dice(-1.0, 1.0);
        QVERIFY(matrix.factorize(one));
        matrix.solve(x);
        const Eigen::VectorXd expected = dense.llt().solve(right);
        for (int i = 0; i < nodes; ++i)
            for (int c = 0; c < 3; ++c)
                QVERIFY2(isNear(x[std::size_t(i)].v[c], expected[3 * i + c], 1e-12),
                         told(x[std::size_t(i)].v[c], expected[3 * i + c]));
    }

    // Threads share the columns, and whoever takes one gathers it in the same order.
    void sameBitsAtAnyNumberOfThreads()
    {
        const int side = 100;
        std::vector<std::pair<int, int>> pairs; // of a net with one diagonal
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                for (const auto& [down, along] :
                     {std::pair(0, 1), std::pair(1, 0), std::pair(1, 1)})
                    if (row + down < side && column + along < side)
                        pairs.emplace_back(row * side + column,
                                           (row + down) * side + column + along);
        BlockCholesky matrix;
        matrix.analyze(side * side, pairs);
        QVERIFY(matrix.products() >= BlockCholesky::productsOfThreads);
        const auto fill = [&](ThreadPool& pool, double ground) {
            Dice dice(3);
            matrix.setZero(pool);
            const auto add = [](BlockCholesky::Block& block, const Eigen::Matrix3d& m) {
                for (int c = 0; c < 3; ++c)
                    for (int r = 0; r < 3; ++r)
                        block.column[c][r] += m(r, c);
            };
            for (std::size_t i = 0; i < std::size_t(side * side); ++i)
                add(matrix.diagonal(i), ground * Eigen::Matrix3d::Identity());
            for (std::size_t k = 0; k < pairs.size(); ++k) {
                const Vec3 n = dice.vector(1.0);
                add(matrix.diagonal(std::size_t(pairs[k].first)), n * n.transpose());
                add(matrix.diagonal(std::size_t(pairs[k].second)), n * n.transpose());
                add(matrix.pair(k), -n * n.transpose());
            }
        };
        std::vector<Row> expected;
        for (const int threads : {1, 2, 4}) {
            ThreadPool pool(threads);
            for (int time = 0; time < 6; ++time) {
                fill(pool, 0.01);
                QVERIFY(matrix.factorize(pool));
                std::vector<Row> x(std::size_t(side * side), Row{{1.0, -2.0, 3.0, 0.0}});
                matrix.solve(x);
                if (expected.empty())
                    expected = x;
                QVERIFY(std::memcmp(x.data(), expected.data(), x.size() * sizeof(Row)) == 0);
            }
            fill(pool, -8.0); // nobody waits for ever for a column that cannot be
            QVERIFY(!matrix.factorize(pool));
        }
    }
};

const RegisteredTest registered("test_block_cholesky", runPlain<TestBlockCholesky>);

} // namespace ripstop::test_block_cholesky
#include "test_block_cholesky.moc"
