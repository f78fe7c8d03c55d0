// Ripstop beside Bullet's soft body, in one process: the same networks, masses and sweeps.
//
// Bullet is what Debian packages: position solver with K iterations, linear stiffness 1, no
// collisions. The order of its links decides how fast it is, so there are three of them:
//   by node    all links of a node after each other, as its own CreatePatch() appends them;
//   by kind    cloths only: all along the rows, all along the columns, both diagonals, ...
//   reordered  by its own ReoptimizeLinkOrder(), which takes links that wait for each other apart
//              and leaves the result as it is; few callers know of it.
// Everything runs in turn, a few milliseconds each, and ratios are formed inside a round.
#include "bullet_results.h"

#include "bench/report.h"
#include "bench/timing.h"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>

#include <algorithm>
#include <iostream>

using namespace ripstop;

namespace {

enum class Order { ByNode, ByKind, Reordered };

std::vector<std::pair<int, int>> linksOf(const BenchNetwork& network, Order order)
{
    std::vector<std::pair<int, int>> links;
    for (const LinkPlace& link : network.system->links)
        links.emplace_back(link.a, link.b);
    // the links of a craft come from its builder cell by cell
    if (order != Order::ByKind && network.name.starts_with("cloth"))
        std::stable_sort(links.begin(), links.end(), [](const auto& one, const auto& other) {
            return std::min(one.first, one.second) < std::min(other.first, other.second);
        });
    return links;
}

// A soft body with the particles and rods of a network.
class BulletBody
{
public:
    BulletBody(const BenchNetwork& network, int iterations, Order order)
        : m_step(btScalar(network.system->timeStep))
    {
        const System& system = *network.system;
        for (const Vec3& place : system.start.position)
            m_start.push_back(toBullet(place));
        std::vector<btScalar> mass;
        for (std::size_t i = 0; i < system.mass.size(); ++i)
            mass.push_back(system.inverseMass[i] > 0.0 ? btScalar(system.mass[i]) : btScalar(0));
        m_info.m_gravity = toBullet(system.gravity);
        m_info.air_density = 0;
        m_info.m_sparsesdf.Initialize();
        m_body =
            std::make_unique<btSoftBody>(&m_info, int(mass.size()), m_start.data(), mass.data());
        m_body->m_materials[0]->m_kLST = 1;
        for (const auto& [a, b] : linksOf(network, order))
            m_body->appendLink(a, b);
        if (order == Order::Reordered)
            btSoftBodyHelpers::ReoptimizeLinkOrder(m_body.get());
        m_body->m_cfg.piterations = iterations;
        m_body->m_cfg.kDP = 0.001;
        m_body->m_cfg.collisions = 0;
    }

    void reset()
    {
        for (std::size_t i = 0; i < m_start.size(); ++i) {
            btSoftBody::Node& node = m_body->m_nodes[int(i)];
            node.m_x = node.m_q = m_start[i];
            node.m_v.setZero();
            node.m_f.setZero();
        }
    }

    // What btSoftRigidDynamicsWorld does with a body that meets nothing.
    void step()
    {
        m_body->predictMotion(m_step);
        m_body->solveConstraints();
        m_body->integrateMotion();
    }

private:
    static btVector3 toBullet(const Vec3& v)
    {
        return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
    }

