#include "cli/certificate_text.h"

#include "io/csv.h"

#include <cstdio>
#include <iostream>

namespace ripstop {

void printTable(const Certificate& certificate)
{
    const auto row = [](const std::string& name, const char* pattern, auto... values) {
        char text[128];
        std::snprintf(text, sizeof text, pattern, values...);
        std::cout << name << std::string(name.size() < 24 ? 24 - name.size() : 0, ' ') << text;
    };
    row("probe", " %14s %12s %7s %6s  %s\n", "value", "error", "digits", "order", "judged by");
    for (const CertifiedProbe& probe : certificate.probes) {
        const Convergence& result = probe.result;
        char order[16] = "-";
        if (result.converges())
            std::snprintf(order, sizeof order, "%.1f", result.order);
        row(withUnit(probe.name, probe.unit), " %14.8g %12.2g %7d %6s  %s\n", result.value[0],
            result.error, result.digits, order,
            probe.ofMean ? "the mean of the second half" : "the last value");
    }
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
