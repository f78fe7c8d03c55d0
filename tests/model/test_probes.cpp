// What probes read in scenes whose answer is known by hand, and formulas made of them.
//
// Stages: readings of air on a plate, the reaction at a pin, free fall and strains, each with its
// answer by hand; then formulas: their values, those that are refused, and those in a scene that
// refer to each other.
#include "check/check.h"
#include "compile/compile.h"
#include "derived/formula.h"
#include "model/probe_bench.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <Eigen/Geometry>

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop::test_probes {

namespace {

constexpr double g = 9.80665; // m/s^2
constexpr double degree = std::numbers::pi / 180.0;

// A square of 2 m x 2 m whose nose points against a wind of 10 m/s along +x, pitched up and banked
// by these angles (degrees), held at its corners. Air presses across it only.
Bench plate(double pitch, double bank = 0.0)
{
    const double p = pitch * degree;
    const double b = bank * degree;
    // nose, right and up of something that flies towards -x; right is -z
    const Vec3 ahead(-std::cos(p), std::sin(p), 0.0);
    const Vec3 level(0.0, 0.0, -1.0);
    const Vec3 top = level.cross(ahead);
    const Vec3 right = std::cos(b) * level - std::sin(b) * top;
    const Vec3 middle(0.0, 50.0, 0.0);
    Part part;
    unsigned id = 10;
    for (const auto& [along, across] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}})
        part.particles.push_back(
            {.id = Id{id++},
             .position = middle + std::numbers::sqrt2 * (along * ahead + across * right),
             .mass = 1.0,
             .pinned = true});
    const Id fabric{2};
    part.panels = {{Id{20}, Id{10}, Id{12}, Id{11}, fabric},
                   {Id{21}, Id{10}, Id{11}, Id{13}, fabric}};
    Material material;
    material.airLaw = AirLaw::LinearNormal;
    material.skinFriction = 0.0;
    Wind wind;
    wind.velocity = Vec3(10.0, 0.0, 0.0);
    Bench bench;
    bench.scene.items = {{Id{1}, part}, {fabric, material}, {Id{3}, wind}};
    bench.scene.nextId = Id{30};
    return bench;
}

} // namespace

class TestProbes : public QObject
{
    Q_OBJECT

private slots:
    void attitude_data()
    {
        QTest::addColumn<double>("pitch");
        QTest::addColumn<double>("bank");
        QTest::newRow("level") << 0.0 << 0.0;
        QTest::newRow("nose up") << 30.0 << 0.0;
        QTest::newRow("nose down") << -12.0 << 0.0;
        QTest::newRow("banked") << 0.0 << 25.0;
        QTest::newRow("climbing turn") << 10.0 << 40.0;
    }

    // Against a level wind the angle of attack is that between the chord and the wind's projection
    // onto the plane of nose and top: tan a = tan(pitch) cos(bank).
    void attitude()
    {
        QFETCH(double, pitch);
        QFETCH(double, bank);
        Bench bench = plate(pitch, bank);
        for (const Quantity quantity :
             {Quantity::Pitch, Quantity::Roll, Quantity::Heading, Quantity::AngleOfAttack})
            bench.add({.quantity = quantity, .target = Id{10}, .from = Id{11}, .side = Id{12}});
        const std::vector<double> read = bench.read();
        const auto near = [](double a, double b) { return std::abs(a - b) < 1e-9; };
        QVERIFY2(near(read[0], pitch), qPrintable(QString::number(read[0])));
        QVERIFY2(near(read[1], bank), qPrintable(QString::number(read[1])));
        QVERIFY2(near(std::abs(read[2]), 180.0), qPrintable(QString::number(read[2])));
        const double attack =
            std::atan(std::tan(pitch * degree) * std::cos(bank * degree)) / degree;
        QVERIFY2(near(read[3], attack), qPrintable(QString::number(read[3])));
    }

