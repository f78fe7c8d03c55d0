// Lines are found first, as chains of links that resist tension alone. Then, at each look, the
// tension that a line bears is followed with a running mean, and a change between slack and taut
// counts when it has lasted. Large systems are looked at every few steps only, since links are
// many.
#include "recording/slack_watch.h"

#include "assembly/split_system.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <unordered_map>

namespace ripstop {
namespace {

constexpr double settling = 0.1;           // s, from the start
constexpr std::size_t atOnce = 4096;       // links looked at in a step
constexpr double leastShare = 1e-5;        // of the weight of all
constexpr double slackShare = 1.0 / 200.0; // of the most that a line has borne
constexpr double tautShare = 1.0 / 50.0;

std::size_t countAt(const Rows& rows, int particle)
{
    const auto i = std::size_t(particle);
    return i + 1 < rows.start.size() ? std::size_t(rows.start[i + 1] - rows.start[i]) : 0;
}

// Whether another rod runs along the link from one of its ends, as the core of a kite's line does:
// how rods that lie side by side share a pull is chance, and says nothing of it.
bool hasTwin(const System& system, const LinkPlace& link)
{
    constexpr double alongside = 0.99; // cosine
    const auto placeOf = [&](int particle) -> const Vec3& {
        return system.start.position[std::size_t(particle)];
    };
    const auto runsFrom = [&](int end, int other) {
        const Vec3 along = (placeOf(other) - placeOf(end)).normalized();
        const Rows& at = system.rodsAt;
        for (int k = at.start[std::size_t(end)]; k < at.start[std::size_t(end) + 1]; ++k) {
            const Rod& rod = system.rods[std::size_t(at.items[std::size_t(k)])];
            const bool isItself =
                link.kind == LinkKind::Rod && at.items[std::size_t(k)] == link.index;
            const Vec3 way = (placeOf(rod.a == end ? rod.b : rod.a) - placeOf(end)).normalized();
            if (!isItself && way.dot(along) > alongside)
                return true;
        }
        return false;
    };
    return runsFrom(link.a, link.b) || runsFrom(link.b, link.a);
}

bool isLine(const System& system, std::size_t link)
{
    const LinkPlace& place = system.links[link];
    const auto index = std::size_t(place.index);
    const Resists resists =
        place.kind == LinkKind::Rod ? system.rods[index].resists : system.springs[index].resists;
    const bool woven = !system.linkStuff.empty() && system.linkStuff[link].role != LinkRole::Line;
    return resists == Resists::Tension && !woven && countAt(system.panelsBeside, int(link)) == 0
           && !hasTwin(system, place);
}

// Follows lines through particles that nothing else hangs on.
class LineFinder
{
public:
    explicit LineFinder(const System& system)
        : m_system(system)
        , m_open(system.links.size(), 0)
    {
        for (std::size_t i = 0; i < m_open.size(); ++i)
            m_open[i] = isLine(system, i);
    }

    std::vector<Line> all()
    {
        std::vector<Line> lines;
        const double least = leastShare * weightOfAll();
        for (std::size_t i = 0; i < m_open.size(); ++i) {
            if (!m_open[i])
                continue;
            m_open[i] = 0;
            Line line{m_system.links[i].key, {int(i)}};
            m_mass = 0.0;
            const int a = follow(m_system.links[i].a, line);
            const int b = follow(m_system.links[i].b, line);
            line.weight = std::max(least, m_mass * m_system.gravity.norm());
            if (a != b && holds(a) && holds(b))
                lines.push_back(std::move(line));
        }
        return lines;
    }

private:
    double weightOfAll() const
    {
        double mass = 0.0;
        for (std::size_t i = 0; i < m_system.mass.size(); ++i)
            mass += m_system.inverseMass[i] > 0.0 ? m_system.mass[i] : 0.0;
        return mass * m_system.gravity.norm();
    }

    // The particle where the line ends.
    int follow(int particle, Line& line)
    {
        while (isPassed(particle)) {
            const int next = openAt(particle);
            if (next < 0)
                break;
            m_open[std::size_t(next)] = 0;
            m_mass += m_system.mass[std::size_t(particle)];
            line.links.push_back(next);
            const LinkPlace& place = m_system.links[std::size_t(next)];
            particle = place.a == particle ? place.b : place.a;
        }
        return particle;
    }

    bool isPassed(int particle) const
    {
        return m_system.inverseMass[std::size_t(particle)] > 0.0
               && countAt(m_system.panelsAt, particle) == 0
               && countAt(m_system.rodsAt, particle) + countAt(m_system.springsAt, particle) == 2;
    }

