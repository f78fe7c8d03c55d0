// How true a run is: which digits of its probes hold.
//
// The scene runs three times, with its substeps as they are, cut in two and cut in four, and with
// its tolerances as they are, half and a quarter of them. Time steps stay, so that all three hear
// the same pilots and meet the same gusts and their probes are read at the same moments. With q1,
// q2 and q4 the values of a probe, coarse to fine (Richardson 1911; Roache 1994, "Perspective: a
// method for uniform reporting of grid refinement studies"):
//
//     order        p  = log2((q1 - q2) / (q2 - q4))
//     limit        q  = q4 + (q4 - q2) / (2^p - 1)
//     error of q1  Fs |q1 - q|, Fs = 1.25
//
// Where the differences do not shrink with one sign, no order shows, and the error is three times
// the largest of them. Motion that is chaotic has no values that converge, but its means may: of a
// probe whose last values do not come nearer to each other the mean over the second half of the
// time is judged instead.
//
// Motion that is too fast for all three runs dies away in all of them, and its last values agree
// on a rest that is not there. Before that they did not: a probe that was somewhere off by as much
// as half of the way it went holds in no digit that its last value shows.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace ripstop {

// Of one number that was found three times.
struct Convergence
{
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::array<double, 3> value{}; // coarse to fine
    double order = none;           // that shows, or none
    double limit = none;           // what the values go to, or none
    double error = none;           // of the coarse one
    int digits = 0;                // of the coarse one that hold, 15 at most

    bool converges() const { return !std::isnan(order); }
};

Convergence convergenceOf(const std::array<double, 3>& value);

// What rounding may make of a value: smaller differences tell nothing.
double roundingOf(double value);

struct CertifiedProbe
{
    std::string name;
    std::string unit;
    bool ofMean = false; // over the second half, since single values do not converge
    Convergence result;
    std::vector<double> value; // [times] of the run as it is
    std::vector<double> error; // [times] of these, as above

    std::size_t worstMoment() const; // index of the largest error; 0 where none is known
    bool holdsItsCourse() const;
    int digits() const { return holdsItsCourse() ? result.digits : 0; }
};

struct Certificate
{
    double seconds = 0.0;
    std::vector<double> time; // [times] s, of every time step
    std::vector<CertifiedProbe> probes;

    // Of the probe of this name at a time step, s; not a number where nothing is certified.
    double errorAt(const std::string& probe, double at) const;
};

} // namespace ripstop
