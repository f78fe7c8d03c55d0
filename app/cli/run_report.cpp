// The report of a run as JSON; then the table and the profile that are printed of it.
#include "cli/run_report.h"

#include "base/hash_text.h"
#include "base/key_index.h"
#include "check/strength_gaps.h"
#include "derived/gust_now.h"
#include "measure/diagnostics.h"
#include "run/end_check.h"
#include "run/has_margins.h"
#include "run/tear_events.h"
#include "run/tear_report.h"
#include "simulation/damping_percent.h"
#include "study/probe_names.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace ripstop {
namespace {

// The law of panels is of small strains. Pulled to one that is not, Green's strain, e + e^2 / 2,
// along a length that has grown, 1 + e, makes more of it than E t e. Null below.
Json largeStrainOf(double strain)
{
    constexpr double large = 0.05;
    if (!(strain > large))
        return nullptr;
    return {{"strain", strain}, {"pull_over_linear", (1.0 + strain) * (1.0 + 0.5 * strain)}};
}

const char* elementKind(const Tear& tear, const Frame& frame)
{
    return isOfPanel(tear, *frame.layout) ? "panel" : "link";
}

const char* loadName(const Tear& tear, const Frame& frame)
{
    return isSnap(tear) ? "moment" : isOfPanel(tear, *frame.layout) ? "tension" : "force";
}

// What is left holds so many times what it bears now, if all its loads grow alike: its place that
// is nearest to breaking says it. Null where nothing that has a strength bears anything.
Json leftStrength(const Frame& frame)
{
    if (frame.worstNow.all().empty())
        return nullptr;
    const double margin = frame.worstNow.all()[0].margin();
    return {{"margin", margin}, {"holds", 1.0 / margin}};
}

// Of the design that was flown, as it was compiled.
PlaceInDesign placesIn(const System& compiled)
{
    KeyIndex index(compiled.key.size());
    for (std::size_t i = 0; i < compiled.key.size(); ++i)
        index.add(compiled.key[i], int(i));
    return [index = std::move(index), &compiled](std::uint32_t id) -> std::optional<Vec3> {
        const int place = index(id);
        if (place == KeyIndex::none)
            return std::nullopt;
        return compiled.start.position[std::size_t(place)];
    };
}

// By how much, 1, what broke first bore more than it holds, as what bears too much breaks at the
// end of a step. Null where it has no strength.
Json overStrength(const Frame& frame, const System& compiled)
{
    const std::span<const LoadedPlace> first = frame.firstBreaks.all();
    if (first.empty() || !(first[0].strength > 0.0))
        return nullptr;
    return std::max(0.0, first[0].margin() / compiled.safetyFactor - 1.0);
}

Json tearSummary(const Frame& frame, const System& compiled)
{
    const std::span<const Tear> tears = frame.tears;
    const TearReport report = tearReport(tears, *frame.layout, placesIn(compiled));
    Json result;
    result["count"] = report.count;
    result["energy"] = report.energy;
    result["first"] = nullptr;
    if (!tears.empty())
        result["first"] = {{"time", tears[0].time},
                           {elementKind(tears[0], frame), tears[0].element},
                           {loadName(tears[0], frame), tears[0].force},
                           {"over_strength", overStrength(frame, compiled)}};
    result["front"] = Json::array();
    for (const TearReport::Front& front : report.front)
        result["front"].push_back({{"time", front.time}, {"distance", front.distance}});
    result["events"] = Json::array();
    for (const TearEvent& event : tearEvents(tears, *frame.layout).all)
        result["events"].push_back(
            {{"begin", event.begin},
             {"end", event.end},
             {"count", event.count},
             {"energy", event.energy},
             {"first", event.first},
             {"place", {event.place.x(), event.place.y(), event.place.z()}}});
    result["left"] = leftStrength(frame);
    return result;
}

Json accuracyOf(const RunAccuracy& accuracy)
{
    return {{"reached", accuracy.pulls},
            {"wanted", accuracy.wantedPulls},
            {"strain", accuracy.strain},
            {"wanted_strain", accuracy.wantedStrain},
            {"missed", accuracy.missedShare()},
            {"worst",
             {{"factor", accuracy.worst},
              {"time", accuracy.worstTime},
              {"link", accuracy.worstLink > 0 ? Json(accuracy.worstLink) : Json(nullptr)}}},
            {"torn_in_missed", accuracy.tornUntrue},
            {"fastest_swing", accuracy.fastestSwing},
            {"numerical_damping", accuracy.damping},
            {"numerical_loss", accuracy.lost},
            {"met", accuracy.isMet()}};
}

Json placesOf(std::span<const LoadedPlace> listed)
{
    Json places = Json::array();
    for (const LoadedPlace& place : listed) {
        const bool isJudged = place.strength > 0.0;
        places.push_back({{"time", place.time},
                          {"kind", choiceNames<LoadKind>[std::size_t(place.kind)]},
                          {place.kind == LoadKind::Cloth ? "panel" : "link", place.element},
                          {"load", place.load},
                          {"strength", isJudged ? Json(place.strength) : Json(nullptr)},
                          {"unit", unitOf(place.kind)},
                          {"margin", isJudged ? Json(place.margin()) : Json(nullptr)},
                          {"torn", place.torn},
                          {"shortfall", place.shortfall},
                          {"at_least", place.isAtLeast()},
                          {"place", {place.place.x(), place.place.y(), place.place.z()}}});
    }
    return places;
}

// Null where nothing has a strength or a limit: then there is no margin to be near. What has torn
// as a whole has none any more, and a list of what tore.
Json loadsOf(const Frame& frame)
{
    if (!hasMargins(frame) && frame.worstOfRun.all().empty())
        return nullptr;
    return {{"moment", placesOf(frame.worstNow.all())},
            {"run", placesOf(frame.worstOfRun.all())},
            {"first_to_break", placesOf(frame.firstBreaks.all())}};
}

void printReportRow(const std::string& label, const std::string& text)
{
    std::cout << label << std::string(24 - std::min<std::size_t>(label.size(), 23), ' ') << text
              << '\n';
}

void printTearEvents(const Json& tears)
{
    constexpr std::size_t most = 5;
    const Json& events = tears["events"];
    printReportRow("events", std::to_string(events.size()));
    for (std::size_t i = 0; i < std::min(most, events.size()); ++i) {
        const Json& event = events[i];
        const long count = event["count"].get<long>();
        printReportRow("  from " + shortNumber(event["begin"]) + " s",
                       std::to_string(count) + (count == 1 ? " tear" : " tears") + " until "
                           + shortNumber(event["end"]) + " s, " + shortNumber(event["energy"])
                           + " J, the first in " + std::to_string(event["first"].get<long>()));
    }
    if (const Json& left = tears["left"]; !left.is_null())
        printReportRow("what is left holds", shortNumber(left["holds"]) + " times its load now");
}

// By the name of the group that has it alone, or by its id.
std::string particleName(const Landing& landing, const Scene& scene)
{
    const std::vector<Id> alone{Id{landing.particle}};
    for (const Entry& entry : scene.items)
        if (const Group* group = std::get_if<Group>(&entry.item); group && group->members == alone)
            return group->name;
    const Item* const part = findItem(scene, Id{landing.part});
    return "particle " + std::to_string(landing.particle)
           + (part ? " of " + nameOf(*part) : std::string());
}

void printLandings(const Json& landings)
{
    constexpr std::size_t most = 3;
    const auto rounded = [](const Json& number) { // to 1 cm and 1 cm/s; 0.0 in place of -0.0
        return shortNumber(std::round(100.0 * number.get<double>()) / 100.0 + 0.0);
    };
    for (std::size_t i = 0; i < std::min(most, landings.size()); ++i) {
        const Json& landing = landings[i];
        const Json& place = landing["place"];
        const double down = -landing["velocity"][1].get<double>();
        printReportRow(i == 0 ? "landed" : "",
                       rounded(landing["speed"]) + " m/s, " + rounded(down) + " m/s down, at "
                           + shortNumber(landing["time"])
                           + " s: " + landing["name"].get<std::string>() + " on "
                           + landing["collider"].get<std::string>() + ", at " + rounded(place[0])
                           + ", " + rounded(place[1]) + ", " + rounded(place[2]) + " m");
    }
    if (landings.size() > most)
        printReportRow("", "and " + std::to_string(landings.size() - most) + " more: --json");
}

std::string shortfallWords(const Json& place)
{
    const double percent = 100.0 * place["shortfall"].get<double>();
    return place["at_least"].get<bool>()
               ? ", or about " + Message::number("%.0f", percent).english() + " % more"
               : "";
}

void printWorstMargin(const Json& loads)
{
    if (loads.is_null())
        return;
    if (!loads["run"].empty()) {
        const Json& worst = loads["run"].front();
        const std::string kind = worst.contains("panel") ? "panel" : "link";
        const std::string unit = ' ' + worst["unit"].get<std::string>();
        printReportRow("worst margin",
                       shortNumber(worst["margin"]) + ": " + shortNumber(worst["load"]) + unit
                           + " of " + shortNumber(worst["strength"]) + unit + " in " + kind + ' '
                           + std::to_string(worst[kind].get<long>()) + " at "
                           + shortNumber(worst["time"]) + " s"
                           + (worst["torn"].get<bool>() ? ", torn" : "") + shortfallWords(worst));
    }
    std::string names;
    for (const Json& name : loads.value("without_strength", Json::array()))
        names += (names.empty() ? "" : ", ") + name.get<std::string>();
    if (!names.empty())
        printReportRow("without a strength", names);
    if (loads.contains("opening_safety_factor"))
        printReportRow("opening loads",
                       "of canopies are a third to two fifths below measured ones: "
                       "settings.safetyFactor="
                           + shortNumber(loads["opening_safety_factor"]) + " makes up for it");
}

} // namespace

