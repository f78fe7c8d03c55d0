// How long an edit takes on its way from the author into a running simulation.
//
// The scene is the cloth of 316 x 316 particles with its panels, probes and controls. Three threads
// share the way in the editor: the window changes the scene, a worker finds what that means, and
// the runner takes it over at the next step boundary. Each part is timed by itself.
#include "bench/races.h"
#include "bench/report.h"
#include "builders/builder.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "simulation/simulation.h"

#include <algorithm>

namespace ripstop {
namespace {

using Clock = std::chrono::steady_clock;

const std::vector<Column> editColumns{
    {"cloth tied by", -14}, {"edit", -34},     {"window ms", 10}, {"worker ms", 10},
    {"runner ms", 10},      {"median ms", 10}, {"slow", 8}};

struct EditCase
{
    const char* name;
    Edit (*make)(const Scene& scene, int turn); // the same size in each turn
};

template <typename T>
Id firstItem(const Scene& scene)
{
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<T>(entry.item))
            return entry.id;
    return noId;
}

const Part& sheet(const Scene& scene) { return *findItem<Part>(scene, firstItem<Part>(scene)); }

const Particle& middle(const Scene& scene)
{
    const auto& particles = sheet(scene).particles;
    return particles[particles.size() / 2];
}

Edit set(const Property& property, std::vector<Id> targets, Value value)
{
    return {{}, {SetValues{&property, std::move(targets), {std::move(value)}}}};
}

Edit setLink(const Scene& scene, const Property& property, double value)
{
    const auto& links = sheet(scene).links;
    return set(property, {links[links.size() / 2].id}, value);
}

// Edits the material that all links are made of.
Edit setMaterial(const Scene& scene, const Property& property, double value)
{
    return set(property, {sheet(scene).links.front().material}, value);
}

const EditCase editCases[]{
    {"mass of one particle",
     [](const Scene& scene, int turn) {
         return set(propertyOf<&Particle::mass>(), {middle(scene).id}, 1e-4 + 1e-6 * turn);
     }},
    {"pin on one particle",
     [](const Scene& scene, int turn) {
         return set(propertyOf<&Particle::pinned>(), {middle(scene).id}, turn % 2 == 0);
     }},
    {"stiffness of one link",
     [](const Scene& scene, int turn) {
         return setLink(scene, propertyOf<&Link::stiffness>(), 10.0 + turn);
     }},
    {"compliance of one link",
     [](const Scene& scene, int turn) {
         return setLink(scene, propertyOf<&Link::compliance>(), 1e-4 + 1e-6 * turn);
     }},
    {"rest length of one link",
     [](const Scene& scene, int turn) {
         return setLink(scene, propertyOf<&Link::restLength>(), 0.003 + 1e-6 * turn);
     }},
    {"wind",
     [](const Scene& scene, int turn) {
         return set(propertyOf<&Wind::velocity>(), {firstItem<Wind>(scene)},
                    Vec3(0.01 * turn, 0.0, 0.0));
     }},
    {"stiffness of the material of all",
     [](const Scene& scene, int turn) {
         return setMaterial(scene, propertyOf<&Material::stiffness>(), 20.0 + turn);
     }},
    {"compliance of the material of all",
     [](const Scene& scene, int turn) {
         return setMaterial(scene, propertyOf<&Material::compliance>(), 1e-5 * turn);
     }},
    {"mass of every particle",
     [](const Scene& scene, int turn) {
         std::vector<Id> all;
         for (const Particle& particle : sheet(scene).particles)
             all.push_back(particle.id);
         return set(propertyOf<&Particle::mass>(), std::move(all), 1e-4 + 1e-6 * turn);
     }},
    {"add one link",
     [](const Scene& scene, int turn) {
         const auto& particles = sheet(scene).particles;
         const auto from = particles.size() / 2 + std::size_t(turn);
         Link link;
         link.id = scene.nextId;
         link.from = particles[from].id;
         link.to = particles[from + 5].id;
         link.material = sheet(scene).links.front().material;
         return Edit{Message(), {AddRows{firstItem<Part>(scene), {}, {link}, {}}}};
     }},
    {"remove one particle and its links",
     [](const Scene& scene, int) { return removal(scene, {middle(scene).id}); }},
};

Result<Scene> clothScene(LinkKind kind)
{
    Result<Scene> scene =
        build(*findBuilder("cloth"),
              {{"columns", 315}, {"rows", 315}, {"sphere", 0}, {"width", 3.15}, {"height", 3.15}});
    if (!scene)
        return scene;
    scene->settings.solver = Solver::GaussSeidel;
    scene->settings.substeps = 1;
    scene->settings.sweeps = 1;
    scene->settings.gravity.setZero(); // it is the way that is timed, not the flight
    for (Entry& entry : scene->items)
        if (Part* part = std::get_if<Part>(&entry.item))
            for (Link& link : part->links) {
                link.kind = kind;
                link.material = part->links.front().material;
            }
    return scene;
}

class Way
{
public:
    explicit Way(Scene scene)
        : m_scene(std::move(scene))
        , m_live(m_scene)
        , m_simulation(std::get<Update>(m_live.update(1, 1)).system)
    {}

