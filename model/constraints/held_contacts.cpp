// An iteration goes over the contacts three times: decide() says which act, and whether they stick,
// as the matrix is filled; foresee() takes what the linear system gave them; follow() asks where
// the surfaces are after the move.
#include "constraints/held_contacts.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double unseen = 1e-4;        // of the inverse mass: the softness of a surface
constexpr double nearEnough = 1e-7;    // m
constexpr double seenWay = 1e-7;       // m, in a substep; it adds up to a millimetre in a minute
constexpr double heldWay = 1e-10;      // m, that what is held harder gives way by, at the most
constexpr double turnsBack = 1e-9;     // m, of what slides, that is as good as rest
constexpr double nearlySlides = 0.005; // of what friction can take
constexpr int mostTurns = 1;
constexpr std::size_t surfacesEach = 2;

Vec3 at(std::span<const Row> rows, std::uint32_t row)
{
    return Vec3(rows[row].v[0], rows[row].v[1], rows[row].v[2]);
}

Vec3 along(const HeldContact& contact, const Vec3& vector)
{
    return vector - vector.dot(contact.normal) * contact.normal;
}

// What sticks may take, kg m; where it is firm a little more each time that it has slid and come to
// rest.
double mayHold(const HeldContact& contact)
{
    const double more = contact.kind == Friction::Firm ? std::exp2(2 * contact.turns) : 1.0;
    return (1.0 + nearlySlides * more) * contact.most;
}

void measureAt(HeldContact& contact, const Vec3& position)
{
    contact.depth = (contact.surface - position).dot(contact.normal);
    contact.slip = along(contact, position - contact.start);
}

} // namespace

double HeldContact::miss() const
{
    if (!isNear)
        return 0.0;
    if (!acts)
        return std::max(depth, 0.0);
    return std::abs(depth - softness * multiplier) + std::max(-multiplier, 0.0) * inverseMass;
}

void HeldContacts::reserve(std::size_t nodes)
{
    m_contacts.clear();
    m_contacts.reserve(surfacesEach * nodes);
}

// As if the particle were alone, which is where iterations begin.
void HeldContacts::take(HeldContact& contact, double mass, const Vec3& guess)
{
    contact.isNew = false;
    contact.isFirst = true;
    contact.kind = m_kind;
    contact.inverseMass = 1.0 / mass;
    contact.softness = contact.hold = unseen / mass;
    measureAt(contact, guess);
    contact.multiplier = contact.before = mass * std::max(contact.depth, 0.0);
    contact.rub = -mass * contact.slip;
    contact.sticks =
        contact.rub.norm() <= contact.friction * contact.multiplier || contact.multiplier == 0.0;
    if (contact.multiplier == 0.0)
        contact.rub.setZero();
    contact.against = contact.sticks ? Vec3::Zero() : contact.slip.normalized();
}

void HeldContacts::start(const ContactSearch* search, std::span<const int> particle,
                         std::span<const double> mass, std::span<const Row> guess, Friction kind)
{
    m_search = search;
    m_kind = kind;
    m_contacts.clear();
    if (!search)
        return;
    search->find(particle, guess, m_contacts);
    for (HeldContact& contact : m_contacts)
        take(contact, mass[contact.row], at(guess, contact.row));
}

bool HeldContacts::follow(std::span<const int> particle, std::span<const double> mass,
                          std::span<const Row> position)
{
    if (!m_search)
        return true;
    m_search->find(particle, position, m_contacts);
    bool asThought = true;
    for (HeldContact& contact : m_contacts) {
        const Vec3 place = at(position, contact.row);
        if (contact.isNew) {
            take(contact, mass[contact.row], place);
            contact.multiplier = contact.before = 0.0;
            contact.rub.setZero();
            contact.sticks = true;
            contact.isFirst = false;
            asThought = asThought && contact.depth <= nearEnough;
            continue;
        }
        measureAt(contact, place);
        asThought = asThought && contact.miss() <= nearEnough;
    }
    return asThought;
}

void HeldContacts::decide(HeldContact& contact)
{
    const bool acted = contact.acts || contact.isFirst;
    const double reach = acted ? contact.multiplier * contact.inverseMass : 0.0; // m, of its push
    contact.acts =
        contact.isNear && (contact.isFirst ? contact.multiplier : contact.depth + reach) > 0.0;
    contact.isFirst = false;
    if (!contact.acts) {
        contact.multiplier = 0.0;
        return;
    }
    if (!acted) { // friction of a push that is not known yet would hold what the push lets go
        contact.sticks = false;
        contact.against = contact.slip.normalized();
    }
    contact.most = contact.share * contact.friction * std::max(contact.multiplier, 0.0);
    const double rub = contact.rub.norm();
    if (contact.sticks && rub > mayHold(contact)) {
        contact.sticks = false;
        contact.against = -contact.rub / rub;
    } else if (!contact.sticks) {
        const double way = contact.slip.dot(contact.against);
        if (way < -turnsBack && (contact.turns++ < mostTurns || contact.kind == Friction::Firm)) {
            contact.sticks = true;
        } else if (way < -turnsBack) { // it hardly sticks: so much friction as does not drive it
            contact.share *= 0.5;
            contact.most *= 0.5;
        } else if (way > turnsBack) {
            contact.against = contact.slip.normalized();
        }
    }
    contact.against = along(contact, contact.against).normalized();
}

