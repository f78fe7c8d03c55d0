// Sums adds up particles, links and panels, wherever they come from, and puts the sums into words;
// a panel whose corners do not all exist counts without an area.
//
// Each kind of item has a function: parts go through their tables, groups through their members,
// materials count what is made of them. Parts and groups also say centre of gravity and inertia.
// Many elements at once are added through Net, which finds corners together.
#include "inspector/totals.h"

#include "builders/builder.h"
#include "derived/flat_panel.h"
#include "document/spoken.h"
#include "document/words.h"
#include "select/net.h"
#include "shaping/spread_mass.h"

#include <QLocale>

#include <algorithm>

namespace ripstop {
namespace {

QString whole(qsizetype count) { return QLocale().toString(count); }

QString joined(const QStringList& facts) { return facts.join(QStringLiteral(" \u00b7 ")); }

// Sums over elements, whatever tables they come from.
struct Sums
{
    qsizetype particles = 0;
    qsizetype pins = 0;
    qsizetype guided = 0;
    qsizetype springs = 0;
    qsizetype rods = 0;
    qsizetype panels = 0;
    double mass = 0.0;   // kg
    double length = 0.0; // m
    double area = 0.0;   // m^2

    void add(const Particle& particle)
    {
        ++particles;
        pins += particle.pinned;
        guided += !particle.pinned && particle.guide != Guide::None;
        mass += particle.mass;
    }
    void add(const Link& link)
    {
        ++(link.kind == LinkKind::Spring ? springs : rods);
        length += link.restLength;
    }
    void add(const Panel& panel, const Vec3& a, const Vec3& b, const Vec3& c)
    {
        ++panels;
        area += cutArea(panel, a, b, c);
    }
    void add(const Scene& scene, const Part& part, const Panel& panel)
    {
        const auto corner = [&](Id id) -> const Particle* {
            if (const Particle* near = findRow(part.particles, id))
                return near;
            const auto ref = find(scene, id); // it may be of another part
            return ref && kindOf(*ref) == Kind::Particle ? std::get<const Particle*>(*ref)
                                                         : nullptr;
        };
        const Particle* a = corner(panel.a);
        const Particle* b = corner(panel.b);
        const Particle* c = corner(panel.c);
        if (a && b && c)
            add(panel, a->position, b->position, c->position);
        else
            ++panels;
    }

