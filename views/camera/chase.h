// Lets the camera go along with the fabric in flight, so that it stays where it is in the picture.
//
// The middle of the fabric (of all particles where there are no panels) is noted with each frame,
// and the focus of the camera is shifted by as much as that has moved since the frame before. Of
// fabric that has torn, the large pieces count. The person keeps turning and zooming as before. The
// viewport has one of these and calls it for each frame that it shows.
#pragma once

#include "camera/camera.h"
#include "simulation/frame.h"

#include <optional>

namespace ripstop {

// Whether another run has begun since the frame `before`.
bool beginsAnew(const Frame& frame, const Frame& before);

class Chase
{
public:
    bool isOn() const { return m_on; }

    // Switches the camera to follow or to stay, from the frame `now` on, which may be null.
    void set(bool on, const Frame* now);
    void forget() { m_last.reset(); } // another scene: the camera does not go there by itself
    void settle(const Frame* now);    // the camera has been placed for this frame

    const std::optional<Vec3>& middle() const { return m_last; } // m, of what it follows

    // `before` is the frame that was shown before, or null. What an author does to a design at rest
    // is to be seen against the ground, so the camera stays then, and so it does where something
    // comes into a run or goes out of it; it goes along where the run begins anew. What comes down
    // does not draw eye or focus through the `ground` below the eye, m, but is seen from above, and
    // as before when it rises again or the run begins anew.
    void move(Camera& camera, const Frame& frame, const Frame* before, double ground);

private:
    // What the ground has added to a camera that came down to it. It is taken off again, unless
    // somebody has moved the camera since.
    struct Lift
    {
        double focus = 0.0;         // m, upwards
        double elevation = 0.0;     // rad
        Vec3 left = Vec3::Zero();   // m, the focus as this has left it
        double leftElevation = 0.0; // rad
    };
    void takeOff(Camera& camera);
    void keepAbove(Camera& camera, double ground, double lowest, double above);

    bool m_on = true;
    Lift m_lift;
    std::optional<Vec3> m_last; // m, where the middle of the fabric was
};

} // namespace ripstop
