// The air of canopies, in two stages.
//
// CanopyFiller::advance() moves the air of each canopy on by a substep, before the forces: Former
// measures the canopy as it stands (volume, mouth, holes, how fast the volume grows and how readily
// it yields to pressure), fillWithAir() lets air in and out and finds the pressure, and takeAlong()
// exchanges momentum with the added mass. addCanopyLoads() then turns the loads of panels into
// those with this air; it is called for each filling of forces and leaves the State alone, so that
// measurements may ask as well.
#include "forces/canopy_air.h"

#include "forces/wind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double discharge = 0.6;    // of a hole with a sharp edge
constexpr double softness = 0.02;    // share of the volume by which air exceeds it at full pressure
constexpr double follows = 0.03;     // s, until added mass has the velocity of the canopy
constexpr double leastMouth = 2e-3;  // of the area of the cloth, so that a shut mouth opens again
constexpr double leastVolume = 2e-4; // over the 3/2 power of that area; a full one has 0.11

// Positions or velocities of the particles of one canopy, by their places in it.
class Rows3
{
public:
    Rows3(const Canopy& canopy, const std::vector<PaddedVec3>& values)
        : m_canopy(canopy)
        , m_values(values)
    {}
    const Vec3& operator[](int place) const
    {
        return m_values[std::size_t(m_canopy.particles[std::size_t(place)])];
    }
    Vec3 meanOf(const std::vector<int>& loop) const
    {
        Vec3 sum = Vec3::Zero();
        for (const int place : loop)
            sum += (*this)[place];
        return sum / double(loop.size());
    }

private:
    const Canopy& m_canopy;
    const std::vector<PaddedVec3>& m_values;
};

struct Form // of a canopy at an instant
{
    Vec3 axis = Vec3::Zero();     // unit, towards the crown, or zero when there is none
    Vec3 middle = Vec3::Zero();   // m, of the cloth
    Vec3 velocity = Vec3::Zero(); // m/s, of the cloth
    double mouth = 0.0;           // m^2, across the axis
    double holes = 0.0;           // m^2, vents and torn panels
    double volume = 0.0;          // m^3
    double growth = 0.0;          // m^3/s
    double yielding = 0.0;        // m^4/kg: of the growth to pressure, per time
    double mass = 0.0;            // kg, that resists a push by shares of the cloth; 0 when pinned
    double porosity = 0.0;        // 1, mean of the cloth
};

class Former
{
public:
    Former(const System& system, const State& state, const Canopy& canopy,
           std::span<CanopyCorner> corners)
        : m_system(system)
        , m_state(state)
        , m_canopy(canopy)
        , m_position(canopy, state.position)
        , m_velocity(canopy, state.velocity)
        , m_from(m_position.meanOf(canopy.mouth))
        , m_corners(corners.first(canopy.particles.size()))
    {}

    Form form()
    {
        std::fill(m_corners.begin(), m_corners.end(), CanopyCorner());
        for (const Canopy::Facet& facet : m_canopy.facets)
            addFacet(facet);
        for (const std::vector<int>& vent : m_canopy.vents)
            m_form.holes += addLid(vent, m_position.meanOf(vent), m_velocity.meanOf(vent)).norm();
        const Vec3 closing = addLid(m_canopy.mouth, m_from, m_velocity.meanOf(m_canopy.mouth));
        addYielding();
        m_form.axis = (m_form.middle - m_from).stableNormalized();
        m_form.mouth = -closing.dot(m_form.axis);
        return m_form;
    }

private:
    void addFacet(const Canopy::Facet& facet)
    {
        const auto [a, b, c] = facet.corner;
        const Vec3 velocity = m_velocity[a] + m_velocity[b] + m_velocity[c];
        const Vec3 third = addTriangle(m_position[a], m_position[b], m_position[c]) / 3.0;
        m_form.growth += third.dot(velocity);
        m_form.middle += facet.share / 3.0 * (m_position[a] + m_position[b] + m_position[c]);
        m_form.velocity += facet.share / 3.0 * velocity;
        if (m_state.panelGone[std::size_t(facet.panel)]) {
            m_form.holes += 3.0 * third.norm();
            return;
        }
        const auto air = std::size_t(m_system.panels[std::size_t(facet.panel)].air);
        m_form.porosity += facet.share * m_system.materialAir[air].porosity;
        for (const int corner : facet.corner) {
            m_corners[std::size_t(corner)].area += third;
            m_corners[std::size_t(corner)].share += facet.share / 3.0;
        }
    }

    // Adds a fan of triangles over a loop, facing out. Returns its area, m^2.
    Vec3 addLid(const std::vector<int>& loop, const Vec3& middle, const Vec3& velocity)
    {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int a = loop[i + 1 < loop.size() ? i + 1 : 0];
            const int b = loop[i];
            const Vec3 area = addTriangle(m_position[a], m_position[b], middle);
            m_form.growth += area.dot(m_velocity[a] + m_velocity[b] + velocity) / 3.0;
            sum += area;
        }
        return sum;
    }

    // Adds the cone from the middle of the mouth to a triangle to the volume. Returns the area of
    // the triangle, m^2.
    Vec3 addTriangle(const Vec3& a, const Vec3& b, const Vec3& c)
    {
        const Vec3 area = 0.5 * (b - a).cross(c - a);
        m_form.volume += area.dot(a - m_from) / 3.0;
        return area;
    }

    void addYielding()
    {
        double lightness = 0.0; // 1/kg
        for (std::size_t i = 0; i < m_corners.size(); ++i) {
            const double inverse = m_system.inverseMass[std::size_t(m_canopy.particles[i])];
            m_form.yielding += inverse * m_corners[i].area.squaredNorm();
            lightness += inverse * m_corners[i].share * m_corners[i].share;
        }
        m_form.mass = lightness > 0.0 ? 1.0 / lightness : 0.0;
    }

    const System& m_system;
    const State& m_state;
    const Canopy& m_canopy;
    Rows3 m_position;
    Rows3 m_velocity;
    Vec3 m_from; // m, middle of the mouth
    std::span<CanopyCorner> m_corners;
    Form m_form;
};

