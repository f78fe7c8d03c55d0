// Three tables are walked for each kind of row: as it was built, which has the places; what stands
// in the scene, which has the paint; and as it is built now. rowsAsHeld() pairs the first two,
// sourcesOf() the first and the last. Several rows that are equally near give their mean, so that
// halves stay mirror images of each other.
#include "author/carry_paint.h"

#include "derived/flat_panel.h"
#include "scene/property.h"
#include "shaping/brush.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

namespace ripstop {
namespace {

constexpr double radians = std::numbers::pi / 180.0;
constexpr double alike = 1e-9; // shares of a distance, or of a cloth, that are rounding errors

std::array<Id, 2> cornersOf(const Link& row) { return {row.from, row.to}; }
std::array<Id, 3> cornersOf(const Panel& row) { return {row.a, row.b, row.c}; }

LinkRole roleOf(const Link& row) { return row.role; }
LinkRole roleOf(const Panel&) { return LinkRole::Line; } // panels have one role only

// What a row is: only rows of one sort give each other their paint.
using Sort = std::pair<std::string, LinkRole>; // of which material, as what

// Where a row is, so that it can be compared between two meshes of one design: its place in the box
// around all of its sort, and its texture coordinates; 1.
using Place = Eigen::Vector<double, 5>;

// The rows of a kind in a part, with what their places follow from.
template <typename Row>
struct Table
{
    Table(const Scene& scene, const Part& part, std::vector<Row> Part::*rows)
        : rows(part.*rows)
        , particles(part.particles)
    {
        for (std::size_t i = 0; i < particles.size(); ++i)
            indices[particles[i].id] = i;
        for (const Entry& entry : scene.items)
            if (const auto* material = std::get_if<Material>(&entry.item))
                materials[entry.id] = material->name;
    }

    const Particle& particle(Id id) const { return particles[indices.at(id)]; }

    Sort sortOf(const Row& row) const
    {
        const auto material = materials.find(row.material);
        return {material == materials.end() ? std::string() : material->second, roleOf(row)};
    }

    Vec3 middle(const Row& row) const // m, in the frame of the builder
    {
        Vec3 sum = Vec3::Zero();
        for (const Id id : cornersOf(row))
            sum += particle(id).position;
        return sum / double(cornersOf(row).size());
    }

    Eigen::Vector2d printed(const Row& row) const // texture coordinates
    {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const Id id : cornersOf(row))
            sum += Eigen::Vector2d(particle(id).textureU, particle(id).textureV);
        return sum / double(cornersOf(row).size());
    }

    double uprightGrain(const Panel& row) const // degrees
    {
        return ripstop::uprightGrain(particle(row.a), particle(row.b), particle(row.c));
    }

    std::span<const Row> rows;
    std::span<const Particle> particles;
    std::map<Id, std::size_t> indices; // of particles
    std::map<Id, std::string> materials;
};

template <typename Row>
bool isJoinedAlike(const Table<Row>& a, const Table<Row>& b)
{
    return std::ranges::equal(a.rows, b.rows, [&](const Row& x, const Row& y) {
        return std::ranges::equal(cornersOf(x), cornersOf(y), [&](Id of, Id with) {
            return a.indices.at(of) == b.indices.at(with);
        });
    });
}

// Places of rows, by which the nearest is found without looking at all of them.
class Places
{
public:
    void add(const Place& place, std::size_t row) { m_places.emplace_back(place, row); }

    void sort()
    {
        std::ranges::sort(m_places, [](const auto& a, const auto& b) {
            return std::pair(a.first.x(), a.second) < std::pair(b.first.x(), b.second);
        });
    }