    // A force across the plate alone: lift over drag is 1 / tan(pitch), and its centre is in the
    // middle.
    void liftAndDrag()
    {
        const double pitch = 30.0;
        Bench bench = plate(pitch);
        for (const Quantity quantity :
             {Quantity::AirForce, Quantity::Lift, Quantity::Drag, Quantity::LiftToDrag,
              Quantity::DragArea, Quantity::PressureX, Quantity::PressureY, Quantity::PressureZ,
              Quantity::Airspeed, Quantity::Area, Quantity::WindSpeed})
            bench.add({.quantity = quantity, .target = Id{1}});
        const std::vector<double> read = bench.read();
        const double force = read[0];
        QVERIFY(force > 1.0);
        const auto near = [](double a, double b) {
            return std::abs(a - b) < 1e-9 * std::max(1.0, std::abs(b));
        };
        QVERIFY(near(read[1], force * std::cos(pitch * degree)));
        QVERIFY(near(read[2], force * std::sin(pitch * degree)));
        QVERIFY(near(read[3], 1.0 / std::tan(pitch * degree)));
        QVERIFY(near(read[4], read[2] / (0.5 * bench.scene.settings.airDensity * 100.0)));
        QVERIFY(near(read[5], 0.0));
        QVERIFY(near(read[6], 50.0));
        QVERIFY(near(read[7], 0.0));
        QVERIFY(near(read[8], 10.0));
        QVERIFY(near(read[9], 4.0));
        QVERIFY(near(read[10], 10.0));
    }

    // 3 kg on a spring that m g stretches by 1 cm, at rest: the pin of 0.5 kg is held with the
    // weight of both.
    void reactionAtAPin()
    {
        Material spring;
        spring.stiffness = 3.0 * g / 0.01;
        Part part;
        part.particles = {{.id = Id{10}, .mass = 0.5, .pinned = true},
                          {.id = Id{11}, .position = Vec3(0.0, -1.01, 0.0), .mass = 3.0}};
        part.links = {{.id = Id{12},
                       .from = Id{10},
                       .to = Id{11},
                       .material = Id{2},
                       .kind = LinkKind::Spring,
                       .restLength = 1.0}};
        Bench bench;
        bench.scene.items = {{Id{1}, part}, {Id{2}, spring}};
        bench.scene.nextId = Id{30};
        bench.add({.quantity = Quantity::Reaction, .target = Id{1}});
        bench.add({.quantity = Quantity::Length, .target = Id{12}});
        bench.add({.quantity = Quantity::EnergyChange});
        const std::vector<double> read = bench.read(5);
        QVERIFY2(std::abs(read[0] - 3.5 * g) < 1e-9, qPrintable(QString::number(read[0], 'g', 12)));
        QVERIFY(std::abs(read[1] - 1.01) < 1e-12);
        QVERIFY(std::abs(read[2]) < 1e-12);
    }

    // A triangle of elastic cloth, 1 m high, that hangs from its upper side and is stretched by 1 %
    // by a weight at its tip. Nothing goes across, so that the pull is A S h with the area A = 1/2,
    // S = E t (h^2 - 1) / 2 along the weft, and the way of the tip 1 / (1 m).
    void reactionOfElasticCloth()
    {
        const double height = 1.01;
        const double pull = 0.5 * 1000.0 * 0.5 * (height * height - 1.0) * height;
        Material cloth;
        cloth.membraneStiffness = cloth.weftStiffness = 1000.0;
        cloth.shearStiffness = 500.0;
        cloth.poissonRatio = 0.0;
        Part part;
        part.carrier = FabricKind::Panels;
        part.particles = {{.id = Id{10}, .position = Vec3(-0.5, 0, 0), .mass = 0.1, .pinned = true},
                          {.id = Id{11}, .position = Vec3(0.5, 0, 0), .mass = 0.1, .pinned = true},
                          {.id = Id{12}, .position = Vec3(0, -height, 0), .mass = pull / g}};
        part.panels = {{.id = Id{13},
                        .a = Id{10},
                        .b = Id{11},
                        .c = Id{12},
                        .material = Id{2},
                        .restAB = 1.0,
                        .restBC = std::hypot(0.5, 1.0),
                        .restCA = std::hypot(0.5, 1.0)}};
        Bench bench;
        bench.scene.items = {{Id{1}, part}, {Id{2}, cloth}};
        bench.scene.nextId = Id{30};
        bench.add({.quantity = Quantity::Reaction, .target = Id{1}});
        for (const int steps : {0, 20}) {
            const double read = bench.read(steps)[0];
            QVERIFY2(std::abs(read - (pull + 0.2 * g)) < 1e-6 * pull,
                     qPrintable(QString::number(read, 'g', 12)));
        }
    }

