#include "system/system.h"

#include "system/fields.h"

namespace ripstop {
namespace {

// Arrays are emptied and keep their memory; anything else becomes what it is in `fresh`.
template <typename T>
void renew(std::vector<T>& values, const std::vector<T>&)
{
    values.clear();
}

template <typename T>
void renew(T& value, const T& fresh)
{
    if constexpr (HasFields<T>)
        forEachField<T>([&](auto field) { renew(field.of(value), field.of(fresh)); });
    else
        value = fresh;
}

} // namespace

void clear(System& system) { renew(system, System()); }

bool operator==(const System& a, const System& b) { return differingField(a, b).empty(); }

} // namespace ripstop
