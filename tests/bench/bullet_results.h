// The head of the results of programs that run beside Bullet: the machine, and which Bullet it was.
#pragma once

#include "bench/report.h"

#include <LinearMath/btScalar.h>

namespace ripstop {

inline Json resultsBesideBullet()
{
    return {{"machine", machine()},
            {"bullet", std::to_string(BT_BULLET_VERSION)},
            {"bullet_precision", sizeof(btScalar) == 4 ? "single" : "double"},
            {"rows", Json::array()}};
}

} // namespace ripstop
