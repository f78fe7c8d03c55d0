// Cables and bars with loads at their knots.
//
// In order: a line that is drawn aside in its middle (RF-22) and two nets of cables (RF-23, RF-24),
// their members of one rod or four; and a shallow truss that snaps through (RF-25), with two time
// steps. Viscosity, which changes nothing of where they end, brings them to rest. Weight is along
// -y.
#include "measure/diagnostics.h"
#include "verify/at_rest.h"
#include "verify/line_scenes.h"
#include "verify/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

// Members between knots, each of as many rods as one asks for.
class CableNet
{
public:
    CableNet(SolvedBy by, double slowest, double axial, int rods)
        : m_scene(emptyScene(by, slowest))
        , m_cord(addCord(m_scene, axial))
        , m_axial(axial)
        , m_rods(rods)
        , m_seconds(16.0 / slowest)
        , m_network(m_scene, "net")
    {}

    Id anchor(const Vec3& place)
    {
        const Id id = m_network.particle(place, 1.0);
        m_network.row(id).pinned = true;
        return id;
    }
    Id knot(const Vec3& place, double load) // m, N
    {
        return m_network.particle(place, load / standardGravity);
    }
    // A straight member with this pull, N, where it is. Its own mass is next to nothing.
    std::size_t member(Id from, Id to, double pull)
    {
        const double length = (m_network.position(to) - m_network.position(from)).norm();
        const std::size_t first = m_network.part().links.size();
        m_network.line(from, to, m_rods, 1e-4 * length, m_cord, Resists::Tension);
        for (int i = 0; i < m_rods; ++i)
            m_cut.push_back(length / m_rods / (1.0 + pull / m_axial));
        return first;
    }
    // What knots have come to and members carry; members are named by what member() said.
    struct Loaded
    {
        AtRest rest;
        std::vector<double> tension; // N, [rods]
        Vec3 place(Id knot) const
        {
            const auto& key = rest.system->key;
            return rest.state
                .position[std::size_t(std::ranges::find(key, Key(knot)) - key.begin())];
        }
    };
    Loaded loaded()
    {
        m_network.finish({}, {});
        auto& links = std::get<Part>(m_scene.items.back().item).links;
        for (std::size_t i = 0; i < links.size(); ++i)
            links[i].restLength = m_cut[i];
        AtRest rest = restOf(m_scene, m_seconds);
        std::vector<double> tension = tensions(*rest.system, rest.state);
        return {std::move(rest), std::move(tension)};
    }

private:
    Scene m_scene;
    Id m_cord;
    double m_axial;
    int m_rods;
    double m_seconds;
    Network m_network;
    std::vector<double> m_cut; // m, [rods]
};

struct Aside
{
    double sag = 0.0;  // m
    double pull = 0.0; // N
};

// 1 mm of Dyneema over 10 m with 50 N in it, and 100 N at its middle.
Aside drawnAside(int rods, SolvedBy by)
{
    CableNet net(by, 4.0, 43197.0, rods);
    const Id left = net.anchor({-5.0, 0.0, 0.0}), right = net.anchor({5.0, 0.0, 0.0});
    const Id middle = net.knot(Vec3::Zero(), 100.0);
    const std::size_t member = net.member(left, middle, 50.0);
    net.member(middle, right, 50.0);
    const CableNet::Loaded loaded = net.loaded();
    return {-loaded.place(middle).y(), loaded.tension[member]};
}

struct Saafan
{
    double outwards = 0.0, down = 0.0; // m, of a knot
    double outer = 0.0, inner = 0.0;   // N
};

