// The choice of what arrows stand on the elements of the view.
//
// The menus of the window choose one, and the vector layer draws the arrows.
#pragma once

namespace ripstop {

// What the arrows show: nothing, m/s of particles, N on panels, or N along links.
enum class Vectors { None, Velocity, PanelLoad, Tension };

} // namespace ripstop
