// Cuts wings into strips, once for a system and not in a step.
//
// wingsOf() joins panels that hang together into wings. For each, Layout::cut() settles which way
// the panels face (orient), lays the wing flat along its wind (turn), divides the span (measure),
// finds the edges at each station (findRim) and samples how the area of each panel lies in strips
// and along the chord (sample). addParts() then balances the weights of panels, so that the force
// of a strip acts at a quarter of its chord. A wing that one of these stages cannot lay out is left
// out, and its panels have the load of plates.
#include "laws/wing_strips.h"

#include "base/joined_sets.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double tiny = 1e-9; // of the span, lengths that are rounding

struct Place // on the wing laid flat, m
{
    double x; // along the chord
    double y; // along the span
};

struct Triangle
{
    std::array<int, 3> corner;
    Vec3 normal; // m^2, twice the area long
    Vec3 middle; // m
    Vec3 wind;   // m/s
};

// Sums over the part of a panel in a strip.
struct Sums
{
    double area = 0.0;
    double wash = 0.0;
    double load = 0.0;
};

class Layout
{
public:
    Layout(std::vector<Triangle> triangles, std::span<const PaddedVec3> position)
        : m_triangles(std::move(triangles))
        , m_position(position)
    {}

    // Returns false when the wing cannot be laid out, as when it has no area.
    bool cut(WingStrips& wing)
    {
        if (!orient(wing))
            return false;
        turn();
        measure();
        if (!(m_span > 0.0))
            return false;
        for (std::size_t station = 0; station < wingStations; ++station)
            if (!findRim(station, wing))
                return false;
        sample(wing);
        return std::all_of(m_strips.begin(), m_strips.end(),
                           [](const auto& strip) { return !strip.empty(); });
    }

    void addParts(WingStrips& wing) const
    {
        for (int strip = 0; strip < wingStrips; ++strip)
            spread(strip, wing);
    }

private:
    struct Held // a panel in a strip
    {
        int panel;
        Sums sums;
    };

    bool orient(WingStrips& wing)
    {
        const auto largest = std::max_element(
            m_triangles.begin(), m_triangles.end(), [](const Triangle& a, const Triangle& b) {
                return a.normal.squaredNorm() < b.normal.squaredNorm();
            });
        const Vec3 reference = largest->normal;
        m_up = Vec3::Zero();
        for (const Triangle& triangle : m_triangles) {
            wing.side.push_back(triangle.normal.dot(reference) < 0.0 ? -1.0 : 1.0);
            m_up += wing.side.back() * triangle.normal;
        }
        const double length = m_up.norm();
        if (!(length > 0.0))
            return false;
        m_up /= length;
        return true;
    }

    // The frame: `m_along` is the chord, `m_across` the span, and chord x span points up.
    void turn()
    {
        double area = 0.0;
        Vec3 wind = Vec3::Zero();
        Vec3 middle = Vec3::Zero();
        for (const Triangle& triangle : m_triangles) {
            const double part = triangle.normal.norm();
            area += part;
            wind += part * triangle.wind;
            middle += part * triangle.middle;
        }
        middle /= area;
        const double speed = wind.norm();
        const Vec3 level = wind - wind.dot(m_up) * m_up;
        m_along = level.norm() > 0.1 * speed ? level.normalized() : shortWay(middle);
        m_across = m_up.cross(m_along);
    }

    Vec3 shortWay(const Vec3& middle) const
    {
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        for (const Triangle& triangle : m_triangles) {
            Vec3 from = triangle.middle - middle;
            from -= from.dot(m_up) * m_up;
            spread += triangle.normal.norm() * from * from.transpose();
        }
        // the least spread is across the wing, the greatest along the span
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
        const Vec3 span = axes.eigenvectors().col(2);
        Vec3 along = span.cross(m_up).normalized();
        double first = 0.0, last = 0.0;
        for (const Triangle& triangle : m_triangles)
            for (const int corner : triangle.corner) {
                const double x = (m_position[std::size_t(corner)] - middle).dot(along);
                first = std::min(first, x);
                last = std::max(last, x);
            }
        return first + last > 0.0 ? Vec3(-along) : along; // the pointed end is further away
    }

