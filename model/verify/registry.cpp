#include "verify/sections.h"

#include <iterator>

namespace ripstop {
namespace {

struct Section
{
    const char* title;
    std::vector<Case> (*cases)();
};

const Section sections[] = {
    {"Particles", particleCases},
    {"Integrators", integratorCases},
    {"Damping and step limits", dampingCases},
    {"Pendulum", pendulumCases},
    {"Rods", rodCases},
    {"Guides", guideCases},
    {"Softness of sweeps", softnessCases},
    {"Hanging rods", hangCases},
    {"Ropes", ropeCases},
    {"Cloth", clothCases},
    {"Materials", materialCases},
    {"Defaults of a new scene", defaultCases},
    {"Cables", lineCases},
    {"Cable nets and trusses", netCases},
    {"Elastic panels", membraneCases},
    {"Strips and frames of cloth", stripCases},
    {"Cloth under pressure", inflatedCases},
    {"Bending", bendingCases},
    {"Elastica", elasticaCases},
    {"Conservation and invariance", invarianceCases},
    {"Repeats", repeatCases},
    {"Contact", contactCases},
    {"Tearing", tearingCases},
    {"Breaking by strength", strengthCases},
    {"Air", airCases},
    {"Laws of the air", airLawCases},
    {"Wings", wingCases},
    {"Wind", windCases},
    {"Flight", flightCases},
    {"Canopies", canopyCases},
    {"Counts", countCases},
};

} // namespace

std::vector<Case> allCases()
{
    std::vector<Case> all;
    for (const Section& section : sections) {
        std::vector<Case> cases = section.cases();
        for (Case& one : cases)
            one.section = section.title;
        std::move(cases.begin(), cases.end(), std::back_inserter(all));
    }
    return all;
}

} // namespace ripstop
