// An experiment, no part of the product: does a coarse-to-fine hierarchy hold large cloths at less
// cost than plain small steps?
//
// The cloth of networks.h with 2^k m + 1 particles a side. Level l has every 2^l-th particle,
// tied by rods to its neighbours along rows, columns and diagonals that resist tension only: cloth
// between them may be slack, but not longer than the way along it (Mueller 2008, Hierarchical
// position based dynamics). A substep predicts, then goes from the coarsest level to the finest:
// sweeps there, and hands what moved to the next level, linearly between particles. The finest
// level is one coloured sweep over all rods, as in plain small steps. Both have the same plain
// loops, so that times compare; the orders of colours are shuffled by the number of the substep.
#include "bench/networks.h"
#include "bench/quality.h"
#include "bench/report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>

using namespace ripstop;

namespace {

constexpr double frameSeconds = 0.01;
constexpr double viscosity = 0.2; // 1/s
constexpr double gravity = 9.80665;
constexpr int framesOfPath = 100;

struct Stencil // rods from (row, column) to (row + down, column + right)
{
    int right;
    int down;
};

constexpr Stencil fineStencils[]{{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 0}, {0, 2}};
constexpr Stencil coarseStencils[]{{1, 0}, {0, 1}, {1, 1}, {-1, 1}};

enum class Holds { Both, Tension };

class Level
{
public:
    Level(int fineSide, int stride)
        : side((fineSide - 1) / stride + 1)
        , spacing(double(stride) / (fineSide - 1))
        , place(std::size_t(side * side))
        , moved(place.size(), Vec3::Zero())
    {}

    Vec3& at(int row, int column) { return place[std::size_t(row * side + column)]; }
    Vec3& motion(int row, int column) { return moved[std::size_t(row * side + column)]; }

    // One sweep over the rods of all stencils; all particles weigh the same but the two pins.
    template <Holds holds, std::size_t count>
    void sweep(const Stencil (&stencils)[count], unsigned seed)
    {
        int order[2 * count];
        for (int i = 0; i < int(2 * count); ++i)
            order[i] = i;
        for (int i = int(2 * count) - 1; i > 0; --i) {
            seed = seed * 1664525u + 1013904223u;
            std::swap(order[i], order[(seed >> 16) % unsigned(i + 1)]);
        }
        for (const int colour : order)
            sweepColour<holds>(stencils[colour / 2], colour % 2);
    }

    int side;
    double spacing;          // m
    std::vector<Vec3> place; // m
    std::vector<Vec3> moved; // m, by sweeps of this level and of coarser ones

private:
    // Rods of one stencil that share no particle: every other row when it goes down, else every
    // other column or pair of columns.
    template <Holds holds>
    void sweepColour(const Stencil& stencil, int parity)
    {
        const double rest = spacing * std::hypot(stencil.right, stencil.down);
        const int span = std::max(stencil.down, std::abs(stencil.right));
        for (int row = 0; row + stencil.down < side; ++row) {
            if (stencil.down > 0 && (row / stencil.down) % 2 != parity)
                continue;
            for (int column = std::max(0, -stencil.right);
                 column + std::max(0, stencil.right) < side; ++column)
                if (stencil.down > 0 || (column / span) % 2 == parity)
                    project<holds>(row * side + column,
                                   (row + stencil.down) * side + column + stencil.right, rest);
        }
    }

    template <Holds holds>
    void project(int a, int b, double rest)
    {
        Vec3& xa = place[std::size_t(a)];
        Vec3& xb = place[std::size_t(b)];
        const Vec3 d = xb - xa;
        const double length = d.norm();
        if (holds == Holds::Tension && length <= rest)
            return;
        const double wa = isPin(a) ? 0.0 : 1.0;
        const double wb = isPin(b) ? 0.0 : 1.0;
        if (wa + wb == 0.0)
            return;
        const Vec3 pull = ((length - rest) / (length * (wa + wb))) * d;
        xa += wa * pull;
        xb -= wb * pull;
    }

    bool isPin(int i) const { return i == 0 || i == side - 1; }
};

class Cloth
{
public:
    Cloth(int side, int levels, int coarseSweeps)
        : m_coarseSweeps(coarseSweeps)
    {
        for (int l = 0; l <= levels; ++l)
            m_levels.emplace_back(side, 1 << l);
        Level& fine = m_levels[0];
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                fine.at(row, column) = Vec3(column * fine.spacing - 0.5, 0.0, row * fine.spacing);
        m_velocity.assign(fine.place.size(), Vec3::Zero());
    }

    void frame(int substeps)
    {
        const double h = frameSeconds / substeps;
        for (int i = 0; i < substeps; ++i)
            substep(h);
    }

    double largestStrain()
    {
        Level& fine = m_levels[0];
        double largest = 0.0;
        for (int row = 0; row < fine.side; ++row)
            for (int column = 0; column < fine.side; ++column) {
                const auto strain = [&](const Vec3& other) {
                    const double length = (other - fine.at(row, column)).norm();
                    largest = std::max(largest, std::abs(length / fine.spacing - 1.0));
                };
                if (column + 1 < fine.side)
                    strain(fine.at(row, column + 1));
                if (row + 1 < fine.side)
                    strain(fine.at(row + 1, column));
            }
        return largest;
    }

