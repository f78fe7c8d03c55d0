#include "camera/chase.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double leastRise = 0.2; // of its distance, of an eye over ground that it comes down to

// What a following camera keeps in place: the fabric, or the network where there is none.
Vec3 middleOf(const Frame& frame)
{
    Vec3 sum = Vec3::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < frame.gone.size(); ++i)
        if (!frame.gone[i])
            for (const int particle : frame.layout->panelCorners[i]) {
                sum += frame.position[particle];
                count += 1.0;
            }
    for (std::size_t i = 0; count == 0.0 && i < frame.position.size(); ++i)
        sum += frame.position[i] / double(frame.position.size());
    return count > 0.0 ? Vec3(sum / count) : sum;
}

// Whether an edit has brought or taken what the middle is of: that has jumped then, and not flown.
bool areOthers(const Frame& frame, const Frame& before)
{
    const Layout &now = *frame.layout, &then = *before.layout;
    return &now != &then && (now.panelId != then.panelId || now.particleId != then.particleId);
}

} // namespace

bool beginsAnew(const Frame& frame, const Frame& before)
{
    return before.run != frame.run && before.step > frame.step;
}

void Chase::set(bool on, const Frame* now)
{
    m_on = on;
    m_last.reset();
    settle(now);
}

void Chase::settle(const Frame* now)
{
    m_lift = {};
    if (m_on && now)
        m_last = middleOf(*now);
}

void Chase::takeOff(Camera& camera)
{
    if (camera.focus == m_lift.left && camera.elevation == m_lift.leftElevation) {
        camera.focus.y() -= m_lift.focus;
        camera.elevation -= m_lift.elevation;
    }
    m_lift = {};
}

// `lowest` bounds the focus, m, and `above` is how far the eye was above the ground, m.
void Chase::keepAbove(Camera& camera, double ground, double lowest, double above)
{
    const double focus = camera.focus.y();
    const double elevation = camera.elevation;
    camera.focus.y() = std::max(focus, lowest);
    camera.liftEye(ground + std::min(above, leastRise * camera.distance));
    m_lift = {camera.focus.y() - focus, camera.elevation - elevation, camera.focus,
              camera.elevation};
}

void Chase::move(Camera& camera, const Frame& frame, const Frame* before, double ground)
{
    const Vec3 middle = middleOf(frame);
    if (!m_on || !middle.allFinite())
        return;
    const bool isShaped =
        frame.step == 0 && before && before->step == 0 && frame.generation != before->generation;
    const bool isOther = before && areOthers(frame, *before) && !beginsAnew(frame, *before);
    if (m_last && !isShaped && !isOther) {
        const double above = camera.eye().y() - ground; // a person may have chosen a low place
        const double lowest = std::min(camera.focus.y(), ground);
        takeOff(camera);
        camera.focus += middle - *m_last;
        if (std::isfinite(ground))
            keepAbove(camera, ground, lowest, above);
    }
    m_last = middle;
}

} // namespace ripstop
