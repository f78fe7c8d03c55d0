// The scene that a system was compiled from, cheap to keep: a scene that many of them share, and
// the edits since. A design is a value that may go to any thread, as what it shares is constant;
// the log belongs to the thread that follows the scene (views/document/follower.h).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace ripstop {

struct Edit;  // scene/edit.h
struct Scene; // scene/scene.h

struct Design
{
    std::shared_ptr<const Scene> base; // null when there is none
    std::vector<std::shared_ptr<const Edit>> edits;

    Scene scene() const; // a copy; there has to be a base
};

// Follows a scene that is edited.
class DesignLog
{
public:
    void replace() { m_design = {}; }
    void apply(const Edit& edit);

    // `scene` is what the log has followed. Copies it when there is nothing to build on, or when
    // the edits weigh more than the scene does.
    const Design& design(const Scene& scene);

private:
    Design m_design;
    std::size_t m_weight = 0; // values in the edits
};

} // namespace ripstop
