// A mesh brought in by hand: the dialog, the edit that comes of it, and the ways there.
//
// Stages: the dialog and its refusals; the import as one step of the history and its cancelling;
// the ways there (drop, menu, start page); then large meshes, and the preview by its pixels.
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "files/arrivals.h"
#include "import/import_dialog.h"
#include "import/import_form.h"
#include "import/mesh_preview.h"
#include "language/language.h"
#include "model/meshes.h"
#include "start/start_page.h"
#include "viewport/viewport.h"
#include "views/run_with_widgets.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_import {

namespace {

constexpr int patience = 20000; // ms

// Puts a narrow blank between number and unit.
QString spaced(QString text)
{
    static const QRegularExpression place("(\\d) (c?m)\\b");
    return text.replace(place, QStringLiteral("\\1\u202f\\2"));
}

// Whether the middle of the picture shows something that is not the pale sky.
bool hasFabric(const QImage& image)
{
    const QColor color = image.pixelColor(image.width() / 2, image.height() / 2);
    return color.red() > color.blue() + 40; // new materials are red
}

struct Editor
{
    Document document;
    Selection selection{document};
    Player player{document};
    MainWindow window{document, selection, player, MainWindow::Memory::Ignore};

    Editor()
    {
        window.show();
        QApplication::setActiveWindow(&window); // Xvfb has no window manager to do it
    }
};

// Presses Import (or Cancel) once the dialog that opens next shows what it will do.
class Answer : public QObject
{
public:
    explicit Answer(QDialogButtonBox::StandardButton button)
    {
        connect(&m_timer, &QTimer::timeout, this, [this, button] {
            auto* dialog = qobject_cast<ImportDialog*>(QApplication::activeModalWidget());
            if (!dialog || !dialog->isSettled())
                return;
            m_timer.stop();
            wasAsked = true;
            QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(button),
                              Qt::LeftButton);
        });
        m_timer.start(10);
    }

    bool wasAsked = false;

private:
    QTimer m_timer;
};

} // namespace

class TestImport : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString m_cube; // the loose triangles of a cube

