// Films and pictures that the export dialog makes, looked at by other programs and by their pixels.
//
// Stages: films of each format and slow motion, with the counts that ffprobe or the files tell;
// pictures; then a film that is cancelled, and a window that is closed meanwhile.
#include "app/window_shop.h"
#include "files/export_dialog.h"
#include "files/film.h"
#include "files/film_look.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProcess>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace ripstop::test_film {

namespace {

// The export dialog over a kite, with its fields in reach.
struct FilmShop : WindowShop
{
    QTemporaryDir folder;
    FilmLook drawn; // of the last picture
    std::unique_ptr<ExportDialog> dialog;

    FilmShop()
    {
        window.files().open(SOURCE_DIR "/scenes/delta_kite.ripstop.json");
        window.resize(900, 700);
        window.show();
        for (int i = 0; i < 500 && !player.frame(); ++i)
            QTest::qWait(10);
        const auto draw = [this](const std::shared_ptr<const Frame>& frame, const FilmLook& look) {
            viewport.show(frame);
            drawn = look;
            return viewport.image(
                Viewport::Shot{look.size, Viewport::Overlays::With,
                               look.transparent ? Backdrop::Transparent : Backdrop::Scenery});
        };
        dialog =
            std::make_unique<ExportDialog>(ExportDialog::Matter{document.scene(), player.frame()},
                                           folder.filePath("kite"), draw, viewport.size(), &window);
        dialog->show();
    }

    void choose(const QString& format)
    {
        auto* box = dialog->findChild<QComboBox*>();
        box->setCurrentIndex(box->findText(format));
    }

    // 0 to 0.4 s at 10 per second: five pictures of 320 x 240
    void makeItSmall()
    {
        set<QDoubleSpinBox>("to", 0.4);
        set<QDoubleSpinBox>("rate", 10.0);
        set<QSpinBox>("width", 320);
        set<QSpinBox>("height", 240);
    }

    template <typename Box>
    void set(const char* name, double value)
    {
        dialog->findChild<Box*>(name)->setValue(int(value) == value ? int(value) : value);
    }

    QStringList files() const { return QDir(folder.path()).entryList(QDir::Files, QDir::Name); }
};

QByteArray probed(const QString& file, const QString& entries)
{
    QProcess process;
    process.start("ffprobe", {"-v", "error", "-count_frames", "-select_streams", "v:0",
                              "-show_entries", "stream=" + entries, "-of", "csv=p=0", file});
    process.waitForFinished(-1);
    return process.readAllStandardOutput().trimmed();
}

} // namespace

