#include "simulation/damping_percent.h"

namespace ripstop {

Message dampingPercent(double damping)
{
    const double percent = 100.0 * damping;
    return percent > 100.0 ? Message("more than 100")
                           : Message::number(percent < 10.0 ? "%.2g" : "%.0f", percent);
}

} // namespace ripstop