Json runReport(const Simulation& simulation, double wallSeconds)
{
    const std::shared_ptr<const Frame> frame = simulation.frame();
    const State& state = simulation.state();
    const Energies energy = energies(simulation.system(), state);
    const auto largest = std::max_element(frame->strain.begin(), frame->strain.end());

    Json result;
    result["time"] = state.time;
    result["steps"] = state.step;
    result["substeps"] = frame->substeps;
    result["wall_seconds"] = wallSeconds;
    result["steps_per_second"] = wallSeconds > 0.0 ? double(state.step) / wallSeconds : 0.0;
    result["hash"] = hashText(stateHash(state));
    result["torn"] = tornElements(*frame);
    const double ofPanels = largestPanelStrain(simulation.system(), simulation.state());
    result["max_strain"] =
        std::max(largest == frame->strain.end() ? 0.0 : double(*largest), ofPanels);
    result["large_strain"] = largeStrainOf(ofPanels);
    result["accuracy"] = accuracyOf(frame->accuracy);
    result["energy"] = energy.total();
    result["energies"] = {
        {"kinetic", energy.kinetic}, {"potential", energy.potential}, {"elastic", energy.elastic}};
    result["probes"] = Json::object();
    const std::vector<std::string> names = distinctNames(frame->layout->probes);
    for (std::size_t i = 0; i < names.size(); ++i)
        result["probes"][names[i]] = frame->probe[i];
    result["tears"] = Json::array();
    for (const Tear& tear : frame->tears)
        result["tears"].push_back({{"time", tear.time},
                                   {elementKind(tear, *frame), tear.element},
                                   {"length", tear.length},
                                   {"strain", tear.strain},
                                   {loadName(tear, *frame), tear.force},
                                   {"energy", tear.energy},
                                   {"place", {tear.place.x(), tear.place.y(), tear.place.z()}}});
    result["tear_report"] = tearSummary(*frame, *simulation.compiled());
    result["loads"] = loadsOf(*frame);
    result["absurd"] = Json::array();
    for (const Message& one : absurdities(simulation))
        result["absurd"].push_back(one.english());
    result["stopped"] = simulation.trouble().has_value();
    if (simulation.trouble()) {
        result["message"] = simulation.trouble()->message.english();
        result["accuracy"]["met"] = false;
    }
    if (interrupted())
        result["interrupted"] = true;
    return result;
}