class TestFilm : public QObject
{
    Q_OBJECT

private slots:
    // Each row of the caption is as far below the one before, the last one as well, and stands in
    // the field that is behind it: the lowest dark pixel goes down evenly, and light is below it.
    void captionHasRoomForAllRows()
    {
        auto layout = std::make_shared<Layout>();
        Frame frame;
        std::vector<int> lowest, bottom; // pixels, of the letters and of the field
        for (int rows = 1; rows <= 8; ++rows) {
            layout->probes.push_back({std::uint32_t(rows), "gpq", "m", true});
            frame.probe.push_back(1.0);
            frame.layout = layout;
            QImage picture(400, 300, QImage::Format_RGB32);
            picture.fill(QColor(120, 120, 120));
            paintCaption(picture, frame, {.time = false, .probes = true});
            lowest.push_back(0);
            bottom.push_back(0);
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) {
                    const int grey = qGray(picture.pixel(x, y));
                    lowest.back() = grey < 80 ? y : lowest.back();
                    bottom.back() = grey > 180 ? y : bottom.back();
                }
            QVERIFY(bottom.back() > lowest.back());
        }
        const double each = (lowest.back() - lowest.front()) / 7.0;
        for (std::size_t i = 1; i < lowest.size(); ++i)
            QVERIFY2(std::abs(lowest[i] - lowest[i - 1] - each) <= 1.0,
                     qPrintable(QString::number(i)));
    }

    void captionSaysSharesInPercent()
    {
        Scene scene;
        Probe strain, pull;
        strain.quantity = Quantity::MaxStrain;
        pull.quantity = Quantity::Tension;
        scene.items = {{Id{7}, strain}, {Id{8}, pull}};
        auto layout = std::make_shared<Layout>();
        layout->probes = {{7, "max strain", "", true}, {8, "pull", "N", true}};
        Frame frame;
        frame.layout = layout;
        frame.probe = {0.0021, 0.5};
        FilmLook look{.time = false, .probes = true};
        look.inPercent = sharesOf(scene);
        QCOMPARE(captionOf(frame, look),
                 (QStringList{"max strain  0.21\u00a0%", "pull  0.5\u00a0N"}));
    }

    // Letters are a share of the height of the picture, so that films of all sizes look alike.
    void captionGrowsWithThePicture()
    {
        Frame frame;
        frame.layout = std::make_shared<Layout>();
        const auto heightOfLetters = [&](int height) { // pixels
            QImage picture(height, height, QImage::Format_RGB32);
            picture.fill(QColor(120, 120, 120));
            paintCaption(picture, frame, {.time = true});
            int top = height, bottom = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < height; ++x)
                    if (qGray(picture.pixel(x, y)) < 80) {
                        top = std::min(top, y);
                        bottom = y;
                    }
            return bottom - top + 1;
        };
        const int letters = heightOfLetters(720);
        QVERIFY(letters > 8);
        // the edges of letters lie on whole pixels: each height is one off at most
        QVERIFY(std::abs(heightOfLetters(1440) - 2 * letters) <= 2 + 1);
        QVERIFY(std::abs(heightOfLetters(2160) - 3 * letters) <= 3 + 1);
    }

    // Marks of fixed particles are for who edits; a film has them when they are asked for.
    void pinsAreAChoice()
    {
        FilmShop shop;
        shop.choose("Pictures, PNG");
        shop.makeItSmall();
        auto* pins = shop.dialog->findChild<QCheckBox*>("pins");
        QVERIFY(pins->isVisible() && !pins->isChecked());
        shop.dialog->findChild<QDialogButtonBox*>()->accepted();
        QTRY_VERIFY_WITH_TIMEOUT(shop.dialog->result() == QDialog::Accepted, 60000);
        QVERIFY(!shop.drawn.pins);
        FilmShop other;
        other.choose("Pictures, PNG");
        other.makeItSmall();
        other.dialog->findChild<QCheckBox*>("pins")->setChecked(true);
        other.dialog->findChild<QDialogButtonBox*>()->accepted();
        QTRY_VERIFY_WITH_TIMEOUT(other.dialog->result() == QDialog::Accepted, 60000);
        QVERIFY(other.drawn.pins);
    }

    // The codecs of MP4 and WebM take even sizes only, which the dialog says before.
    void oddSizesAreCutAndTold_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("size");
        QTest::newRow("MP4") << "Film, MP4"
                             << "kite.mp4" << QByteArray("320,240");
        QTest::newRow("GIF") << "Moving picture, GIF"
                             << "kite.gif" << QByteArray("321,241");
    }

    void oddSizesAreCutAndTold()
    {
        QFETCH(QString, format);
        QFETCH(QString, file);
        QFETCH(QByteArray, size);
        FilmShop shop;
        shop.choose(format);
        shop.makeItSmall();
        auto* message = shop.dialog->findChild<QLabel*>("message");
        QVERIFY(!message->text().contains("even number"));
        shop.set<QSpinBox>("width", 321);
        shop.set<QSpinBox>("height", 241);
        QCOMPARE(message->text().contains("even number"), size == "320,240");
        QVERIFY(message->text().contains(QString::fromUtf8(size).replace(",", " × ")));
        shop.dialog->findChild<QDialogButtonBox*>()->accepted();
        QTRY_VERIFY_WITH_TIMEOUT(shop.dialog->result() == QDialog::Accepted, 60000);
        QCOMPARE(probed(shop.folder.filePath(file), "width,height"), size);
    }

    void films_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QString>("file");
        QTest::newRow("MP4") << "Film, MP4"
                             << "kite.mp4";
        QTest::newRow("WebM") << "Film, WebM"
                              << "kite.webm";
        QTest::newRow("GIF") << "Moving picture, GIF"
                             << "kite.gif";
    }

    void films()
    {
        QFETCH(QString, format);
        QFETCH(QString, file);
        QVERIFY2(!QStandardPaths::findExecutable("ffmpeg").isEmpty(), "packages.txt names ffmpeg");
        FilmShop shop;
        shop.choose(format);
        shop.makeItSmall();
        shop.dialog->findChild<QDialogButtonBox*>()->accepted();
        QTRY_VERIFY_WITH_TIMEOUT(shop.dialog->result() == QDialog::Accepted, 60000);
        QCOMPARE(shop.files(), QStringList{file});
        QCOMPARE(probed(shop.folder.filePath(file), "width,height,r_frame_rate,nb_read_frames"),
                 QByteArray("320,240,10/1,5"));
    }

    // Slowed down ten times, a film of 10 pictures a second has 100 for each second of the flight.
    void slowMotion()
    {
        FilmShop shop;
        shop.choose("Pictures, PNG");
        shop.makeItSmall();
        shop.set<QDoubleSpinBox>("to", 0.05);
        shop.set<QDoubleSpinBox>("speed", 0.1);
        shop.dialog->findChild<QDialogButtonBox*>()->accepted();
        QTRY_VERIFY_WITH_TIMEOUT(shop.dialog->result() == QDialog::Accepted, 60000);
        QCOMPARE(shop.files().size(), 6);
    }

    // Sky where nothing is; nothing there when that is asked for. The kite is in both.
    void pictures_data()
    {
        QTest::addColumn<bool>("transparent");
        QTest::newRow("with the sky") << false;
        QTest::newRow("transparent") << true;
    }

    void pictures()
    {
        QFETCH(bool, transparent);
        FilmShop shop;
        shop.choose("Pictures, PNG");
        shop.makeItSmall();
        shop.dialog->findChild<QCheckBox*>("transparent")->setChecked(transparent);
        shop.dialog->findChild<QDialogButtonBox*>()->accepted();
        QTRY_VERIFY_WITH_TIMEOUT(shop.dialog->result() == QDialog::Accepted, 60000);
        QCOMPARE(shop.files(), (QStringList{"kite_0000.png", "kite_0001.png", "kite_0002.png",
                                            "kite_0003.png", "kite_0004.png"}));
        const QImage picture(shop.folder.filePath("kite_0000.png"));
        QCOMPARE(picture.size(), QSize(320, 240));
        QCOMPARE(qAlpha(picture.pixel(319, 2)), transparent ? 0 : 255);
        int sail = 0; // orange and red
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor color = picture.pixelColor(x, y);
                sail += color.alpha() == 255 && color.red() > color.blue() + 60;
            }
        QVERIFY2(sail > 320 * 240 / 50, qPrintable(QString::number(sail)));
    }

    // It would begin anew, and what was made before would be missing.
    void ffmpegThatEndsInTheMiddle()
    {
        const QTemporaryDir folder;
        QFile ffmpeg(folder.filePath("ffmpeg"));
        QVERIFY(ffmpeg.open(QFile::WriteOnly));
        ffmpeg.write("#!/bin/sh\nhead -c 4096 >/dev/null\n"); // a picture, and it is at an end
        ffmpeg.close();
        QVERIFY(ffmpeg.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        const QByteArray path = qgetenv("PATH");
        const auto putBack = qScopeGuard([&] { qputenv("PATH", path); });
        qputenv("PATH", folder.path().toUtf8() + ':' + path);
        const QString target = folder.filePath("kite.mp4");
        {
            const auto film = openFilm(*filmFormatOf(target), target, 25.0, [](const auto&) {
                return QImage(32, 32, QImage::Format_RGBA8888);
            });
            QVERIFY(film);
            std::optional<Failure> failure;
            for (int i = 0; i < 200 && !failure; ++i) {
                failure = (*film)->add(Frame());
                QTest::qWait(5);
            }
            QVERIFY(failure);
            QVERIFY2(failure->message.english().find("kite.mp4 was not written")
                         != std::string::npos,
                     failure->message.english().c_str());
        }
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"ffmpeg"});
    }

    void cancelled()
    {
        FilmShop shop;
        shop.choose("Pictures, PNG");
        shop.makeItSmall();
        shop.set<QDoubleSpinBox>("to", 1000.0);
        shop.dialog->findChild<QDialogButtonBox*>()->accepted();
        QTRY_VERIFY(!shop.files().isEmpty());
        shop.dialog->reject();
        QTRY_VERIFY(shop.files().isEmpty());
        QTRY_VERIFY(shop.dialog->findChild<QLabel*>("message")->text().contains("Cancelled"));
        QVERIFY(shop.dialog->isVisible());
    }

    // The window is closed with the dialog at work.
    void closedWhileItWorks()
    {
        FilmShop shop;
        shop.choose("Pictures, PNG");
        shop.makeItSmall();
        shop.set<QDoubleSpinBox>("to", 1000.0);
        shop.dialog->findChild<QDialogButtonBox*>()->accepted();
        QTRY_VERIFY(!shop.files().isEmpty());
        shop.dialog.reset();
        QVERIFY(shop.files().isEmpty());
    }
};

const RegisteredTest registered("test_film", runWithView<TestFilm>);

} // namespace ripstop::test_film
#include "test_film.moc"
