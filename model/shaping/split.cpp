// Splits links part by part: each selected link becomes a chain of new particles and pieces that
// share its stretch, and the mass of its line moves from the ends to the chain; each panel with
// such a side becomes a fan. finish() puts masses, new rows, references and removals into one edit
// in this order, so that groups never point at what is gone.
#include "shaping/split.h"

#include "derived/flat_panel.h"
#include "derived/panel_sides.h"
#include "scene/particle_of.h"
#include "scene/references.h"
#include "select/elements.h"
#include "select/net.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace ripstop {
namespace {

class Splitter
{
public:
    Splitter(const Scene& scene, int count, double mass)
        : m_scene(scene)
        , m_next(scene.nextId)
        , m_count(count)
        , m_mass(mass)
    {}

    void split(Id partId, const Part& part, const std::vector<Id>& ids)
    {
        AddRows added{partId, {}, {}, {}};
        RemoveRows removed{partId, {}, {}, {}};
        m_between.clear();
        for (const Link& row : part.links)
            if (std::ranges::binary_search(ids, row.id))
                splitLink(row, added, removed);
        for (const Panel& row : part.panels)
            splitPanel(part, row, added, removed);
        for (const Particle& row : added.particles)
            m_split.made.push_back(row.id);
        if (removed.links.empty())
            return;
        m_added.push_back(std::move(added));
        m_removed.push_back(std::move(removed));
    }

    LinksSplit finish()
    {
        m_split.edit.label = Message("Split links");
        SetValues masses{&propertyOf<&Particle::mass>(), {}, {}};
        for (const auto& [id, mass] : m_endMass) {
            masses.targets.push_back(id);
            masses.values.emplace_back(mass);
        }
        if (!masses.targets.empty())
            m_split.edit.changes.emplace_back(std::move(masses));
        for (AddRows& rows : m_added)
            m_split.edit.changes.emplace_back(std::move(rows));
        renewGroups();
        for (RemoveRows& rows : m_removed)
            m_split.edit.changes.emplace_back(std::move(rows));
        std::sort(m_split.made.begin(), m_split.made.end());
        return std::move(m_split);
    }

private:
    Id fresh()
    {
        const Id id = m_next;
        m_next = Id{std::uint32_t(m_next) + 1};
        return id;
    }

    void splitLink(const Link& row, AddRows& added, RemoveRows& removed)
    {
        const Particle* from = particleOf(m_scene, row.from);
        const Particle* to = particleOf(m_scene, row.to);
        const Material* material = findItem<Material>(m_scene, row.material);
        // a second link between the same ends would get its own particles and part from the first
        if (!from || !to || m_between.contains(sideOf(row.from, row.to)))
            return;
        std::vector<Id> chain{row.from};
        const double mass = pieceMass(row, material);
        for (int i = 1; i < m_count; ++i) {
            const double share = double(i) / m_count;
            Particle middle;
            middle.id = fresh();
            middle.position = from->position + share * (to->position - from->position);
            middle.velocity = from->velocity + share * (to->velocity - from->velocity);
            middle.textureU = from->textureU + share * (to->textureU - from->textureU);
            middle.textureV = from->textureV + share * (to->textureV - from->textureV);
            middle.mass = mass;
            added.particles.push_back(middle);
            chain.push_back(middle.id);
        }
        chain.push_back(row.to);
        for (std::size_t i = 1; i < chain.size(); ++i) {
            Link piece = pieceOf(row, material);
            piece.id = fresh();
            piece.from = chain[i - 1];
            piece.to = chain[i];
            m_pieces[row.id].push_back(piece.id);
            added.links.push_back(piece);
        }
        removed.links.push_back(row.id);
        ++m_split.links;
        if (row.from > row.to)
            std::ranges::reverse(chain);
        m_between[sideOf(row.from, row.to)] = std::move(chain);
    }

    // kg, of a particle between two pieces; takes that much off the ends where it was there.
    double pieceMass(const Link& row, const Material* material)
    {
        if (!material || !material->linearDensity)
            return m_mass;
        const double line = *material->linearDensity * row.restLength; // kg
        const double off = 0.5 * line * (1.0 - 1.0 / m_count);
        for (const Id end : {row.from, row.to}) {
            const auto held = m_endMass.try_emplace(end, particleOf(m_scene, end)->mass).first;
            held->second = std::max(held->second - off, 0.0);
        }
        return line / m_count;
    }

