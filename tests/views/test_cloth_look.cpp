// How cloth is drawn: light that falls through it, colours that stand for numbers, pictures on it,
// borders and seams as bands, the mesh only when asked for, and lines as thick as they are.
//
// Stages: pictures of a square sheet tell by their pixels; then the pieces of bands by their areas.
#include "views/bare_view.h"
#include "views/run_with_widgets.h"

#include "builders/builder.h"
#include "layers/printed_cloth.h"
#include "look/bands.h"
#include "look/color_map.h"
#include "look/scene_frame.h"
#include "look/theme.h"

#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_cloth_look {

namespace {

// A square of two panels with sides of 2 m, turned about x. Ids: part 1, particles 2 to 5 round
// from the lower left, panels 6 and 7, material 8.
Scene sheet(double degrees)
{
    const Eigen::AngleAxisd turn(degrees * 3.14159265358979 / 180.0, Vec3::UnitX());
    const auto corner = [&](std::uint32_t id, double x, double y) {
        Particle particle{.id = Id{id}, .position = turn * Vec3(x, y, 0.0), .pinned = true};
        particle.textureU = 0.5 + 0.5 * x;
        particle.textureV = 0.5 + 0.5 * y;
        return particle;
    };
    Scene scene;
    Part part;
    part.particles = {corner(2, -1, -1), corner(3, 1, -1), corner(4, 1, 1), corner(5, -1, 1)};
    part.panels.push_back({Id{6}, Id{2}, Id{3}, Id{4}, Id{8}});
    part.panels.push_back({Id{7}, Id{2}, Id{4}, Id{5}, Id{8}});
    Material material;
    material.color = "#b0b0b0";
    material.arealDensity = 0.04;
    scene.items = {{Id{1}, part}, {Id{8}, material}};
    scene.nextId = Id{9};
    return scene;
}

struct View : BareView
{
    explicit View(Scene scene)
        : BareView(std::move(scene), {400, 300})
    {
        viewport.setWindShown(false);
        viewport.view(PresetView::Front);
    }
    bool isReady()
    {
        return QTest::qWaitForWindowExposed(&viewport)
               && QTest::qWaitFor([this] { return bool(player.frame()); });
    }

    QColor at(const Vec3& place) // of the scene
    {
        const QImage image = viewport.image(Viewport::Overlays::Without);
        const Eigen::Vector4d seen =
            viewport.camera().projection(400.0 / 300.0) * place.homogeneous();
        return image.pixelColor(int((0.5 + 0.5 * seen.x() / seen.w()) * image.width()),
                                int((0.5 - 0.5 * seen.y() / seen.w()) * image.height()));
    }
};

double areaOf(const std::array<Vec3, 3>& corners)
{
    return 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
}

} // namespace

class TestClothLook : public QObject
{
    Q_OBJECT

private slots:
    // The sun is above: of light cloth the lower side glows, of heavy cloth it does so less.
    void lightFallsThroughCloth()
    {
        const auto lightness = [](double density, PresetView from) {
            Scene scene = sheet(-90.0);
            std::get<Material>(*findItem(scene, Id{8})).arealDensity = density;
            View view(scene);
            if (!view.isReady())
                return 0.0;
            view.viewport.view(from);
            return double(view.at(Vec3(0.2, 0.0, 0.3)).lightnessF());
        };
        const double lit = lightness(0.04, PresetView::Top);
        const double behind = lightness(0.04, PresetView::Bottom);
        QVERIFY2(behind > 0.35 * lit, qPrintable(QString("%1 of %2").arg(behind).arg(lit)));
        QVERIFY(behind < lit);
        QVERIFY(lightness(0.3, PresetView::Bottom) < behind - 0.05);
    }

    void numbersHaveTheColourOfTheLegend()
    {
        Scene scene = sheet(10.0);
        Part& part = std::get<Part>(*findItem(scene, Id{1}));
        part.carrier = FabricKind::Panels;
        for (Panel& panel : part.panels)
            panel.strengthFactor = 0.25;
        std::get<Material>(*findItem(scene, Id{8})).membraneStiffness = 1e4;
        View view(scene);
        QVERIFY(view.isReady());
        view.viewport.setColorBy(ColorBy::Strength);
        const ValueRange range{0.0, 1.0};
        view.viewport.setFixedRange(range);
        const Color meant = ColorMap::sequential().at(0.25, range);
        const QColor seen = view.at(Vec3(0.3, 0.1, 0.0));
        QVERIFY2(std::abs(seen.red() - meant[0]) <= 2 && std::abs(seen.green() - meant[1]) <= 2
                     && std::abs(seen.blue() - meant[2]) <= 2,
                 qPrintable(QString("%1, and the legend has %2 %3 %4")
                                .arg(seen.name())
                                .arg(meant[0])
                                .arg(meant[1])
                                .arg(meant[2])));
    }

