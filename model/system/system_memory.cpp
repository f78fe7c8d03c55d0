#include "system/system_memory.h"

#include <mutex>
#include <utility>

namespace ripstop {

struct SystemMemory::Store
{
    std::mutex mutex;
    std::unique_ptr<System> spare; // guarded by mutex
};

std::shared_ptr<System> SystemMemory::take()
{
    if (!m_store)
        m_store = std::make_shared<Store>();
    std::unique_ptr<System> system;
    {
        const std::lock_guard lock(m_store->mutex);
        system = std::move(m_store->spare);
    }
    if (!system)
        system = std::make_unique<System>();
    return {system.release(), [store = m_store](System* done) {
                std::unique_ptr<System> spare(done);
                clear(*spare);
                const std::lock_guard lock(store->mutex);
                store->spare.swap(spare); // the one before dies after the lock is released
            }};
}

} // namespace ripstop
