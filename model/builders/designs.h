// The rows of the table of builders, for builder.cpp alone, which puts them in order. Each stands
// in a source of its own, and the obstacles share one. Everybody else asks builder.h.
#pragma once

#include "builders/builder.h"

namespace ripstop {

extern const Builder bridleBuilder;
extern const Builder clothBuilder;
extern const Builder crossParachuteBuilder;
extern const Builder diamondKiteBuilder;
extern const Builder frameBuilder;
extern const Builder poleFlagBuilder;
extern const Builder rectangularKiteBuilder;
extern const Builder ropeBuilder;
extern const Builder hangGliderBuilder;
extern const Builder deltaKiteBuilder;
extern const Builder parachuteBuilder;
extern const Builder stiffenedRodBuilder;
extern const Builder bendingTestBuilder;
std::span<const Builder> obstacleBuilders();

} // namespace ripstop
