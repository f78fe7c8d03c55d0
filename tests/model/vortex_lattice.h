// A vortex lattice for flat wings: what the vortex law's slopes are held against. It shares nothing
// with the law. The wing is cut into cells across and along the chord; each has a horseshoe vortex
// at a quarter of its chord, whose ends trail off downstream in the plane of the wing, and a place
// at three quarters where no air goes through (Bertin and Smith, Aerodynamics for Engineers, 2nd
// ed. 1989, eq. 7.44).
#pragma once

#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <vector>

namespace ripstop {

struct Strips
{
    std::vector<double> cuts;    // m, [strips + 1], ascending y of their sides
    std::vector<double> middles; // m, [strips], where the air is looked at
};

// A strip for each step of `share` from 0 to 1, which `place` puts between the tips.
inline Strips strips(int count, const std::function<double(double share)>& place)
{
    Strips made;
    for (int i = 0; i <= count; ++i)
        made.cuts.push_back(place(double(i) / count));
    for (int i = 0; i < count; ++i)
        made.middles.push_back(place((i + 0.5) / count));
    return made;
}

// Narrower towards the tips, where the load changes most.
inline Strips cosineStrips(double span, int count)
{
    return strips(count, [=](double share) { return -0.5 * span * std::cos(M_PI * share); });
}

inline Strips evenStrips(double span, int count)
{
    return strips(count, [=](double share) { return span * (share - 0.5); });
}

struct FlatWing
{
    std::function<double(double y)> leading, trailing; // m downstream, of edges that may be swept
    Strips strips;
    int cellsAlong;
};

struct FlatWingAnswer
{
    double slope;      // 1/rad, of the lift coefficient
    double efficiency; // 1, CL^2 / (pi A CDi)
};

// The upwash at (x, y) of a horseshoe of unit circulation from `1` to `2`.
inline double upwash(double x, double y, double x1, double y1, double x2, double y2)
{
    const double r1 = std::hypot(x - x1, y - y1), r2 = std::hypot(x - x2, y - y2);
    const double bound = (((x2 - x1) * (x - x1) + (y2 - y1) * (y - y1)) / r1
                          - ((x2 - x1) * (x - x2) + (y2 - y1) * (y - y2)) / r2)
                         / ((x - x1) * (y - y2) - (x - x2) * (y - y1));
    const double trailing = (1.0 + (x - x1) / r1) / (y1 - y) - (1.0 + (x - x2) / r2) / (y2 - y);
    return (bound + trailing) / (4.0 * M_PI);
}

// The wind is 1 m/s at 1 rad, and all is of the first order of the angle.
inline FlatWingAnswer latticeAnswer(const FlatWing& wing)
{
    const auto& [cuts, middles] = wing.strips;
    const std::size_t strips = middles.size();
    const std::size_t along = std::size_t(wing.cellsAlong);
    const auto x = [&](double y, double share) { // `share` of the chord behind the leading edge
        return wing.leading(y) + share * (wing.trailing(y) - wing.leading(y));
    };
    Eigen::MatrixXd wash(strips * along, strips * along);
    for (std::size_t at = 0; at < strips * along; ++at) {
        const double y = middles[at / along];
        const double there = x(y, (double(at % along) + 0.75) / double(along));
        for (std::size_t of = 0; of < strips * along; ++of) {
            const double left = cuts[of / along], right = cuts[of / along + 1];
            const double share = (double(of % along) + 0.25) / double(along);
            wash(Eigen::Index(at), Eigen::Index(of)) =
                upwash(there, y, x(left, share), left, x(right, share), right);
        }
    }
    const Eigen::VectorXd circulation =
        wash.partialPivLu().solve(Eigen::VectorXd::Constant(wash.rows(), -1.0));

    // far behind, where the wake alone says what it costs (Trefftz 1921)
    std::vector<double> ofStrip(strips, 0.0);
    for (std::size_t cell = 0; cell < strips * along; ++cell)
        ofStrip[cell / along] += circulation[Eigen::Index(cell)];
    double area = 0.0, lift = 0.0, drag = 0.0; // over density
    for (std::size_t i = 0; i < strips; ++i) {
        const double width = cuts[i + 1] - cuts[i];
        const double y = middles[i];
        double downwash = 0.0;
        for (std::size_t j = 0; j < strips; ++j)
            downwash += ofStrip[j] / (2.0 * M_PI) * (1.0 / (y - cuts[j]) - 1.0 / (y - cuts[j + 1]));
        area += width * (wing.trailing(y) - wing.leading(y));
        lift += ofStrip[i] * width;
        drag += 0.5 * ofStrip[i] * downwash * width;
    }
    const double span = cuts.back() - cuts.front();
    return {lift / (0.5 * area), 2.0 * lift * lift / (M_PI * span * span * std::abs(drag))};
}

} // namespace ripstop
