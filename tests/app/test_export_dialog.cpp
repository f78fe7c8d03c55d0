// Bundles and recordings in the export dialog, flown again by the command line.
//
// Stages: a bundle from the dialog is flown again by ripstop-cli; a recording is exported as it
// was; and without one the dialog offers no choice.
#include "app/window_shop.h"
#include "bundle/bundle.h"
#include "compile/compile.h"
#include "files/export_dialog.h"
#include "model/cli_call.h"
#include "recording/recorder.h"
#include "simulation/simulation.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>

namespace ripstop::test_export_dialog {

namespace {

// A kite that has flown for half a second, and the dialog over it.
struct ExportShop : WindowShop
{
    QTemporaryDir folder;
    std::shared_ptr<Recording> recording;
    std::unique_ptr<ExportDialog> dialog;

    ExportShop()
    {
        QObject::connect(&player, &Player::recordingBegan, &window,
                         [this](const auto& begun) { recording = begun; });
        window.files().open(SOURCE_DIR "/scenes/delta_kite.ripstop.json");
        window.resize(900, 700);
        window.show();
        player.playUntil(0.5);
        (void)QTest::qWaitFor(
            [this] { return player.frame() && player.frame()->time > 0.49 && !player.isPlaying(); },
            30000);
    }

    void open(bool looksBack)
    {
        const auto draw = [this](const std::shared_ptr<const Frame>& frame, const FilmLook& look) {
            viewport.show(frame);
            return viewport.image(
                Viewport::Shot{look.size, Viewport::Overlays::With,
                               look.transparent ? Backdrop::Transparent : Backdrop::Scenery});
        };
        ExportDialog::Matter matter{document.scene(), player.frame()};
        if (looksBack)
            matter.recording = recording;
        dialog = std::make_unique<ExportDialog>(matter, folder.filePath("kite"), draw,
                                                QSize(320, 240), &window);
        dialog->show();
    }

    void choose(const QString& format)
    {
        auto* box = dialog->findChild<QComboBox*>();
        box->setCurrentIndex(box->findText(format));
    }

    QDoubleSpinBox& number(const char* name) { return *dialog->findChild<QDoubleSpinBox*>(name); }

    bool exports()
    {
        dialog->findChild<QDialogButtonBox*>()->accepted();
        return QTest::qWaitFor([this] { return dialog->result() == QDialog::Accepted; }, 60000);
    }
};

} // namespace

class TestExportDialog : public QObject
{
    Q_OBJECT

private slots:
    void bundles_data()
    {
        QTest::addColumn<bool>("looksBack");
        QTest::newRow("flown anew") << false;
        QTest::newRow("as it was recorded") << true;
    }

    void bundles()
    {
        QFETCH(bool, looksBack);
        ExportShop shop;
        QVERIFY(shop.recording);
        shop.open(looksBack);
        shop.choose("Bundle of the whole run, ZIP");
        QCOMPARE(shop.number("to").isVisible(), !looksBack); // a recording is bundled whole
        QVERIFY(!shop.number("from").isVisible());
        QVERIFY(shop.exports());
        const QString file = shop.folder.filePath("kite.zip");
        QCOMPARE(QDir(shop.folder.path()).entryList(QDir::Files), QStringList{"kite.zip"});
        const auto bundle = openBundle(file.toStdString());
        QVERIFY2(bundle, bundle ? "" : bundle.message().english().c_str());
        QVERIFY(std::abs(bundle->manifest.end - 0.5) < 0.003);
        const QImage view(QString::fromStdString((bundle->folder / "view.png").string()));
        QCOMPARE(view.size(), QSize(320, 240));
        const Outcome flown = call({"run", file, "--json"});
        QVERIFY2(flown.exitCode == 0, qPrintable(flown.error));
        QCOMPARE(flown.json()["hash"].toString().toStdString(), bundle->manifest.hashAtEnd);
    }

    // A recording that ended where it began, as of a run that got no further than its start or a
    // step of 4 ms, which the fields show as 0.00 s, is one moment, of which no flight can be made:
    // it is simulated, for as long as one likes.
    void aMomentIsNoFlight_data()
    {
        QTest::addColumn<int>("steps");
        QTest::newRow("at its start") << 0;
        QTest::newRow("after a step") << 1;
    }
    void aMomentIsNoFlight()
    {
        QFETCH(int, steps);
        ExportShop shop;
        QVERIFY(shop.document.scene().settings.timeStep < 0.005); // s
        Simulation simulation(*compile(shop.document.scene()));
        Recorder recorder;
        recorder.loaded(simulation, {std::make_shared<const Scene>(shop.document.scene()), {}});
        QVERIFY(recorder.beforeStep(simulation));
        for (int i = 0; i < steps && simulation.step(); ++i)
            recorder.afterStep(simulation);
        shop.recording = recorder.recording();
        recorder.finish();
        QVERIFY(shop.recording->frameCount() > 0);
        shop.open(true);
        shop.choose("Table of the probes, CSV");
        auto* source = shop.dialog->findChild<QComboBox*>("source");
        QVERIFY(source->currentText().startsWith("Simulated anew"));
        QVERIFY(shop.number("to").value() > 0.0);
        QVERIFY(shop.number("to").maximum() > 100.0);
        auto* message = shop.dialog->findChild<QLabel*>("message");
        QVERIFY2(message->text().contains("No flight is recorded"), qPrintable(message->text()));
        source->setCurrentIndex(0); // and back
        QCOMPARE(shop.number("to").value(), 0.0);
        source->setCurrentIndex(1);
        QVERIFY(shop.number("to").value() > 0.0);
    }

