// Which variable matters: the indices of Sobol' (1993) of a measure over the spread of all
// variables.
//
//     S_i  = V[E(f | x_i)] / V[f]         what x_i alone explains of the variance
//     ST_i = E[V(f | all but x_i)] / V[f] what vanishes when x_i is known, with its interactions
//
// A plan of sensitivity has blocks: a point of A, one of B, which are independent, and for each i
// the point of A that has x_i of B. With f in the mean of all, V that of A and B,
//
//     S_i  = mean f_B (f_ABi - f_A) / V          (Saltelli and others 2010)
//     ST_i = mean (f_A - f_ABi)^2 / (2 V)        (Jansen 1999)
//
// Bands are the middle 95 % of what whole blocks, drawn again with replacement, come to (bootstrap
// of Efron 1979). They are wider than the error of points of Sobol', which lie more evenly than
// random ones. It is computed here and not by OpenTURNS, whose random numbers and threads would
// decide the last digits.
#pragma once

#include <cstddef>
#include <vector>

namespace ripstop {

struct ConfidenceBand
{
    double value;
    double low;
    double high;
};

struct SobolIndices
{
    ConfidenceBand first;
    ConfidenceBand total;
};

struct Sensitivity
{
    std::vector<SobolIndices> variables; // empty when less than two blocks are whole
    std::size_t blocks = 0;              // whole ones
    std::size_t leftOut = 0;             // blocks of which a point is missing or has no number
    double mean = 0.0;
    double variance = 0.0;
};

//   values  [blocks][variables + 2], not a number where it is not known
Sensitivity sensitivityOf(const std::vector<double>& values, std::size_t variables);

} // namespace ripstop
