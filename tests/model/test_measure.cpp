// Probes, energies and the hash on states that are known.
//
// Stages: energies, masses and places of a state by hand; links and probes, also those with
// nothing to read; the mean glide; and the hash, which must see any single bit.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "base/hash_text.h"
#include "base/quantity.h"
#include "measure/diagnostics.h"
#include "measure/probe.h"

#include <QtTest>

#include <cstring>

Q_DECLARE_METATYPE(ripstop::ProbeSpec)

namespace ripstop::test_measure {

namespace {

// Three particles of 1, 2 and 3 kg at the corners of a right triangle with legs of 3 m and 4 m, a
// pin at the origin, a spring, a rod, one panel.
System known()
{
    System system = emptySystem(0.01);
    system.gravity = {0.0, -10.0, 0.0};
    addParticle(system, {0.0, 2.0, 0.0}, 1.0, {1.0, 0.0, 0.0});
    addParticle(system, {3.0, 2.0, 0.0}, 2.0, {0.0, -2.0, 0.0});
    addParticle(system, {0.0, 2.0, 4.0}, 3.0, {2.0, -1.0, 2.0});
    addPin(system, Vec3::Zero(), 5.0);
    addSpring(system, 0, 1, 2.0, 50.0, 3.0); // 1 m long, drawn out
    addRod(system, 1, 2, 4.0, 1e-3);         // 5 m: 1 m too long
    addSpring(system, 0, 2, 5.0, 40.0);      // 4 m: 1 m too short
    addPanel(system, 0, 1, 2, AirLaw::Paper, 4.0);
    system.wind = {0.0, 3.0, 0.0};
    finish(system);
    system.start.step = 1; // what rods pull with is that of a step
    system.start.rodTension[0] = 7.0;
    return system;
}

ProbeSpec probe(Quantity quantity, std::vector<int> particles, std::vector<int> links = {},
                std::vector<int> panels = {}, int from = -1)
{
    return {Key(1),           "probe",           quantity, std::move(particles),
            std::move(links), std::move(panels), from,     true};
}

} // namespace

class TestMeasure : public QObject
{
    Q_OBJECT

private slots:
    void energiesOfKnownState()
    {
        const System system = known();
        const Energies e = energies(system, system.start);
        // 1/2 (1 x 1 + 2 x 4 + 3 x 9); 6 kg x 10 m/s^2 x 2 m; springs and the compliant rod
        QVERIFY2(isNear(e.kinetic, 18.0, 1e-12), told(e.kinetic, 18.0));
        QVERIFY2(isNear(e.potential, 120.0, 1e-12), told(e.potential, 120.0));
        const double elastic = 0.5 * 50.0 + 0.5 * 40.0 + 0.5 * 1000.0;
        QVERIFY2(isNear(e.elastic, elastic, 1e-12), told(e.elastic, elastic));
        QCOMPARE(e.total(), e.kinetic + e.potential + e.elastic);
    }

    void elasticOnlyWhereItResists()
    {
        System system = known();
        system.springs[0].resists = Resists::Compression; // it is long
        system.springs[1].resists = Resists::Tension;     // it is short
        QCOMPARE(energies(system, system.start).elastic, 500.0);
        system.start.rodTorn[0] = 1;
        QCOMPARE(energies(system, system.start).elastic, 0.0);
        QCOMPARE(tensions(system, system.start), (std::vector<double>{0.0, 0.0, 0.0}));
    }

    void massesAndPlaces()
    {
        const System system = known();
        QCOMPARE(totalMass(system), 11.0);
        const Vec3 centre = Vec3(6.0, 12.0, 12.0) / 11.0;
        QVERIFY(isNear(centerOfMass(system, system.start.position), centre, 1e-14));
        QVERIFY(isNear(momentum(system, system.start), Vec3(7.0, -7.0, 6.0), 1e-14));
        QVERIFY(isNear(fabricArea(system, system.start), 6.0, 1e-14));
    }

    // In the author's order: springs first here, since finish() numbered them so.
    void linkValues()
    {
        const System system = known();
        const std::vector<double> strain = strains(system, system.start);
        QVERIFY2(isNear(strain[0], 0.5, 1e-14), told(strain[0], 0.5));
        QVERIFY2(isNear(strain[1], -0.2, 1e-14), told(strain[1], -0.2));
        QVERIFY2(isNear(strain[2], 0.25, 1e-14), told(strain[2], 0.25));
        const std::vector<double> tension = tensions(system, system.start);
        // 50 x 1 + 3 x (0 - 1) along x; 40 x (-1); what the solver said
        QVERIFY2(isNear(tension[0], 47.0, 1e-12), told(tension[0], 47.0));
        QVERIFY2(isNear(tension[1], -40.0, 1e-12), told(tension[1], -40.0));
        QVERIFY2(isNear(tension[2], 7.0, 1e-12), told(tension[2], 7.0));
    }

    // Before the first step a rod of 4 m that is 5 m long and gives way by 1 mm/N pulls with 1 kN;
    // one that resists what it is not, nothing; and of one that never gives way nothing is known.
    void rodsPullBeforeTheFirstStep()
    {
        System system = known();
        system.start.step = 0;
        system.start.rodTension[0] = 0.0;
        const auto pull = [&] { return pullOfRod(system, system.start, 0); };
        QVERIFY2(isNear(pull(), 1000.0, 1e-9), told(pull(), 1000.0));
        system.rods[0].resists = Resists::Compression;
        QCOMPARE(pull(), 0.0);
        system.rods[0].resists = Resists::Both;
        system.rods[0].compliance = 0.0;
        QCOMPARE(pull(), 0.0);
    }

