// What `ripstop-cli run` says of a run: one JSON object, from which the table is printed too.
#pragma once

#include "recording/landing_watch.h"
#include "simulation/simulation.h"
#include "step/step_times.h"
#include "terminal/terminal.h"

namespace ripstop {

Json runReport(const Simulation& simulation, double wallSeconds);
Json settlingOf(const Settling& end);

// `scene` says what things are called; it needs its items alone.
Json landingsOf(std::span<const Landing> landings, const Scene& scene);

// The materials that carry loads and have no strength for them, for a report of loads.
Json namesWithoutStrength(const Scene& scene);

// Puts them into the report; says it where there is nothing but them.
void tellUnjudged(Json names, Json& result);

// Puts into the report in which discrete gust the first tear was, and says it of one that begins
// after the end of the run and of a measured wind that ends before.
void tellWinds(const Scene& scene, Json& result);

// Puts into the loads which safety factor makes up for opening loads that are too low, if any are.
void tellOpening(const Scene& scene, Json& result);

// Seconds by stage; what is left of the wall time is the watchdog and what is written.
Json profileOf(const StepTimes& times, double wallSeconds);

void printRunTable(const Json& result, const Layout& layout);
void printProfile(const Json& result);

} // namespace ripstop
