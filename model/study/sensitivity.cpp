// All sums of a set of blocks are gathered in one pass, once for the indices and again for each
// resample of the bootstrap.
#include "study/sensitivity.h"

#include "study/plan.h"
#include "study/random_share.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::size_t resamples = 500;
constexpr double outside = 0.025; // of the resamples, on either side of a band

// Of a block: f_A, f_B, then f_ABi.
using BlockValues = const double*;

// Sums of which both indices are made, over blocks.
struct IndexSums
{
    double count = 0.0;
    double f = 0.0;
    double square = 0.0;
    std::vector<double> first; // [variables] of f_B (f_ABi - f_A)
    std::vector<double> total; // [variables] of (f_A - f_ABi)^2 / 2

    explicit IndexSums(std::size_t variables)
        : first(variables, 0.0)
        , total(variables, 0.0)
    {}

    //   mean  of all, which is taken off so that products stay small
    void add(BlockValues block, double mean)
    {
        const double a = block[0] - mean;
        const double b = block[1] - mean;
        count += 1.0;
        f += a + b;
        square += a * a + b * b;
        for (std::size_t i = 0; i < first.size(); ++i) {
            const double mixed = block[2 + i] - mean;
            first[i] += b * (mixed - a);
            total[i] += 0.5 * (a - mixed) * (a - mixed);
        }
    }

    double variance() const
    {
        const double mean = f / (2.0 * count);
        return square / (2.0 * count) - mean * mean;
    }
    double indexOf(double sum) const
    {
        return variance() > 0.0 ? sum / (count * variance()) : std::nan("");
    }
};

ConfidenceBand bandOf(double value, std::vector<double>& drawn)
{
    std::ranges::sort(drawn);
    const auto at = std::size_t(outside * double(drawn.size()));
    return {value, drawn[at], drawn[drawn.size() - 1 - at]};
}

} // namespace

Sensitivity sensitivityOf(const std::vector<double>& values, std::size_t variables)
{
    const std::size_t size = sensitivityBlock(variables);
    Sensitivity found;
    std::vector<BlockValues> blocks;
    double sum = 0.0;
    for (std::size_t begin = 0; begin + size <= values.size(); begin += size) {
        const BlockValues block = values.data() + begin;
        if (!std::all_of(block, block + size, [](double one) { return std::isfinite(one); })) {
            ++found.leftOut;
            continue;
        }
        blocks.push_back(block);
        sum += block[0] + block[1];
    }
    found.blocks = blocks.size();
    if (blocks.size() < 2)
        return found;
    found.mean = sum / (2.0 * double(blocks.size()));
    IndexSums all(variables);
    for (const BlockValues block : blocks)
        all.add(block, found.mean);
    found.variance = all.variance();

    std::vector<std::vector<double>> first(variables), total(variables);
    RandomShares random(0);
    for (std::size_t k = 0; k < resamples; ++k) {
        IndexSums drawn(variables);
        for (std::size_t i = 0; i < blocks.size(); ++i)
            drawn.add(blocks[random.below(blocks.size())], found.mean);
        for (std::size_t v = 0; v < variables; ++v) {
            first[v].push_back(drawn.indexOf(drawn.first[v]));
            total[v].push_back(drawn.indexOf(drawn.total[v]));
        }
    }
    for (std::size_t v = 0; v < variables; ++v)
        found.variables.push_back({bandOf(all.indexOf(all.first[v]), first[v]),
                                   bandOf(all.indexOf(all.total[v]), total[v])});
    return found;
}

} // namespace ripstop
