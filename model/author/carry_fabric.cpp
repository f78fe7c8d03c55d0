// Seams counts what lies beside each link before it says which go; panelsCarry() chooses the way
// for each part.
#include "author/carry_fabric.h"

#include "derived/panel_fabric.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ripstop {
namespace {

using SeamEnds = std::pair<Id, Id>; // of a link or of a side, the lower id first

SeamEnds seamEnds(Id a, Id b) { return {std::min(a, b), std::max(a, b)}; }

bool isMadeOf(const Part& part, const std::vector<Id>& materials)
{
    return std::ranges::any_of(part.panels, [&](const Panel& panel) {
        return std::ranges::count(materials, panel.material) > 0;
    });
}

// The links that what panels carry takes the place of.
class Seams
{
public:
    Seams(const Scene& scene, const Part& part)
        : m_scene(scene)
    {
        for (const Panel& panel : part.panels) {
            const bool carries = isCarrying(panel.material);
            for (const SeamEnds& side : {seamEnds(panel.a, panel.b), seamEnds(panel.b, panel.c),
                                         seamEnds(panel.c, panel.a)}) {
                Beside& beside = m_sides[side];
                ++beside.panels;
                beside.carrying += carries ? 1 : 0;
            }
        }
        for (const Link& link : part.links) {
            Uses& count = m_counts[link.material];
            ++count.links;
            count.between += isBetween(link) ? 1 : 0;
        }
        for (const Link& link : part.links)
            if (isBetween(link) && isOfSeams(link.material) && allCarry(link))
                links.push_back(link.id);
    }

    std::vector<Id> links;

private:
    struct Beside
    {
        int panels = 0;
        int carrying = 0; // of them, those whose material has a membrane stiffness
    };
    struct Uses
    {
        std::size_t links = 0;
        std::size_t between = 0; // two panels
    };

    bool isCarrying(Id id) const
    {
        const Material* material = findItem<Material>(m_scene, id);
        return material && material->membraneStiffness;
    }
    bool isBetween(const Link& link) const
    {
        const auto side = m_sides.find(seamEnds(link.from, link.to));
        return side != m_sides.end() && side->second.panels > 1;
    }
    bool allCarry(const Link& link) const
    {
        const Beside& side = m_sides.at(seamEnds(link.from, link.to));
        return side.carrying == side.panels;
    }
    bool isOfSeams(Id id) const
    {
        const Material* material = findItem<Material>(m_scene, id);
        const Uses& count = m_counts.at(id);
        return material && !material->axialStiffness && material->flexuralRigidity == 0.0
               && 2 * count.between >= count.links;
    }

    const Scene& m_scene;
    std::map<SeamEnds, Beside> m_sides;
    std::map<Id, Uses> m_counts;
};

} // namespace

Result<Edit> panelsCarry(const Scene& scene, const std::vector<Id>& materials)
{
    for (const Id id : materials)
        if (const Material* material = findItem<Material>(scene, id);
            material && !material->membraneStiffness)
            return Failure("%1 has no membrane stiffness that panels could carry: give it one "
                           "first, in N/m, or the numbers of a fabric of the library.",
                           material->name);
    std::vector<Id> threaded;
    SetValues carrier{&propertyOf<&Part::carrier>(),
                      {},
                      {std::string(choiceNames<FabricKind>[std::size_t(FabricKind::Panels)])}};
    std::vector<Id> seams;
    forEachPart(scene, [&](Id id, const Part& part) {
        if (!isMadeOf(part, materials))
            return;
        if (std::ranges::any_of(part.links, isOfFabric)) {
            threaded.push_back(id);
        } else if (part.carrier != FabricKind::Panels) {
            carrier.targets.push_back(id);
            const std::vector<Id> links = Seams(scene, part).links;
            seams.insert(seams.end(), links.begin(), links.end());
        }
    });
    if (!threaded.empty()) { // what names their threads changes, so they go by themselves
        Result<PanelFabric> made = carriedByPanels(scene, threaded);
        return made ? Result<Edit>(std::move(made->edit)) : Result<Edit>(made.failure());
    }
    if (carrier.targets.empty())
        return Failure("There is no panel of this material that could carry its pull.");
    std::ranges::sort(seams);
    Edit edit = seams.empty() ? Edit() : removal(scene, seams);
    edit.label = Message("Panels carry the fabric");
    edit.changes.emplace_back(std::move(carrier));
    return edit;
}

} // namespace ripstop
