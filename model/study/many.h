// Many runs at a time: what sweep and study share.
#pragma once

#include <cstddef>
#include <functional>

namespace ripstop {

// Calls work(i) for each i below `count` in order, `jobs` of them at a time, this thread being one.
// The first that returns false ends it: no other begins, and those under way are waited for.
void forEachOfMany(std::size_t count, int jobs, const std::function<bool(std::size_t)>& work);

} // namespace ripstop