    // A picture of four squares: red and green above, blue and white below.
    void picturesLieAtTheirPlace()
    {
        const QTemporaryDir folder;
        QImage squares(64, 64, QImage::Format_RGB888);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                squares.setPixelColor(x, y,
                                      y < 32 ? (x < 32 ? Qt::red : Qt::green)
                                             : (x < 32 ? Qt::blue : Qt::white));
        QVERIFY(squares.save(folder.filePath("squares.png")));
        Scene scene = sheet(0.0);
        Material& material = std::get<Material>(*findItem(scene, Id{8}));
        material.picture = folder.filePath("squares.png").toStdString();
        View view(scene);
        QVERIFY(view.isReady());
        const auto isMostly = [](const QColor& color, Qt::GlobalColor what) {
            const QColor pure(what);
            const int share = 2 * std::max({color.red(), color.green(), color.blue()}) / 3;
            return (color.red() > share) == (pure.red() > 128)
                   && (color.green() > share) == (pure.green() > 128)
                   && (color.blue() > share) == (pure.blue() > 128);
        };
        QVERIFY(isMostly(view.at(Vec3(-0.5, 0.5, 0.0)), Qt::red));
        QVERIFY(isMostly(view.at(Vec3(0.5, 0.5, 0.0)), Qt::green));
        QVERIFY(isMostly(view.at(Vec3(-0.5, -0.5, 0.0)), Qt::blue));
        QVERIFY(isMostly(view.at(Vec3(0.5, -0.5, 0.0)), Qt::white));

        // a picture of 1 m that is moved by half of it: a red square has its middle in the middle
        Scene small = scene;
        Material& moved = std::get<Material>(*findItem(small, Id{8}));
        moved.pictureWidth = 1.0;
        moved.pictureRight = 0.25;
        moved.pictureUp = -0.25;
        View other(small);
        QVERIFY(other.isReady());
        QVERIFY(isMostly(other.at(Vec3(0.0, 0.0, 0.0)), Qt::red));
        QVERIFY(isMostly(other.at(Vec3(0.5, 0.0, 0.0)), Qt::green));
        QVERIFY(isMostly(other.at(Vec3(0.0, -0.5, 0.0)), Qt::blue));
        QVERIFY(isMostly(other.at(Vec3(-1.0 + 0.1, 0.0, 0.0)), Qt::red)); // again after 1 m
    }

    // VTK complains with each frame that draws nothing, once in a hundred times that it gets there.
    void aPictureOnNothingIsNotDrawn()
    {
        vtkNew<vtkPolyData> vertices;
        vtkNew<vtkPoints> points;
        points->SetNumberOfPoints(3);
        vertices->SetPoints(points);
        PrintedCloth print(*vertices);
        const std::vector corners{Corners{0, 1, 2}};
        for (const std::size_t count : {1, 0, 1}) {
            print.rebuild({}, {}, std::span(corners).first(count));
            QCOMPARE(print.actor().GetVisibility() != 0, count == 1);
        }
    }

    // Streaks of wind are seen through what they are made of: what shines through is the picture,
    // not the cloth below it.
    void windBlowsBeforePictures()
    {
        const QTemporaryDir folder;
        QImage blue(8, 8, QImage::Format_RGB888);
        blue.fill(Qt::blue);
        QVERIFY(blue.save(folder.filePath("blue.png")));
        Scene scene = sheet(0.0);
        Material& material = std::get<Material>(*findItem(scene, Id{8}));
        material.picture = folder.filePath("blue.png").toStdString();
        material.color = "#ff0000";
        Wind wind;
        wind.velocity = Vec3(8.0, 0.0, 0.0);
        scene.items.push_back({scene.nextId, wind});
        scene.nextId = Id{10};
        View view(scene);
        QVERIFY(view.isReady());
        const auto seen = [&](bool streaks) {
            view.viewport.setStreaksShown(streaks);
            return view.viewport.image(Viewport::Overlays::Without);
        };
        const QImage still = seen(false), windy = seen(true);
        const int most = Theme::from(view.viewport.palette()).wind.red();
        int streaked = 0;
        for (int y = 0; y < still.height(); ++y)
            for (int x = 0; x < still.width(); ++x) {
                const QColor below = still.pixelColor(x, y), above = windy.pixelColor(x, y);
                if (below.blue() < 2 * below.green() || below.blue() < 2 * below.red()
                    || below == above)
                    continue; // sky, ground, or no streak
                ++streaked;
                QVERIFY2(above.red() <= std::max(below.red(), most) + 4,
                         qPrintable(QString("%1 over %2").arg(above.name(), below.name())));
            }
        QVERIFY(streaked > 20);
    }

