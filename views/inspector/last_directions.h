// Which way vectors pointed before they were made 0.
//
// A slider sets the length of a vector, and 0 has no direction: without this, the way back from 0
// would lead along an axis. Every slider notes what it shows, so that a vector comes back as it
// was, also where another slider took it to 0. Forgotten with the scene, as no id means the same in
// another one.
#pragma once

#include "scene/property.h"

#include <map>
#include <utility>

namespace ripstop {

class LastDirections
{
public:
    void note(const Property& property, Id id, const Value& value) // 0 is not noted
    {
        if (const Vec3* vector = std::get_if<Vec3>(&value); vector && !vector->isZero(0.0))
            m_last[{&property, id}] = *vector;
    }

    // The last vector that was not 0. Of one that has always been 0 the default, which lets gravity
    // pull down, or else x; never 0.
    Vec3 of(const Property& property, Id id) const
    {
        if (const auto found = m_last.find({&property, id}); found != m_last.end())
            return found->second;
        const Vec3* usual = std::get_if<Vec3>(&property.initial);
        return usual && !usual->isZero(0.0) ? *usual : Vec3(Vec3::UnitX());
    }

    void forget() { m_last.clear(); }

private:
    std::map<std::pair<const Property*, Id>, Vec3> m_last;
};

} // namespace ripstop