    // A straight spar of two links of 1 m, clamped by two pins, of which the second link is turned
    // by 0.01. The pins hold, in the sum, what its moment pulls at the free end, 1 m away.
    void reactionOfASpar()
    {
        Material spar;
        spar.flexuralRigidity = 2.0;
        Part part;
        part.particles = {{.id = Id{10}, .position = Vec3(-1, 0, 0), .mass = 1.0, .pinned = true},
                          {.id = Id{11}, .position = Vec3(0, 0, 0), .mass = 1.0, .pinned = true},
                          {.id = Id{12}, .position = Vec3(1, 0, 0), .mass = 1.0}};
        part.links = {{.id = Id{13}, .from = Id{10}, .to = Id{11}, .material = Id{2}},
                      {.id = Id{14}, .from = Id{11}, .to = Id{12}, .material = Id{2}}};
        Bench bench;
        bench.scene.settings.gravity = Vec3::Zero();
        bench.scene.items = {{Id{1}, part}, {Id{2}, spar}};
        bench.scene.nextId = Id{30};
        bench.add({.quantity = Quantity::Reaction, .target = Id{1}});
        bench.add({.quantity = Quantity::BendingMoment, .target = Id{1}});
        const auto system = compile(bench.scene);
        QVERIFY(system);
        Simulation simulation(*system);
        State state = simulation.state();
        state.position[2] = Vec3(std::cos(0.01), std::sin(0.01), 0.0);
        simulation.place(std::move(state));
        const double read = simulation.frame()->probe.front();  // N
        const double moment = simulation.frame()->probe.back(); // N m
        QVERIFY(moment > 0.99 * 2.0 * 0.01);
        QVERIFY2(std::abs(read - moment) < 1e-4 * moment,
                 qPrintable(QString::number(read, 'g', 12)));
    }

    // What falls is accelerated by g; before the first step nothing is known of that.
    void freeFall()
    {
        Part part;
        part.particles = {{.id = Id{10}, .velocity = Vec3(3.0, 0.0, 4.0), .mass = 2.0}};
        Bench bench;
        bench.scene.items = {{Id{1}, part}};
        bench.scene.nextId = Id{30};
        bench.add({.quantity = Quantity::Acceleration, .target = Id{10}});
        bench.add({.quantity = Quantity::VelocityZ, .target = Id{10}});
        bench.add({.quantity = Quantity::Momentum, .target = Id{10}});
        QVERIFY(std::isnan(bench.read()[0]));
        QCOMPARE(bench.read()[2], 10.0);
        const std::vector<double> read = bench.read(1);
        QVERIFY2(std::abs(read[0] - g) < 1e-9, qPrintable(QString::number(read[0], 'g', 12)));
        QCOMPARE(read[1], 4.0);
    }

