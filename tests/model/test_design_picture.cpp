// The small picture of a design: what is where, what hides what, and that each sample can be drawn
// from the command line in less than a second.
#include "export/design_picture.h"
#include "model/cli_call.h"
#include "registered_test.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <array>

namespace ripstop::test_design_picture {

namespace {

struct Pixel
{
    int red, green, blue, alpha;
};

Pixel at(const RasterPicture& picture, int x, int y)
{
    const auto* p = picture.pixels.data() + 4 * (y * picture.size + x);
    return {p[0], p[1], p[2], p[3]};
}

// Two upright squares of 1 m in one place as the eye sees them, the red one nearer to it.
Scene squares(bool redIsShown)
{
    Scene scene;
    Part part;
    std::uint32_t id = 10;
    const Vec3 toEye(std::sin(0.65) * std::cos(0.42), std::sin(0.42),
                     std::cos(0.65) * std::cos(0.42));
    const Vec3 right(std::cos(0.65), 0.0, -std::sin(0.65));
    const Vec3 up = toEye.cross(right);
    const auto square = [&](double nearer, Id material) {
        const Id first{id};
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            part.particles.push_back(
                {.id = Id{id++}, .position = nearer * toEye + x * right + y * up});
        const auto corner = [&](std::uint32_t i) { return Id{std::uint32_t(first) + i}; };
        part.panels.push_back({Id{id + 100}, corner(0), corner(1), corner(2), material});
        part.panels.push_back({Id{id + 101}, corner(0), corner(2), corner(3), material});
    };
    square(1.0, Id{2});
    square(0.0, Id{3});
    scene.items = {{Id{1}, part},
                   {Id{2}, Material{.name = "red", .color = "#ff0000", .shown = redIsShown}},
                   {Id{3}, Material{.name = "blue", .color = "#0000ff"}}};
    return scene;
}

} // namespace

class TestDesignPicture : public QObject
{
    Q_OBJECT

private slots:
    void theNearestHidesTheOthers()
    {
        const RasterPicture both = pictureOf(squares(true), 64);
        QCOMPARE(both.pixels.size(), std::size_t(4 * 64 * 64));
        QCOMPARE(at(both, 1, 1).alpha, 0); // the margin
        QCOMPARE(at(both, 32, 32).alpha, 255);
        QVERIFY(at(both, 32, 32).red > 90 && at(both, 32, 32).blue == 0);
        const RasterPicture one = pictureOf(squares(false), 64);
        QVERIFY(at(one, 32, 32).blue > 90 && at(one, 32, 32).red == 0);
    }

    void emptyIsTransparent()
    {
        const RasterPicture nothing = pictureOf(Scene(), 16);
        QVERIFY(std::ranges::all_of(nothing.pixels, [](std::uint8_t byte) { return byte == 0; }));
        QVERIFY(pngBytes(nothing));
    }

    void eachSample_data()
    {
        QTest::addColumn<QString>("file");
        for (const QString& name : QDir(SCENES_DIR).entryList({"*.ripstop.json"}))
            QTest::newRow(qPrintable(name)) << QString(SCENES_DIR "/" + name);
    }

    void eachSample()
    {
        QFETCH(QString, file);
        const QTemporaryDir folder;
        const QString picture = folder.filePath("picture");
        const Outcome outcome = call({"thumbnail", file, "-o", picture, "--size", "128"});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        QFile png(picture);
        QVERIFY(png.open(QIODevice::ReadOnly));
        QVERIFY(png.readAll().startsWith("\x89PNG\r\n\x1a\n"));
    }

    void refuses()
    {
        const Outcome missing = call({"thumbnail", "missing.ripstop.json", "-o", "x.png"});
        QCOMPARE(missing.exitCode, 1);
        QVERIFY(missing.error.contains("missing.ripstop.json"));
        QCOMPARE(call({"thumbnail", scene("delta_kite"), "-o", "/nowhere/x.png"}).exitCode, 1);
        QCOMPARE(call({"thumbnail", scene("delta_kite"), "-o", "x.png", "--size", "1"}).exitCode,
                 2);
    }
};

const RegisteredTest registered("test_design_picture", runPlain<TestDesignPicture>);

} // namespace ripstop::test_design_picture
#include "test_design_picture.moc"
