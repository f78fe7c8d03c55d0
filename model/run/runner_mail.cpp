// What becomes of updates that wait when another one comes.
#include "run/runner_mail.h"

#include "compile/patch.h"
#include "simulation/simulation.h"

namespace ripstop {
namespace {

std::uint64_t runOf(const Update& update)
{
    return update.system ? update.system->run : update.patch->run;
}

} // namespace

void RunnerMail::putUpdate(Update update)
{
    std::vector<Update> replaced; // dies after the lock is released
    const std::lock_guard lock(m_mutex);
    if (update.system)
        m_updates.swap(replaced);
    for (const Update& before : replaced)
        if (!update.moment && before.moment && runOf(before) == runOf(update))
            update.moment = before.moment;
    m_updates.push_back(std::move(update));
}

} // namespace ripstop