    // The rows that are nearest, which are several where they are equally far.
    std::vector<std::size_t> nearest(const Place& place) const
    {
        const auto start = std::ranges::lower_bound(m_places, place.x(), {},
                                                    [](const auto& one) { return one.first.x(); });
        double least = std::numeric_limits<double>::infinity();
        std::vector<std::size_t> rows;
        const auto look = [&](const std::pair<Place, std::size_t>& one) {
            if (std::abs(one.first.x() - place.x()) > least + alike)
                return false; // and so are all that follow
            const double distance = (one.first - place).norm();
            if (distance < least - alike)
                rows.clear();
            if (distance <= least + alike)
                rows.push_back(one.second);
            least = std::min(least, distance);
            return true;
        };
        for (auto one = start; one != m_places.end() && look(*one); ++one)
            ;
        for (auto one = std::make_reverse_iterator(start); one != m_places.rend() && look(*one);
             ++one)
            ;
        return rows;
    }

private:
    std::vector<std::pair<Place, std::size_t>> m_places;
};

template <typename Row>
std::vector<Place> placesOf(const Table<Row>& table)
{
    std::map<Sort, Eigen::AlignedBox3d> boxes;
    for (const Row& row : table.rows)
        boxes[table.sortOf(row)].extend(table.middle(row));
    std::vector<Place> places;
    for (const Row& row : table.rows) {
        const Eigen::AlignedBox3d& box = boxes.at(table.sortOf(row));
        Place place;
        // in what is flat, rounding errors must not become shares
        const Vec3 sizes = box.sizes().cwiseMax(1e-6 * box.diagonal().norm() + alike);
        place.head<3>() = (table.middle(row) - box.min()).cwiseQuotient(sizes);
        place.tail<2>() = table.printed(row);
        places.push_back(place);
    }
    return places;
}

// [rows of `to`] The rows of `from` that are nearest to each, of its sort.
template <typename Row>
std::vector<std::vector<std::size_t>> sourcesOf(const Table<Row>& from, const Table<Row>& to)
{
    std::vector<std::vector<std::size_t>> sources(to.rows.size());
    if (isJoinedAlike(from, to)) {
        for (std::size_t i = 0; i < sources.size(); ++i)
            sources[i] = {i};
        return sources;
    }
    std::map<Sort, Places> sorts;
    const std::vector<Place> before = placesOf(from);
    for (std::size_t i = 0; i < before.size(); ++i)
        sorts[from.sortOf(from.rows[i])].add(before[i], i);
    for (auto& [sort, places] : sorts)
        places.sort();
    const std::vector<Place> now = placesOf(to);
    for (std::size_t i = 0; i < now.size(); ++i)
        if (const auto sort = sorts.find(to.sortOf(to.rows[i])); sort != sorts.end())
            sources[i] = sort->second.nearest(now[i]);
    return sources;
}

// [rows as built] The row of the scene that each has become. Where rows came or went by hand, it is
// the one between the same particles, which are known by their places then.
template <typename Row>
std::vector<const Row*> rowsAsHeld(const Table<Row>& built, const Part& part,
                                   std::vector<Row> Part::*rows, const Counterparts& counterparts)
{
    std::vector<const Row*> found(built.rows.size(), nullptr);
    const std::vector<Row>& held = part.*rows;
    if (held.size() == found.size()) {
        std::ranges::transform(held, found.begin(), [](const Row& row) { return &row; });
        return found;
    }
    Places places;
    const auto at = [](const Vec3& position) {
        Place place = Place::Zero();
        place.head<3>() = position;
        return place;
    };
    const Eigen::Affine3d back = counterparts.motion.map.inverse();
    for (std::size_t i = 0; i < part.particles.size(); ++i)
        places.add(at(back * part.particles[i].position), i);
    places.sort();
    std::map<Id, Id> heldAs;
    for (const Particle& particle : built.particles)
        for (const std::size_t near : places.nearest(at(particle.position)))
            if ((back * part.particles[near].position - particle.position).norm()
                <= counterparts.tolerance)
                heldAs.try_emplace(particle.id, part.particles[near].id);
    std::map<decltype(cornersOf(Row())), const Row*> byCorners;
    for (const Row& row : held)
        byCorners.try_emplace(cornersOf(row), &row);
    for (std::size_t i = 0; i < found.size(); ++i) {
        auto corners = cornersOf(built.rows[i]);
        for (Id& id : corners)
            id = heldAs.contains(id) ? heldAs.at(id) : noId;
        if (const auto row = byCorners.find(corners); row != byCorners.end())
            found[i] = row->second;
    }
    return found;
}

double mean(const std::vector<double>& numbers)
{
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) / double(numbers.size());
}

// Degrees, 0 to 180. A warp has no head: 179 and 1 have their mean at 0.
double meanGrain(const std::vector<double>& grains)
{
    std::complex<double> sum;
    for (const double grain : grains)
        sum += std::polar(1.0, 2.0 * grain * radians);
    return turnedGrain(grains.size() == 1 ? grains[0] : std::arg(sum) / (2.0 * radians), 0.0);
}

// Carries what is painted on one kind of row.
template <typename Row>
class Carrying
{
public:
    Carrying(Table<Row> before, std::vector<const Row*> held, Table<Row> after,
             std::vector<Row>& rows, const std::map<Id, Id>& heldAs)
        : m_before(std::move(before))
        , m_held(std::move(held))
        , m_after(std::move(after))
        , m_rows(rows)
        , m_heldAs(heldAs)
        , m_isPainted(m_held.size())
        , m_isKept(rows.size())
    {}

