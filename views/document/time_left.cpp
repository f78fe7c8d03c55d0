#include "document/time_left.h"

#include "document/words.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double leastTime = 2.0;   // s; what begins is slower or faster than what follows
constexpr double leastShare = 0.01; // 1
constexpr double longest = 90.0;    // s, that is said in seconds

} // namespace

double secondsLeft(double elapsed, double share)
{
    return elapsed < leastTime || share < leastShare
               ? std::numeric_limits<double>::quiet_NaN()
               : elapsed * (1.0 - std::min(share, 1.0)) / share;
}

QString timeLeftText(double seconds)
{
    if (!std::isfinite(seconds))
        return {};
    const auto whole = [](double amount) { return QLocale().toString(int(std::ceil(amount))); };
    return words("About %1 left.")
        .arg(seconds < longest ? words("%1 s").arg(whole(std::max(seconds, 1.0)))
                               : words("%1 min").arg(whole(seconds / 60.0)));
}

} // namespace ripstop