    Vec3 center() const
    {
        Vec3 sum = Vec3::Zero();
        for (const Vec3& place : m_levels[0].place)
            sum += place;
        return sum / double(m_levels[0].place.size());
    }

private:
    void substep(double h)
    {
        Level& fine = m_levels[0];
        const int last = fine.side - 1;
        m_before = fine.place;
        for (std::size_t i = 0; i < fine.place.size(); ++i)
            if (i != 0 && i != std::size_t(last)) {
                m_velocity[i].y() -= gravity * h;
                fine.place[i] += h * m_velocity[i];
            }
        ++m_number;
        if (m_levels.size() > 1)
            correctFromCoarse();
        fine.sweep<Holds::Both>(fineStencils, m_number);
        const double keep = std::exp(-viscosity * h);
        for (std::size_t i = 0; i < fine.place.size(); ++i)
            m_velocity[i] = (keep / h) * (fine.place[i] - m_before[i]);
    }

    void correctFromCoarse()
    {
        for (std::size_t l = m_levels.size() - 1; l >= 1; --l) {
            Level& level = m_levels[l];
            const int stride = 1 << l;
            for (int row = 0; row < level.side; ++row)
                for (int column = 0; column < level.side; ++column) {
                    Vec3& place = level.at(row, column);
                    place = m_levels[0].at(row * stride, column * stride);
                    if (l + 1 < m_levels.size())
                        place += level.motion(row, column);
                }
            for (int i = 0; i < m_coarseSweeps; ++i)
                level.sweep<Holds::Tension>(coarseStencils, m_number * 7 + unsigned(i));
            for (int row = 0; row < level.side; ++row)
                for (int column = 0; column < level.side; ++column)
                    level.motion(row, column) =
                        level.at(row, column) - m_levels[0].at(row * stride, column * stride);
            handDown(level, m_levels[l - 1], l == 1);
        }
    }

    // What moved on a level, linearly between its particles, becomes what is handed to the finer
    // one; the finest takes it at once.
    static void handDown(Level& coarse, Level& fine, bool finest)
    {
        for (int row = 0; row < fine.side; ++row)
            for (int column = 0; column < fine.side; ++column) {
                const int r = row / 2;
                const int c = column / 2;
                const int r1 = r + row % 2;
                const int c1 = c + column % 2;
                const Vec3 mean = 0.25
                                  * (coarse.motion(r, c) + coarse.motion(r1, c)
                                     + coarse.motion(r, c1) + coarse.motion(r1, c1));
                if (finest)
                    fine.at(row, column) += mean;
                else
                    fine.motion(row, column) = mean;
            }
    }

    int m_coarseSweeps;
    unsigned m_number = 0;
    std::vector<Level> m_levels;
    std::vector<Vec3> m_velocity; // m/s
    std::vector<Vec3> m_before;   // m
};

struct Outcome
{
    double seconds; // s for a frame, median
    double strain;  // 1, median over the last three quarters of the frames
    double error;   // m, RMS of the mass centre over the first second
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

Outcome fly(int side, int levels, int coarseSweeps, int substeps, int frames)
{
    // The mass centre of cloth_100, converged: the same cloth but for its grain. The references of
    // 32 and 100 particles a side differ by some millimetres.
    static const Path reference = pathFromFile(REFERENCE_FOLDER "/cloth_100.csv");
    Cloth cloth(side, levels, coarseSweeps);
    std::vector<double> seconds;
    std::vector<double> strain;
    double square = 0.0;
    int compared = 0;
    for (int frame = 1; frame <= frames && !interrupted(); ++frame) {
        const auto start = std::chrono::steady_clock::now();
        cloth.frame(substeps);
        seconds.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        if (4 * frame > frames)
            strain.push_back(cloth.largestStrain());
        if (frame <= framesOfPath && std::size_t(frame) < reference.size()) {
            square += (cloth.center() - reference[std::size_t(frame)]).squaredNorm();
            ++compared;
        }
    }
    if (strain.empty())
        return {};
    return {median(seconds), median(strain), std::sqrt(square / std::max(1, compared))};
}

int usage()
{
    std::cerr << "ripstop-bench-hierarchy SIDE FRAMES LEVELS,SWEEPS,SUBSTEPS...\n"
                 "SIDE - 1 is a multiple of 2^LEVELS; SWEEPS are those of each coarse level. "
                 "LEVELS 0 is plain small steps.\n"
                 "Example: ripstop-bench-hierarchy 321 120 0,0,110 4,2,55\n";
    return WrongUsage;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4)
        return usage();
    const int side = std::atoi(argv[1]);
    const int frames = std::atoi(argv[2]);
    catchInterrupt();
    Table table("Cloth of " + std::to_string(side) + " particles a side, " + std::to_string(frames)
                    + " frames of 10 ms",
                {{"levels", 6},
                 {"sweeps", 6},
                 {"substeps", 8},
                 {"ms/frame", 9},
                 {"strain", 9},
                 {"path error", 10}},
                true);
    for (int i = 3; i < argc && !interrupted(); ++i) {
        int levels = 0;
        int sweeps = 0;
        int substeps = 0;
        if (std::sscanf(argv[i], "%d,%d,%d", &levels, &sweeps, &substeps) != 3 || side < 3
            || substeps < 1 || levels < 0 || levels > 20 || (side - 1) % (1 << levels) != 0)
            return usage();
        const Outcome outcome = fly(side, levels, sweeps, substeps, frames);
        if (interrupted())
            break;
        table.row({std::to_string(levels), std::to_string(sweeps), std::to_string(substeps),
                   fixed(1e3 * outcome.seconds, 1), percent(outcome.strain),
                   fixed(1e3 * outcome.error, 1) + " mm"});
    }
    return interrupted() ? Interrupted : Done;
}