    const Scene& scene() const { return m_scene; }

    void send(const Edit& edit, std::vector<double> (&seconds)[4])
    {
        const auto start = Clock::now();
        const Edit inverse = apply(m_scene, edit); // for undo, as in the editor
        const auto edited = Clock::now();
        m_live.apply(edit);
        auto update = m_live.update(++m_generation, 1);
        const auto known = Clock::now();
        m_simulation.load(std::get<Update>(update));
        const auto loaded = Clock::now();
        const auto note = [&](int i, Clock::duration time) {
            seconds[i].push_back(std::chrono::duration<double>(time).count());
        };
        note(0, edited - start);
        note(1, known - edited);
        note(2, loaded - known);
        note(3, loaded - start);
        m_simulation.step(); // between two edits there are steps
    }

    // The way without any live system, for comparison: a copy of the scene, compiled from nothing.
    double sendWhole()
    {
        const auto start = Clock::now();
        const Scene copy = m_scene;
        m_simulation.load(*compile(copy, ++m_generation, 1));
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

private:
    Scene m_scene;
    LiveSystem m_live;
    Simulation m_simulation;
    std::uint64_t m_generation = 1;
};

std::vector<std::string> cells(const char* tie, const char* edit, const std::vector<double> (&s)[4])
{
    const TimingSummary whole = timingSummaryOf(s[3]);
    return {tie,
            edit,
            fixed(1e3 * timingSummaryOf(s[0]).median, 3),
            fixed(1e3 * timingSummaryOf(s[1]).median, 3),
            fixed(1e3 * timingSummaryOf(s[2]).median, 3),
            fixed(1e3 * whole.median, 3),
            fixed(1e3 * whole.slow, 3)};
}

} // namespace

std::optional<Json> editRace(const BenchOptions& options)
{
    Json rows = Json::array();
    if (options.quick || !isWanted(options, "cloth_316"))
        return Json::object();
    Table table("Edits of a running cloth of 316 x 316 particles", editColumns, !options.json);
    for (const LinkKind kind : {LinkKind::Rod, LinkKind::Spring}) {
        Result<Scene> scene = clothScene(kind);
        if (!scene)
            return std::nullopt;
        const char* tie = kind == LinkKind::Rod ? "rods" : "springs";
        const std::size_t links = sheet(*scene).links.size();
        Way way(std::move(*scene));
        constexpr int turns = 15;
        const auto report = [&](const char* edit, const std::vector<double>(&seconds)[4]) {
            table.row(cells(tie, edit, seconds));
            rows.push_back({{"network", "cloth_316"},
                            {"links", links},
                            {"tied_by", tie},
                            {"edit", edit},
                            {"window_seconds", jsonOf(timingSummaryOf(seconds[0]))},
                            {"worker_seconds", jsonOf(timingSummaryOf(seconds[1]))},
                            {"runner_seconds", jsonOf(timingSummaryOf(seconds[2]))},
                            {"seconds", jsonOf(timingSummaryOf(seconds[3]))}});
        };
        for (const EditCase& edit : editCases) {
            std::vector<double> seconds[4];
            for (int turn = 0; turn < turns; ++turn) {
                if (interrupted())
                    return std::nullopt;
                way.send(edit.make(way.scene(), turn), seconds);
            }
            report(edit.name, seconds);
        }
        std::vector<double> seconds[4]{{0.0}, {}, {0.0}, {}};
        for (int turn = 0; turn < 5 && !interrupted(); ++turn) {
            seconds[3].push_back(way.sendWhole());
            seconds[1].push_back(seconds[3].back());
        }
        report("the whole scene anew", seconds);
    }
    return Json{{"edits", rows}};
}

} // namespace ripstop