    void probes_data()
    {
        QTest::addColumn<ProbeSpec>("spec");
        QTest::addColumn<double>("expected");
        QTest::addColumn<QString>("unit");
        const auto row = [](const char* name, ProbeSpec spec, double expected, const char* unit) {
            QTest::newRow(name) << std::move(spec) << expected << QString(unit);
        };
        row("x", probe(Quantity::PositionX, {1}), 3.0, "m");
        row("y", probe(Quantity::PositionY, {1}), 2.0, "m");
        row("z of the centre of mass", probe(Quantity::PositionZ, {0, 1, 2}), 2.0, "m");
        row("speed", probe(Quantity::Speed, {2}), 3.0, "m/s");
        row("speed of the centre of mass", probe(Quantity::Speed, {0, 1}),
            std::sqrt(1.0 + 16.0) / 3.0, "m/s");
        row("sink rate", probe(Quantity::SinkRate, {2}), 1.0, "m/s");
        row("tension", probe(Quantity::Tension, {}, {0}), 47.0, "N");
        row("largest tension", probe(Quantity::MaxTension, {}, {1, 2}), 7.0, "N");
        row("strain", probe(Quantity::Strain, {}, {1}), -0.2, "");
        row("largest strain", probe(Quantity::MaxStrain, {}, {0, 1, 2}), 0.5, "");
        row("distance", probe(Quantity::Distance, {2}, {}, {}, 1), 5.0, "m");
        row("elevation", probe(Quantity::Elevation, {0, 2}, {}, {}, 3),
            std::atan2(2.0, 3.0) * 180.0 / 3.14159265358979324, "deg");
        row("straight up", probe(Quantity::Elevation, {0}, {}, {}, 3), 90.0, "deg");
        row("glide ratio", probe(Quantity::GlideRatio, {2}), std::sqrt(8.0), "");
        // 1/2 rho 4 A |n.w| n.w, w = wind less the mean velocity of the corners, (1, -1, 2/3)
        row("air force", probe(Quantity::AirForce, {}, {}, {0}), 0.5 * 1.225 * 4.0 * 6.0 * 16.0,
            "N");
        row("kinetic energy", probe(Quantity::KineticEnergy, {}), 18.0, "J");
        row("potential energy", probe(Quantity::PotentialEnergy, {}), 120.0, "J");
        row("elastic energy", probe(Quantity::ElasticEnergy, {}), 545.0, "J");
        row("total energy", probe(Quantity::TotalEnergy, {}), 683.0, "J");
        row("torn links", probe(Quantity::TornLinks, {}, {0, 1, 2}), 0.0, "");
    }
    void probes()
    {
        QFETCH(ProbeSpec, spec);
        QFETCH(double, expected);
        QFETCH(QString, unit);
        const System system = known();
        const double got = Readings(system, system.start).value(spec);
        QVERIFY2(isNear(got, expected, 1e-12 * std::max(1.0, std::abs(expected))),
                 told(got, expected));
        const std::string_view name = unitOf(spec.quantity);
        QCOMPARE(QString::fromUtf8(name.data(), qsizetype(name.size())), unit);
    }

    void nothingToRead_data()
    {
        QTest::addColumn<ProbeSpec>("spec");
        QTest::newRow("no particle") << probe(Quantity::PositionY, {});
        QTest::newRow("no link") << probe(Quantity::MaxTension, {});
        QTest::newRow("no other end") << probe(Quantity::Distance, {1});
        QTest::newRow("glide of what does not sink") << probe(Quantity::GlideRatio, {0});
        QTest::newRow("glide of what has not sunk") << probe(Quantity::MeanGlideRatio, {0});
    }
    void nothingToRead()
    {
        QFETCH(ProbeSpec, spec);
        const System system = known();
        QVERIFY(std::isnan(Readings(system, system.start).value(spec)));
    }

    // From the start on: 12 m over the ground for 4 m of height.
    void meanGlide()
    {
        const System system = known();
        State state = system.start;
        state.position[1] += Vec3(0.0, -4.0, -12.0);
        const double got = Readings(system, state).value(probe(Quantity::MeanGlideRatio, {1}));
        QVERIFY2(isNear(got, 3.0, 1e-12), told(got, 3.0));
    }

    // The hash tells apart what differs in a single bit, and nothing else.
    void hash()
    {
        const System system = known();
        const std::uint64_t hash = stateHash(system.start);
        State same = system.start;
        QCOMPARE(stateHash(same), hash);
        const auto differs = [&](auto change) {
            State other = system.start;
            change(other);
            return stateHash(other) != hash;
        };
        QVERIFY(differs([](State& s) { s.position[2].z() = std::nextafter(4.0, 5.0); }));
        QVERIFY(differs([](State& s) { s.position[0].x() = -0.0; }));
        QVERIFY(differs([](State& s) { s.velocity[3].x() = 1e-300; }));
        QVERIFY(differs([](State& s) { std::swap(s.position[0], s.position[1]); }));
        QVERIFY(differs([](State& s) { ++s.step; }));
        QVERIFY(differs([](State& s) { s.springTorn[1] = 1; }));
        QVERIFY(differs([](State& s) { s.rodTorn[0] = 1; }));
        QVERIFY(differs([](State& s) { s.panelGone[0] = 1; }));
    }

    // FNV-1a with 64 bits: the offset basis is the hash of nothing.
    void hashText()
    {
        QCOMPARE(QString::fromStdString(ripstop::hashText(0xcbf29ce484222325u)),
                 QString("cbf29ce484222325"));
        QCOMPARE(QString::fromStdString(ripstop::hashText(0x1fu)), QString("000000000000001f"));
    }
};

const RegisteredTest registered("test_measure", runPlain<TestMeasure>);

} // namespace ripstop::test_measure
#include "test_measure.moc"
