// Ripstop beside CalculiX: the same networks, solved as statics by finite elements and flown to
// rest by what a new scene has.
//
// The decks in tests/model/calculix are what CalculiX was given; scenes are made of the same files,
// so that neither can be another network than the other. README.md there says what they are and how
// their answers were made. Viscosity lets a network come to rest and changes nothing of where that
// is; loads are weights, in a gravity that pulls the way they do, and pressure is that of air that
// fills the square through its rim.
//
// Every node has to be where CalculiX has it to within 0.1 % of the longest way that any has gone,
// and every element has to pull within 0.1 % of what it pulls there; so has what is held, or of a
// twentieth of the largest where that is more. Both have the same law and the same triangles: what
// is left is how far each has iterated.
#include "builders/network.h"
#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "model/systems.h"
#include "registered_test.h"
#include "simulation/simulation.h"
#include "system/membrane.h"

#include <QFile>
#include <QtTest>

#include <Eigen/Dense>

#include <cmath>
#include <map>
#include <numbers>

namespace ripstop::test_calculix {

namespace {

using Row = std::vector<double>;
using Table = std::map<int, Row>; // by the number of the node or element

// Lines of numbers by the first word of the heading over them; a later heading with the same word
// begins anew, as *BOUNDARY of the second step does.
std::map<QString, std::vector<Row>> sections(const QString& file, const QString& heading)
{
    std::map<QString, std::vector<Row>> found;
    QFile in(SOURCE_DIR "/tests/model/calculix/" + file);
    if (!in.open(QIODevice::ReadOnly))
        return found;
    std::vector<Row>* rows = nullptr;
    for (const QString& line : QString::fromUtf8(in.readAll()).split('\n')) {
        const QStringList words = line.split(',');
        if (line.startsWith("**") || line.trimmed().isEmpty())
            continue;
        if (line.contains(QRegularExpression(heading))) {
            rows = &found[words.first()];
            rows->clear();
            continue;
        }
        Row row;
        for (const QString& word : words)
            row.push_back(word.trimmed().toDouble()); // a name is 0
        rows->push_back(row);
    }
    return found;
}

Table byNumber(const std::vector<Row>& rows)
{
    Table table;
    for (const Row& row : rows)
        table[int(row[0])] = Row(row.begin() + 1, row.end());
    return table;
}

Vec3 vectorOf(const Row& row, std::size_t from = 0)
{
    return {row[from], row[from + 1], row[from + 2]};
}

struct Deck
{
    Table nodes, elements;
    std::map<int, Vec3> load;  // N
    std::map<int, Vec3> moved; // m, what is held
    std::map<int, Guide> held; // Guide::None is held altogether, others slide along y
    double stiffness = 0.0;    // N/m, of a spring or E t
    double poisson = 0.0;
    double pressure = 0.0; // Pa

    bool isNet() const { return elements.begin()->second.size() == 2; }
};

Deck deckOf(const QString& name)
{
    auto cards = sections(name + ".inp", "^\\*");
    Deck deck;
    deck.nodes = byNumber(cards["*NODE"]);
    deck.elements = byNumber(cards["*ELEMENT"]);
    if (deck.isNet()) {
        deck.stiffness = cards["*SPRING"].front().front();
    } else {
        const Row& elastic = cards["*ELASTIC"].front();
        deck.stiffness = elastic[0] * cards["*MEMBRANE SECTION"].front().front();
        deck.poisson = elastic[1];
    }
    for (const Row& row : cards["*CLOAD"])
        deck.load.try_emplace(int(row[0]), Vec3::Zero()).first->second[int(row[1]) - 1] = row[2];
    std::map<int, int> directions;
    for (const Row& row : cards["*BOUNDARY"])
        for (int direction = int(row[1]); direction <= int(row[2]); ++direction) {
            deck.moved.try_emplace(int(row[0]), Vec3::Zero()).first->second[direction - 1] = row[3];
            ++directions[int(row[0])];
        }
    for (const auto& [node, count] : directions)
        deck.held[node] = count == 3 ? Guide::None : Guide::Line;
    for (const Row& row : cards["*DLOAD"])
        deck.pressure = row[2];
    return deck;
}

// Direction in which all loads of a deck pull.
Vec3 direction(const Deck& deck)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& [node, force] : deck.load)
        sum += force;
    return sum.stableNormalized();
}

