#pragma once

namespace ripstop {

// What arrows stand on the elements.
enum class Vectors { None, Velocity, PanelLoad, Tension };

} // namespace ripstop
