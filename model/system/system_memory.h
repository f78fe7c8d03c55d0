#pragma once

#include "system/system.h"

#include <memory>

namespace ripstop {

// The memory of a system that nobody runs any more, kept for the next one: to get a hundred
// megabytes from the operating system takes as long as to compile 600 000 links into them. Systems
// may be let go on any thread, and after the store is gone.
class SystemMemory
{
public:
    // A system as it starts. What memory it has comes back when its last owner lets it go; one
    // that is spare is kept.
    std::shared_ptr<System> take();

private:
    struct Store;
    std::shared_ptr<Store> m_store;
};

} // namespace ripstop