// Wind blows into the square, whose rim is the mouth of a canopy that lets nothing through: the air
// inside comes to rest and has the wind's dynamic pressure. The cloth starts with a hollow, so that
// there is an inside.
void inflate(Scene& scene, Network& network, double pressure)
{
    scene.settings.airDensity = 1.225;
    addWind(scene, Vec3(0.0, 0.0, std::sqrt(2.0 * pressure / 1.225)));
    for (const Particle& particle : network.part().particles) {
        if (particle.pinned)
            continue;
        const Vec3 at = std::numbers::pi * particle.position;
        network.row(particle.id).position.z() = 0.02 * std::sin(at.x()) * std::sin(at.y());
    }
}

Scene sceneOf(const Deck& deck)
{
    constexpr double density = 0.042; // kg/m^2, of cloth that nothing hangs on
    Scene scene;
    scene.settings.viscosity = 10.0;
    scene.settings.airDensity = 0.0;
    scene.settings.gravity = standardGravity * direction(deck);
    Material material;
    material.skinFriction = 0.0;
    if (deck.isNet()) {
        material.compliance = 1.0 / deck.stiffness;
    } else {
        material.membraneStiffness = material.weftStiffness = deck.stiffness;
        material.shearStiffness = deck.stiffness / (2.0 * (1.0 + deck.poisson));
        material.poissonRatio = deck.poisson;
    }
    const Id made = addItem(scene, material);
    Network network(scene, "deck");
    std::map<int, Id> ids;
    for (const auto& [number, row] : deck.nodes) {
        const auto force = deck.load.find(number);
        const double mass = force == deck.load.end() ? 0.0 : force->second.norm() / standardGravity;
        ids[number] = network.particle(vectorOf(row), mass);
        network.texture(ids[number], row[0], row[1]);
    }
    const auto id = [&](double number) { return ids.at(int(number)); };
    for (const auto& [number, ends] : deck.elements)
        if (deck.isNet())
            network.rod(id(ends[0]), id(ends[1]), made);
        else
            network.panel(id(ends[0]), id(ends[1]), id(ends[2]), made);
    if (!deck.isNet())
        network.carryByPanels();
    if (deck.load.empty())
        network.addFabricMass(density);
    for (const auto& [number, guide] : deck.held) {
        Particle& particle = network.row(id(number));
        particle.pinned = guide == Guide::None;
        particle.guide = guide;
        particle.guideAxis = Vec3::UnitY();
        particle.position += deck.moved.at(number);
    }
    if (deck.pressure > 0.0)
        inflate(scene, network, deck.pressure);
    const Id part = network.finish({}, {});
    if (deck.pressure > 0.0)
        std::get<Part>(*findItem(scene, part)).canopyPressure = 1.0;
    return scene;
}

// Of a panel: the two main tensions per width as it is now, N/m, and what it pulls its corners
// back with, N.
struct PanelPull
{
    double most = 0.0, least = 0.0;
    std::array<Vec3, 3> back;
};

PanelPull pullOf(const System& system, const Membrane& membrane, const State& state)
{
    const Corners corners = cornersOf(system, membrane, state.position);
    const Vec3 tension = tensionIn(system, membrane, corners).tension;
    const auto [warp, weft] = axesOf(membrane, corners[1] - corners[0], corners[2] - corners[0]);
    Eigen::Matrix2d piola, stretch;
    piola << tension[0], tension[2], tension[2], tension[1];
    stretch << warp.dot(warp), warp.dot(weft), warp.dot(weft), weft.dot(weft);
    // F S F^T / J has the eigenvalues of S C / J
    const Eigen::Matrix2d cauchy = piola * stretch / std::sqrt(stretch.determinant());
    const double mean = 0.5 * cauchy.trace();
    const double radius = std::sqrt(std::max(0.0, mean * mean - cauchy.determinant()));
    PanelPull pull{mean + radius, mean - radius, {}};
    for (int corner = 0; corner < 3; ++corner) {
        const auto [along, across] = gradient(membrane, corner);
        const Eigen::Vector2d share = piola * Eigen::Vector2d(along, across);
        pull.back[std::size_t(corner)] = membrane.area * (share.x() * warp + share.y() * weft);
    }
    return pull;
}

// What the network comes to, as the tables of CalculiX have it.
struct Answer
{
    Table nodes;    // m, N
    Table elements; // N or N/m
};

