#include "cli/certificate_text.h"

#include "io/csv.h"

#include <cmath>
#include <cstdio>
#include <iostream>

namespace ripstop {
namespace {

// Motion that the steps have damped away is off by nothing in the end, and was off before.
double largestError(const CertifiedProbe& probe)
{
    return probe.error.empty() ? Convergence::none : probe.error[probe.worstMoment()];
}

const char* judgedBy(const CertifiedProbe& probe)
{
    if (!probe.holdsItsCourse())
        return "its course, which does not hold";
    return probe.ofMean ? "the mean of the second half" : "the last value";
}

} // namespace

void printTable(const Certificate& certificate)
{
    const auto row = [](const std::string& name, const char* pattern, auto... values) {
        char text[128];
        std::snprintf(text, sizeof text, pattern, values...);
        std::cout << name << std::string(name.size() < 24 ? 24 - name.size() : 0, ' ') << text;
    };
    row("probe", " %14s %12s %7s %6s %12s %9s  %s\n", "value", "error", "digits", "order",
        "at most", "at s", "judged by");
    for (const CertifiedProbe& probe : certificate.probes) {
        const Convergence& result = probe.result;
        char order[16] = "-";
        if (result.converges())
            std::snprintf(order, sizeof order, "%.1f", result.order);
        row(withUnit(probe.name, probe.unit), " %14.8g %12.2g %7d %6s %12.2g %9.3g  %s\n",
            result.value[0], result.error, probe.digits(), order, largestError(probe),
            certificate.time[probe.worstMoment()], judgedBy(probe));
    }
}

Json jsonOf(const Certificate& certificate)
{
    Json probes = Json::array();
    for (const CertifiedProbe& probe : certificate.probes) {
        const Convergence& result = probe.result;
        probes.push_back(
            {{"name", probe.name},
             {"unit", probe.unit},
             {"of_mean", probe.ofMean},
             {"value", result.value[0]},
             {"half", result.value[1]},
             {"quarter", result.value[2]},
             {"limit", result.limit},
             {"error", result.error},
             {"order", result.order},
             {"digits", probe.digits()},
             {"course_holds", probe.holdsItsCourse()},
             {"largest",
              {{"error", largestError(probe)}, {"time", certificate.time[probe.worstMoment()]}}}});
    }
    return {{"seconds", certificate.seconds}, {"probes", std::move(probes)}};
}

} // namespace ripstop
