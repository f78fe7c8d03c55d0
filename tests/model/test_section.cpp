// The section of a sail, against mean lines of aerofoils whose camber is known (Abbott and von
// Doenhoff, Theory of Wing Sections, 1959, section 6.4): two parabolas that meet at the crest.
#include "model/probe_bench.h"
#include "registered_test.h"

#include <Eigen/Geometry>

#include <QtTest>

#include <cmath>

namespace ripstop::test_section {

namespace {

constexpr int along = 100;                 // cells
constexpr int across = 4;                  // an odd column is in no node of the section
constexpr double chord = 1.7, width = 0.8; // m

double meanLine(double x, double camber, double crest) // 1, all of the chord
{
    const double part = x < crest ? crest : 1.0 - crest;
    return camber / (part * part)
           * (x < crest ? 2.0 * crest * x - x * x : 1.0 - 2.0 * crest + 2.0 * crest * x - x * x);
}

// A sheet that is arched along x, and turned anyhow.
Bench sail(double camber, double crest)
{
    Part part;
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.1, Vec3(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
    const auto at = [](int i, int j) { return Id(100 + unsigned(j * (along + 1) + i)); };
    for (int j = 0; j <= across; ++j)
        for (int i = 0; i <= along; ++i) {
            const double x = double(i) / along;
            const Vec3 place(chord * x, chord * meanLine(x, camber, crest),
                             width * (double(j) / across - 0.5));
            part.particles.push_back({.id = at(i, j),
                                      .position = Vec3(4.0, 5.0, 6.0) + turn * place,
                                      .mass = 1.0,
                                      .pinned = true});
        }
    unsigned id = 5000;
    const auto add = [&](Id a, Id b, Id c) { part.panels.push_back({Id{id++}, a, b, c, Id{2}}); };
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < along; ++i) {
            add(at(i, j), at(i, j + 1), at(i + 1, j));
            add(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
        }
    Bench bench;
    bench.scene.items = {{Id{1}, part}, {Id{2}, Material()}};
    bench.scene.nextId = Id{9000};
    const int middle = across / 2;
    for (const Quantity quantity : {Quantity::Camber, Quantity::CamberPosition})
        bench.add({.quantity = quantity, .target = at(0, middle), .from = at(along, middle)});
    return bench;
}

} // namespace

class TestSection : public QObject
{
    Q_OBJECT

private slots:
    void measuresMeanLines_data()
    {
        QTest::addColumn<double>("camber");
        QTest::addColumn<double>("crest");
        QTest::newRow("2 % at 40 %") << 0.02 << 0.4;
        QTest::newRow("6 % at 30 %") << 0.06 << 0.3;
        QTest::newRow("below, 4 % at half") << -0.04 << 0.5;
    }

    void measuresMeanLines()
    {
        QFETCH(double, camber);
        QFETCH(double, crest);
        const std::vector<double> read = sail(camber, crest).read();
        QVERIFY2(std::abs(read[0] - std::abs(camber)) < 1e-9, qPrintable(QString::number(read[0])));
        QVERIFY2(std::abs(read[1] - crest) < 1e-9, qPrintable(QString::number(read[1])));
    }

    void flatSailHasNone()
    {
        const std::vector<double> read = sail(0.0, 0.4).read();
        QVERIFY2(read[0] < 1e-12, qPrintable(QString::number(read[0])));
    }

    // Without a tail, and where there are no panels, there is nothing to read.
    void saysNothingWithoutASection()
    {
        Bench bench = sail(0.02, 0.4);
        bench.add({.quantity = Quantity::Camber, .target = Id{100}});
        QVERIFY(std::isnan(bench.read().back()));
        std::get<Part>(bench.scene.items.front().item).panels.clear();
        QVERIFY(std::isnan(bench.read().front()));
    }
};

const RegisteredTest registered("test_section", runPlain<TestSection>);

} // namespace ripstop::test_section
#include "test_section.moc"
