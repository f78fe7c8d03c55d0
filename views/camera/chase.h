// Lets the camera go along with the fabric in flight, so that it stays where it is in the picture.
#pragma once

#include "camera/camera.h"
#include "run/frame.h"

#include <optional>

namespace ripstop {

class Chase
{
public:
    bool isOn() const { return m_on; }

    // From `now` on, which may be null.
    void set(bool on, const Frame* now);
    void forget() { m_last.reset(); } // another scene: the camera does not go there by itself
    void settle(const Frame* now);    // the camera has been placed for this frame

    // `before` is the frame that was shown before, or null. What an author does to a design at rest
    // is to be seen against the ground, so the camera stays then.
    void move(Camera& camera, const Frame& frame, const Frame* before);

private:
    bool m_on = true;
    std::optional<Vec3> m_last; // m, where the middle of the fabric was
};

} // namespace ripstop