Json landingsOf(std::span<const Landing> landings, const Scene& scene)
{
    const auto named = [&](std::uint32_t id) {
        const Item* const item = findItem(scene, Id{id});
        return item ? nameOf(*item) : std::to_string(id);
    };
    Json all = Json::array();
    for (const Landing& landing : landings)
        all.push_back(
            {{"time", landing.time},
             {"part", named(landing.part)},
             {"collider", named(landing.collider)},
             {"particle", landing.particle},
             {"name", particleName(landing, scene)},
             {"place", {landing.place.x(), landing.place.y(), landing.place.z()}},
             {"speed", landing.speed()},
             {"velocity", {landing.velocity.x(), landing.velocity.y(), landing.velocity.z()}}});
    return all;
}

Json namesWithoutStrength(const Scene& scene)
{
    Json names = Json::array();
    for (const Id id : materialsWithoutStrength(scene))
        names.push_back(id == noId ? "what has no material" : nameOf(*findItem(scene, id)));
    return names;
}

void tellOpening(const Scene& scene, Json& result)
{
    if (!result["loads"].is_null() && understatesOpening(scene))
        result["loads"]["opening_safety_factor"] = openingSafetyFactor;
}

// What of a wind a run does not see, or goes on without; empty where there is nothing to say.
std::string missedOf(const Wind& wind, double end)
{
    if (wind.kind == WindKind::DiscreteGust && wind.onset >= end)
        return "blows its first gust at " + shortNumber(wind.onset)
               + " s, after the end of the run at " + shortNumber(end)
               + " s: take more seconds, or an earlier onset.";
    const bool isMeasured = wind.kind == WindKind::Measured && wind.velocities.size() > 1;
    if (isMeasured && wind.velocities.back()[0] < end)
        return "was measured until " + shortNumber(wind.velocities.back()[0])
               + " s, and the run goes on to " + shortNumber(end)
               + " s: from there it blows as it did then.";
    return {};
}