void fillWithAir(const Canopy& canopy, const Form& form, double speed, double density, double h,
                 CanopyAir& air)
{
    const double q = 0.5 * density * speed * speed;
    const double open = discharge * form.holes;
    const double leaks = form.porosity + open / canopy.area;
    const double slowed = 1.0 + leaks * std::sqrt(canopy.pressureCoefficient);
    const double most = canopy.pressureCoefficient * q / (slowed * slowed);
    if (!(most > 0.0)) {
        air.volume = form.volume;
        air.pressure = air.fullness = 0.0;
        return;
    }
    const double mouth = std::max(form.mouth, leastMouth * canopy.area);
    const double leak = speed * std::sqrt(air.pressure / q)
                        * (form.porosity * std::min(canopy.area, 2.0 * mouth) + open);
    const double efficiency = std::min(1.0, canopy.fillEfficiency * std::sqrt(canopy.area / mouth));
    const double inflow =
        efficiency * (mouth * speed * std::sqrt(std::max(0.0, 1.0 - air.fullness)) - leak);

    const double scale = leastVolume * canopy.area * std::sqrt(canopy.area);
    const double stiffness = most / (softness * std::max(form.volume, scale)); // Pa/m^3
    const double yields = h * h * form.yielding;                               // m^3/Pa
    const double foreseen = form.volume + h * form.growth;
    // The canopy that is foreseen knows nothing of what holds it against the pressure that there
    // is, and has room for more air the longer the substep is.
    const double held = air.volume + air.pressure * yields + h * inflow;
    air.pressure =
        std::clamp(stiffness * (held - foreseen) / (1.0 + stiffness * yields), 0.0, most);
    air.fullness = air.pressure / most;
    air.volume = held - air.pressure * yields;
    // what cannot be held flows out, and where the canopy grows faster than it fills, air follows
    if (air.pressure <= 0.0 || air.pressure >= most)
        air.volume = foreseen + air.pressure / stiffness;
}

void takeAlong(const Canopy& canopy, const Form& form, double speed, double density, double h,
               CanopyAir& air)
{
    const double radius = std::sqrt(std::max(form.mouth, 0.0) / std::numbers::pi);
    const double mass =
        canopy.addedMass * density * 2.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    if (!air.started)
        air.momentum = mass * speed;
    else if (mass < air.addedMass) // some of the air stays behind
        air.momentum *= mass / air.addedMass;
    air.addedMass = mass;
    air.push.setZero();
    if (!(mass > 0.0) || !(form.mass > 0.0))
        return;
    const double shared = form.mass * mass / (form.mass + mass);
    const double impulse = std::min(shared, mass * h / follows) * (speed - air.momentum / mass);
    air.momentum += impulse;
    air.push = -impulse / h * form.axis;
}

} // namespace

void CanopyFiller::prepare(const System& system)
{
    for (const Canopy& canopy : system.canopies)
        m_corners.resize(std::max(m_corners.size(), canopy.particles.size()));
}

void CanopyFiller::advance(const System& system, State& state, double h)
{
    for (std::size_t i = 0; i < system.canopies.size(); ++i) {
        const Canopy& canopy = system.canopies[i];
        CanopyAir& air = state.canopies[i];
        const Form form = Former(system, state, canopy, m_corners).form();
        const Vec3 wind = windAt(system, state, form.middle) - form.velocity;
        const double speed = wind.dot(form.axis);
        if (!air.started)
            air.volume = form.volume;
        fillWithAir(canopy, form, std::max(speed, 0.0), system.airDensity, h, air);
        takeAlong(canopy, form, -speed, system.airDensity, h, air);
        air.started = true;
    }
}

void addCanopyLoads(const System& system, const State& state, ThreadPool& pool,
                    std::span<PaddedVec3> load)
{
    for (std::size_t i = 0; i < system.canopies.size(); ++i) {
        const Canopy& canopy = system.canopies[i];
        const CanopyAir& air = state.canopies[i];
        const Rows3 position(canopy, state.position);
        pool.parallelFor(canopy.facets.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                const Canopy::Facet& facet = canopy.facets[k];
                const auto [a, b, c] = facet.corner;
                const Vec3 area =
                    0.5 * (position[b] - position[a]).cross(position[c] - position[a]);
                const double square = area.squaredNorm();
                if (state.panelGone[std::size_t(facet.panel)] || !(square > 0.0))
                    continue;
                PaddedVec3& held = load[std::size_t(facet.panel)];
                held = held + (air.pressure - air.fullness * held.dot(area) / square) * area
                       + facet.share * air.push;
            }
        });
    }
}

} // namespace ripstop
