// mapped() reads the formula once and evaluates it for each element at a Spot, which is the mean of
// the element's particles. presentValue() says what a link has that leaves a number to its
// material.
#include "select/element_map.h"

#include "derived/flat_panel.h"
#include "derived/formula.h"
#include "derived/link_stiffness.h"
#include "derived/tear_bounds.h"
#include "scene/particle_of.h"
#include "scene/said_number.h"
#include "select/elements.h"
#include "shapes/shape_files.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

enum Name : std::size_t { X, Y, Z, U, V, Present, Grey, nameCount };

std::vector<Formula::Name> mapNames()
{
    const auto keyOf = [](const Property& property) { return std::string(property.key); };
    return {{"x", ""},
            {"y", ""},
            {"z", ""},
            {keyOf(propertyOf<&Particle::textureU>()), ""},
            {keyOf(propertyOf<&Particle::textureV>()), ""},
            {"value", ""},
            {"grey", ""}};
}

// "x, y, z" and so on.
std::string listOf(const std::vector<Formula::Name>& names)
{
    std::string list;
    for (const Formula::Name& name : names)
        list += (list.empty() ? "" : ", ") + name.name;
    return list;
}

struct Spot
{
    Vec3 place = Vec3::Zero(); // m
    double u = 0.0;
    double v = 0.0;
};

Spot spotOf(const Scene& scene, const std::vector<Id>& particles)
{
    Spot spot;
    for (const Id id : particles)
        if (const Particle* particle = particleOf(scene, id)) {
            const double share = 1.0 / double(particles.size());
            spot.place += share * particle->position;
            spot.u += share * particle->textureU;
            spot.v += share * particle->textureV;
        }
    return spot;
}

std::vector<Id> particlesOf(const ConstRef& element)
{
    if (const auto* link = std::get_if<const Link*>(&element))
        return {(*link)->from, (*link)->to};
    if (const auto* panel = std::get_if<const Panel*>(&element))
        return {(*panel)->a, (*panel)->b, (*panel)->c};
    return {std::get<const Particle*>(element)->id};
}

// What the material gives a link that has no number of its own; nothing where it gives none.
std::optional<double> ofItsMaterial(const Scene& scene, const Property& property, const Link& link)
{
    const Material* material = findItem<Material>(scene, link.material);
    if (!material)
        return std::nullopt;
    if (isOneOf<&Link::stiffness>(property))
        return springStiffness(*material, link);
    if (isOneOf<&Link::damping>(property))
        return material->damping;
    if (isOneOf<&Link::compliance>(property))
        return rodCompliance(*material, link);
    const TearLimit tear = linkTearOf(*material, link.role, link.width, {}, link.strengthFactor);
    return tear.rule == TearRule::Never ? std::nullopt : std::optional(tear.limit);
}

// The corners of a panel whose grain is mapped; nothing for other numbers. A grain counts from a
// side of its own panel, while a map speaks of directions on the cloth.
std::optional<std::array<const Particle*, 3>>
cornersOfGrain(const Scene& scene, const Property& property, const ConstRef& element)
{
    if (!isOneOf<&Panel::grain>(property))
        return std::nullopt;
    const Panel& panel = *std::get<const Panel*>(element);
    const std::array corners{particleOf(scene, panel.a), particleOf(scene, panel.b),
                             particleOf(scene, panel.c)};
    return std::ranges::count(corners, nullptr) > 0 ? std::nullopt : std::optional(corners);
}

std::optional<double> presentValue(const Scene& scene, const Property& property,
                                   const ConstRef& element)
{
    if (const auto at = cornersOfGrain(scene, property, element))
        return grainTurn(*std::get<const Panel*>(element), *(*at)[0], *(*at)[1], *(*at)[2]);
    const Value value = property.get(element);
    if (const double* number = std::get_if<double>(&value))
        return *number;
    const auto* link = std::get_if<const Link*>(&element);
    return link ? ofItsMaterial(scene, property, **link) : std::nullopt;
}

// The particles of those elements that have the number.
template <typename Visit> // visit(particle)
void forEachParticle(const Scene& scene, const Property& property, const std::vector<Id>& elements,
                     Visit visit)
{
    for (const Id id : elements)
        if (const auto element = find(scene, id); element && kindOf(*element) == property.kind)
            for (const Id particle : particlesOf(*element))
                if (const Particle* row = particleOf(scene, particle))
                    visit(*row);
}

// m
Eigen::AlignedBox3d boxAround(const Scene& scene, const Property& property,
                              const std::vector<Id>& elements)
{
    Eigen::AlignedBox3d box;
    forEachParticle(scene, property, elements,
                    [&](const Particle& particle) { box.extend(particle.position); });
    return box;
}

// Where the picture lies on the elements: by their texture, or over the box around them.
class PicturePlace
{
public:
    PicturePlace(const Scene& scene, const Property& property, const std::vector<Id>& elements)
        : m_box(boxAround(scene, property, elements))
    {
        forEachParticle(scene, property, elements, [this](const Particle& particle) {
            m_isPrinted |= particle.textureU != 0.0 || particle.textureV != 0.0;
        });
        Eigen::Index least = 2;
        if (!m_box.isEmpty())
            m_box.sizes().minCoeff(&least);
        m_across = least == 0 ? 2 : 0;
        m_up = least == 1 ? 2 : 1;
    }

    std::pair<double, double> operator()(const Spot& spot) const // u and v
    {
        return m_isPrinted ? std::pair(spot.u, spot.v)
                           : std::pair(share(spot, m_across), share(spot, m_up));
    }

private:
    double share(const Spot& spot, Eigen::Index axis) const
    {
        const double size = m_box.sizes()[axis];
        return size > 0.0 ? (spot.place[axis] - m_box.min()[axis]) / size : 0.0;
    }

