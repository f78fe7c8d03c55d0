// Smoothing against what it does to waves: on a ring of n particles a wave of k turns has the
// eigenvalue 1 - f (1 - cos(2 pi k / n)) in one pass, with f negative in Taubin's second.
//
// Stages: the eigenvalue of each wave; then what must stay (borders, what is not selected) and
// what becomes of rest lengths; then the operation as an edit that can be undone, and its
// refusals.
#include "model/systems.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "shaping/operation.h"
#include "shaping/smooth.h"

#include <QtTest>

#include <numbers>

namespace ripstop::test_smooth {

namespace {

constexpr double pi = std::numbers::pi;

struct Ring
{
    Scene scene;
    Id part{};
};

// A ring of lines, with a wave of k turns about the radius 1 m.
Ring ring(int count, int turns, double height)
{
    Ring made;
    made.part = takeId(made.scene);
    Part part;
    for (int i = 0; i < count; ++i) {
        Particle particle;
        particle.id = takeId(made.scene);
        const double angle = 2.0 * pi * i / count;
        particle.position =
            Vec3(std::cos(angle), height * std::cos(turns * angle), std::sin(angle));
        part.particles.push_back(particle);
    }
    for (int i = 0; i < count; ++i) {
        Link link;
        link.id = takeId(made.scene);
        link.from = part.particles[std::size_t(i)].id;
        link.to = part.particles[std::size_t((i + 1) % count)].id;
        part.links.push_back(link);
    }
    made.scene.items.push_back({made.part, part});
    return made;
}

Part& partOf(Scene& scene) { return std::get<Part>(scene.items.front().item); }

// A sheet of builder cloth with a bump on its middle.
Scene bumpySheet()
{
    Parameters parameters;
    const Builder& builder = *findBuilder("cloth");
    for (const Parameter& one : builder.parameters)
        parameters[std::string(one.key)] = one.initial;
    parameters["columns"] = parameters["rows"] = 6;
    parameters["sphere"] = 0;
    Scene scene = *builder.build(parameters);
    return scene;
}

Part& sheetOf(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item))
            return *part;
    std::abort();
}

} // namespace

class TestSmooth : public QObject
{
    Q_OBJECT

private slots:
    void aWaveFallsByItsEigenvalue_data();
    void aWaveFallsByItsEigenvalue();
    void bordersStayOrKeepTheirLine();
    void whatIsNotSelectedStays();
    void restLengthsFollowOrStay();
    void theOperationIsOneStepBack();
    void nothingToSmoothSaysSo();
};

void TestSmooth::aWaveFallsByItsEigenvalue_data()
{
    QTest::addColumn<Smoothing>("smoothing");
    QTest::addColumn<int>("turns");
    QTest::addColumn<double>("factor");
    QTest::addColumn<int>("iterations");
    QTest::newRow("zigzag, half way, once: gone") << Smoothing::Laplacian << 12 << 0.5 << 1;
    QTest::newRow("long wave, Laplacian") << Smoothing::Laplacian << 1 << 0.5 << 10;
    QTest::newRow("short wave, Laplacian") << Smoothing::Laplacian << 6 << 0.3 << 5;
    QTest::newRow("long wave, Taubin") << Smoothing::Taubin << 1 << 0.5 << 10;
    QTest::newRow("short wave, Taubin") << Smoothing::Taubin << 8 << 0.5 << 10;
}

void TestSmooth::aWaveFallsByItsEigenvalue()
{
    QFETCH(Smoothing, smoothing);
    QFETCH(int, turns);
    QFETCH(double, factor);
    QFETCH(int, iterations);
    constexpr int count = 24;
    Ring made = ring(count, turns, 0.2);
    const auto share = [&](int k) {
        const double lift = 1.0 - std::cos(2.0 * pi * k / count);
        double each = 1.0 - factor * lift;
        if (smoothing == Smoothing::Taubin)
            each *= 1.0 - lift / (0.1 - 1.0 / factor);
        return std::pow(each, iterations);
    };
    (void)apply(made.scene,
                smoothed(made.scene, {made.part}, {smoothing, factor, iterations, Border::Kept},
                         RestLengths::Keep));
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * pi * i / count;
        const double round = share(1); // the ring itself is a wave of one turn
        const Vec3 expected(round * std::cos(angle), 0.2 * share(turns) * std::cos(turns * angle),
                            round * std::sin(angle));
        const Vec3& got = partOf(made.scene).particles[std::size_t(i)].position;
        QVERIFY2(isNear(got, expected, 1e-12), told(got, expected));
    }
}