// Two by two cables 30.48 m apart whose ends stand 9.144 m above the knots.
Saafan saafan(int rods, SolvedBy by)
{
    constexpr double bay = 30.48, load = 35586.0;
    CableNet net(by, 4.0, 146.45e-6 * 82737e6, rods);
    std::array<std::array<Id, 2>, 2> knot;
    for (const std::size_t i : {0, 1})
        for (const std::size_t j : {0, 1})
            knot[i][j] = net.knot(bay * Vec3(double(i) - 0.5, 0.0, double(j) - 0.5), load);
    std::size_t outer = 0, inner = 0;
    for (const std::size_t i : {0, 1}) {
        const double at = bay * (double(i) - 0.5);
        for (const std::size_t end : {0, 1}) {
            const double far = bay * (3.0 * double(end) - 1.5);
            outer = net.member(net.anchor({at, 9.144, far}), knot[i][end], 23687.0);
            net.member(net.anchor({far, 9.144, at}), knot[end][i], 23687.0);
        }
        inner = net.member(knot[i][0], knot[i][1], 24283.0);
        net.member(knot[0][i], knot[1][i], 24283.0);
    }
    const CableNet::Loaded loaded = net.loaded();
    const Vec3 place = loaded.place(knot[1][1]);
    return {0.5 * (place.x() + place.z()) - 0.5 * bay, -place.y(), loaded.tension[outer],
            loaded.tension[inner]};
}

struct Flat
{
    double corner = 0.0, side = 0.0, centre = 0.0; // m, down
    double least = 0.0, most = 0.0;                // N
};

// Three by three cables 0.5 m apart in a square of 2 m, with 100 N in them and 10 N at each knot.
Flat flatNet(int rods, SolvedBy by)
{
    CableNet net(by, 8.0, 43197.0, rods);
    std::array<std::array<Id, 5>, 5> node{};
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j) {
            const bool edge = i % 4 == 0, side = j % 4 == 0;
            const Vec3 place(0.5 * i, 0.0, 0.5 * j);
            if (!edge || !side)
                node[std::size_t(i)][std::size_t(j)] =
                    edge || side ? net.anchor(place) : net.knot(place, 10.0);
        }
    for (std::size_t row = 1; row < 4; ++row)
        for (std::size_t bay = 0; bay < 4; ++bay) {
            net.member(node[row][bay], node[row][bay + 1], 100.0);
            net.member(node[bay][row], node[bay + 1][row], 100.0);
        }
    const CableNet::Loaded loaded = net.loaded();
    const auto [least, most] = std::ranges::minmax(loaded.tension);
    return {-loaded.place(node[1][1]).y(), -loaded.place(node[1][2]).y(),
            -loaded.place(node[2][2]).y(), least, most};
}

void addNets(std::vector<Case>& cases)
{
    for (const int rods : {1, 4})
        for (const SolvedBy by : solvers) {
            const std::string mesh = ", members of "
                                     + std::string(rods == 1 ? "1 rod, " : "4 rods, ") + nameOf(by)
                                     + ", ";
            const auto row = [&](const char* id, const std::string& what, double expected,
                                 Tolerance tolerance, const char* unit, const char* source,
                                 auto measure) {
                cases.push_back({id, what, expected, tolerance, unit, source, measure});
            };
            const auto aside = shared([=] { return drawnAside(rods, by); });
            const std::string line = "line of 10 m drawn aside by 100 N" + mesh;
            const char* statics = "statics of two straight members";
            row("RF-22", line + "sag", 0.63470, relative(1e-3), "m", statics,
                [=] { return aside().sag; });
            row("RF-22", line + "tension", 397.05, relative(1e-3), "N", statics,
                [=] { return aside().pull; });

            const auto grid = shared([=] { return saafan(rods, by); });
            const std::string net = "net of two by two cables" + mesh;
            const char* published = "Saafan 1970; West and Kar 1973; Thai and Kim 2011";
            row("RF-23", net + "a knot moves outwards", 0.04030, relative(0.01), "m", published,
                [=] { return grid().outwards; });
            row("RF-23", net + "and down", 0.44767, relative(0.01), "m", published,
                [=] { return grid().down; });
            row("RF-23", net + "outer member", 59204.0, relative(0.01), "N", published,
                [=] { return grid().outer; });
            row("RF-23", net + "inner member", 56392.0, relative(0.01), "N", published,
                [=] { return grid().inner; });

            const auto flat = shared([=] { return flatNet(rods, by); });
            const std::string square = "flat net of three by three cables" + mesh;
            const char* newton = "statics, solved apart by Newton's method";
            row("RF-24", square + "knot at a corner, down", 0.025463, relative(0.005), "m", newton,
                [=] { return flat().corner; });
            row("RF-24", square + "knot at a side, down", 0.031668, relative(0.005), "m", newton,
                [=] { return flat().side; });
            row("RF-24", square + "knot in the middle, down", 0.040215, relative(0.005), "m",
                newton, [=] { return flat().centre; });
            row("RF-24", square + "least tension", 129.6, ofPull(by, 0.005), "N", newton,
                [=] { return flat().least; });
            row("RF-24", square + "largest tension", 146.8, ofPull(by, 0.005), "N", newton,
                [=] { return flat().most; });
        }
}