    QString text() const
    {
        QStringList facts;
        if (particles > 0)
            facts << spokenText(mass, "kg");
        if (pins > 0)
            facts << words("%1 pinned").arg(whole(pins));
        if (guided > 0)
            facts << words("%1 on guides").arg(whole(guided));
        if (springs > 0 && rods > 0)
            facts << (springs == 1 ? words("1 spring") : words("%1 springs").arg(whole(springs)))
                  << (rods == 1 ? words("1 rod") : words("%1 rods").arg(whole(rods)));
        if (springs + rods > 0)
            facts << words("%1 of links").arg(spokenText(length, "m"));
        if (panels > 0)
            facts << spokenText(area, "m\u00b2");
        return joined(facts);
    }
};

// The centre of gravity and the moments of inertia about x, y and z through it: "Centre of gravity
// 0, 1.2, 0.1 m, inertia 0.2, 0.1, 0.3 kg m²".
QString balance(const Scene& scene, const std::vector<Id>& ids)
{
    const MassProperties weight = massPropertiesOf(scene, ids);
    if (weight.mass <= 0.0 || weight.particles < 2)
        return {};
    const auto three = [](const Vec3& v, const char* unit) {
        const SpokenScale scale = spokenScale(v.cwiseAbs().maxCoeff(), unit);
        QStringList numbers;
        for (const double one : v)
            numbers << scale.number(one, 3);
        return numbers.join(QStringLiteral(", ")) + QChar(0x00a0) + scale.unit;
    };
    return QChar('\n')
           + words("Centre of gravity %1, inertia %2")
                 .arg(three(weight.centre, "m"), three(weight.inertia, "kg m\u00b2"));
}

QString counts(const Sums& sums)
{
    QStringList facts;
    if (sums.particles > 0)
        facts << counted(Kind::Particle, sums.particles);
    if (sums.springs + sums.rods > 0)
        facts << counted(Kind::Link, sums.springs + sums.rods);
    if (sums.panels > 0)
        facts << counted(Kind::Panel, sums.panels);
    return joined(facts);
}

void addAll(Sums& sums, const Scene& scene, const std::vector<Id>& ids)
{
    const Census all = census(scene, ids);
    for (const Census::Found& found : all[Kind::Particle])
        sums.add(*std::get<const Particle*>(found.ref));
    for (const Census::Found& found : all[Kind::Link])
        sums.add(*std::get<const Link*>(found.ref));
    for (const Census::Found& found : all[Kind::Panel])
        sums.add(scene, *findItem<Part>(scene, found.part), *std::get<const Panel*>(found.ref));
}

// "span 2.4 m", "cloth Icarex P31".
QString chosenText(const Parameter& parameter, double value)
{
    const QString name = choiceLabel(parameter.key).toLower();
    const auto place = std::size_t(std::max(value, 0.0));
    const QString said = place < parameter.choices.size() ? choiceLabel(parameter.choices[place])
                                                          : spokenText(value, parameter.unit);
    return name + QChar(' ') + said;
}

// Only what is otherwise than in a new design: the form of the builder has all of it.
QString built(const Part& part)
{
    if (part.builder.empty())
        return {};
    const QString by = words("Built by %1").arg(choiceLabel(part.builder).toLower());
    const Builder* builder = findBuilder(part.builder);
    if (!builder)
        return by;
    Parameters values = part.parameters;
    for (const Parameter& parameter : builder->parameters)
        values.try_emplace(std::string(parameter.key), parameter.initial);
    QStringList chosen;
    for (const Parameter& parameter : builder->parameters) {
        const double value = values.at(std::string(parameter.key));
        if (value != parameter.atFirst() && counts(parameter, builder->parameters, values))
            chosen << chosenText(parameter, value);
    }
    return (chosen.isEmpty() ? words("%1 as it comes").arg(by)
                             : labelled(by, chosen.join(QStringLiteral(", "))))
           + QStringLiteral(". ") + words("Change it with Insert > Change parameters.");
}

QString ofParts(const Scene& scene, const std::vector<Id>& ids)
{
    Sums sums;
    QString builders;
    for (const Id id : ids) {
        const Part& part = *findItem<Part>(scene, id);
        for (const Particle& row : part.particles)
            sums.add(row);
        for (const Link& row : part.links)
            sums.add(row);
        for (const Panel& row : part.panels)
            sums.add(scene, part, row);
        if (ids.size() == 1 && !part.builder.empty())
            builders = QChar('\n') + built(part);
    }
    return counts(sums) + QChar('\n') + sums.text() + balance(scene, ids) + builders;
}

QString ofGroups(const Scene& scene, const std::vector<Id>& ids)
{
    Sums sums;
    for (const Id id : ids) {
        std::vector<Id> members = findItem<Group>(scene, id)->members;
        std::sort(members.begin(), members.end());
        addAll(sums, scene, members);
    }
    return (counts(sums) + QChar('\n') + sums.text() + balance(scene, ids)).trimmed();
}

QString ofMaterials(const Scene& scene, const std::vector<Id>& ids)
{
    qsizetype links = 0;
    qsizetype panels = 0;
    const auto isOne = [&](Id id) { return std::binary_search(ids.begin(), ids.end(), id); };
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& row : part.links)
            links += isOne(row.material);
        for (const Panel& row : part.panels)
            panels += isOne(row.material);
    });
    QStringList users;
    if (links > 0)
        users << counted(Kind::Link, links);
    if (panels > 0)
        users << counted(Kind::Panel, panels);
    return users.isEmpty() ? words("Used by nothing yet")
                           : words("Used by %1").arg(users.join(QStringLiteral(", ")));
}

// The corners of many panels are found faster together than one by one.
void addAny(Sums& sums, const Scene& scene, const std::vector<Id>& elements)
{
    constexpr std::size_t many = 2000;
    if (elements.size() < many)
        return addAll(sums, scene, elements);
    const Net net(scene);
    const Marks marks(net, scene, elements);
    for (std::size_t i = 0; i < marks.particles.size(); ++i)
        if (marks.particles[i])
            sums.add(*net.all.particles[i]);
    for (std::size_t i = 0; i < marks.links.size(); ++i)
        if (marks.links[i])
            sums.add(*net.all.links[i]);
    const auto at = [&](int particle) -> const Vec3& {
        return net.all.particles[std::size_t(particle)]->position;
    };
    for (std::size_t i = 0; i < marks.panels.size(); ++i)
        if (const auto& corners = net.corners[i]; marks.panels[i] && net.isWhole(corners))
            sums.add(*net.all.panels[i], at(corners[0]), at(corners[1]), at(corners[2]));
}

} // namespace

QString totals(const Scene& scene, const std::vector<Id>& selected)
{
    Sums sums;
    addAny(sums, scene, elementsOf(scene, selected));
    return sums.text();
}

QString totals(const Scene& scene, Kind kind, const std::vector<Id>& ids)
{
    if (kind == Kind::Part)
        return ofParts(scene, ids);
    if (kind == Kind::Group)
        return ofGroups(scene, ids);
    if (kind == Kind::Material)
        return ofMaterials(scene, ids);
    if (!isElement(kind))
        return {};
    Sums sums;
    addAny(sums, scene, ids);
    return sums.text();
}

} // namespace ripstop
