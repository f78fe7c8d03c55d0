// Wind over height, and in a jet.
#include "base/airflow.h"
#include "verify/sections.h"

#include <cmath>

namespace ripstop {
namespace {

// Speed at a height over that at 10 m.
double profile(WindKind kind, double height)
{
    Airflow flow;
    flow.kind = kind;
    flow.velocity = {5.0, 0.0, 0.0};
    return velocityAt(flow, {3.0, height, -2.0}).x() / 5.0;
}

} // namespace

std::vector<Case> windCases()
{
    std::vector<Case> cases;
    const double rows[][3] = {{2.0, 0.7229, 0.7946},
                              {20.0, 1.1193, 1.1041},
                              {50.0, 1.2771, 1.2585},
                              {100.0, 1.3964, 1.3895}};
    for (const auto& [height, log, power] : rows) {
        const std::string at = " at " + std::to_string(int(height)) + " m over that at 10 m";
        cases.push_back({"3.7", "wind over grass, log law," + at, log, within(0.5e-4), "",
                         "ln(z/z0) / ln(10/z0), z0 0.03 m",
                         [height = height] { return profile(WindKind::LogLaw, height); }});
        cases.push_back({"3.7", "wind, power law 1/7," + at, power, within(0.5e-4), "",
                         "(z/10)^(1/7)",
                         [height = height] { return profile(WindKind::PowerLaw, height); }});
    }
    return cases;
}

} // namespace ripstop
