// Ripstop beside Bullet's deformable world, in one process, on sheets whose answer is known.
//
// Both hang the same sheet (hung_sheet.h), thread by thread and gram by gram, with the same
// damping, and make steps of 10 ms for 2 s, by one thread. Ripstop has what a new scene has.
// Bullet's btDeformableMultiBodyDynamicsWorld has btDeformableMassSpringForce, implicit, and no
// collisions.
//
// How well Bullet solves a step is for its user to say, so that there are several efforts:
//   one step of 10 ms and its own limit of 300 iterations of conjugate gradients;
//   as few iterations as leave the worst thread, at rest, within the 1 % that Ripstop wants;
//   three substeps, as many as let the lower edge swing as truly as Ripstop's does, with 300
//   iterations, and with as few as keep that.
// Bullet has backward Euler alone, which takes more of a swing than the BDF2 of Ripstop's default.
// One Newton iteration is Bullet's own number; three changed no error here and doubled the time.
// Its line search is off, as it is by default: it takes all links for equally stiff.
//
// Errors at rest, of the drop, of pulls (RMS) and of the worst pull, are the largest of the last
// half second. The error of the swing is the RMS over the first one, 0.1 s, over the drop at rest.
// Time is that of the processor, not of the clock, for machines that are not quiet; of several runs
// the best counts.
#include "bullet_results.h"
#include "hung_sheet.h"

#include "bench/report.h"
#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "simulation/simulation.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <optional>

using namespace ripstop;

namespace {

constexpr double timeStep = 0.01; // s
constexpr int steps = 200;
constexpr int swinging = 10; // the first of them, a whole swing
constexpr int resting = 50;  // the last

struct Effort
{
    int substeps;   // for 10 ms
    int iterations; // of conjugate gradients, at most
};

struct Case
{
    int cells;
    std::vector<Effort> efforts;
};

const Case cases[]{{32, {{1, 300}, {1, 15}, {3, 300}, {3, 15}}},
                   {100, {{1, 300}, {1, 40}, {3, 300}, {3, 50}}}};

// Reaches the limit of iterations, for which the library has no function.
class DeformableSolver final : public btDeformableBodySolver
{
public:
    explicit DeformableSolver(int iterations)
    {
        m_cg.m_maxIterations = iterations;
        // The only one that goes with implicit steps. The world does not tell it the masses, so
        // that it leaves vectors as they are; told, it takes more iterations with so heavy an edge.
        setPreconditioner(btDeformableBackwardEulerObjective::Mass_preconditioner);
    }
};

btVector3 toBullet(const Vec3& v) { return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())}; }

class BulletSheet
{
public:
    BulletSheet(const System& system, const Effort& effort)
        : m_system(system)
        , m_substeps(effort.substeps)
        , m_dispatcher(&m_configuration)
        , m_solver(effort.iterations)
        , m_world(&m_dispatcher, &m_broadphase, &m_constraints, &m_configuration, &m_solver)
        , m_gravity(toBullet(system.gravity))
    {
        m_constraints.setDeformableSolver(&m_solver);
        m_world.setImplicit(true);
        m_world.setUseProjection(true);
        m_world.setGravity(toBullet(system.gravity));
        addNodes();
        addLinks();
        m_world.addSoftBody(m_body.get());
        m_world.addForce(m_body.get(), m_springs.get());
        m_world.addForce(m_body.get(), &m_gravity);
    }
    ~BulletSheet() { m_world.removeSoftBody(m_body.get()); }
    BulletSheet(const BulletSheet&) = delete;
    BulletSheet& operator=(const BulletSheet&) = delete;

    void step()
    {
        const auto h = btScalar(timeStep / m_substeps);
        const btScalar kept = 1 / (1 + h * btScalar(m_system.viscosity));
        for (int i = 0; i < m_substeps; ++i) {
            m_world.stepSimulation(h, 1, h);
            for (int k = 0; k < m_body->m_nodes.size(); ++k) { // implicit, it has no viscosity
                btSoftBody::Node& node = m_body->m_nodes[k];
                node.m_v *= kept;
                node.m_vn = node.m_v;
            }
        }
    }

    double height(int particle) const // m
    {
        return m_body->m_nodes[m_node[std::size_t(particle)]].m_x.y();
    }

