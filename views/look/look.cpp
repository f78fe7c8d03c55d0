// Directory finds the row of the scene for an id: rows of all parts are listed in ascending order
// of id, and as a layout asks in nearly the same order, most answers are the row after the last
// one.
//
// paintsOf() reads each material once. lookOf() then fills the arrays: particles (shown, weights),
// links, panels and their pictures, each by a walk over the layout. What the scene no longer has
// keeps the value "not shown".
//
// changesLook() asks the property of each change whether it shows; changes of structure always do.
#include "look/look.h"

#include "derived/fabric_picture.h"
#include "derived/flat_panel.h"
#include "derived/link_thickness.h"
#include "derived/tear_bounds.h"
#include "look/subject.h"
#include "scene/particle_of.h"
#include "select/elements.h"

#include <map>

#include <algorithm>
#include <charconv>

namespace ripstop {
namespace {

constexpr Color unknownColor{150, 150, 150};

// Where the elements of the scene are, by id. It is not an array indexed by id, as a file may
// number its three particles in the billions.
class Directory
{
public:
    struct Row
    {
        std::uint32_t id;
        std::uint32_t index; // in the table of its kind
        const Part* part;
    };

    explicit Directory(const Scene& scene)
    {
        forEachPart(scene, [this](Id, const Part& part) {
            add(part, part.particles);
            add(part, part.links);
            add(part, part.panels);
        });
        if (!std::ranges::is_sorted(m_rows, {}, &Row::id))
            std::ranges::sort(m_rows, {}, &Row::id);
    }

    const Row* find(std::uint32_t id)
    {
        // A layout is in the order of the tables: what is asked for mostly follows the last answer.
        if (m_next >= m_rows.size() || m_rows[m_next].id != id)
            m_next =
                std::size_t(std::ranges::lower_bound(m_rows, id, {}, &Row::id) - m_rows.begin());
        return m_next < m_rows.size() && m_rows[m_next].id == id ? &m_rows[m_next++] : nullptr;
    }

private:
    template <typename Element>
    void add(const Part& part, const std::vector<Element>& table)
    {
        for (std::uint32_t i = 0; i < table.size(); ++i)
            m_rows.push_back({std::uint32_t(table[i].id), i, &part});
    }

