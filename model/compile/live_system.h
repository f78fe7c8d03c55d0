// A scene that follows edits, and what a running simulation needs to know of each.
//
// It keeps a scene of its own and an index of it. Edits that only set values become a Patch, which
// names what they touched; edits that add, remove or join things become a new System. What is
// noted stays noted until an update succeeds, so a scene may be broken for a while.
#pragma once

#include "compile/design.h"
#include "compile/patch.h"
#include "scene/check.h"
#include "scene/edit.h"
#include "system/moment.h"
#include "system/system_memory.h"

#include <memory>
#include <variant>

namespace ripstop {

// Either what to run from now on, or what to change in it.
struct Update
{
    std::shared_ptr<const System> system; // null when there is a patch
    std::shared_ptr<const Patch> patch;
    Design design = {};                        // that this comes from, where someone keeps it
    std::shared_ptr<const Moment> moment = {}; // the run begins there; null: at the start
};

class LiveSystem
{
public:
    explicit LiveSystem(Scene scene = {});

    const Scene& scene() const { return m_scene; }

    void replace(Scene scene);
    void apply(const Edit& edit);

    // All that has changed since the last update; the first one is a whole system. Whoever
    // runs it must be given every update in order.
    std::variant<Update, Finding> update(std::uint64_t generation, std::uint64_t run);

private:
    struct Noted // since the last update
    {
        bool structure = true; // a new system is due
        bool settings = false;
        bool wind = false;
        bool obstacles = false;
        bool fabricLayers = false;
        bool inputs = false;
        bool probes = false;
        std::vector<Id> materials;
        std::vector<Id> particles;
        std::vector<Id> links;
        std::vector<Id> panels;
    };

    void note(const SetValues& change);
    bool isSound() const;
    Patch patch() const;
    void patchLink(Id id, Patch& patch) const;
    void patchPanel(Id id, Patch& patch) const;

    Scene m_scene;
    ElementIndex m_index; // of the scene when m_noted.structure is false
    Noted m_noted;
    SystemMemory m_memory;
};

} // namespace ripstop