    Link pieceOf(const Link& row, const Material* material) const
    {
        Link piece = row;
        const double n = m_count;
        piece.restLength /= n;
        if (piece.stiffness)
            *piece.stiffness *= n;
        if (piece.damping)
            *piece.damping *= n;
        if (piece.compliance)
            *piece.compliance /= n;
        if (!material)
            return piece;
        // a physical stiffness knows the length of a piece by itself
        const bool physical = row.role == LinkRole::Line ? material->axialStiffness.has_value()
                                                         : material->membraneStiffness.has_value();
        if (!physical && row.kind == LinkKind::Spring && !piece.stiffness)
            piece.stiffness = n * row.stiffnessFactor * material->stiffness;
        if (!physical && row.kind == LinkKind::Rod && !piece.compliance
            && material->compliance > 0.0)
            piece.compliance = material->compliance / (n * row.stiffnessFactor);
        if (row.kind == LinkKind::Spring && !piece.damping && material->damping > 0.0)
            piece.damping = n * material->damping;
        if (material->tearRule == TearRule::Length)
            piece.tearLimit = row.tearLimit.value_or(material->tearLimit) / n;
        return piece;
    }

    // Splits side after side, so that a panel with several such sides is split at all of them.
    void splitPanel(const Part& part, const Panel& row, AddRows& added, RemoveRows& removed)
    {
        std::vector<std::array<Id, 3>> pieces{{row.a, row.b, row.c}};
        bool isSplit = false;
        for (std::size_t i = 0; i < pieces.size();) {
            bool here = false;
            for (std::size_t k = 0; k < 3 && !here; ++k) {
                const auto [a, b, c] =
                    std::array{pieces[i][k], pieces[i][(k + 1) % 3], pieces[i][(k + 2) % 3]};
                const auto found = m_between.find(sideOf(a, b));
                if (found == m_between.end())
                    continue;
                std::vector<Id> chain = found->second; // from the lower id
                if (a > b)
                    std::ranges::reverse(chain);
                pieces[i] = {chain[0], chain[1], c};
                for (std::size_t j = 2; j < chain.size(); ++j)
                    pieces.push_back({chain[j - 1], chain[j], c});
                here = isSplit = true;
            }
            i += here ? 0 : 1;
        }
        if (!isSplit)
            return;
        removed.panels.push_back(row.id);
        const auto at = [&](Id id) -> Vec3 {
            const auto found = std::ranges::lower_bound(added.particles, id, {}, &Particle::id);
            const bool isNew = found != added.particles.end() && found->id == id;
            const Particle* const particle = isNew ? &*found : particleOf(m_scene, id);
            return particle ? particle->position : Vec3(Vec3::Zero());
        };
        const Vec3 a = at(row.a), ab = at(row.b) - a, ac = at(row.c) - a;
        const auto shares =
            part.carrier == FabricKind::Panels ? warpShares(row, a, a + ab, a + ac) : std::nullopt;
        for (const auto& corner : pieces) {
            Panel piece{fresh(), corner[0], corner[1], corner[2], row.material};
            piece.stiffnessFactor = row.stiffnessFactor;
            piece.strengthFactor = row.strengthFactor;
            if (shares)
                piece.grain = grainAlong(at(piece.a), at(piece.b), at(piece.c),
                                         (*shares)[0] * ab + (*shares)[1] * ac);
            m_pieces[row.id].push_back(piece.id);
            added.panels.push_back(piece);
        }
    }

    // Pieces stand in the groups of what they come from.
    void renewGroups()
    {
        passOn(m_split.edit, m_scene, [&](Id id, std::vector<Id>& heirs) {
            if (const auto found = m_pieces.find(id); found != m_pieces.end())
                heirs.insert(heirs.end(), found->second.begin(), found->second.end());
            else
                heirs.push_back(id);
        });
    }

    const Scene& m_scene;
    Id m_next;
    int m_count;
    double m_mass; // kg
    LinksSplit m_split;
    std::map<PanelSide, std::vector<Id>>
        m_between;                          // the chain that a side became, from the lower id
    std::map<Id, std::vector<Id>> m_pieces; // of links and panels
    std::map<Id, double> m_endMass;         // kg
    std::vector<AddRows> m_added;
    std::vector<RemoveRows> m_removed;
};

} // namespace

LinksSplit linksSplit(const Scene& scene, const std::vector<Id>& selected, int count, double mass)
{
    std::vector<Id> ids = selected;
    std::sort(ids.begin(), ids.end());
    Splitter splitter(scene, count, mass);
    forEachPart(scene, [&](Id id, const Part& part) { splitter.split(id, part, ids); });
    return splitter.finish();
}

} // namespace ripstop
