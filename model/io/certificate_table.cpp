#include "io/certificate_table.h"

#include "io/csv.h"
#include "io/json_text.h"

#include <cmath>

namespace ripstop {

std::string certificateTable(const Certificate& certificate)
{
    const auto heading = [](const std::string& name, const std::string& unit) {
        return ',' + csvCell(withUnit(name, unit));
    };
    std::string text = "time (s)";
    for (const CertifiedProbe& probe : certificate.probes)
        text += heading(probe.name, probe.unit) + heading(probe.name + " error", probe.unit);
    text += '\n';
    for (std::size_t k = 0; k < certificate.time.size(); ++k) {
        appendNumber(text, certificate.time[k]);
        for (const CertifiedProbe& probe : certificate.probes)
            for (const double number : {probe.value[k], probe.error[k]}) {
                text += ',';
                if (std::isfinite(number))
                    appendNumber(text, number);
            }
        text += '\n';
    }
    return text;
}

} // namespace ripstop
