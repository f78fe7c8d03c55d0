// Names of the enumerators that a design chooses from: integrators, air laws, quantities, ...
//
// Files, the command line and the screen use them, in the order of the enumerators. They are never
// renamed. Each enumeration stands with its names in the header of its topic (solver_laws.h,
// air_laws.h, link_laws.h, contact_laws.h, guide.h, control_kind.h, quantity.h, plot_axis.h,
// wind_kind.h), so that one more law is an edit of that header alone. All of it is constant: any
// thread may read it.
#pragma once

#include <array>
#include <string_view>

namespace ripstop {

// The names of an enumeration; empty for one that no design chooses from.
template <typename E>
inline constexpr std::array<std::string_view, 0> choiceNames{};

} // namespace ripstop