// --- a shallow truss of two bars --------------------------------------------------------------

constexpr double rise = 0.2;     // m, over half a span of 1 m
constexpr double barAxial = 1e4; // N

// Load that holds the tip at a height, N down (von Mises 1923).
double loadAt(double height)
{
    const double length = std::hypot(1.0, height), cut = std::hypot(1.0, rise);
    return 2.0 * barAxial * (1.0 - length / cut) * height / length;
}

// Where a load stands, between two heights of which the first needs less of it.
double heightUnder(double load, double less, double more)
{
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (less + more);
        (loadAt(middle) < load ? less : more) = middle;
    }
    return less;
}

// The height of the tip under a load, m; it is let down so slowly that it does not overshoot.
//   steps  that a new scene's step is cut in
double truss(double load, int steps, SolvedBy by)
{
    Scene scene = emptyScene(by, 20.0);
    scene.settings.timeStep /= steps;
    const Id bar = addCord(scene, barAxial);
    Network network(scene, "truss");
    const Id left = network.particle({-1.0, 0.0, 0.0}, 1.0);
    const Id right = network.particle({1.0, 0.0, 0.0}, 1.0);
    const Id tip = network.particle({0.0, rise, 0.0}, load / standardGravity);
    network.row(left).pinned = network.row(right).pinned = true;
    network.row(tip).guide = Guide::Line;
    network.row(tip).guideAxis = Vec3::UnitY();
    network.rod(left, tip, bar);
    network.rod(tip, right, bar);
    network.finish({}, {});
    return restOf(scene, 30.0).state.position[2].y();
}

void addTrusses(std::vector<Case>& cases)
{
    // the largest load is carried where cos(a) = cos(a0)^(1/3)
    const double a0 = std::atan(rise);
    const double limit = 2.0 * barAxial * std::pow(1.0 - std::pow(std::cos(a0), 2.0 / 3.0), 1.5);
    const double height = std::sqrt(std::pow(std::cos(a0), -2.0 / 3.0) - 1.0);
    for (const int steps : {1, 2})
        for (const SolvedBy by : solvers) {
            const std::string title = std::string("truss of two bars, steps of 1/")
                                      + std::to_string(240 * steps) + " s, " + nameOf(by);
            for (const double share : {0.5, 0.99})
                cases.push_back(
                    {"RF-25", title + ", under " + digits(share, 3) + " of what it bears, height",
                     heightUnder(share * limit, rise, height), relative(0.005), "m",
                     "von Mises 1923, shallow truss",
                     [=] { return truss(share * limit, steps, by); }});
            cases.push_back({"RF-25", title + ", under 1.01 of what it bears, height",
                             heightUnder(1.01 * limit, -rise, -2.0 * rise), relative(0.005), "m",
                             "von Mises 1923, snapped through",
                             [=] { return truss(1.01 * limit, steps, by); }});
        }
}

} // namespace

std::vector<Case> netCases()
{
    std::vector<Case> cases;
    addNets(cases);
    addTrusses(cases);
    return cases;
}

} // namespace ripstop