void tellWinds(const Scene& scene, Json& result)
{
    for (const Entry& entry : scene.items)
        if (const Wind* wind = std::get_if<Wind>(&entry.item))
            if (const std::string missed = missedOf(*wind, result["time"]); !missed.empty())
                warn("Wind " + wind->name + ' ' + missed);
    Json& first = result["tear_report"]["first"];
    if (first.is_null())
        return;
    if (const std::optional<GustNow> gust = gustNow(scene, first["time"]))
        first["gust"] = {{"wind", nameOf(*findItem(scene, gust->wind))},
                         {"number", gust->number},
                         {"peak", gust->peak}};
}

void tellUnjudged(Json names, Json& result)
{
    if (!result["loads"].is_null())
        result["loads"]["without_strength"] = std::move(names);
    else
        std::cerr << "No material of this scene has a strength for what it carries (lineStrength "
                     "of lines, warpStrength and weftStrength of cloth, breakingMoment of spars), "
                     "so that there are no margins: the table of loads has no rows.\n";
}

Json settlingOf(const Settling& end)
{
    return {{"still", end.outcome == Settling::Outcome::Still},
            {"speed", end.speed},
            {"goal", end.goal},
            {"seconds", end.since}};
}

Json profileOf(const StepTimes& times, double wallSeconds)
{
    Json profile;
    double left = wallSeconds;
    for (std::size_t i = 0; i < stepStageNames.size(); ++i) {
        profile.push_back({{"stage", stepStageNames[i]}, {"seconds", times.seconds[i]}});
        left -= times.seconds[i];
    }
    profile.push_back({{"stage", "watchdog and output"}, {"seconds", std::max(left, 0.0)}});
    return profile;
}

void printProfile(const Json& result)
{
    std::cout << "\nwhere the time went\n";
    for (const Json& row : result["profile"]) {
        char line[80];
        std::snprintf(line, sizeof line, "  %-22s%8.3f s %5.1f %%\n",
                      row["stage"].get<std::string>().c_str(), row["seconds"].get<double>(),
                      100.0 * row["seconds"].get<double>()
                          / std::max(result["wall_seconds"].get<double>(), 1e-9));
        std::cout << line;
    }
}

