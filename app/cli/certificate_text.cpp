#include "cli/certificate_text.h"

#include "io/csv.h"

#include <cmath>
#include <cstdio>
#include <iostream>

namespace ripstop {
namespace {

// Of what was found at every step: motion that the steps have damped away is off by nothing in the
// end, and was off before.
struct LargestError
{
    double error = Convergence::none;
    double time = 0.0; // s
};

LargestError largestError(const Certificate& certificate, const CertifiedProbe& probe)
{
    LargestError largest;
    for (std::size_t k = 0; k < probe.error.size(); ++k)
        if (!(probe.error[k] <= largest.error) && std::isfinite(probe.error[k]))
            largest = {probe.error[k], certificate.time[k]};
    return largest;
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
        const LargestError largest = largestError(certificate, probe);
        row(withUnit(probe.name, probe.unit), " %14.8g %12.2g %7d %6s %12.2g %9.3g  %s\n",
            result.value[0], result.error, result.digits, order, largest.error, largest.time,
            probe.ofMean ? "the mean of the second half" : "the last value");
    }
}

Json jsonOf(const Certificate& certificate)
{
    Json probes = Json::array();
    for (const CertifiedProbe& probe : certificate.probes) {
        const Convergence& result = probe.result;
        const LargestError largest = largestError(certificate, probe);
        probes.push_back({{"name", probe.name},
                          {"unit", probe.unit},
                          {"of_mean", probe.ofMean},
                          {"value", result.value[0]},
                          {"half", result.value[1]},
                          {"quarter", result.value[2]},
                          {"limit", result.limit},
                          {"error", result.error},
                          {"order", result.order},
                          {"digits", result.digits},
                          {"largest", {{"error", largest.error}, {"time", largest.time}}}});
    }
    return {{"seconds", certificate.seconds}, {"probes", std::move(probes)}};
}

} // namespace ripstop
