// A scene that follows edits, and what a running simulation needs to know of each.
//
// It keeps a scene of its own and an index of it. Edits that only set values become a Patch, which
// names what they touched; edits that add, remove or join things become a new System. What is
// noted stays noted until an update succeeds, so a scene may be broken for a while.
//
// One thread at a time may use it (in the editor that of views/document/follower.h); the updates
// that it hands out are constant and may go to any other.
#pragma once

#include "check/check.h"
#include "compile/update.h"
#include "scene/edit.h"

#include <cstdint>
#include <memory>
#include <variant>

namespace ripstop {

class LiveSystem
{
public:
    explicit LiveSystem(Scene scene = {});
    ~LiveSystem();

    const Scene& scene() const;

    void replace(Scene scene);
    void apply(const Edit& edit);

    // All that has changed since the last update; the first one is a whole system. Whoever
    // runs it must be given every update in order.
    std::variant<Update, Finding> update(std::uint64_t generation, std::uint64_t run);

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace ripstop