    // 21 springs strained by 0, 1, ... 20 %: the mean is 10 %, and 20 of 21 are at most 19 %.
    void strains()
    {
        Part part;
        for (unsigned i = 0; i <= 20; ++i) {
            const double x = double(i);
            part.particles.push_back(
                {.id = Id{100 + 3 * i}, .position = Vec3(x, 0, 0), .mass = 1.0, .pinned = true});
            part.particles.push_back({.id = Id{101 + 3 * i},
                                      .position = Vec3(x, 1.0 + 0.01 * i, 0),
                                      .mass = 1.0,
                                      .pinned = true});
            part.links.push_back({.id = Id{102 + 3 * i},
                                  .from = Id{100 + 3 * i},
                                  .to = Id{101 + 3 * i},
                                  .material = Id{2},
                                  .kind = LinkKind::Spring,
                                  .restLength = 1.0});
        }
        Bench bench;
        bench.scene.items = {{Id{1}, part}, {Id{2}, Material{}}};
        bench.scene.nextId = Id{300};
        for (const Quantity quantity :
             {Quantity::MeanStrain, Quantity::HighStrain, Quantity::MaxStrain})
            bench.add({.quantity = quantity, .target = Id{1}});
        const std::vector<double> read = bench.read();
        QVERIFY(std::abs(read[0] - 0.10) < 1e-12);
        QVERIFY(std::abs(read[1] - 0.19) < 1e-12);
        QVERIFY(std::abs(read[2] - 0.20) < 1e-12);
    }