    Place flat(const Vec3& point) const { return {point.dot(m_along), point.dot(m_across)}; }
    Place flat(int particle) const { return flat(Vec3(m_position[std::size_t(particle)])); }

    void measure()
    {
        double low = INFINITY, high = -INFINITY;
        for (const Triangle& triangle : m_triangles)
            for (const int corner : triangle.corner) {
                low = std::min(low, flat(corner).y);
                high = std::max(high, flat(corner).y);
            }
        m_span = high - low;
        for (std::size_t i = 0; i < m_y.size(); ++i)
            m_y[i] = 0.5 * (low + high) - 0.5 * m_span * stationCosines()[i];
    }

    bool findRim(std::size_t station, WingStrips& wing)
    {
        const double y = m_y[station];
        const double near = tiny * m_span;
        double& first = m_first[station] = INFINITY;
        double& last = m_last[station] = -INFINITY;
        const auto meet = [&](int a, int b, double share) {
            const double x = flat(a).x + share * (flat(b).x - flat(a).x);
            if (x < first - near) {
                first = x;
                wing.front[station] = {a, b, share};
            }
            if (x > last + near) {
                last = x;
                wing.rear[station] = {a, b, share};
            }
        };
        for (const Triangle& triangle : m_triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const int a = triangle.corner[i];
                const int b = triangle.corner[(i + 1) % 3];
                const double toA = flat(a).y - y;
                const double toB = flat(b).y - y;
                if (std::abs(toA) < near)
                    meet(a, a, 0.0);
                else if (std::abs(toB) >= near && (toA < 0.0) != (toB < 0.0))
                    meet(a, b, toA / (toA - toB));
            }
        return first <= last;
    }

    // Chordwise weights of thin plates: pressure goes with sqrt((1 - x) / x), and a slope counts
    // for the lift with sqrt(x / (1 - x)), x from 0 at the front to 1 (Glauert 1926).
    void note(double x, double y, std::size_t station, double area,
              std::array<Sums, wingStrips>& sums) const
    {
        const double t = (y - m_y[station]) / (m_y[station + 1] - m_y[station]);
        const double first = m_first[station] + t * (m_first[station + 1] - m_first[station]);
        const double last = m_last[station] + t * (m_last[station + 1] - m_last[station]);
        const double chord = std::max(last - first, tiny * m_span);
        const double place = std::clamp((x - first) / chord, 0.005, 0.995);
        Sums& strip = sums[station / 2];
        strip.area += area;
        strip.wash += area * std::sqrt(place / (1.0 - place));
        strip.load += area * std::sqrt((1.0 - place) / place);
    }

    void samplePanel(const Triangle& triangle, int k, std::array<Sums, wingStrips>& sums) const
    {
        const Place a = flat(triangle.corner[0]);
        const Place b = flat(triangle.corner[1]);
        const Place c = flat(triangle.corner[2]);
        const double each = 1.0 / double(k * k);
        const auto at = [&](double u, double v) {
            const double x = a.x + u * (b.x - a.x) + v * (c.x - a.x);
            const double y = a.y + u * (b.y - a.y) + v * (c.y - a.y);
            const auto above = std::upper_bound(m_y.begin() + 1, m_y.end() - 1, y);
            const std::size_t station = std::size_t(above - m_y.begin()) - 1;
            // what lies on a station belongs to both sides, so that mirror images get mirrored
            // parts
            const bool onLow = station > 0 && y - m_y[station] < tiny * m_span;
            const bool onHigh = station + 2 < wingStations && m_y[station + 1] - y < tiny * m_span;
            note(x, y, station, onLow || onHigh ? 0.5 * each : each, sums);
            if (onLow || onHigh)
                note(x, y, onLow ? station - 1 : station + 1, 0.5 * each, sums);
        };
        for (int i = 0; i < k; ++i)
            for (int j = 0; i + j < k; ++j) {
                at((i + 1.0 / 3.0) / k, (j + 1.0 / 3.0) / k);
                if (i + j + 1 < k)
                    at((i + 2.0 / 3.0) / k, (j + 2.0 / 3.0) / k);
            }
    }