    // What is typed names the format, and stays when another one is chosen after it.
    void endingThatIsTypedIsTheFormat()
    {
        ExportShop shop;
        shop.open(false);
        auto* box = shop.dialog->findChild<QComboBox*>();
        auto* file = shop.dialog->findChild<QLineEdit*>();
        QVERIFY(file->accessibleName() == "File");
        file->selectAll();
        QTest::keyClicks(file, shop.folder.filePath("gust.glb"));
        QCOMPARE(shop.dialog->ending(), ".glb");
        QCOMPARE(file->text(), shop.folder.filePath("gust.glb"));
        shop.choose("Table of what has torn, CSV");
        QCOMPARE(file->text(), shop.folder.filePath("gust_tears.csv"));
        // of the tables that end so, the one that is chosen stays
        file->selectAll();
        QTest::keyClicks(file, shop.folder.filePath("broken.csv"));
        QCOMPARE(box->currentText(), "Table of what has torn, CSV");
        file->selectAll();
        QTest::keyClicks(file, shop.folder.filePath("sail.OBJ"));
        QCOMPARE(shop.dialog->ending(), ".obj");
        QCOMPARE(file->text(), shop.folder.filePath("sail.OBJ"));
        // a sequence has the ending of one mesh
        file->selectAll();
        QTest::keyClicks(file, shop.folder.filePath("sail_{frame}.obj"));
        QCOMPARE(box->currentText(), "Sequence of OBJ files");
        QCOMPARE(file->text(), shop.folder.filePath("sail_{frame}.obj"));
    }

    // A name without a folder is one beside the design, and is shown so; none is no name.
    void namesAreWhole()
    {
        ExportShop shop;
        shop.open(false);
        auto* file = shop.dialog->findChild<QLineEdit*>();
        file->selectAll();
        QTest::keyClicks(file, "sail.glb");
        emit file->editingFinished();
        QCOMPARE(file->text(), shop.folder.filePath("sail.glb"));
        file->selectAll();
        QTest::keyClicks(file, shop.folder.path() + "/");
        emit file->editingFinished();
        QVERIFY(!shop.dialog->findChild<QPushButton*>("go")->isEnabled());
    }

    // The fields know where the recording begins and ends; every frame is one that was flown.
    void exportsTheRunAsItWasRecorded()
    {
        ExportShop shop;
        shop.open(true);
        shop.choose("Table of the probes, CSV");
        QVERIFY(shop.dialog->findChild<QComboBox*>("source")->isVisible());
        QCOMPARE(shop.number("from").value(), 0.0);
        QCOMPARE(shop.number("to").value(), 0.5);
        QCOMPARE(shop.number("to").maximum(), 0.5);
        shop.number("from").setValue(0.2);
        shop.number("rate").setValue(20.0);
        QVERIFY(shop.exports());
        QFile table(shop.folder.filePath("kite.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = table.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), 2 + 7 + 1); // 0.2 s to 0.5 s, and three lines around them
        QVERIFY(std::abs(lines[2].split(',')[0].toDouble() - 0.2) < 0.003);
        QVERIFY(std::abs(lines[8].split(',')[0].toDouble() - 0.5) < 0.003);
    }

    // No step is written twice, whatever the rate, and so many frames are promised: those of 0.2 s
    // in steps of the scene, from the first to the last.
    void promisesAsManyFramesAsThereAreSteps()
    {
        ExportShop shop;
        shop.open(true);
        shop.choose("Table of the probes, CSV");
        shop.number("from").setValue(0.2);
        shop.number("to").setValue(0.4);
        shop.number("rate").setValue(shop.number("rate").maximum());
        const double timeStep = shop.document.scene().settings.timeStep;
        QVERIFY(shop.number("rate").value() > 1.0 / timeStep);
        const int steps = int(std::floor(0.2 / timeStep + 1e-9)) + 1;
        const QString promise = QString(" %1 frames").arg(steps);
        const auto labels = shop.dialog->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(
            labels, [&](const QLabel* label) { return label->text().contains(promise); }));
        QVERIFY(shop.exports());
        QFile table(shop.folder.filePath("kite.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const auto lines = table.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), 2 + steps + 1); // with three lines around them
    }

    void withoutARecordingThereIsNothingToChoose()
    {
        ExportShop shop;
        shop.open(false);
        shop.choose("Table of the probes, CSV");
        QVERIFY(!shop.dialog->findChild<QComboBox*>("source")->isVisible());
        QVERIFY(shop.number("to").maximum() > 1000.0);
    }
};

const RegisteredTest registered("test_export_dialog", runWithView<TestExportDialog>);

} // namespace ripstop::test_export_dialog
#include "test_export_dialog.moc"