    std::vector<Row> m_rows; // ascending ids
    std::size_t m_next = 0;
};

struct Paint
{
    Color color = unknownColor;
    bool shown = true;
    const Material* tears = nullptr;
};

std::vector<std::pair<Id, Paint>> paintsOf(const Scene& scene)
{
    std::vector<std::pair<Id, Paint>> paints;
    for (const Entry& entry : scene.items)
        if (const Material* material = std::get_if<Material>(&entry.item))
            paints.push_back(
                {entry.id, {colorFromText(material->color), material->shown, material}});
    return paints;
}

Paint paintOf(const std::vector<std::pair<Id, Paint>>& paints, Id material)
{
    const auto found = std::ranges::find(paints, material, &std::pair<Id, Paint>::first);
    return found != paints.end() ? found->second : Paint{};
}

// From this share of the mass of its part on, a particle is drawn as a weight.
constexpr double heavyShare = 0.2;

double massOf(const Part& part)
{
    double sum = 0.0;
    for (const Particle& particle : part.particles)
        sum += particle.mass;
    return sum;
}

void lookAtParticles(const Scene& scene, Directory& directory, const Layout& layout, Look& look)
{
    const std::size_t count = layout.particleId.size();
    look.particleShown.assign(count, 0);
    look.isWeight.assign(count, 0);
    look.isBridle.assign(count, 0);
    std::map<const Part*, double> partMass;
    std::map<const Part*, std::vector<Id>> bridles;
    for (std::size_t i = 0; i < count; ++i) {
        const Directory::Row* row = directory.find(layout.particleId[i]);
        if (!row || row->index >= row->part->particles.size())
            continue;
        const Particle& particle = row->part->particles[row->index];
        look.particleShown[i] = row->part->shown;
        const auto [mass, isNew] = partMass.try_emplace(row->part, 0.0);
        if (isNew) {
            mass->second = massOf(*row->part);
            bridles[row->part] = bridlePoints(scene, *row->part);
        }
        look.isBridle[i] = std::ranges::binary_search(bridles.at(row->part), particle.id);
        look.isWeight[i] = !particle.pinned && particle.mass >= heavyShare * mass->second
                           && row->part->particles.size() > 1;
    }
}

Look::Warp warpOf(const Scene& scene, const Panel& panel)
{
    const Particle* const a = particleOf(scene, panel.a);
    const Particle* const b = particleOf(scene, panel.b);
    const Particle* const c = particleOf(scene, panel.c);
    if (!a || !b || !c)
        return {};
    const auto shares = warpShares(panel, a->position, b->position, c->position);
    if (!shares)
        return {};
    return {true, *shares, grainTurn(panel, *a, *b, *c)};
}

// Light cloth is ripstop, and light falls through it: of 40 g/m^2 seven tenths, of the Dacron of
// 200 g/m^2 a fifth, which an exponential joins. Cloth of unknown weight is taken for light.
constexpr double knownDensity = 0.06; // kg/m^2
constexpr double halving = 0.136;     // kg/m^2, by which light falls to 1/e
constexpr double heaviestRipstop = 0.1;
constexpr float ripstopGrid = 0.005F; // m

Look::Cloth clothOf(const Scene& scene, const Part& part, const Panel& panel,
                    const Material* material)
{
    const double told = material ? material->arealDensity.value_or(0.0) : 0.0;
    const double density = told > 0.0 ? told : knownDensity;
    Look::Cloth cloth;
    cloth.through = float(std::min(0.94 * std::exp(-density / halving), 0.8));
    cloth.isBuilt = !part.builder.empty();
    cloth.grid = density < heaviestRipstop ? ripstopGrid : 0.0F;
    const Particle* const a = particleOf(scene, panel.a);
    const Particle* const b = particleOf(scene, panel.b);
    const Particle* const c = particleOf(scene, panel.c);
    if (!a || !b || !c)
        return cloth;
    Panel laid = panel;
    if (part.carrier != FabricKind::Panels)
        laid.grain = uprightGrain(*a, *b, *c);
    if (const auto flat = flatPanel(laid, a->position, b->position, c->position)) {
        cloth.place[1] = {float(flat->ab.y()), float(flat->ab.x())};
        cloth.place[2] = {float(flat->ac.y()), float(flat->ac.x())};
    }
    return cloth;
}

// The pictures of the materials, and which of them has a material.
std::map<Id, int> printsOf(const Scene& scene, const Layout& layout, Look& look)
{
    std::map<Id, int> numbers;
    for (const Entry& entry : scene.items) {
        const auto points = printedPoints(scene, entry.id);
        if (points.empty())
            continue;
        const Material& material = std::get<Material>(entry.item);
        Look::Print print{
            placeOfPicture(scene, material).string(), colorFromText(material.color), {}};
        print.at.assign(layout.particleId.size(), {0.0F, 0.0F});
        for (std::size_t i = 0; i < layout.particleId.size(); ++i) {
            const auto point =
                std::ranges::lower_bound(points, layout.particleId[i], {}, &PrintedPoint::particle);
            if (point != points.end() && point->particle == layout.particleId[i])
                print.at[i] = {float(point->at[0]), float(point->at[1])};
        }
        numbers.emplace(entry.id, int(look.prints.size()));
        look.prints.push_back(std::move(print));
    }
    return numbers;
}

Look::Form formOf(const Link& link, const Material* material)
{
    if (link.role != LinkRole::Line)
        return Look::Form::Wire;
    const bool isRound = material
                         && (material->diameter > 0.0 || material->flexuralRigidity > 0.0
                             || material->linearDensity.value_or(0.0) > 0.0);
    return isRound ? Look::Form::Round : Look::Form::Sewn;
}

// A material that nearly every side of a panel has is that of the mesh, and sews nothing: a
// triangle has one and a half sides of its own, and the seams of a canopy are fewer than its
// panels.
void takeMeshForWire(const Layout& layout, Directory& directory, Look& look)
{
    std::map<std::pair<const Part*, Id>, std::size_t> counts;
    const auto kindOf = [&](std::size_t i) -> std::pair<const Part*, Id> {
        const Directory::Row* row = directory.find(layout.links[i].id);
        if (!row || row->index >= row->part->links.size())
            return {};
        return {row->part, row->part->links[row->index].material};
    };
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        if (look.linkForm[i] == Look::Form::Sewn)
            ++counts[kindOf(i)];
    for (std::size_t i = 0; i < layout.links.size(); ++i) {
        if (look.linkForm[i] != Look::Form::Sewn)
            continue;
        const auto kind = kindOf(i);
        if (kind.first && !kind.first->panels.empty() && counts[kind] > kind.first->panels.size())
            look.linkForm[i] = Look::Form::Wire;
    }
}

} // namespace

Look lookOf(const Scene& scene, const Layout& layout)
{
    Directory directory(scene);
    const auto paints = paintsOf(scene);
    Look look;
    lookAtParticles(scene, directory, layout, look);

    look.linkShown.assign(layout.links.size(), 0);
    look.linkColor.assign(layout.links.size(), unknownColor);
    look.linkForm.assign(layout.links.size(), Look::Form::Round);
    look.linkThickness.assign(layout.links.size(), 0.0);
    look.linkTear.assign(layout.links.size(), {});
    look.linkWidth.assign(layout.links.size(), 0.0);
    look.linkPainted.assign(layout.links.size(), {});
    for (std::size_t i = 0; i < layout.links.size(); ++i) {
        const Directory::Row* row = directory.find(layout.links[i].id);
        if (!row || row->index >= row->part->links.size())
            continue;
        const Paint paint = paintOf(paints, row->part->links[row->index].material);
        look.linkShown[i] = row->part->shown && paint.shown;
        look.linkColor[i] = paint.color;
        const Link& link = row->part->links[row->index];
        look.linkForm[i] = formOf(link, paint.tears);
        look.linkThickness[i] = paint.tears ? linkThickness(*paint.tears) : 0.0;
        look.linkTear[i] = paint.tears ? linkTearOf(*paint.tears, link.role, link.width,
                                                    link.tearLimit, link.strengthFactor)
                                       : TearLimit();
        look.linkPainted[i] = {link.stiffnessFactor, link.strengthFactor};
        look.linkWidth[i] = link.role == LinkRole::Line ? 0.0 : link.width;
    }

    takeMeshForWire(layout, directory, look);
    look.panelShown.assign(layout.panelId.size(), 0);
    look.panelColor.assign(layout.panelId.size(), unknownColor);
    look.panelTear.assign(layout.panelId.size(), {});
    look.panelPainted.assign(layout.panelId.size(), {});
    look.panelWarp.assign(layout.panelId.size(), {});
    look.panelCloth.assign(layout.panelId.size(), {});
    look.panelPrint.assign(layout.panelId.size(), -1);
    const std::map<Id, int> prints = printsOf(scene, layout, look);
    for (std::size_t i = 0; i < layout.panelId.size(); ++i) {
        const Directory::Row* row = directory.find(layout.panelId[i]);
        if (!row || row->index >= row->part->panels.size())
            continue;
        const Panel& panel = row->part->panels[row->index];
        const Paint paint = paintOf(paints, panel.material);
        look.panelShown[i] = row->part->shown && paint.shown;
        look.panelColor[i] = paint.color;
        if (const auto print = prints.find(panel.material); print != prints.end())
            look.panelPrint[i] = print->second;
        look.panelPainted[i] = {panel.stiffnessFactor, panel.strengthFactor};
        look.panelCloth[i] = clothOf(scene, *row->part, panel, paint.tears);
        if (row->part->carrier == FabricKind::Panels)
            look.panelWarp[i] = warpOf(scene, panel);
        if (paint.tears)
            look.panelTear[i] = timesStrength(fabricTearOf(*paint.tears), panel.strengthFactor);
    }
    return look;
}

bool changesLook(const Edit& edit)
{
    return std::ranges::any_of(edit.changes, [](const Change& change) {
        const auto* set = std::get_if<SetValues>(&change);
        if (!set)
            return true;
        return changesLooks(*set->property);
    });
}

Color colorFromText(const std::string& text)
{
    std::uint32_t value = 0;
    const char* first = text.data() + 1;
    const char* last = text.data() + text.size();
    if (text.size() != 7 || text.front() != '#'
        || std::from_chars(first, last, value, 16).ptr != last)
        return unknownColor;
    return {std::uint8_t(value >> 16), std::uint8_t(value >> 8), std::uint8_t(value)};
}

} // namespace ripstop