    bool m_isPrinted = false;
    Eigen::AlignedBox3d m_box; // m
    Eigen::Index m_across = 0;
    Eigen::Index m_up = 1;
};

// Between the points of the picture, whose first row is its top, v = 1.
double greyAt(const HeightGrid& picture, double u, double v)
{
    const auto cell = [](double share, int count) {
        const double place = std::clamp(share, 0.0, 1.0) * (count - 1);
        const int first = std::min(int(place), count - 2);
        return std::pair(first, place - first);
    };
    const auto [column, across] = cell(u, picture.columns);
    const auto [row, down] = cell(1.0 - v, picture.rows);
    const auto along = [&picture, column = column, across = across](int r) {
        return (1.0 - across) * picture.at(r, column) + across * picture.at(r, column + 1);
    };
    return (1.0 - down) * along(row) + down * along(row + 1);
}

bool isRealNumber(const Property& property)
{
    return isElement(property.kind)
           && (property.optional || std::holds_alternative<double>(property.initial));
}

} // namespace

Result<MappedNumbers> mapped(const Scene& scene, const Property& property,
                             const std::vector<Id>& elements, std::string_view formula,
                             const HeightGrid* picture)
{
    if (!isRealNumber(property))
        return Failure("%1 is no number of particles, links or panels.", property.key);
    const std::vector<Formula::Name> names = mapNames();
    if (formula.find_first_not_of(' ') == std::string_view::npos)
        return Failure("The formula is empty; write one of %1.", listOf(names));
    if (const std::string unknown = Formula::unknownName(formula, names); !unknown.empty())
        return Failure("The formula asks for \"%1\"; it can ask for %2.", unknown, listOf(names));
    Result<Formula> read = Formula::read(formula, names);
    if (!read)
        return read.failure();
    const auto uses = [&](Name name) { return std::ranges::count(read->used(), name) > 0; };
    if (uses(Grey) && !picture)
        return Failure("The formula asks for grey, and there is no picture: name one.");

    const PicturePlace lies(scene, property, elements);
    SetValues values{&property, {}, {}};
    MappedNumbers made;
    for (const Id id : elements) {
        const auto element = find(scene, id);
        if (!element || kindOf(*element) != property.kind)
            continue;
        const Spot spot = spotOf(scene, particlesOf(*element));
        const auto present = presentValue(scene, property, *element);
        if (uses(Present) && !present)
            return Failure("The formula asks for the value of link %1, which has none: its "
                           "material never tears. Choose what it tears by, or leave out value.",
                           std::uint32_t(id));
        const auto [across, up] = lies(spot);
        const std::array<double, nameCount> at{spot.place.x(),
                                               spot.place.y(),
                                               spot.place.z(),
                                               spot.u,
                                               spot.v,
                                               present.value_or(0.0),
                                               picture ? greyAt(*picture, across, up) : 0.0};
        const double number = read->value(at);
        if (!std::isfinite(number))
            return Failure("At %1 %2 the formula gives no finite number: check what it divides by, "
                           "and of what it takes the root or the logarithm.",
                           kindName(property.kind), std::uint32_t(id));
        const auto corners = cornersOfGrain(scene, property, *element);
        const double stored =
            corners
                ? turnedGrain(uprightGrain(*(*corners)[0], *(*corners)[1], *(*corners)[2]), number)
                : number;
        if (const auto why = refusal(property, stored))
            return Failure("At %1 %2 the formula gives %3, and %4 %5.", kindName(property.kind),
                           std::uint32_t(id), Message::number("%.4g", number), property.key, *why);
        made.least = made.count == 0 ? number : std::min(made.least, number);
        made.most = made.count == 0 ? number : std::max(made.most, number);
        ++made.count;
        values.targets.push_back(id);
        values.values.emplace_back(stored);
    }
    if (made.count == 0)
        return Failure("There is no %1 to map.", kindName(property.kind));
    made.edit.label = Message("Map of %1", Message::word(property.label));
    made.edit.changes.emplace_back(std::move(values));
    return made;
}

Result<MappedNumbers> mappedByPicture(const Scene& scene, const Property& property,
                                      const std::vector<Id>& elements, std::string_view formula,
                                      const std::filesystem::path& picture)
{
    if (picture.empty())
        return mapped(scene, property, elements, formula);
    const auto read = heightsFromFile(picture);
    if (!read)
        return read.failure();
    return mapped(scene, property, elements, formula, read->get());
}

std::string fadingSpot(const Scene& scene, const Property& property,
                       const std::vector<Id>& elements)
{
    constexpr int digits = 3;
    constexpr double shareOfSize = 0.2;  // of the box around the elements
    constexpr double leastRadius = 0.01; // m, of what is a point
    const Eigen::AlignedBox3d box = boxAround(scene, property, elements);
    if (box.isEmpty())
        return {};
    const auto squareOf = [&](const char* axis, double middle) {
        if (isNothing(middle))
            return std::string(axis) + "^2";
        return "(" + std::string(axis) + (middle < 0.0 ? " + " : " - ")
               + plainNumber(std::abs(middle), digits) + ")^2";
    };
    const Vec3 middle = box.center();
    const double radius = std::max(leastRadius, shareOfSize * box.sizes().maxCoeff());
    return "value * (1 - 0.5 * exp(-(" + squareOf("x", middle.x()) + " + "
           + squareOf("y", middle.y()) + " + " + squareOf("z", middle.z()) + ") / "
           + plainNumber(radius * radius, digits) + "))";
}

std::vector<const Property*> mappableNumbers(Kind kind)
{
    std::vector<const Property*> numbers;
    for (const Property& property : propertiesOf(kind))
        if (isRealNumber(property))
            numbers.push_back(&property);
    return numbers;
}

} // namespace ripstop
