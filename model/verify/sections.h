// The sections of cases (case.h), each of which stands in a file of its own, and what they share:
// names of choices, experiments that several rows read from, and the search for a limit. Adding a
// section is a function here and a row in registry.cpp.
#pragma once

#include "base/choice_names.h"
#include "verify/case.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ripstop {

std::vector<Case> particleCases();
std::vector<Case> integratorCases();
std::vector<Case> dampingCases();
std::vector<Case> pendulumCases();
std::vector<Case> rodCases();
std::vector<Case> guideCases();
std::vector<Case> softnessCases();
std::vector<Case> hangCases();
std::vector<Case> ropeCases();
std::vector<Case> clothCases();
std::vector<Case> materialCases();
std::vector<Case> defaultCases();
std::vector<Case> lineCases();
std::vector<Case> netCases();
std::vector<Case> membraneCases();
std::vector<Case> stripCases();
std::vector<Case> inflatedCases();
std::vector<Case> bendingCases();
std::vector<Case> elasticaCases();
std::vector<Case> invarianceCases();
std::vector<Case> repeatCases();
std::vector<Case> contactCases();
std::vector<Case> tearingCases();
std::vector<Case> strengthCases();
std::vector<Case> airCases();
std::vector<Case> airLawCases();
std::vector<Case> wingCases();
std::vector<Case> windCases();
std::vector<Case> flightCases();
std::vector<Case> canopyCases();
std::vector<Case> countCases();

template <typename E>
std::string nameOf(E choice)
{
    return std::string(choiceNames<E>[std::size_t(choice)]);
}

// An experiment that several rows read from. The first row that asks runs it; the result is kept
// for all copies of the function. One thread at a time may ask.
template <typename Make>
auto shared(Make make)
{
    using Made = decltype(make());
    return [make, held = std::make_shared<std::optional<Made>>()]() -> const Made& {
        if (!*held)
            held->emplace(make());
        return **held;
    };
}

// The largest value between `low` and `high` up to which something is `sound`, found by halving. It
// has to be sound at `low` and not at `high`.
template <typename Sound>
double limitOf(const Sound& sound, double low, double high, int halvings = 14)
{
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (sound(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace ripstop