Answer answerOf(const Deck& deck, const System& system, const State& state)
{
    Answer answer;
    std::vector<int> number; // of a particle
    for (const auto& [node, row] : deck.nodes) {
        const Vec3 way = state.position[number.size()] - vectorOf(row);
        answer.nodes[node] = {way.x(), way.y(), way.z(), 0.0, 0.0, 0.0};
        number.push_back(node);
    }
    const auto pull = [&](int particle, const Vec3& force) {
        const int node = number[std::size_t(particle)];
        for (int k = 0; k < 3 && deck.held.contains(node); ++k)
            answer.nodes[node][std::size_t(k) + 3] += force[k];
    };
    const std::vector<double> tension = tensions(system, state);
    std::size_t i = 0;
    for (const auto& [element, ends] : deck.elements) {
        if (deck.isNet()) {
            const auto [a, b] = std::pair(system.links[i].a, system.links[i].b);
            const Vec3 way = state.position[std::size_t(b)] - state.position[std::size_t(a)];
            pull(a, -tension[i] * way.normalized());
            pull(b, tension[i] * way.normalized());
            answer.elements[element] = {tension[i]};
        } else {
            const PanelPull panel = pullOf(system, system.membranes[i], state);
            const auto& corner = system.panels[std::size_t(system.membranes[i].panel)].corner;
            for (std::size_t k = 0; k < 3; ++k)
                pull(corner[k], panel.back[k]);
            answer.elements[element] = {panel.most, panel.least};
        }
        ++i;
    }
    return answer;
}

// The largest of the differences, 1, each over what is expected or, where that is less, `least`;
// of `count` numbers `from` a place in each row, as one vector.
double worst(const Table& got, const Table& expected, std::size_t from, std::size_t count,
             double least)
{
    double largest = 0.0;
    for (const auto& [number, row] : expected) {
        double difference = 0.0, size = 0.0;
        for (std::size_t k = from; k < from + count; ++k) {
            difference += std::pow(got.at(number)[k] - row[k], 2);
            size += std::pow(row[k], 2);
        }
        largest = std::max(largest, std::sqrt(difference) / std::max(least, std::sqrt(size)));
    }
    return largest;
}

double largest(const Table& table, std::size_t from)
{
    double most = 0.0;
    for (const auto& [number, row] : table)
        most = std::max(most, vectorOf(row, from).norm());
    return most;
}

} // namespace

class TestCalculix : public QObject
{
    Q_OBJECT

private slots:
    void agrees_data()
    {
        QTest::addColumn<double>("shortest"); // m, way of the node that goes farthest
        QTest::newRow("net") << 0.03;
        QTest::newRow("sheet") << 0.01;
        QTest::newRow("square") << 0.05;
    }
    void agrees()
    {
        QFETCH(double, shortest);
        const QString name = QTest::currentDataTag();
        const Deck deck = deckOf(name);
        auto tables = sections(name + ".csv", "^[a-z]");
        const Answer expected{byNumber(tables["node"]), byNumber(tables["element"])};
        QCOMPARE(expected.nodes.size(), deck.nodes.size());
        QCOMPARE(expected.elements.size(), deck.elements.size());

        const auto system = *compile(sceneOf(deck));
        Simulation simulation(system);
        QVERIFY(simulation.runUntil(4.0));
        const Answer got = answerOf(deck, *system, simulation.state());
        for (const Vec3& velocity : simulation.state().velocity)
            QVERIFY2(velocity.norm() < 1e-3, told(velocity.norm(), 0.0));

        const double longest = largest(expected.nodes, 0);
        QVERIFY(longest > shortest); // large enough that a linear answer would be another
        const double strongest = largest(expected.nodes, 3);
        const std::size_t pulls = expected.elements.begin()->second.size();
        const double moved = worst(got.nodes, expected.nodes, 0, 3, longest);
        const double held = worst(got.nodes, expected.nodes, 3, 3, 0.05 * strongest);
        const double pull = worst(got.elements, expected.elements, 0, pulls, 0.0);
        QVERIFY2(moved < 1e-3, told(moved, 0.0));
        QVERIFY2(held < 1e-3, told(held, 0.0));
        QVERIFY2(pull < 1e-3, told(pull, 0.0));
    }
};

const RegisteredTest registered("test_calculix", runPlain<TestCalculix>);

} // namespace ripstop::test_calculix
#include "test_calculix.moc"
