// The memory of a system that nobody runs any more, kept for the next one.
//
// To get a hundred megabytes from the operating system takes as long as to compile 600 000 links
// into them; LiveSystem (compile/live_system.h) therefore compiles each system into the memory of
// one before. take() is for one thread. What it gives may be let go on any thread, also after the
// SystemMemory itself is gone.
#pragma once

#include "system/system.h"

#include <memory>

namespace ripstop {

class SystemMemory
{
public:
    // An empty system, in the memory of the spare one if there is any. When its last owner lets it
    // go, its memory becomes the spare one in place of any other.
    std::shared_ptr<System> take();

private:
    struct Store;
    std::shared_ptr<Store> m_store;
};

} // namespace ripstop
