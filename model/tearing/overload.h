// What is above its limit, and the order in which such things break.
#pragma once

namespace ripstop {

// How far: the length, strain, force, pull or moment over the limit.
struct Overload
{
    enum class Of { Link, Panel, Spar };

    int element;  // index into System::links, System::membranes or BendLists::ofSpars()
    double ratio; // 1
    Of of = Of::Link;
};

// Links before panels before spars, each as they are numbered; of spars the worst first.
inline bool inOrder(const Overload& one, const Overload& other)
{
    if (one.of != other.of)
        return one.of < other.of;
    if (one.of == Overload::Of::Spar && one.ratio != other.ratio)
        return one.ratio > other.ratio;
    return one.element < other.element;
}

inline bool worstFirst(const Overload& one, const Overload& other)
{
    return one.ratio != other.ratio ? one.ratio > other.ratio : inOrder(one, other);
}

} // namespace ripstop
