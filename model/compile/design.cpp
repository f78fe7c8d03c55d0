#include "compile/design.h"

#include "scene/edit.h"

#include <algorithm>

namespace ripstop {
namespace {

struct Weight
{
    std::size_t operator()(const SetValues& change) const
    {
        return std::max(change.targets.size(), change.values.size());
    }
    std::size_t operator()(const AddRows& rows) const { return count(rows); }
    std::size_t operator()(const RemoveRows& rows) const { return count(rows); }
    template <typename Other>
    std::size_t operator()(const Other&) const
    {
        return 1;
    }

private:
    template <typename Rows>
    static std::size_t count(const Rows& rows)
    {
        return rows.particles.size() + rows.links.size() + rows.panels.size();
    }
};

std::size_t rowsOf(const Scene& scene)
{
    std::size_t rows = scene.items.size();
    forEachPart(scene, [&](Id, const Part& part) {
        rows += part.particles.size() + part.links.size() + part.panels.size();
    });
    return rows;
}

} // namespace

Scene Design::scene() const
{
    Scene scene = *base;
    for (const auto& edit : edits)
        (void)apply(scene, *edit);
    return scene;
}

void DesignLog::apply(const Edit& edit)
{
    if (!m_design.base)
        return; // the copy will have it
    m_design.edits.push_back(std::make_shared<const Edit>(edit));
    for (const Change& change : edit.changes)
        m_weight += std::visit(Weight(), change);
}

const Design& DesignLog::design(const Scene& scene)
{
    constexpr std::size_t fewest = 1000; // values; no small scene is copied for each edit
    if (!m_design.base || m_weight > std::max(fewest, rowsOf(scene))) {
        m_design = {std::make_shared<const Scene>(scene), {}};
        m_weight = 0;
    }
    return m_design;
}

} // namespace ripstop
