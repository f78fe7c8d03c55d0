// followed() says which panels count, middleOf() where these are. move() compares the middle of the
// same panels in the frame before and in this one, so that what comes off in between does not pull
// at the camera; where a run begins anew, it compares with what was followed last.
#include "camera/chase.h"

#include "base/joined_sets.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double leastRise = 0.2; // of its distance, of an eye over ground that it comes down to

// [panels] Which of them the camera goes along with: all that are there, and where something has
// torn those of the largest piece and of others that are at least half as large, such as the halves
// of a sheet. Shreds that drift away would draw it into the empty air between them and the rest.
std::vector<std::uint8_t> followed(const Frame& frame)
{
    const Layout& layout = *frame.layout;
    std::vector<std::uint8_t> panels(frame.gone.size());
    std::ranges::transform(frame.gone, panels.begin(), [](auto gone) { return gone == 0; });
    if (frame.tears.empty())
        return panels;
    JoinedSets pieces(frame.position.size());
    for (std::size_t i = 0; i < panels.size(); ++i)
        if (const auto& corner = layout.panelCorners[i]; panels[i]) {
            pieces.join(corner[0], corner[1]);
            pieces.join(corner[1], corner[2]);
        }
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        if (!frame.torn[i])
            pieces.join(layout.links[i].a, layout.links[i].b);
    std::vector<int> size(frame.position.size()); // of each piece, panels
    const auto sizeOf = [&](std::size_t panel) -> int& {
        return size[std::size_t(pieces.of(layout.panelCorners[panel][0]))];
    };
    for (std::size_t i = 0; i < panels.size(); ++i)
        sizeOf(i) += panels[i];
    const int largest = size.empty() ? 0 : std::ranges::max(size);
    for (std::size_t i = 0; i < panels.size(); ++i)
        panels[i] = panels[i] && 2 * sizeOf(i) >= largest;
    return panels;
}

// What a following camera keeps in place: the middle of these panels, or of the network where
// there are none.
Vec3 middleOf(const Frame& frame, const std::vector<std::uint8_t>& panels)
{
    Vec3 sum = Vec3::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < panels.size(); ++i)
        if (panels[i])
            for (const int particle : frame.layout->panelCorners[i]) {
                sum += frame.position[std::size_t(particle)];
                count += 1.0;
            }
    for (std::size_t i = 0; count == 0.0 && i < frame.position.size(); ++i)
        sum += frame.position[i] / double(frame.position.size());
    return count > 0.0 ? Vec3(sum / count) : sum;
}

// Whether an edit has brought or taken what the middle is of: that has jumped then, and not flown.
// Particles that a tear has doubled are no others, as panels keep their ids.
bool areOthers(const Frame& frame, const Frame& before)
{
    const Layout &now = *frame.layout, &then = *before.layout;
    return &now != &then
           && (now.panelId != then.panelId
               || (now.panelId.empty() && now.particleId != then.particleId));
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
        m_last = middleOf(*now, followed(*now));
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
    const std::vector<std::uint8_t> panels = followed(frame);
    const Vec3 middle = middleOf(frame, panels);
    if (!m_on || !middle.allFinite())
        return;
    const bool isShaped =
        frame.step == 0 && before && before->step == 0 && frame.generation != before->generation;
    const bool isAnew = before && beginsAnew(frame, *before);
    const bool isOther = before && areOthers(frame, *before);
    if (m_last && !isShaped && (isAnew || !isOther)) {
        const double above = camera.eye().y() - ground; // a person may have chosen a low place
        const double lowest = std::min(camera.focus.y(), ground);
        takeOff(camera);
        // what has come off in between has not moved the rest
        const bool goesOn = before && !isAnew && !isOther;
        camera.focus += middle - (goesOn ? middleOf(*before, panels) : *m_last);
        if (std::isfinite(ground))
            keepAbove(camera, ground, lowest, above);
    }
    m_last = middle;
}

} // namespace ripstop