    // A strip has the area of the teeth that it stands for, and no point of it is farther from the
    // edge than it is wide.
    void bordersAreStraightStripsOfTheSameArea()
    {
        const Scene scene = *build(*findBuilder("hang_glider"), {});
        const auto frame = sceneFrame(scene);
        const Layout& layout = *frame->layout;
        const Look look = lookOf(scene, layout);
        const auto panels = facingAlike(layout.panelCorners);
        std::vector<std::array<ClothPoint, 3>> points(panels.size());
        for (std::size_t p = 0; p < panels.size(); ++p)
            for (std::size_t i = 0; i < 3; ++i) {
                const bool isTurned = panels[p][1] != layout.panelCorners[p][1];
                const auto& place = look.panelCloth[p].place[isTurned ? (3 - i) % 3 : i];
                points[p][i] = {place[0], place[1], 0.0F, 0.0F};
            }
        const Bands bands = bandsOf(panels, points, layout, look);

        const Color border = colorFromText("#264653");
        double teeth = 0.0, strips = 0.0; // m^2
        const auto corner = [&](int panel, std::size_t i) {
            return frame->position[std::size_t(panels[std::size_t(panel)][i])];
        };
        for (int p = 0; p < int(panels.size()); ++p)
            if (look.panelColor[std::size_t(p)] == border)
                teeth += areaOf({corner(p, 0), corner(p, 1), corner(p, 2)});
        std::set<std::pair<int, std::vector<int>>> seen; // two sides may cut the same piece
        for (const BandPiece& piece : bands.pieces) {
            if (piece.color != border)
                continue;
            std::vector<int> rounded;
            std::vector<Vec3> places;
            for (const auto& shares : piece.corners) {
                Vec3 place = Vec3::Zero();
                for (std::size_t i = 0; i < 3; ++i) {
                    place += double(shares[i]) * corner(piece.panel, i);
                    rounded.push_back(int(std::lround(200.0 * double(shares[i]))));
                }
                places.push_back(place);
            }
            if (!seen.emplace(piece.panel, rounded).second)
                continue;
            for (std::size_t i = 2; i < places.size(); ++i)
                strips += areaOf({places[0], places[i - 1], places[i]});
        }
        QVERIFY(teeth > 1.0);
        QVERIFY2(std::abs(strips / teeth - 1.0) < 0.1,
                 qPrintable(QString("%1 of %2 m2").arg(strips).arg(teeth)));
        for (std::size_t p = 0; p < panels.size(); ++p) // what is left is all below the strips
            QVERIFY(bands.panelColor[p] != border);
    }

    void theMeshIsDrawnWhenAskedFor()
    {
        Scene scene = sheet(0.0);
        Part& part = std::get<Part>(*findItem(scene, Id{1}));
        Link thread{.id = Id{9}, .from = Id{2}, .to = Id{4}, .material = Id{10}};
        thread.role = LinkRole::Thread;
        part.links.push_back(thread);
        Material black;
        black.color = "#000000";
        scene.items.push_back({Id{10}, black});
        scene.nextId = Id{11};
        View view(scene);
        QVERIFY(view.isReady());
        const int without = view.at(Vec3(0.3, 0.3, 0.0)).lightness();
        view.viewport.setMeshShown(true);
        QVERIFY(view.at(Vec3(0.3, 0.3, 0.0)).lightness() < without - 60);
    }

    // A spar of 0.2 m in the middle of a picture, and a thread of a tenth of a millimetre, of
    // which a pixel and a half are left.
    void linesAreAsThickAsTheyAre()
    {
        const auto rows = [](double thickness) { // that are dark, in the middle of the picture
            Scene scene = sheet(0.0);
            Part& part = std::get<Part>(*findItem(scene, Id{1}));
            part.panels.clear();
            part.particles[2].position = Vec3(1.0, 0.0, 0.0);
            part.particles[3].position = Vec3(-1.0, 0.0, 0.0);
            part.links.push_back(
                {.id = Id{9}, .from = Id{5}, .to = Id{4}, .material = Id{8}, .restLength = 2.0});
            Material& material = std::get<Material>(*findItem(scene, Id{8}));
            material.color = "#ff0000";
            material.diameter = thickness;
            View view(scene);
            if (!view.isReady())
                return std::pair(-1.0, 1.0);
            const QImage image = view.viewport.image(Viewport::Overlays::Without);
            const auto& camera = view.viewport.camera();
            const double pixel = 2.0 * camera.halfHeight() / image.height(); // m
            double count = 0.0;
            for (int y = 0; y < image.height(); ++y) {
                const QColor color = image.pixelColor(image.width() / 2, y);
                count += color.red() > color.blue() + 60 ? 1.0 : 0.0;
            }
            return std::pair(count, thickness / pixel);
        };
        const auto [thick, meant] = rows(0.2);
        // it is nearer to the eye than its axis by its radius, some percent
        QVERIFY2(std::abs(thick - meant) < 1.5 + 0.06 * meant,
                 qPrintable(QString("%1, and %2 are meant").arg(thick).arg(meant)));
        const auto [thin, little] = rows(1e-4);
        QVERIFY(little < 0.1);
        QVERIFY2(thin >= 1.0 && thin <= 3.0, qPrintable(QString::number(thin)));
    }
};

const RegisteredTest registered("test_cloth_look", runWithView<TestClothLook>);

} // namespace ripstop::test_cloth_look
#include "test_cloth_look.moc"