    double tension(std::size_t link) const // N
    {
        const btSoftBody::Link& own = m_body->m_links[int(link)];
        const double length = (own.m_n[0]->m_x - own.m_n[1]->m_x).length();
        return (own.m_bbending ? 0.5 : 1.0) * m_stiffness * (length - double(own.m_rl));
    }

private:
    // Nodes that are held come last: Bullet counts its explicit forces without them.
    void addNodes()
    {
        m_node.resize(m_system.mass.size());
        std::vector<btVector3> place;
        std::vector<btScalar> mass;
        for (const bool held : {false, true})
            for (std::size_t i = 0; i < m_system.mass.size(); ++i) {
                if ((m_system.inverseMass[i] == 0.0) != held)
                    continue;
                m_node[i] = int(place.size());
                place.push_back(toBullet(m_system.start.position[i]));
                mass.push_back(held ? btScalar(0) : btScalar(m_system.mass[i]));
            }
        m_body = std::make_unique<btSoftBody>(&m_world.getWorldInfo(), int(place.size()),
                                              place.data(), mass.data());
        m_body->m_cfg.collisions = 0;
        m_body->setActivationState(DISABLE_DEACTIVATION);
    }

    // A force has one stiffness, and another for the links that it calls bending: the threads along
    // the edges, which stand for half as much cloth.
    void addLinks()
    {
        const auto stiffness = [&](const LinkPlace& link) {
            return 1.0 / m_system.rods[std::size_t(link.index)].compliance;
        };
        for (const LinkPlace& link : m_system.links)
            m_stiffness = std::max(m_stiffness, stiffness(link));
        for (const LinkPlace& link : m_system.links) {
            m_body->appendLink(m_node[std::size_t(link.a)], m_node[std::size_t(link.b)]);
            m_body->m_links[m_body->m_links.size() - 1].m_bbending =
                stiffness(link) < 0.75 * m_stiffness;
        }
        const double damping = m_stiffness * m_system.rods.front().dampingTime; // N s/m
        m_springs = std::make_unique<btDeformableMassSpringForce>(
            btScalar(m_stiffness), btScalar(damping), true, 0.5 * m_stiffness);
    }

    const System& m_system;
    int m_substeps;
    double m_stiffness = 0.0; // N/m
    std::vector<int> m_node;  // [particles]
    btSoftBodyRigidBodyCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher;
    btDbvtBroadphase m_broadphase;
    DeformableSolver m_solver;
    btDeformableMultiBodyConstraintSolver m_constraints;
    btDeformableMultiBodyDynamicsWorld m_world;
    btDeformableGravityForce m_gravity;
    std::unique_ptr<btDeformableMassSpringForce> m_springs;
    std::unique_ptr<btSoftBody> m_body;
};

struct Figures
{
    double first = 0.0; // ms, the step in which all is set up
    double each = 0.0;  // ms, the mean of the others
    double drop = 0.0;  // errors, 1, as above
    double pull = 0.0;
    double worstPull = 0.0;
    double swing = 0.0;
};

double milliseconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

template <typename Step, typename Look>
Figures flown(const HungSheet& sheet, Step step, Look look)
{
    Figures figures;
    for (int i = 0; i < steps && !interrupted(); ++i) {
        const double start = milliseconds();
        step();
        const double taken = milliseconds() - start;
        (i == 0 ? figures.first : figures.each) += i == 0 ? taken : taken / (steps - 1);
        if (i >= swinging && i < steps - resting)
            continue;
        const HungSheet::Instant now = look();
        if (i < swinging) {
            figures.swing += std::pow(now.drop - sheet.dropAt((i + 1) * timeStep), 2) / swinging;
        } else {
            figures.drop = std::max(figures.drop, std::abs(now.drop - 1.0));
            figures.pull = std::max(figures.pull, now.pull);
            figures.worstPull = std::max(figures.worstPull, now.worstPull);
        }
    }
    figures.swing = std::sqrt(figures.swing);
    return figures;
}

Figures flyRipstop(const HungSheet& sheet, const std::shared_ptr<const System>& system)
{
    Simulation simulation(system);
    const auto look = [&] {
        const State& state = simulation.state();
        const std::vector<double> tension = tensions(*system, state);
        return sheet.instant(
            *system, [&](int i) { return state.position[std::size_t(i)].y(); },
            [&](std::size_t i) { return tension[i]; });
    };
    return flown(
        sheet, [&] { (void)simulation.step(); }, look);
}