    void sample(const WingStrips& wing)
    {
        const double wanted = std::sqrt(40000.0 / double(wing.panels.size()));
        const int k = std::clamp(int(wanted), 3, 64);
        for (std::size_t p = 0; p < m_triangles.size(); ++p) {
            std::array<Sums, wingStrips> sums{};
            samplePanel(m_triangles[p], k, sums);
            for (std::size_t s = 0; s < sums.size(); ++s)
                if (sums[s].area > 0.0)
                    m_strips[s].push_back({int(p), sums[s]});
        }
    }

    // The panels of a strip carry its force such that it acts at a quarter of the chord: the
    // weights of thin plates, changed as little as that asks for. Where they are too few to do so,
    // as at a tip, those of the strips beside help.
    void spread(int strip, WingStrips& wing) const
    {
        const std::size_t s = std::size_t(strip);
        const std::size_t check = 2 * s + 1;
        const double chord = m_last[check] - m_first[check];
        std::vector<double> ease; // how readily the weight of a part changes
        std::vector<StripPart> own = gather(strip, 0, ease);
        std::vector<StripPart> balanced = own;
        // a slope that grows along the chord counts as it is at three quarters
        if (balance(&StripPart::wash, m_first[check] + 0.75 * chord, balanced, ease))
            own = balanced;
        std::vector<StripPart> parts;
        for (int reach = 0; reach < wingStrips; ++reach) {
            parts = gather(strip, reach, ease);
            if (balance(&StripPart::load, m_first[check] + 0.25 * chord, parts, ease))
                break;
        }
        for (StripPart& part : parts)
            for (const StripPart& one : own)
                if (one.panel == part.panel)
                    part.wash = one.wash;
        wing.parts.insert(wing.parts.end(), parts.begin(), parts.end());
    }

    // The parts of the panels of a strip, and of the strips up to `reach` beside it.
    std::vector<StripPart> gather(int strip, int reach, std::vector<double>& ease) const
    {
        std::vector<StripPart> parts;
        std::vector<StripPart> of(m_triangles.size());
        std::vector<double> easeOf(m_triangles.size(), 0.0);
        double wash = 0.0, load = 0.0;
        for (int s = std::max(0, strip - reach); s <= std::min(wingStrips - 1, strip + reach); ++s)
            for (const Held& held : m_strips[std::size_t(s)]) {
                const std::size_t p = std::size_t(held.panel);
                const double size = m_triangles[p].normal.norm();
                easeOf[p] += size * held.sums.area / double(1 + 3 * (s - strip) * (s - strip));
                if (s == strip) {
                    of[p] = {strip, held.panel, held.sums.area, size * held.sums.wash,
                             size * held.sums.load};
                    wash += of[p].wash;
                    load += of[p].load;
                }
            }
        ease.clear();
        for (std::size_t p = 0; p < of.size(); ++p)
            if (easeOf[p] > 0.0) {
                parts.push_back({strip, int(p), of[p].area, of[p].wash / wash, of[p].load / load});
                ease.push_back(easeOf[p]);
            }
        return parts;
    }