    int openAt(int particle) const
    {
        const auto i = std::size_t(particle);
        const auto among = [&](const Rows& rows, const std::vector<int>& linkOf) {
            for (int k = rows.start[i]; k < rows.start[i + 1]; ++k)
                if (const int link = linkOf[std::size_t(rows.items[std::size_t(k)])];
                    m_open[std::size_t(link)])
                    return link;
            return -1;
        };
        const int rod = among(m_system.rodsAt, m_system.rodLink);
        return rod >= 0 ? rod : among(m_system.springsAt, m_system.springLink);
    }

    // A loose end with next to nothing on it does not.
    bool holds(int particle) const
    {
        const auto i = std::size_t(particle);
        return m_system.inverseMass[i] == 0.0 || countAt(m_system.panelsAt, particle) > 0
               || countAt(m_system.rodsAt, particle) + countAt(m_system.springsAt, particle) > 1
               || 2.0 * m_system.mass[i] >= m_mass;
    }

    const System& m_system;
    std::vector<std::uint8_t> m_open; // [links] lines that have not been followed
    double m_mass = 0.0;              // kg, of the line that is followed, without its ends
};

double tensionOf(const System& system, const State& state, const LinkPlace& link)
{
    const auto index = std::size_t(link.index);
    if (link.kind == LinkKind::Rod)
        return state.rodTension[index];
    const Spring& spring = system.springs[index];
    const double length =
        (state.position[std::size_t(link.b)] - state.position[std::size_t(link.a)]).norm();
    return spring.stiffness * (length - spring.restLength);
}

// Nothing when it has torn.
std::optional<double> borne(const Line& line, const System& system, const State& state)
{
    double most = 0.0;
    for (const int i : line.links) {
        const LinkPlace& link = system.links[std::size_t(i)];
        if (isTorn(link, state))
            return std::nullopt;
        most = std::max(most, tensionOf(system, state, link));
    }
    return most;
}

// Whether it has become the other of slack and taut, as an event.
bool changes(Line& line, double tension, double time, double timeStep, bool settled)
{
    line.mean += std::min(1.0, timeStep / SlackWatch::outlast) * (tension - line.mean);
    line.most = std::max(line.most, line.mean);
    const double low = std::max(line.weight, slackShare * line.most);
    const double high = std::max(2.0 * line.weight, tautShare * line.most);
    if (!line.known) {
        line.taut = tension > low;
        line.known = settled;
        line.since = time;
        return false;
    }
    const bool taut = line.taut ? tension >= low : tension > high;
    if (taut == line.taut) {
        line.since = time;
        return false;
    }
    if (time - line.since < SlackWatch::outlast)
        return false;
    line.taut = taut;
    line.since = time;
    return true;
}

} // namespace

std::vector<Line> linesOf(const System& system) { return LineFinder(system).all(); }

void SlackWatch::begin(double time)
{
    m_lines.clear();
    m_begin = time;
    m_serial = m_valuesSerial = 0;
}

// What is known of a line stays known when the system is edited.
void SlackWatch::prepare(const System& system)
{
    if (m_serial == system.serial && m_valuesSerial == system.valuesSerial)
        return;
    m_serial = system.serial;
    m_valuesSerial = system.valuesSerial;
    std::unordered_map<Key, const Line*> before;
    for (const Line& line : m_lines)
        before.emplace(line.key, &line);
    std::vector<Line> lines = linesOf(system);
    std::size_t links = 0;
    for (Line& line : lines) {
        links += line.links.size();
        const auto found = before.find(line.key);
        if (found == before.end())
            continue;
        line.mean = found->second->mean;
        line.most = found->second->most;
        line.since = found->second->since;
        line.taut = found->second->taut;
        line.known = found->second->known;
    }
    m_lines = std::move(lines);
    m_stride = 1 + int(links / atOnce);
}

void SlackWatch::look(const Simulation& simulation, std::vector<RunEvent>& events)
{
    const System& system = simulation.system();
    const State& state = simulation.state();
    prepare(system);
    if (m_lines.empty() || state.step % m_stride != 0)
        return;
    RunEvent slack{RunEvent::Kind::Slack, state.step, state.time, 0, 0};
    RunEvent taut{RunEvent::Kind::Taut, state.step, state.time, 0, 0};
    const double timeStep = m_stride * system.timeStep;
    const bool settled = state.time - m_begin >= settling;
    for (Line& line : m_lines) {
        const std::optional<double> tension = borne(line, system, state);
        if (!tension || !changes(line, *tension, state.time, timeStep, settled))
            continue;
        RunEvent& event = line.taut ? taut : slack;
        if (event.count++ == 0)
            event.what = TwinOrigins(state.splits).link(line.key);
    }
    for (const RunEvent& event : {slack, taut})
        if (event.count > 0)
            events.push_back(event);
}

} // namespace ripstop
