// A range of colours that follows the values without flicker.
//
// Its ends are short numbers, at most half again as far as the values go. It widens at once when
// values leave it, and narrows only after they have stayed far inside for two seconds of the run or
// 120 frames, which are two seconds of a quick machine; a slow one, or a slow motion, shows fewer
// or more of them. Of many values the largest few are let go: a panel where a bridle pulls, or a
// link about to tear, would otherwise paint all others alike. Arrows take their scale from such a
// range, too.
#pragma once

#include <span>
#include <vector>

namespace ripstop {

struct ValueRange
{
    double low = 0.0;
    double high = 1.0;

    friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

class SteadyRange
{
public:
    static constexpr double fewest = 0.005; // one of 200 lies beyond

    // Takes in the values of one frame. `mayBeNegative` makes the range symmetric about zero once
    // a good part of the values is below it, and keeps it so. `beyond` is the share of the values
    // that may lie beyond an end; 0 takes in the largest. Zeros do not count there, as most are of
    // elements that do not have the quantity. `elapsed` is the time of the run since the last
    // frame, s.
    void take(std::span<const double> values, bool mayBeNegative, double beyond = fewest,
              double elapsed = 0.0);

    ValueRange range() const;
    void reset() { *this = {}; }

private:
    std::vector<double> m_scratch;
    double m_bound = 0.0; // 0 before any value
    double m_calm = 0.0;  // frames since the values last filled the range
    bool m_symmetric = false;
};

// The smallest of ..., 0.1, 0.2, 0.5, 1, 2, 5, 10, ... that is not below `value`; 0 for 0.
double roundedUp(double value);

} // namespace ripstop
