// vectorsOf() takes the arrows from the frame, every n-th when there are too many to be told apart.
// update() finds the scale: a steady range gives the value of the longest arrow, and the median
// distance of the tails from their midst gives its length, so that arrows neither flicker nor
// depend on one line that leads far away. Arrows that would be too short to be seen are left out.
#include "layers/vector_layer.h"

#include <vtkRenderer.h>

#include <algorithm>

namespace ripstop {
namespace {

constexpr std::size_t most = 3000;   // arrows
constexpr double longest = 0.4;      // of how far the tails spread
constexpr double negligible = 0.002; // of the longest

std::size_t strideOf(std::size_t count) { return count / most + 1; }

double median(std::vector<double>& values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Median distance of the tails from their midst, m. A long line to a kite does not count, as it
// would in a box around them all.
double spreadOf(const std::vector<VectorArrow>& arrows)
{
    std::vector<double> values(arrows.size());
    Vec3 midst;
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::transform(arrows, values.begin(),
                               [axis](const VectorArrow& arrow) { return arrow.place[axis]; });
        midst[axis] = median(values);
    }
    std::ranges::transform(arrows, values.begin(), [&midst](const VectorArrow& arrow) {
        return (arrow.place - midst).norm();
    });
    return median(values);
}

} // namespace

std::vector<VectorArrow> vectorsOf(const Frame& frame, Vectors vectors)
{
    std::vector<VectorArrow> arrows;
    const Layout& layout = *frame.layout;
    const auto place = [&](int particle) { return frame.position[std::size_t(particle)]; };
    switch (vectors) {
    case Vectors::None:
        break;
    case Vectors::Velocity:
        for (std::size_t i = 0; i < frame.velocity.size(); i += strideOf(frame.velocity.size()))
            arrows.push_back({frame.position[i], frame.velocity[i]});
        break;
    case Vectors::PanelLoad:
        for (std::size_t i = 0; i < frame.panelLoad.size(); i += strideOf(frame.panelLoad.size())) {
            const auto& [a, b, c] = layout.panelCorners[i];
            if (!frame.gone[i])
                arrows.push_back({(place(a) + place(b) + place(c)) / 3.0, frame.panelLoad[i]});
        }
        break;
    case Vectors::Tension:
        for (std::size_t i = 0; i < frame.tension.size(); i += strideOf(frame.tension.size())) {
            const Layout::Link& link = layout.links[i];
            if (frame.torn[i])
                continue;
            const Vec3 along = (place(link.b) - place(link.a)).normalized();
            arrows.push_back({place(link.a), frame.tension[i] * along});
            arrows.push_back({place(link.b), -frame.tension[i] * along});
        }
        break;
    }
    return arrows;
}

VectorLayer::VectorLayer() { m_arrows.actor().SetVisibility(false); }

void VectorLayer::setKind(Vectors kind)
{
    m_kind = kind;
    m_range.reset();
    m_arrows.actor().SetVisibility(kind != Vectors::None);
}

void VectorLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(&m_arrows.actor()); }

void VectorLayer::setShown(bool shown)
{
    m_arrows.actor().SetVisibility(shown && m_kind != Vectors::None);
}

void VectorLayer::rebuild(const Picture& picture)
{
    m_arrows.style(picture.theme.text, picture.pixelRatio);
}

void VectorLayer::update(const Picture& picture)
{
    if (m_kind == Vectors::None)
        return;
    const std::vector<VectorArrow> arrows = vectorsOf(picture.frame, m_kind);
    std::vector<double> sizes;
    for (const VectorArrow& arrow : arrows)
        sizes.push_back(arrow.value.norm());
    m_range.take(sizes, false);
    const double largest = m_range.range().high;
    m_arrows.clear();
    if (largest > 0.0 && !arrows.empty()) {
        const double scale = longest * spreadOf(arrows) / largest;
        for (std::size_t i = 0; i < arrows.size(); ++i)
            if (sizes[i] > negligible * largest)
                m_arrows.add(arrows[i].place, scale * arrows[i].value);
    }
    m_arrows.finish();
}

} // namespace ripstop
