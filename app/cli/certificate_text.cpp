#include "cli/certificate_text.h"

#include "io/csv.h"

#include <cstdio>

namespace ripstop {

void printTable(const Certificate& certificate)
{
    std::printf("%-24s %14s %12s %7s %6s  %s\n", "probe", "value", "error", "digits", "order",
                "judged by");
    for (const CertifiedProbe& probe : certificate.probes) {
        const Convergence& result = probe.result;
        const std::string name = withUnit(probe.name, probe.unit);
        char order[16] = "-";
        if (result.converges())
            std::snprintf(order, sizeof order, "%.1f", result.order);
        std::printf("%-24s %14.8g %12.2g %7d %6s  %s\n", name.c_str(), result.value[0],
                    result.error, result.digits, order,
                    probe.ofMean ? "the mean of the second half" : "the last value");
    }
    std::fflush(stdout);
}

Json jsonOf(const Certificate& certificate)
{
    Json probes = Json::array();
    for (const CertifiedProbe& probe : certificate.probes) {
        const Convergence& result = probe.result;
        probes.push_back({{"name", probe.name},
                          {"unit", probe.unit},
                          {"of_mean", probe.ofMean},
                          {"value", result.value[0]},
                          {"half", result.value[1]},
                          {"quarter", result.value[2]},
                          {"limit", result.limit},
                          {"error", result.error},
                          {"order", result.order},
                          {"digits", result.digits}});
    }
    return {{"seconds", certificate.seconds}, {"probes", std::move(probes)}};
}

} // namespace ripstop