    CarriedPaint run()
    {
        for (std::size_t i = 0; i < m_held.size(); ++i)
            m_isPainted[i] =
                std::ranges::any_of(everyPainted, [&](Painted what) { return isPainted(what, i); });
        if (std::ranges::count(m_isPainted, true) == 0)
            return {};
        const auto sources = sourcesOf(m_before, m_after);
        for (const Painted what : everyPainted)
            if (paintedProperty(what, kind))
                for (std::size_t i = 0; i < m_rows.size(); ++i)
                    take(what, i, sources[i]);
        CarriedPaint carried;
        carried.kept = std::size_t(std::ranges::count(m_isKept, true));
        const auto places = sourcesOf(m_after, m_before);
        for (std::size_t i = 0; i < m_held.size(); ++i)
            carried.lost += m_isPainted[i] && std::ranges::none_of(places[i], [&](std::size_t row) {
                                return m_isKept[row];
                            });
        return carried;
    }

private:
    static constexpr std::array everyPainted{Painted::Strength, Painted::Stiffness, Painted::Grain};
    static constexpr Kind kind = std::is_same_v<Row, Link> ? Kind::Link : Kind::Panel;

    static double number(Painted what, const Row& row)
    {
        return std::get<double>(paintedProperty(what, kind)->get(&row));
    }

    bool isPainted(Painted what, std::size_t i) const
    {
        return m_held[i] && paintedProperty(what, kind)
               && number(what, *m_held[i]) != number(what, m_before.rows[i])
               && !(what == Painted::Grain && isTurned(i));
    }

    // Whether the grain is told from another side than it was: of a panel that was turned over.
    bool isTurned(std::size_t i) const
    {
        auto corners = cornersOf(m_before.rows[i]);
        for (Id& id : corners)
            if (const auto held = m_heldAs.find(id); held != m_heldAs.end())
                id = held->second;
            else
                return false;
        return corners != cornersOf(*m_held[i]);
    }

    // What grains are told from, degrees; 0 for what is no angle.
    double zero(Painted what, const Table<Row>& table, std::size_t i) const
    {
        if constexpr (kind == Kind::Panel)
            return what == Painted::Grain ? table.uprightGrain(table.rows[i]) : 0.0;
        else
            return 0.0;
    }

    void take(Painted what, std::size_t i, const std::vector<std::size_t>& sources)
    {
        if (std::ranges::none_of(sources, [&](std::size_t row) { return isPainted(what, row); }))
            return;
        std::vector<double> numbers;
        for (const std::size_t row : sources)
            numbers.push_back(number(what, m_held[row] ? *m_held[row] : m_before.rows[row])
                              + (zero(what, m_after, i) - zero(what, m_before, row)));
        const double value = what == Painted::Grain ? meanGrain(numbers) : mean(numbers);
        paintedProperty(what, kind)->set(&m_rows[i], value);
        m_isKept[i] = true;
    }

    Table<Row> m_before;
    std::vector<const Row*> m_held; // [rows before] as they stand in the scene; null: taken away
    Table<Row> m_after;
    std::vector<Row>& m_rows; // as they are built now
    const std::map<Id, Id>& m_heldAs;
    std::vector<bool> m_isPainted; // [rows before]
    std::vector<bool> m_isKept;    // [rows as they are built now] that have paint
};

template <typename Row>
CarriedPaint carried(const Part& held, const Counterparts& counterparts, const Scene& before,
                     Scene& after, std::vector<Row> Part::*rows)
{
    const Part& now = std::get<Part>(partEntry(after).item);
    const Table<Row> built(before, std::get<Part>(partEntry(before).item), rows);
    std::vector<Row> painted = now.*rows;
    const CarriedPaint outcome =
        Carrying<Row>(built, rowsAsHeld(built, held, rows, counterparts),
                      Table<Row>(after, now, rows), painted, counterparts.heldAs)
            .run();
    std::get<Part>(*findItem(after, partEntry(after).id)).*rows = std::move(painted);
    return outcome;
}

} // namespace

CarriedPaint carryPaint(const Part& held, const Counterparts& counterparts, const Scene& before,
                        Scene& after)
{
    const CarriedPaint links = carried(held, counterparts, before, after, &Part::links);
    const CarriedPaint panels = carried(held, counterparts, before, after, &Part::panels);
    return {links.kept + panels.kept, links.lost + panels.lost};
}

} // namespace ripstop
