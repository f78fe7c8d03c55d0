// Edits come in front of the table, by what they are about, each with the condition under which it
// can be made. remediesOf() asks for the reason why the value does nothing and offers the rows that
// have it.
#include "author/remedy.h"

#include "author/carry_fabric.h"
#include "author/strip_widths.h"
#include "scene/idle_reasons.h"

#include <algorithm>

namespace ripstop {
namespace {

template <typename T>
const T& as(const ConstRef& thing)
{
    return *std::get<const T*>(thing);
}

Edit settingAll(Message label, const Property& property, std::vector<Id> ids, Value value)
{
    Edit edit{std::move(label), {}};
    edit.changes.emplace_back(SetValues{&property, std::move(ids), {std::move(value)}});
    return edit;
}

template <typename Enum>
Value choice(Enum value)
{
    return std::string(choiceNames<Enum>[std::size_t(value)]);
}

template <typename Wanted>
std::vector<Id> linksWhere(const Scene& scene, const std::vector<Id>& materials, Wanted wanted)
{
    std::vector<Id> links;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& link : part.links)
            if (std::ranges::count(materials, link.material) > 0 && wanted(link))
                links.push_back(link.id);
    });
    return links;
}

// --- fabric -----------------------------------------------------------------------------------

bool hasLinksInAMesh(const Property&, const ConstRef&, const Circumstances& around)
{
    return around.made.links() > 0 && around.all.panels > 0;
}

Result<Edit> giveWidths(const Scene& scene, const Property& property, const std::vector<Id>& ids)
{
    Result<StripWidths> made = widthsFromMesh(scene, ids);
    if (!made)
        return made.failure();
    const bool isOfShear = isOneOf<&Material::shearStiffness>(property);
    if (isOfShear && made->biases == 0)
        return Failure("No link of this material runs across its panels, so that none resists "
                       "shear: have its panels carry the pull.");
    if (!isOfShear && made->threads == 0)
        return Failure("No link of this material runs along a side of a panel, so that none is a "
                       "thread: have its panels carry the pull.");
    return std::move(made->edit);
}

bool couldCarry(const Property&, const ConstRef& thing, const Circumstances& around)
{
    return around.made.panels > 0 && as<Material>(thing).membraneStiffness;
}

Result<Edit> havePanelsCarry(const Scene& scene, const Property&, const std::vector<Id>& ids)
{
    return panelsCarry(scene, ids);
}

// --- tearing ----------------------------------------------------------------------------------

// The rule by which the strengths of the material are limits of what is made of it.
TearRule ruleOfStrength(const Material& material, const Use& made)
{
    const bool bends = material.flexuralRigidity > 0.0 && material.breakingMoment;
    const bool breaksLines = made.lines > 0 && (material.lineStrength || bends);
    const bool tearsPanels =
        made.elasticPanels > 0 && (material.warpStrength || material.weftStrength);
    if (breaksLines || tearsPanels)
        return TearRule::Strength;
    return made.threads > 0 && material.warpStrength ? TearRule::Tension : TearRule::Never;
}

bool couldTear(const Property&, const ConstRef& thing, const Circumstances& around)
{
    return kindOf(thing) == Kind::Material
           && ruleOfStrength(as<Material>(thing), around.made) != TearRule::Never;
}

Result<Edit> tearByStrength(const Scene& scene, const Property&, const std::vector<Id>& ids)
{
    const Usage usage = usageOf(scene);
    SetValues rules{&propertyOf<&Material::tearRule>(), {}, {}};
    SetValues limits{&propertyOf<&Material::tearLimit>(), {}, {}};
    for (const Id id : ids) {
        const Material& material = *findItem<Material>(scene, id);
        const auto made = usage.ofMaterial.find(id);
        const TearRule rule =
            ruleOfStrength(material, made == usage.ofMaterial.end() ? Use() : made->second);
        if (rule == TearRule::Never)
            continue;
        rules.targets.push_back(id);
        rules.values.push_back(choice(rule));
        if (rule == TearRule::Tension) {
            limits.targets.push_back(id);
            limits.values.emplace_back(*material.warpStrength);
        }
    }
    Edit edit{Message("Tear by strength"), {}};
    for (SetValues* values : {&rules, &limits})
        if (!values->targets.empty())
            edit.changes.emplace_back(std::move(*values));
    return edit;
}

// --- springs and rods -------------------------------------------------------------------------

