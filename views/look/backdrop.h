// What lies behind all that is drawn.
#pragma once

namespace ripstop {

enum class Backdrop {
    Scenery,    // sky and ground
    White,      // paper, with shadows on it where there is ground
    Transparent // nothing
};

} // namespace ripstop