std::string gustWords(const Json& gust)
{
    return ", in gust " + std::to_string(gust["number"].get<long>()) + " of "
           + gust["wind"].get<std::string>() + ", which peaks at " + shortNumber(gust["peak"])
           + " m/s";
}

void printRunTable(const Json& result, const Layout& layout)
{
    printReportRow("time", shortNumber(result["time"]) + " s, "
                               + std::to_string(result["steps"].get<long>()) + " steps");
    printReportRow("wall time", shortNumber(result["wall_seconds"]) + " s, "
                                    + shortNumber(result["steps_per_second"]) + " steps/s");
    const Json& tears = result["tear_report"];
    const long torn = result["torn"].get<long>(), count = tears["count"].get<long>();
    printReportRow("torn", std::to_string(torn)
                               + (count > torn ? ", in " + std::to_string(count) + " tears" : ""));
    if (count > 0) {
        const Json& end = tears["front"].back();
        const Json& first = tears["first"];
        const std::string kind = first.contains("panel") ? "panel" : "link";
        printReportRow("first tear",
                       shortNumber(first["time"]) + " s, " + kind + ' '
                           + std::to_string(first[kind].get<long>())
                           + (first.contains("gust") ? gustWords(first["gust"]) : std::string()));
        constexpr double worthAWord = 0.02;
        if (const Json& over = first["over_strength"]; over.is_number() && over > worthAWord)
            printReportRow("", "it bore "
                                   + Message::number("%.2g", 100.0 * over.get<double>()).english()
                                   + " % more than it holds, by which the load rose within a time "
                                     "step: a shorter one tells it closer");
        printReportRow("tears reach", shortNumber(end["distance"])
                                          + " m from there in the design, at "
                                          + shortNumber(end["time"]) + " s");
        printReportRow("energy they released", shortNumber(tears["energy"]) + " J");
        printTearEvents(tears);
    }
    printWorstMargin(result["loads"]);
    printLandings(result["landings"]);
    if (result.contains("settled")) {
        const Json& end = result["settled"];
        const bool still = end["still"].get<bool>();
        printReportRow(still ? "settled after" : "not settled after",
                       shortNumber(end["seconds"]) + " s; the fastest particle "
                           + (still ? "has " : "had ") + shortNumber(end["speed"]) + " m/s"
                           + (still ? "" : " in the last half swing"));
    }
    printReportRow("largest strain", shortNumber(result["max_strain"]) + " at the end");
    const auto percent = [](double share) { return shortNumber(100.0 * share) + " %"; };
    if (const Json& large = result["large_strain"]; !large.is_null())
        printReportRow("", "panels stretched by " + percent(large["strain"]) + " pull "
                               + percent(large["pull_over_linear"].get<double>() - 1.0)
                               + " more than E t times that: their law is of small strains");
    const Json& accuracy = result["accuracy"];
    printReportRow("error of pulls", percent(accuracy["reached"]) + ", wanted "
                                         + percent(accuracy["wanted"]) + "; missed in "
                                         + percent(accuracy["missed"]) + " of the steps");
    if (const double fastest = accuracy["fastest_swing"].get<double>(); fastest > 0.0)
        printReportRow("swings told truly", "up to " + Message::number("%.3g", fastest).english()
                                                + " Hz, frequency and height within 1 %");
    if (const double damping = accuracy["numerical_damping"].get<double>(); damping > 0.0)
        printReportRow("numerical damping",
                       dampingPercent(damping).english()
                           + " % of critical in the last 10 s, beside that of the design");
    printReportRow("energy", shortNumber(result["energy"]) + " J");
    printReportRow("hash", result["hash"].get<std::string>());
    const std::vector<std::string> names = distinctNames(layout.probes);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double value = result["probes"][names[i]].get<double>();
        printReportRow(names[i], (std::isfinite(value) ? shortNumber(value) : "none") + " "
                                     + layout.probes[i].unit);
    }
}

} // namespace ripstop