template <LinkKind kind>
Result<Edit> makeLinks(const Scene& scene, const Property& property, const std::vector<Id>& ids)
{
    const std::vector<Id> links = property.kind == Kind::Link
                                      ? ids
                                      : linksWhere(scene, ids, [](const Link&) { return true; });
    return settingAll(kind == LinkKind::Spring ? Message("Make springs") : Message("Make rods"),
                      propertyOf<&Link::kind>(), links, choice(kind));
}

// The link's own number that takes the place of the material's, or null.
const Property* ownNumber(const Property& property)
{
    for (const Property* own : {&propertyOf<&Link::stiffness>(), &propertyOf<&Link::damping>(),
                                &propertyOf<&Link::compliance>(), &propertyOf<&Link::tearLimit>()})
        if (ofMaterial(*own) == &property)
            return own;
    return nullptr;
}

Result<Edit> takeMaterials(const Scene& scene, const Property& property, const std::vector<Id>& ids)
{
    const Property& own = *ownNumber(property);
    const auto hasOwn = [&](const Link& link) {
        return !std::holds_alternative<std::monostate>(own.get(&link));
    };
    return settingAll(Message("Take the material's numbers"), own, linksWhere(scene, ids, hasOwn),
                      std::monostate());
}

Result<Edit> emptyPhysical(const Scene&, const Property&, const std::vector<Id>& ids)
{
    Edit edit{Message("Empty the physical stiffness"), {}};
    for (const Property* property :
         {&propertyOf<&Material::axialStiffness>(), &propertyOf<&Material::membraneStiffness>(),
          &propertyOf<&Material::shearStiffness>()})
        edit.changes.emplace_back(SetValues{property, ids, {std::monostate()}});
    return edit;
}

// --- solver, air and particles ----------------------------------------------------------------

Result<Edit> chooseSolver(const Scene&, const Property&, const std::vector<Id>&)
{
    return settingAll(Message("Automatic solver"), propertyOf<&Settings::solver>(), {settingsId},
                      choice(Solver::Auto));
}

Result<Edit> letAirIn(const Scene&, const Property&, const std::vector<Id>&)
{
    return settingAll(Message("Air as at sea level"), propertyOf<&Settings::airDensity>(),
                      {settingsId}, Settings().airDensity);
}

Result<Edit> unpin(const Scene&, const Property&, const std::vector<Id>& ids)
{
    return settingAll(Message("Unpin"), propertyOf<&Particle::pinned>(), ids, false);
}

bool always(const Property&, const ConstRef&, const Circumstances&) { return true; }

const std::vector<Remedy>& allRemedies()
{
    using namespace idle;
    // clang-format off
    static const std::vector<Remedy> remedies{
        {Message("Give its links widths from the mesh"), {noThread, noBias}, hasLinksInAMesh, giveWidths},
        {Message("Have its panels carry the pull"), {noThread, noBias, noElasticPanel}, couldCarry, havePanelsCarry},
        {Message("Have its strengths be the limits"), {neverTears}, couldTear, tearByStrength},
        {Message("Make springs of its links"), {onlyRods}, always, makeLinks<LinkKind::Spring>},
        {Message("Make rods of its links"), {onlySprings}, always, makeLinks<LinkKind::Rod>},
        {Message("Make it a spring"), {linkIsRod}, always, makeLinks<LinkKind::Spring>},
        {Message("Make it a rod"), {linkIsSpring}, always, makeLinks<LinkKind::Rod>},
        {Message("Have its links take the material's"), {ownOfSprings, ownOfRods, ownOfLinks}, always, takeMaterials},
        {Message("Empty its axial, membrane and shear stiffness"), {physicalCounts}, always, emptyPhysical},
        {Message("Choose the automatic solver"), {stiffSolver, notAutomatic}, always, chooseSolver},
        {Message("Let in the air of sea level"), {noAir}, always, letAirIn},
        {Message("Unpin"), {pinned}, always, unpin},
    };
    // clang-format on
    return remedies;
}

} // namespace

std::vector<const Remedy*> remediesOf(const Scene& scene, const Usage& usage,
                                      const Property& property, Id id)
{
    std::vector<const Remedy*> remedies;
    const auto reason = whyIdle(scene, usage, property, id);
    if (!reason)
        return remedies;
    const auto thing = find(scene, id);
    const auto made = usage.ofMaterial.find(id);
    const Circumstances around{scene, usage.ofAll,
                               made == usage.ofMaterial.end() ? Use() : made->second};
    for (const Remedy& remedy : allRemedies())
        if (std::ranges::count(remedy.reasons, *reason) > 0
            && remedy.fits(property, *thing, around))
            remedies.push_back(&remedy);
    return remedies;
}

} // namespace ripstop