Figures flyBullet(const HungSheet& sheet, const System& system, const Effort& effort)
{
    BulletSheet bullet(system, effort);
    const auto look = [&] {
        return sheet.instant(
            system, [&](int i) { return bullet.height(i); },
            [&](std::size_t i) { return bullet.tension(i); });
    };
    return flown(
        sheet, [&] { bullet.step(); }, look);
}

std::string nameOf(const std::optional<Effort>& effort) { return effort ? "Bullet" : "Ripstop"; }

Json compare(const Case& one, double damping, int rounds, Table& table)
{
    const HungSheet sheet{one.cells, damping};
    const std::shared_ptr<const System> system = *compile(sheet.scene());
    std::vector<std::optional<Effort>> runs{std::nullopt};
    runs.insert(runs.end(), one.efforts.begin(), one.efforts.end());
    std::vector<Figures> best(runs.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < runs.size() && !interrupted(); ++i) {
            const Figures now =
                runs[i] ? flyBullet(sheet, *system, *runs[i]) : flyRipstop(sheet, system);
            if (round == 0 || now.each < best[i].each)
                best[i] = now;
        }
    Json rows = Json::array();
    for (std::size_t i = 0; i < runs.size() && !interrupted(); ++i) {
        const Figures& f = best[i];
        Json row{{"cells", one.cells},
                 {"program", nameOf(runs[i])},
                 {"first_ms", f.first},
                 {"step_ms", f.each},
                 {"over_ripstop", f.each / best[0].each},
                 {"drop_error", f.drop},
                 {"pull_error", f.pull},
                 {"worst_pull_error", f.worstPull},
                 {"swing_error", f.swing}};
        if (runs[i])
            row.update({{"substeps", runs[i]->substeps}, {"iterations", runs[i]->iterations}});
        table.row({std::to_string(one.cells), nameOf(runs[i]),
                   runs[i] ? std::to_string(runs[i]->substeps) : "auto",
                   runs[i] ? std::to_string(runs[i]->iterations) : "auto", fixed(f.first, 1),
                   fixed(f.each, 2), fixed(f.each / best[0].each, 2), percent(f.drop),
                   percent(f.pull), percent(f.worstPull), percent(f.swing)});
        rows.push_back(row);
    }
    return rows;
}

int usage()
{
    std::cerr
        << "ripstop-bench-beside [--json] [--quick] [--undamped] [--rounds N]\n"
           "Hangs sheets by Ripstop and by Bullet's deformable world; the best of N runs, of\n"
           "2 by default. Quick leaves out the larger sheet, which takes minutes. Undamped\n"
           "cloth has Ripstop take four substeps of Euler in place of one of BDF2.\n";
    return WrongUsage;
}

} // namespace

int main(int argc, char** argv)
{
    bool json = false, quick = false;
    double damping = clothDamping;
    int rounds = 2;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--json")
            json = true;
        else if (word == "--quick")
            quick = true;
        else if (word == "--undamped")
            damping = 0.0;
        else if (word == "--rounds" && i + 1 < argc)
            rounds = std::max(1, std::atoi(argv[++i]));
        else
            return usage();
    }
    catchInterrupt();
    Json results = resultsBesideBullet();
    Table table("Hung sheets, ms of the processor for a step of 10 ms, and errors against theory: "
                "Ripstop, and Bullet "
                    + std::to_string(BT_BULLET_VERSION) + "'s deformable world",
                {{"cells", 5},
                 {"", -8},
                 {"substeps", 8},
                 {"iterations", 10},
                 {"first", 7},
                 {"each", 7},
                 {"ratio", 6},
                 {"drop", 9},
                 {"pull", 9},
                 {"worst", 9},
                 {"swing", 9}},
                !json);
    for (const Case& one : cases) {
        if (quick && one.cells > 32)
            continue;
        for (const Json& row : compare(one, damping, rounds, table))
            results["rows"].push_back(row);
        if (interrupted())
            return fail(Interrupted, "Interrupted.");
    }
    if (json)
        print(results);
    return Done;
}