Mat3 HeldContacts::stiffnessOf(const HeldContact& contact)
{
    const Vec3& n = contact.normal;
    const Mat3 across = n * n.transpose();
    const Mat3 into = across / contact.softness;
    if (contact.friction == 0.0)
        return into;
    const double holds = 1.0 / contact.hold;
    if (contact.sticks)
        return into + holds * (Mat3::Identity() - across);
    const double aside = std::min(holds, contact.most / std::max(contact.slip.norm(), 1e-12));
    return into
           + aside * (Mat3::Identity() - across - contact.against * contact.against.transpose());
}

Vec3 HeldContacts::pullOf(const HeldContact& contact)
{
    const Vec3 push = contact.depth / contact.softness * contact.normal;
    if (contact.friction == 0.0)
        return push;
    return push
           - (contact.sticks ? Vec3(contact.slip / contact.hold)
                             : Vec3(contact.most * contact.against));
}

void HeldContacts::foresee(std::span<const Row> move)
{
    for (HeldContact& contact : m_contacts) {
        contact.before = contact.multiplier;
        contact.multiplier = 0.0;
        contact.rub.setZero();
        if (!contact.acts)
            continue;
        const Vec3 way = at(move, contact.row);
        contact.multiplier = (contact.depth - way.dot(contact.normal)) / contact.softness;
        if (contact.friction == 0.0)
            continue;
        contact.rub = contact.sticks ? Vec3(-(contact.slip + along(contact, way)) / contact.hold)
                                     : Vec3(-contact.most * contact.against);
    }
}

bool HeldContacts::lift(std::span<Row> position) const
{
    bool lifts = false;
    for (const HeldContact& contact : m_contacts) {
        if (!contact.isNear || contact.acts || contact.depth <= 0.0)
            continue;
        lifts = true;
        for (int c = 0; c < 3; ++c)
            position[contact.row].v[c] += (1.0 - unseen) * contact.depth * contact.normal[c];
    }
    return lifts;
}

void HeldContacts::settle(double share)
{
    for (HeldContact& contact : m_contacts)
        contact.multiplier = contact.before + share * (contact.multiplier - contact.before);
}

void HeldContacts::measure(std::span<const Row> position)
{
    for (HeldContact& contact : m_contacts)
        measureAt(contact, at(position, contact.row));
}

double HeldContacts::energy() const
{
    double twice = 0.0;
    for (const HeldContact& contact : m_contacts) {
        if (!contact.isNear || (!contact.acts && contact.depth <= 0.0))
            continue;
        twice += contact.depth * contact.depth / contact.softness;
        if (!contact.acts || contact.friction == 0.0)
            continue;
        twice += contact.sticks ? contact.slip.squaredNorm() / contact.hold
                                : 2.0 * contact.most * contact.slip.norm();
    }
    return twice;
}

double HeldContacts::energyAt(std::span<const Row> position) const
{
    double twice = 0.0;
    for (const HeldContact& contact : m_contacts) {
        const double depth = (contact.surface - at(position, contact.row)).dot(contact.normal);
        if (depth > 0.0)
            twice += depth * depth / contact.softness;
    }
    return twice;
}

bool HeldContacts::isSettled(double accuracy, int iteration) const
{
    constexpr int enoughForFriction = 16;
    constexpr double coarser = 10.0; // no friction is known as well as pulls are asked for
    double off = 0.0, all = 0.0;     // kg^2 m^2
    for (const HeldContact& contact : m_contacts) {
        if (contact.miss() > nearEnough)
            return false;
        if (!contact.acts || contact.friction == 0.0 || iteration >= enoughForFriction)
            continue;
        const double may = contact.share * contact.friction * std::max(contact.multiplier, 0.0);
        const double rub = contact.rub.norm();
        all += may * may;
        const double wrong = contact.sticks ? std::max(rub - may, 0.0)
                             : contact.slip.dot(contact.against) < -turnsBack ? rub
                                                                              : std::abs(rub - may);
        off += wrong * wrong;
    }
    return off <= coarser * coarser * accuracy * accuracy * all;
}

bool HeldContacts::holdHarder()
{
    const auto isSoft = [](const HeldContact& contact) {
        return contact.holds() && contact.sticks && contact.most > 0.0
               && contact.hold == contact.softness;
    };
    const auto isSeen = [&](const HeldContact& contact) {
        return isSoft(contact) && contact.slip.norm() > seenWay;
    };
    if (m_kind != Friction::Firm || std::ranges::none_of(m_contacts, isSeen))
        return false;
    for (HeldContact& contact : m_contacts)
        if (isSoft(contact))
            contact.hold = std::min(contact.softness, heldWay / contact.most);
    return true;
}

bool HeldContacts::hasImpact() const
{
    return std::ranges::any_of(m_contacts, [](const HeldContact& contact) {
        return contact.holds() && contact.inward > 0.0;
    });
}

} // namespace ripstop