    btScalar m_step; // s
    std::vector<btVector3> m_start;
    btSoftBodyWorldInfo m_info;
    std::unique_ptr<btSoftBody> m_body;
};

BenchRunner bulletRunner(const BenchNetwork& network, int iterations, Order order)
{
    const auto body = std::make_shared<BulletBody>(network, iterations, order);
    return {[body] { body->reset(); }, [body] { body->step(); }};
}

struct Case
{
    const char* name;
    int sweeps;
    double wanted; // ratio
};

constexpr Case cases[]{{"glider", 55, 4.5},   {"kite", 55, 4.5},      {"cloth_10", 55, 5.5},
                       {"cloth_32", 55, 5.5}, {"cloth_100", 55, 5.5}, {"cloth_316", 10, 5.5}};

Json compare(const Case& one, double seconds)
{
    const BenchNetwork network = networkCalled(one.name);
    std::vector<BenchRunner> runners{engineRunner(network, {Solver::GaussSeidel, 1, one.sweeps, 1}),
                                     bulletRunner(network, one.sweeps, Order::ByNode),
                                     bulletRunner(network, one.sweeps, Order::ByKind),
                                     bulletRunner(network, one.sweeps, Order::Reordered)};
    const auto times = timeInRounds(one.name, runners, seconds);
    if (interrupted())
        return {};
    const double perVisit = 1e9 / (double(network.system->rods.size()) * one.sweeps);
    const auto ns = [&](std::size_t i) {
        return jsonOf(scaled(timingSummaryOf(times[i]), perVisit));
    };
    Json row{{"network", network.name},
             {"rods", network.system->rods.size()},
             {"sweeps", one.sweeps},
             {"ripstop_ns", ns(0)}};
    const char* const orders[]{"", "by_node", "by_kind", "reordered"};
    for (std::size_t i = 1; i < runners.size(); ++i)
        row[orders[i]] = {
            {"bullet_ns", ns(i)},
            {"bullet_over_ripstop", jsonOf(timingSummaryOf(ratios(times[i], times[0])))}};
    row["wanted_at_least"] = one.wanted;
    for (const char* order : {"by_node", "reordered"})
        row[std::string("met_") + order] =
            row[order]["bullet_over_ripstop"]["median"].get<double>() >= one.wanted;
    return row;
}

void print(Table& table, const Json& row)
{
    std::vector<std::string> cells{row["network"], std::to_string(row["rods"].get<long>()),
                                   fixed(row["ripstop_ns"]["quiet"], 2),
                                   fixed(row["ripstop_ns"]["median"], 2)};
    for (const char* order : {"by_node", "by_kind", "reordered"}) {
        cells.push_back(fixed(row[order]["bullet_ns"]["quiet"], 2));
        cells.push_back(fixed(row[order]["bullet_over_ripstop"]["median"], 2));
    }
    cells.push_back(fixed(row["wanted_at_least"], 1));
    cells.push_back(row["met_by_node"] ? row["met_reordered"] ? "met" : "met by node" : "missed");
    table.row(cells);
}

int usage()
{
    std::cerr << "ripstop-bench-bullet [--json] [--quick] [--filter TEXT] [--seconds T]\n"
                 "Compares Ripstop and Bullet on the same networks; T s of wall time for each.\n";
    return WrongUsage;
}

} // namespace

int main(int argc, char** argv)
{
    bool json = false;
    double seconds = 4.0;
    std::string filter;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--json")
            json = true;
        else if (word == "--quick")
            seconds = 0.5;
        else if (word == "--filter" && i + 1 < argc)
            filter = argv[++i];
        else if (word == "--seconds" && i + 1 < argc)
            seconds = std::atof(argv[++i]);
        else
            return usage();
    }
    catchInterrupt();
    Json results = resultsBesideBullet();
    Table table("Bullet " + std::to_string(BT_BULLET_VERSION)
                    + (sizeof(btScalar) == 4 ? " (single precision)" : " (double precision)")
                    + " beside Ripstop (double): ns per projection when quiet, "
                      "medians of ratios, one thread",
                {{"network", -12},
                 {"rods", 8},
                 {"ripstop", 7},
                 {"median", 7},
                 {"by node", 7},
                 {"ratio", 5},
                 {"by kind", 7},
                 {"ratio", 5},
                 {"reordered", 9},
                 {"ratio", 5},
                 {"wanted", 6},
                 {"", -12}},
                !json);
    for (const Case& one : cases) {
        if (std::string_view(one.name).find(filter) == std::string_view::npos)
            continue;
        const Json row = compare(one, seconds);
        if (interrupted())
            return fail(Interrupted, "Interrupted.");
        results["rows"].push_back(row);
        print(table, row);
    }
    if (json)
        ripstop::print(results);
    return Done;
}