private slots:
    void initTestCase() { m_cube = writeFile(m_folder.filePath("cube.stl"), cubeAsStl()); }

    // Texts that a file makes longer, in the longer language.
    void nothingOfTheFormIsCut()
    {
        const Translation translation(Language::French);
        QString objects;
        for (int i = 0; i < 12; ++i)
            objects +=
                QStringLiteral("o sail %1\nv %1 0 0\nv %1 1 0\nv %1 0 1\nf -3 -2 -1\n").arg(i);
        ImportDialog dialog(Scene(), writeFile(m_folder.filePath("sails.obj"), objects.toUtf8()));
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isSettled(), patience);
        const auto* form = dialog.findChild<ImportForm*>();
        for (QComboBox* box : form->findChildren<QComboBox*>())
            for (int i = 0; i < box->count(); ++i) {
                box->setCurrentIndex(i);
                QTRY_VERIFY2(box->width() >= box->minimumSizeHint().width(),
                             qPrintable(box->currentText()));
                QVERIFY2(box->width()
                             > box->fontMetrics().horizontalAdvance(box->currentText()) + 24,
                         qPrintable(box->currentText()));
            }
        QTRY_VERIFY(form->width() <= form->parentWidget()->width());
    }

    void dialogShowsWhatWillBe()
    {
        const Scene scene;
        ImportDialog dialog(scene, m_cube);
        dialog.show();
        QVERIFY(!dialog.isReady());
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), patience);
        const auto* size = dialog.findChild<QLabel*>("resultingSize");
        const auto* counts = dialog.findChild<QLabel*>("counts");
        auto* report = dialog.findChild<QListWidget*>("report");
        QCOMPARE(size->text(), spaced("1 m wide, 1 m high, 1 m deep"));
        QVERIFY2(counts->text().contains("8 particles"), qPrintable(counts->text()));
        QVERIFY2(counts->text().contains("12 panels"), qPrintable(counts->text()));
        QVERIFY2(!counts->text().contains("rod"), qPrintable(counts->text()));
        const auto* carrier = dialog.findChild<QComboBox*>("pullCarrier");
        QCOMPARE(carrier->currentIndex(), int(FabricKind::Panels));
        QVERIFY2(counts->text().contains("282\u00a0g"),
                 qPrintable(counts->text())); // 6 m^2, 47 g/m^2
        QCOMPARE(report->count(), 1);
        QCOMPARE(report->item(0)->text(), "28 vertices lie on another one: joined.");

        // each choice shows at once what it means
        auto* unit = dialog.findChild<QComboBox*>("unit");
        unit->setCurrentIndex(unit->findText("Centimetres"));
        QVERIFY(!dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
        QTRY_COMPARE_WITH_TIMEOUT(size->text(), spaced("1 cm wide, 1 cm high, 1 cm deep"),
                                  patience);
        QCOMPARE(report->count(), 2); // and that this is small
        unit->setCurrentIndex(unit->findText("Scale to a size"));
        dialog.findChild<QDoubleSpinBox*>("size")->setValue(2.0);
        QTRY_COMPARE_WITH_TIMEOUT(size->text(), spaced("2 m wide, 2 m high, 2 m deep"), patience);
        report->setCurrentRow(0);
        dialog.findChild<QDoubleSpinBox*>("density")->setValue(100.0);
        QTRY_VERIFY2_WITH_TIMEOUT(counts->text().contains("2.4\u00a0kg"),
                                  qPrintable(counts->text()), patience);
        QCOMPARE(report->currentRow(), 0); // fabric does not change the mesh
        dialog.findChild<QComboBox*>("structural")->setCurrentIndex(int(LinkStyle::Springs));
        QTRY_VERIFY2_WITH_TIMEOUT(counts->text().contains("18 springs"), qPrintable(counts->text()),
                                  patience);
        QCOMPARE(carrier->currentIndex(), int(FabricKind::Threads)); // which such links are
    }

    // Several materials of a file become as many, and one where that is unticked.
    void materialsOfTheFile()
    {
        const QString file =
            writeFile(m_folder.filePath("two.obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                                    "usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n");
        const Scene scene;
        ImportDialog dialog(scene, file);
        dialog.show();
        const auto materials = [&] {
            Scene made;
            (void)apply(made, dialog.result().edit);
            return std::ranges::count_if(made.items, [](const Entry& entry) {
                return std::holds_alternative<Material>(entry.item);
            });
        };
        auto* each = dialog.findChild<QCheckBox*>("perMaterial");
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isSettled() && each->isChecked(), patience);
        QCOMPARE(materials(), 2);
        each->click();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isSettled(), patience);
        QCOMPARE(materials(), 1);
    }

    // The warp can be turned where panels carry the pull, and only there.
    void warpIsTurned()
    {
        const Scene scene;
        ImportDialog dialog(scene, m_cube);
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isSettled(), patience);
        auto* grain = dialog.findChild<QDoubleSpinBox*>("warp turn");
        QVERIFY(grain->isEnabled());
        const auto form = dialog.findChild<ImportForm*>();
        QCOMPARE(form->fabric().grain, 0.0);
        grain->setValue(45.0);
        QCOMPARE(form->fabric().grain, 45.0);
        dialog.findChild<QComboBox*>("pullCarrier")->setCurrentIndex(int(FabricKind::Threads));
        QTRY_VERIFY_WITH_TIMEOUT(!grain->isEnabled(), patience);
    }

    void dialogRefusesInASentence()
    {
        const Scene scene;
        const QString broken = writeFile(m_folder.filePath("broken.obj"), "v 0 0 0\nf 1 2 3\n");
        ImportDialog dialog(scene, broken);
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isSettled(), patience);
        QVERIFY(!dialog.isReady());
        QVERIFY(!dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
        const QString text = dialog.findChild<QLabel*>("counts")->text();
        QVERIFY2(text.contains("line 2"), qPrintable(text));
    }

    // One step of the history, selected; undone and redone to the same scene.
    void importIsOneStep()
    {
        Editor editor;
        editor.window.files().startNew();
        const Scene before = editor.document.scene();
        {
            Answer yes(QDialogButtonBox::Ok);
            editor.window.arrivals().importMesh(m_cube);
            QVERIFY(yes.wasAsked);
        }
        QCOMPARE(editor.document.history().count(), 1);
        const Scene after = editor.document.scene();
        std::vector<Id> parts;
        forEachPart(after, [&](Id id, const Part& part) {
            parts.push_back(id);
            QCOMPARE(part.name, "cube");
            QCOMPARE(part.particles.size(), 8u);
        });
        QCOMPARE(parts.size(), 1u);
        QCOMPARE(editor.selection.ids(), parts);
        QTRY_VERIFY_WITH_TIMEOUT(
            editor.player.frame() && editor.player.frame()->position.size() == 8u, patience);

        // the fabric is in the middle of the view
        editor.selection.clear(); // which has a colour of its own
        QTRY_VERIFY_WITH_TIMEOUT(hasFabric(editor.window.viewport().image()), 2000);

        editor.document.history().undo();
        QCOMPARE(editor.document.scene().items, before.items);
        editor.document.history().redo();
        QCOMPARE(editor.document.scene().items, after.items);
    }

    void cancellingChangesNothing()
    {
        Editor editor;
        editor.window.files().startNew();
        const Scene before = editor.document.scene();
        Answer no(QDialogButtonBox::Cancel);
        editor.window.arrivals().importMesh(m_cube);
        QVERIFY(no.wasAsked);
        QCOMPARE(editor.document.scene(), before);
        QCOMPARE(editor.document.history().count(), 0);
    }

    // What lies within the file is told, and written when the mesh is imported, not before.
    void picturesWithinTheFile()
    {
        const QString mesh =
            writeFile(m_folder.filePath("kite.gltf"), trianglePackedWith(redPoint()));
        const QString picture = m_folder.filePath("kite-1.png");
        const Scene scene;
        ImportDialog dialog(scene, mesh);
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), patience);
        const auto* counts = dialog.findChild<QLabel*>("counts");
        QVERIFY2(counts->text().contains("kite-1.png"), qPrintable(counts->text()));
        dialog.reject();
        QVERIFY(!QFile::exists(picture));

        Editor editor;
        editor.window.files().startNew();
        Answer yes(QDialogButtonBox::Ok);
        editor.window.arrivals().importMesh(mesh);
        QFile file(picture);
        QVERIFY(file.open(QFile::ReadOnly));
        QCOMPARE(file.readAll(), redPoint());
        bool isPrinted = false;
        for (const Entry& entry : editor.document.scene().items)
            if (const auto* material = std::get_if<Material>(&entry.item))
                isPrinted |= material->picture.ends_with("kite-1.png");
        QVERIFY(isPrinted);
    }

    void droppedOnTheWindow()
    {
        Editor editor; // with the start page: a new scene
        Answer yes(QDialogButtonBox::Ok);
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(m_cube)});
        QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&editor.window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&editor.window, &drop);
        QTRY_VERIFY_WITH_TIMEOUT(yes.wasAsked, patience);
        QTRY_COMPARE_WITH_TIMEOUT(editor.document.history().count(), 1, patience);
        QCOMPARE(editor.document.displayName(), "cube");
        QVERIFY(editor.window.viewport().isVisible());
    }

    // The program that drops waits for the event, and must not wait for the answer to a question.
    void aDropIsTakenBeforeAQuestion()
    {
        Editor editor;
        editor.document.replace(Scene{}, "sail");
        editor.document.push({Message("Add a part"), {AddItem{0, {Id{1}, Part{}}}}});
        editor.window.showScene();
        QVERIFY(editor.document.isModified());
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(SCENES_DIR "/flag.ripstop.json")});
        QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&editor.window, &enter);
        QDropEvent drop({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&editor.window, &drop);
        QVERIFY(drop.isAccepted());
        QVERIFY(!QApplication::activeModalWidget());
        bool wasAsked = false;
        QTimer answer;
        connect(&answer, &QTimer::timeout, this, [&] {
            if (auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                wasAsked = true;
                question->button(QMessageBox::Discard)->click();
            }
        });
        answer.start(10);
        QTRY_COMPARE_WITH_TIMEOUT(QFileInfo(editor.document.file()).fileName(), "flag.ripstop.json",
                                  patience);
        QVERIFY(wasAsked);
    }

    void severalFilesAreToldOneAtATime()
    {
        Editor editor;
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(m_cube), QUrl::fromLocalFile(m_cube)});
        QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&editor.window, &enter);
        QVERIFY(enter.isAccepted()); // else the drop would not be heard of
        QDropEvent drop({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&editor.window, &drop);
        QVERIFY(!drop.isAccepted());
        QVERIFY2(editor.window.statusBar()->currentMessage().contains("one alone"),
                 qPrintable(editor.window.statusBar()->currentMessage()));
    }

    void menuAndStartPage()
    {
        Editor editor;
        const QAction* action = editor.window.actions()["import"];
        QCOMPARE(action->shortcut(), QKeySequence("Ctrl+Shift+I"));
        QVERIFY(!action->statusTip().isEmpty());
        StartPage page;
        QSignalSpy asked(&page, &StartPage::importRequested);
        QTest::mouseClick(page.findChild<QPushButton*>("import"), Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
    }

    // Reading and repairing go on elsewhere: the window answers, and closing it stops them.
    void largeMeshesDoNotBlock()
    {
        const QString file =
            writeFile(m_folder.filePath("large.obj"),
                      QByteArray::fromStdString(sheet(316, 0.01, false))); // 199 712 triangles
        const Scene scene;
        {
            ImportDialog dialog(scene, file);
            dialog.show();
            QVERIFY(!dialog.isReady()); // so that it was not waited for
            dialog.reject();
        }
        {
            ImportDialog dialog(scene, file);
            dialog.show();
            QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), patience);
            QCOMPARE(dialog.result().panels, 199712u);
            auto* preview = dialog.findChild<MeshPreview*>();
            QElapsedTimer timer;
            timer.start();
            preview->grab();
            qInfo("a picture of 199 712 triangles: %lld ms", timer.elapsed());
            Document document;
            timer.restart();
            document.push(dialog.result().edit);
            qInfo("its edit: %lld ms", timer.elapsed());
        }
    }

    // Blue is the front: a square seen from the side that it is wound towards, ochre from behind.
    void previewTellsFrontFromBack()
    {
        const PreparedMesh square =
            preparedOf(meshOf("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"));
        MeshLook look;
        look.ground = Qt::black;
        look.front = QColor(0, 0, 255);
        look.back = QColor(255, 0, 0);
        look.edge = look.rim = look.trouble = QColor(0, 255, 0);
        MeshCamera camera;
        camera.scale = 40.0;
        const QImage front = drawMesh(square, camera, {100, 100}, look);
        QVERIFY(front.pixelColor(45, 60).blue() > 100);
        QCOMPARE(front.pixelColor(45, 60).red(), 0);
        QCOMPARE(front.pixelColor(2, 2), QColor(Qt::black));
        camera.turn = Eigen::AngleAxisd(M_PI, Vec3::UnitY()).toRotationMatrix();
        const QImage back = drawMesh(square, camera, {100, 100}, look);
        QVERIFY(back.pixelColor(45, 60).red() > 100);
        QCOMPARE(back.pixelColor(45, 60).blue(), 0);
    }

    // Lines beside the faces: a bridle above the square, drawn, counted, and measured on its own.
    void linesAreShownAndTold()
    {
        const QByteArray text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nv 3 2 0\n"
                                "f 1 2 3 4\nl 4 5 6\n"; // 1 m up and 3 m to the right
        MeshLook look;
        look.ground = Qt::black;
        look.front = look.back = QColor(0, 0, 255);
        look.edge = look.trouble = QColor(255, 0, 0);
        look.rim = QColor(0, 255, 0);
        MeshCamera camera;
        camera.scale = 20.0;
        const QImage picture = drawMesh(preparedOf(meshOf(text)), camera, {200, 100}, look);
        QCOMPARE(picture.pixelColor(100, 20), look.rim); // (0, 1.5)
        QCOMPARE(picture.pixelColor(140, 10), look.rim); // (2, 2)
        QCOMPARE(picture.pixelColor(140, 20), look.ground);

        ImportDialog dialog(Scene(), writeFile(m_folder.filePath("bridle.obj"), text));
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), patience);
        QCOMPARE(dialog.findChild<QLabel*>("resultingSize")->text(),
                 spaced("1 m wide, 1 m high, 0 m deep")
                     + QStringLiteral(" \u00b7 2 lines, 4\u00a0m long together"));
        // in a longer language the sentence breaks, and the dialog stays as narrow
        const int narrowest = dialog.minimumSizeHint().width();
        auto* size = dialog.findChild<QLabel*>("resultingSize");
        size->setText(size->text() + QStringLiteral(" and so on").repeated(20));
        QCOMPARE(dialog.minimumSizeHint().width(), narrowest);
    }
};

const RegisteredTest registered("test_import", runWithView<TestImport>);

} // namespace ripstop::test_import
#include "test_import.moc"
