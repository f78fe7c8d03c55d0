// What no thread of a cloth pulls or stretches by more than, in a few operations: the law itself
// (cloth_law.h) takes a search where cloth wrinkles.
//
// Where the largest principal strain is e, the strain e in all directions is the strain there and
// what wrinkles could take up of it, so that the relaxed energy W is at most that of a taut cloth
// strained so, e^2 (warp + 2 coupling + weft) / 2. A tension of the energy W has no component
// beyond sqrt(2 W stiffness), and its threads no strain beyond sqrt(2 W compliance). A piece that
// buckles under a push pulls no more than one would that is strained by that in addition.
#pragma once

#include "laws/cloth_law.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

class ClothBound
{
public:
    ClothBound() = default;
    explicit ClothBound(const PieceLaw& law) // that is elastic
    {
        const double stiffest = std::max(law.warp, law.weft);
        const double softest = stiffest / (law.warp * law.weft - law.coupling * law.coupling);
        const double all = law.warp + 2.0 * law.coupling + law.weft;
        m_pullPerStrain = std::sqrt(stiffest * all);
        m_stretchPerStrain = std::sqrt(softest * all);
        const Vec3 buckling = strainOf(law, {law.bucklingLoad, law.bucklingLoad, 0.0});
        m_more = std::max(buckling[0], buckling[1]) - std::min({0.0, buckling[0], buckling[1]});
    }

    // N/m and 1, of threads; `strain` is the largest principal one, not negative.
    double pullAt(double strain) const
    {
        return (strain + m_more) * m_pullPerStrain * (1.0 + stretchAt(strain));
    }
    double stretchAt(double strain) const { return (strain + m_more) * m_stretchPerStrain; }

private:
    double m_pullPerStrain = 0.0; // N/m
    double m_stretchPerStrain = 0.0;
    double m_more = 0.0; // 1
};

} // namespace ripstop
