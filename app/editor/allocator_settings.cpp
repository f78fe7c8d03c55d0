#include "editor/allocator_settings.h"

#include <cstdlib> // says whether there is glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ripstop {

void setUpAllocator()
{
#ifdef __GLIBC__
    constexpr int keptAtTop = 4 << 20;   // bytes
    constexpr int ownMapping = 32 << 20; // the most there is, as asking the system takes long
    ::mallopt(M_TRIM_THRESHOLD, keptAtTop);
    ::mallopt(M_MMAP_THRESHOLD, ownMapping);
#endif
}

} // namespace ripstop
