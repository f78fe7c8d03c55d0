// find() goes over the particles in their order, so that the contacts are the same at every number
// of threads. What is near a surface is taken in before it touches: whether it pushes is the
// solver's to find out.
#include "contact/surface_search.h"

#include "constraints/guides.h"
#include "contact/contact.h"
#include "contact/obstacle_touch.h"

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

constexpr double neverSlides = 1e9; // friction of what stops
constexpr double leastReach = 1e-6; // m
constexpr double settled = 2e-7;    // m

double frictionOf(const Obstacle& obstacle)
{
    switch (obstacle.response) {
    case Response::Stop:
        return neverSlides;
    case Response::Contact:
        return obstacle.friction;
    case Response::Slide:
        break;
    }
    return 0.0;
}

double restitutionOf(const Obstacle& obstacle)
{
    return obstacle.response == Response::Contact ? obstacle.restitution : 0.0;
}

bool mayMeet(const Obstacle& obstacle, const PlacedObstacle& placed, const Vec3& from,
             const Vec3& to, double reach)
{
    if (obstacle.shape == ColliderShape::Plane)
        return (to - placed.position).dot(obstacle.normal) - obstacle.thickness < reach;
    for (int i = 0; i < 3; ++i)
        if (std::min(from[i], to[i]) > placed.high[i] + reach
            || std::max(from[i], to[i]) < placed.low[i] - reach)
            return false;
    return true;
}

} // namespace

SurfaceSearch::SurfaceSearch(const System& system, std::span<const PaddedVec3> before,
                             std::span<const PaddedVec3> velocity,
                             std::span<const PlacedObstacle> placed, double h)
    : m_system(system)
    , m_before(before)
    , m_velocity(velocity)
    , m_placed(placed)
    , m_h(h)
    , m_reach(std::max(4.0 * system.gravity.norm() * h * h, leastReach))
    , m_restSpeed(2.0 * system.gravity.norm() * h)
{}

void SurfaceSearch::find(std::span<const int> particle, std::span<const Row> position,
                         std::vector<HeldContact>& contacts) const
{
    const auto place = [&](std::size_t row) {
        return Vec3(position[row].v[0], position[row].v[1], position[row].v[2]);
    };
    for (HeldContact& contact : contacts)
        look(contact, place(contact.row));
    const std::size_t had = contacts.size();
    std::size_t known = 0; // the first contact that is not of a row before
    for (std::size_t row = 0; row < particle.size(); ++row) {
        const auto p = std::size_t(particle[row]);
        const Vec3 to = place(row);
        while (known < had && contacts[known].row < row)
            ++known;
        const auto isKnown = [&](std::size_t obstacle) {
            for (std::size_t k = known; k < had && contacts[k].row == row; ++k)
                if (std::size_t(contacts[k].obstacle) == obstacle)
                    return true;
            return false;
        };
        for (std::size_t o = 0; o < m_placed.size(); ++o) {
            if (!mayMeet(m_system.obstacles[o], m_placed[o], m_before[p], to, m_reach) || isKnown(o)
                || guideOf(m_system, int(p)) || contacts.size() == contacts.capacity())
                continue;
            if (const HeldContact contact = contactOf(std::uint32_t(row), p, o, to); contact.isNear)
                contacts.push_back(contact);
        }
    }
    if (contacts.size() > had)
        std::ranges::sort(contacts, {}, [](const HeldContact& contact) {
            return std::pair(contact.row, contact.obstacle);
        });
}

HeldContact SurfaceSearch::contactOf(std::uint32_t row, std::size_t particle, std::size_t o,
                                     const Vec3& place) const
{
    HeldContact contact;
    contact.row = row;
    contact.particle = int(particle);
    contact.obstacle = int(o);
    look(contact, place);
    if (!contact.isNear)
        return contact;
    const Obstacle& obstacle = m_system.obstacles[o];
    const Vec3 pace = m_placed[o].way / m_h; // m/s, of the surface
    const double inward = -(m_velocity[particle] - pace).dot(contact.normal);
    contact.start = m_before[particle] + m_placed[o].way;
    contact.inward = inward > m_restSpeed ? inward : 0.0;
    contact.friction =
        frictionOf(obstacle) * (contact.inward > 0.0 ? 1.0 + restitutionOf(obstacle) : 1.0);
    return contact;
}

void SurfaceSearch::look(HeldContact& contact, const Vec3& place) const
{
    const auto o = std::size_t(contact.obstacle);
    const Vec3 start = m_before[std::size_t(contact.particle)] + m_placed[o].way;
    const auto touch = surfaceNear(m_system.obstacles[o], m_placed[o], {start, place}, m_reach);
    contact.isNear = touch.has_value();
    if (touch) {
        contact.surface = touch->surface;
        contact.normal = touch->normal;
    }
}

void followHeldContacts(const System& system, State& state, std::span<const HeldContact> contacts,
                        std::span<const PlacedObstacle> placed, double h,
                        std::span<std::uint8_t> held, std::span<std::uint32_t> touches)
{
    std::ranges::fill(held, std::uint8_t(0));
    for (const HeldContact& contact : contacts)
        held[std::size_t(contact.particle)] = 1;
    for (const HeldContact& contact : contacts) {
        const auto p = std::size_t(contact.particle);
        const auto o = std::size_t(contact.obstacle);
        const Vec3& n = contact.normal;
        const double depth = (contact.surface - state.position[p]).dot(n);
        if (depth > contact.depth + settled
            || contact.miss() > settled) // moved since, or not found
            held[p] = 0;
        if (!contact.holds())
            continue;
        touches[p] |= touchOf(o);
        const Vec3 pace = placed[o].way / h; // m/s, of the surface
        const double outward = restitutionOf(system.obstacles[o]) * contact.inward;
        const auto follow = [&](PaddedVec3& velocity) {
            if (contact.sticks && contact.friction > 0.0)
                velocity = pace + outward * n;
            else
                velocity += (outward - (velocity - pace).dot(n)) * n;
        };
        follow(state.velocity[p]);
        follow(state.drift[p]);
        follow(state.velocityBefore[p]);
    }
}

} // namespace ripstop
