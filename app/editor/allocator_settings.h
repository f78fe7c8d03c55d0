// Has the heap give memory back to the system while the editor runs.
//
// The allocator of glibc keeps at the top of each thread's arena twice the largest block that was
// ever freed by itself, up to 64 MB (malloc(3), mallopt(3): the dynamic threshold). The editor has
// a dozen threads: hours after a large design was closed they would still hold what it took. Where
// there is no glibc this does nothing.
#pragma once

namespace ripstop {

void setUpAllocator(); // at the start of the program

} // namespace ripstop
