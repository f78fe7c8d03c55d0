#include "run/tear_report.h"

namespace ripstop {

TearReport tearReport(std::span<const Tear> tears)
{
    TearReport report;
    report.count = int(tears.size());
    for (const Tear& tear : tears) {
        report.energy += tear.energy;
        const double distance = (tear.place - tears[0].place).norm();
        if (report.front.empty() || distance > report.front.back().distance)
            report.front.push_back({tear.time, distance});
    }
    return report;
}

} // namespace ripstop