    // Returns false when no weights balance, or only such that pull hard against each other.
    bool balance(double StripPart::*weight, double target, std::vector<StripPart>& parts,
                 const std::vector<double>& ease) const
    {
        double all = 0.0, first = 0.0, second = 0.0, has = 0.0;
        std::vector<double> behind; // m, the target
        for (std::size_t i = 0; i < parts.size(); ++i) {
            behind.push_back(flat(m_triangles[std::size_t(parts[i].panel)].middle).x - target);
            all += ease[i];
            first += ease[i] * behind[i];
            second += ease[i] * behind[i] * behind[i];
            has += parts[i].*weight * behind[i];
        }
        const double middle = first / all;
        const double spread = second - first * middle;
        if (!(spread > 1e-8 * all * m_span * m_span))
            return false;
        double least = 0.0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            parts[i].*weight -= has * ease[i] * (behind[i] - middle) / spread;
            least = std::min(least, parts[i].*weight);
        }
        return least > -0.05;
    }

    std::vector<Triangle> m_triangles;
    std::span<const PaddedVec3> m_position;
    Vec3 m_up; // unit vectors
    Vec3 m_along;
    Vec3 m_across;
    double m_span = 0.0;                        // m
    std::array<double, wingStations> m_y{};     // m
    std::array<double, wingStations> m_first{}; // m, x where the cuts meet the edges
    std::array<double, wingStations> m_last{};
    std::array<std::vector<Held>, wingStrips> m_strips;
};

} // namespace

const std::array<double, wingStations>& stationCosines()
{
    static const auto cosines = [] {
        // halving the right angle, then cos (m + 1) = 2 cos 1 cos m - cos (m - 1)
        double step = 0.0;
        for (int count = 1; count < wingStrips; count *= 2)
            step = std::sqrt(0.5 * (1.0 + step));
        std::array<double, wingStations> values{};
        values[0] = 1.0;
        values[1] = step;
        for (std::size_t i = 1; i + 1 < wingStrips; ++i)
            values[i + 1] = 2.0 * step * values[i] - values[i - 1];
        for (std::size_t i = 0; i < wingStrips; ++i)
            values[wingStations - 1 - i] = -values[i];
        return values;
    }();
    return cosines;
}

WingRim rimOf(const std::array<RimPoint, wingStations>& places,
              std::span<const PaddedVec3> position)
{
    WingRim rim;
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const Vec3& a = position[std::size_t(places[i].a)];
        const Vec3& b = position[std::size_t(places[i].b)];
        rim[i] = a + places[i].share * (b - a);
    }
    return rim;
}

std::vector<WingStrips> wingsOf(std::span<const std::array<int, 3>> corners,
                                std::span<const std::uint8_t> member,
                                std::span<const PaddedVec3> position, std::span<const Vec3> wind)
{
    JoinedSets pieces(position.size());
    for (std::size_t p = 0; p < corners.size(); ++p)
        if (member[p]) {
            pieces.join(corners[p][0], corners[p][1]);
            pieces.join(corners[p][0], corners[p][2]);
        }
    std::vector<int> wingOf(position.size(), -1); // [particles] of each piece
    std::vector<WingStrips> wings;
    std::vector<std::vector<Triangle>> triangles;
    for (std::size_t p = 0; p < corners.size(); ++p) {
        if (!member[p])
            continue;
        const auto [a, b, c] = corners[p];
        int& number = wingOf[std::size_t(pieces.of(a))];
        if (number < 0) {
            number = int(wings.size());
            wings.emplace_back();
            triangles.emplace_back();
        }
        const Vec3& from = position[std::size_t(a)];
        const Vec3& toB = position[std::size_t(b)];
        const Vec3& toC = position[std::size_t(c)];
        wings[std::size_t(number)].panels.push_back(int(p));
        triangles[std::size_t(number)].push_back(
            {corners[p], (toB - from).cross(toC - from), (from + toB + toC) / 3.0, wind[p]});
    }
    std::vector<WingStrips> sound;
    for (std::size_t i = 0; i < wings.size(); ++i) {
        Layout layout(std::move(triangles[i]), position);
        if (!layout.cut(wings[i]))
            continue;
        layout.addParts(wings[i]);
        sound.push_back(std::move(wings[i]));
    }
    return sound;
}

} // namespace ripstop