void TestSmooth::bordersStayOrKeepTheirLine()
{
    for (const Border border : {Border::Kept, Border::Along}) {
        Scene scene = bumpySheet();
        Part& sheet = sheetOf(scene);
        sheet.particles[24].position.y() += 0.1; // 7 x 7: in the middle
        sheet.particles[3].position.y() += 0.1;  // in the middle of the first edge
        const std::vector<Particle> before = sheet.particles;
        const Id id = findRow(sheet.particles, sheet.particles[24].id)->id;
        QVERIFY(id != noId);
        std::vector<Id> all;
        for (const Particle& row : sheet.particles)
            all.push_back(row.id);
        (void)apply(
            scene, smoothed(scene, all, {Smoothing::Laplacian, 0.5, 1, border}, RestLengths::Keep));
        const std::vector<Particle>& now = sheetOf(scene).particles;
        // its neighbours lie flat, so that it goes half way
        QVERIFY2(isNear(now[24].position.y(), before[24].position.y() - 0.05, 1e-12), "middle");
        const double rise = border == Border::Kept ? 0.1 : 0.05;
        QVERIFY2(isNear(now[3].position.y(), before[2].position.y() + rise, 1e-12),
                 told(now[3].position.y(), before[2].position.y() + rise));
    }
}

void TestSmooth::whatIsNotSelectedStays()
{
    Ring made = ring(8, 4, 0.3);
    const std::vector<Particle> before = partOf(made.scene).particles;
    (void)apply(made.scene,
                smoothed(made.scene, {before[2].id}, {Smoothing::Laplacian, 1.0, 1, Border::Kept},
                         RestLengths::Keep));
    const std::vector<Particle>& now = partOf(made.scene).particles;
    for (std::size_t i = 0; i < now.size(); ++i)
        if (i != 2)
            QCOMPARE(now[i], before[i]);
    const Vec3 middle = 0.5 * (before[1].position + before[3].position);
    QVERIFY2(isNear(now[2].position, middle, 1e-12), told(now[2].position, middle));
}

void TestSmooth::restLengthsFollowOrStay()
{
    for (const RestLengths lengths : {RestLengths::Keep, RestLengths::Rebind}) {
        Ring made = ring(12, 6, 0.1);
        (void)apply(made.scene, smoothed(made.scene, {made.part}, {}, lengths));
        const Part& part = partOf(made.scene);
        for (const Link& link : part.links) {
            const double distance = (findRow(part.particles, link.from)->position
                                     - findRow(part.particles, link.to)->position)
                                        .norm();
            const double expected = lengths == RestLengths::Keep ? 1.0 : distance;
            QVERIFY2(isNear(link.restLength, expected, 1e-12), told(link.restLength, expected));
        }
    }
}

void TestSmooth::theOperationIsOneStepBack()
{
    Ring made = ring(12, 6, 0.1);
    const std::vector<Entry> before = made.scene.items;
    const Operation& operation = *findOperation("smooth");
    Parameters parameters;
    for (const Parameter& one : operation.parameters)
        parameters[std::string(one.key)] = one.initial;
    const Result<Shaped> shaped = operation.apply(made.scene, {made.part}, parameters);
    QVERIFY(shaped);
    const Edit back = apply(made.scene, shaped->edit);
    QVERIFY(made.scene.items != before);
    (void)apply(made.scene, back);
    QVERIFY(made.scene.items == before);
}

void TestSmooth::nothingToSmoothSaysSo()
{
    Scene scene;
    const Id id = takeId(scene);
    Part part;
    Particle particle;
    particle.id = takeId(scene);
    part.particles.push_back(particle);
    scene.items.push_back({id, part});
    const Operation& operation = *findOperation("smooth");
    Parameters parameters;
    for (const Parameter& one : operation.parameters)
        parameters[std::string(one.key)] = one.initial;
    for (const std::vector<Id>& ids : {std::vector<Id>{}, std::vector<Id>{id}}) {
        const Result<Shaped> shaped = operation.apply(scene, ids, parameters);
        QVERIFY(!shaped);
        QVERIFY(shaped.message().english().find("Select fabric or lines") != std::string::npos);
    }
}

const RegisteredTest registered("test_smooth", runPlain<TestSmooth>);

} // namespace ripstop::test_smooth
#include "test_smooth.moc"