    void formulas_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("expected");
        QTest::addColumn<QString>("unit");
        QTest::newRow("ratio") << "line_tension / weight" << 4.0 << "";
        QTest::newRow("sum of like") << "line_tension + 2 * weight" << 60.0 << "N";
        QTest::newRow("work") << "weight * height" << 150.0 << "J";
        QTest::newRow("power") << "weight * speed" << 20.0 << "W";
        QTest::newRow("pythagoras")
            << "sqrt(height^2 + (2*height)^2)" << 15.0 * std::sqrt(5.0) << "m";
        QTest::newRow("of an angle") << "sin(pitch)" << 0.5 << "";
        QTest::newRow("angle") << "2 * pitch" << 60.0 << "deg";
        QTest::newRow("odd unit") << "height * height * speed" << 450.0 << "m^3 s^-1";
        QTest::newRow("larger") << "max(height, 3 * height)" << 45.0 << "m";
        QTest::newRow("a number") << "2 * 21" << 42.0 << "";
        // numbers for some values only
        QTest::newRow("leg of a triangle")
            << "sqrt(line_tension^2 - weight^2)" << std::sqrt(1500.0) << "N";
        QTest::newRow("angle of a ratio") << "acos(weight / line_tension)" << std::acos(0.25) << "";
        QTest::newRow("root of a difference")
            << "sqrt(1 - (weight / line_tension)^2)" << std::sqrt(0.9375) << "";
        QTest::newRow("logarithm of a difference")
            << "ln(1 - weight / line_tension)" << std::log(0.75) << "";
        QTest::newRow("what is left")
            << "max(0 * weight, line_tension - 3 * weight)" << 10.0 << "N";
        QTest::newRow("root of what is below zero")
            << "sqrt(-height * height_of_pit)" << 30.0 << "m";
    }

    void formulas()
    {
        QFETCH(QString, text);
        QFETCH(double, expected);
        QFETCH(QString, unit);
        const std::vector<Formula::Name> names{{"line tension", "N"}, {"weight", "N"},
                                               {"height", "m"},       {"speed", "m/s"},
                                               {"pitch", "deg"},      {"height of pit", "m"}};
        const std::vector<double> values{40.0, 10.0, 15.0, 2.0, 30.0, -60.0};
        auto formula = Formula::read(text.toStdString(), names);
        QVERIFY2(bool(formula), formula ? "" : formula.message().english().c_str());
        QVERIFY(std::abs(formula->value(values) - expected) < 1e-12 * std::abs(expected));
        QCOMPARE(QString::fromStdString(formula->unit()), unit);
    }

    void badFormulas_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("said");
        QTest::newRow("empty") << " "
                               << "empty";
        QTest::newRow("unlike") << "weight + height"
                                << "different units";
        QTest::newRow("sine of a length") << "sin(height)"
                                          << "different units";
        QTest::newRow("unlike below a root") << "sqrt(weight - 3 * height)"
                                             << "different units";
        QTest::newRow("arc of a length") << "asin(height)"
                                         << "different units";
        QTest::newRow("unlike below a logarithm") << "ln(weight - 3 * height)"
                                                  << "different units";
        QTest::newRow("unknown") << "weight + lift"
                                 << "\"lift\" is no other probe";
        QTest::newRow("endless") << "1 / 0"
                                 << "no finite number";
        // the faults that its parser knows, in sentences that are translated; characters are
        // counted from 1
        const std::array<std::pair<const char*, const char*>, 20> faults{{
            {"weight *", "it ends where a number or a name has to follow"},
            {"weight height", "a sign such as * is missing before \"height\" at character 8"},
            {"2 weight", "a sign such as * is missing before \"weight\" at character 3"},
            {"weight 2", "a sign such as * is missing before \"2\" at character 8"},
            {"2 sin(1)", "a sign such as * is missing before \"sin\" at character 3"},
            {"weight (2)", "a sign such as * is missing before \"(\" at character 8"},
            {"weight ** 2", "no number or name stands before \"*\" at character 9"},
            {"2*(weight", "a \")\" is missing at its end"},
            {"weight)", "the \")\" at character 7 comes too early or has no \"(\" before it"},
            {"(2*)", "the \")\" at character 4 comes too early or has no \"(\" before it"},
            {"2*,3", "the comma at character 3 is out of place"},
            {"0,5*weight", "the comma at character 2 is out of place; decimals have a point"},
            {"max(1, 2) + 1,5", "the comma at character 14 is out of place"},
            {"sin(1, 2)", "the function \"sin\" has too many values in its brackets"},
            {"sin()", "the function \"sin\" has too few values in its brackets"},
            {"sin", "the function \"sin\" has no brackets behind it: sin(...)"},
            {"weight ? 1", "a choice is written condition ? value : other value"},
            {"\"weight\"", "texts in quotation marks have no place in a formula"},
            {"weight @ 2", "the sign at character 8 means nothing in a formula"},
            {"2 * \u00e9 + weight", "the sign at character 5 means nothing in a formula"},
        }};
        for (const auto& [text, said] : faults)
            QTest::newRow(text) << text << said;
    }

    void badFormulas()
    {
        QFETCH(QString, text);
        QFETCH(QString, said);
        const std::vector<Formula::Name> names{{"weight", "N"}, {"height", "m"}};
        const auto formula = Formula::read(text.toStdString(), names);
        QVERIFY(!formula);
        QVERIFY2(QString::fromStdString(formula.message().english()).contains(said),
                 formula.message().english().c_str());
    }

    // A formula may use formulas before it; one that cannot be worked out is told, reads nothing
    // and harms no other.
    void formulasInAScene()
    {
        Part part;
        part.particles = {{.id = Id{10}, .position = Vec3(3.0, 4.0, 0.0), .mass = 2.0}};
        Bench bench;
        bench.scene.items = {{Id{1}, part}};
        bench.scene.nextId = Id{30};
        bench.add({.quantity = Quantity::PositionX, .target = Id{10}});     // p30
        bench.add({.quantity = Quantity::Formula, .formula = "2 * p30"});   // p31
        bench.add({.quantity = Quantity::Formula, .formula = "p31 * p34"}); // p32
        bench.add({.quantity = Quantity::Formula, .formula = "p33 + 1"});   // p33, itself
        bench.add({.quantity = Quantity::PositionY, .target = Id{10}});     // p34
        const std::vector<double> read = bench.read();
        QCOMPARE(read[1], 6.0);
        QCOMPARE(read[2], 24.0);
        QVERIFY(std::isnan(read[3]));
        const auto problems = problemsOf(bench.scene);
        const auto told = std::ranges::count_if(problems, [](const Finding& problem) {
            return problem.message.english().starts_with("The formula of");
        });
        QCOMPARE(told, 1);
    }
};

const RegisteredTest registered("test_probes", runPlain<TestProbes>);

} // namespace ripstop::test_probes
#include "test_probes.moc"
