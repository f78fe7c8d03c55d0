// How the values of a variable of a study are spread, and the value that a share of them lies
// below.
//
// Plans draw shares between 0 and 1 (plan.h) and ask here for the value, so that every plan can
// have every distribution. All is made of portable functions (base/portable_math.h): a study has
// the same values on every machine.
#pragma once

namespace ripstop {

struct Distribution
{
    enum class Kind {
        Uniform,   // from a to b
        Log,       // from a to b, uniform in the logarithm; both above 0
        Normal,    // mean a, standard deviation b
        LogNormal, // median a, the logarithm with standard deviation b
        Triangular // from a to b, most likely at c
    };
    Kind kind = Kind::Uniform;
    double a = 0.0;
    double b = 1.0;
    double c = 0.0;
};

// `share` is above 0 and below 1.
double quantile(const Distribution& distribution, double share);

// Of the standard normal distribution, to 1e-15 of it (Wichura 1988, algorithm AS 241).
double normalQuantile(double share);

} // namespace ripstop
