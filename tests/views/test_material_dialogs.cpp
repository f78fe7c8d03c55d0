// Own materials in the window: the chooser of presets, what it lists and says of sources, and the
// dialogs that save a material and make one from a test.
//
// Stages: a material of a scene is saved and listed as own; a bad file is told of and not touched;
// a test is read, fitted over a range and saved; what is wrong with a test is said.
#include "builders/builder.h"
#include "document/document.h"
#include "document/number_line.h"
#include "document/selection.h"
#include "inspector/inspector.h"
#include "inspector/material_test_dialog.h"
#include "inspector/own_material_dialog.h"
#include "inspector/preset_chooser.h"
#include "materials/presets.h"
#include "model/files.h"
#include "scene/path.h"
#include "views/run_with_widgets.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include <algorithm>

namespace ripstop::test_material_dialogs {

namespace {

// The inspector over the material of a rope.
struct RopeForm
{
    Document document;
    Selection selection{document};
    Inspector inspector{document, selection};
    PresetChooser* chooser = nullptr;
    Id cord{};

    RopeForm()
    {
        document.replace(*build(*findBuilder("rope"), {{"segments", 4}}));
        cord = *findNamed(document.scene(), Kind::Material, "cord");
        inspector.resize(320, 700);
        inspector.show();
        selection.set({cord});
        chooser = inspector.findChild<PresetChooser*>();
    }
    QStringList listed() const // the names without what they bear
    {
        QStringList names;
        for (const QString& entry : entries())
            names << entry.section('\t', 0, 0);
        return names;
    }
    QStringList entries() const
    {
        QStringList texts;
        emit chooser->findChild<QToolButton*>()->menu()->aboutToShow();
        for (const QAction* kind : chooser->findChild<QToolButton*>()->menu()->actions())
            if (kind->menu())
                for (const QAction* action : kind->menu()->actions())
                    texts << action->text();
        return texts;
    }
    template <typename Dialog>
    Dialog* dialog() const
    {
        const auto dialogs = inspector.findChildren<Dialog*>();
        return dialogs.isEmpty() ? nullptr : dialogs.back();
    }
};

bool says(const QWidget& widget, const QString& words)
{
    const auto labels = widget.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* label) { return label->text().contains(words); });
}

QPushButton* button(const QWidget& widget, const QString& word)
{
    for (QPushButton* one : widget.findChildren<QPushButton*>())
        if (one->text().contains(word))
            return one;
    return nullptr;
}

// Kept in a folder of the test's own.
QString ownFile() { return QString::fromStdString(ownMaterialsFile().string()); }

} // namespace

class TestMaterialDialogs : public QObject
{
    Q_OBJECT

private slots:
    // Who double-clicks on 2.4 and types 3 means 3, not 3.4.
    void aDoubleClickTakesTheWholeNumber()
    {
        NumberLine line;
        line.setText("2.4");
        QTest::mouseDClick(&line, Qt::LeftButton, {}, QPoint(6, 6));
        QCOMPARE(line.selectedText(), QString("2.4"));

        // and who clicks three times, as in other lines, has it, too
        line.deselect();
        QTest::mouseClick(&line, Qt::LeftButton, {}, QPoint(6, 6));
        QTest::mouseDClick(&line, Qt::LeftButton, {}, QPoint(6, 6));
        QTest::mouseClick(&line, Qt::LeftButton, {}, QPoint(6, 6));
        QCOMPARE(line.selectedText(), QString("2.4"));
    }

    // By what they bear one looks for a stronger one; Liros lists 45 daN.
    void theMenuSaysWhatPresetsBear()
    {
        RopeForm form;
        const QStringList entries = form.entries();
        QVERIFY(std::ranges::any_of(entries, [](const QString& entry) {
            return entry.startsWith("Liros LTC45\t450") && entry.endsWith('N');
        }));
    }

    void init()
    {
        m_home = std::make_unique<QTemporaryDir>();
        qputenv("XDG_DATA_HOME", m_home->path().toUtf8());
    }

    void aMaterialIsSavedAndListed()
    {
        RopeForm form;
        form.chooser->apply(**findPreset("liros_ltc80"));
        QVERIFY(says(*form.chooser, "Where its numbers are from"));
        form.chooser->showSources();
        QVERIFY(says(*form.chooser, "secant at 300 N"));

        form.document.push(*assignment(form.document.scene(), "cord.lineStrength=640"));
        form.chooser->saveAsOwn();
        auto* dialog = form.dialog<OwnMaterialDialog>();
        QVERIFY(dialog);
        dialog->findChildren<QLineEdit*>().front()->setText("Old line!");
        QVERIFY(says(*dialog, "As old_line in"));
        button(*dialog, "Save")->click();
        QVERIFY(QFile::exists(ownFile()));
        QVERIFY(form.listed().contains("Old line! (own)"));
        QCOMPARE(form.chooser->findChild<QToolButton*>()->text(), QString("Old line! (own)"));

        // another of that name has to be confirmed
        OwnMaterialDialog again(**findPreset("liros_ltc80"));
        again.setAttribute(Qt::WA_DeleteOnClose, false);
        again.findChildren<QLineEdit*>().front()->setText("Old line");
        QVERIFY(button(again, "Replace"));
        again.findChildren<QLineEdit*>().front()->setText("???");
        QVERIFY(!button(again, "Save")->isEnabled());
    }

    // An ampersand of a name is no sign of a key, on the button as in the menu.
    void anAmpersandIsShownAsItIs()
    {
        RopeForm form;
        form.chooser->apply(**findPreset("liros_ltc80"));
        form.chooser->saveAsOwn();
        auto* dialog = form.dialog<OwnMaterialDialog>();
        QVERIFY(dialog);
        dialog->findChildren<QLineEdit*>().front()->setText("Rope & twine");
        button(*dialog, "Save")->click();
        QVERIFY(form.listed().contains("Rope && twine (own)"));
        QCOMPARE(form.chooser->findChild<QToolButton*>()->text(), QString("Rope && twine (own)"));
    }

    void aBadFileIsLeftAlone()
    {
        QVERIFY(QDir().mkpath(QFileInfo(ownFile()).path()));
        write(ownFile(), "{ not JSON");
        RopeForm form;
        const int builtIn = form.listed().size();
        QCOMPARE(std::size_t(builtIn), allPresets().size());
        bool told = false;
        for (QAction* action : form.chooser->findChild<QToolButton*>()->menu()->actions())
            if (action->isVisible() && action->text().contains("cannot be read")) {
                action->trigger();
                told = says(*form.chooser, "line 1");
            }
        QVERIFY(told);
        form.chooser->saveAsOwn();
        auto* dialog = form.dialog<OwnMaterialDialog>();
        button(*dialog, "Save")->click();
        QVERIFY(says(*dialog, "lose nothing"));
        QCOMPARE(contentOf(ownFile()), QByteArray("{ not JSON"));
    }

    // A line of 1 m with EA of 12 kN beyond 0.2 %, softer before, that breaks at 228 N.
    void aTestBecomesAMaterial()
    {
        const QString file = m_home->filePath("My cord.csv");
        QByteArray rows = "force (N),elongation (mm)\n";
        for (int i = 0; i <= 20; ++i)
            rows += QByteArray::number(i < 2 ? 6.0 * i : 12.0 * (i - 1)) + ','
                    + QByteArray::number(i) + '\n';
        write(file, rows + "5,21\n");
        RopeForm form;
        form.chooser->fromTest();
        auto* dialog = form.dialog<MaterialTestDialog>();
        QVERIFY(dialog && !button(*dialog, "Save")->isEnabled());
        dialog->findChildren<QComboBox*>().front()->setCurrentIndex(int(Specimen::Line));
        const auto field = [&](const QString& text) {
            for (QLineEdit* one : dialog->findChildren<QLineEdit*>())
                if (one->text() == text || one->placeholderText().startsWith(text))
                    return one;
            return static_cast<QLineEdit*>(nullptr);
        };
        field("200 mm")->setText("1 m");
        dialog->read(file);
        QVERIFY(says(*dialog, "12000 N") && says(*dialog, "Broke at 228 N and 2 %"));
        field("where 10 %")->setText("0.5 %");
        field("where 60 %")->setText("1 %");
        QVERIFY2(says(*dialog, "6 points from 0.5 to 1 %"), "range");
        field("where 60 %")->setText("0.4 %");
        QVERIFY(says(*dialog, "There are 0 points"));
        QVERIFY(!button(*dialog, "Save")->isEnabled());
        field("where 60 %")->setText("1 kg");
        QVERIFY(says(*dialog, "The range: it"));
        field("where 60 %")->setText("1 %");
        button(*dialog, "Save")->click();
        QVERIFY(form.listed().contains("My cord (own)"));
        const OwnMaterials own = readOwnMaterials(ownMaterialsFile());
        const PresetNumber* stiffness =
            findNumber(own.presets.front(), propertyOf<&Material::axialStiffness>());
        QVERIFY(std::abs(std::get<double>(stiffness->value) - 12e3) < 1e-6);
    }

    void aBadTestIsTold()
    {
        MaterialTestDialog dialog;
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        const QString file = m_home->filePath("bad.csv");
        write(file, "force (N),elongation (mm)\n0,0\nbroke,1\n");
        dialog.read(file);
        QVERIFY(says(dialog, "line 3: \"broke\" is no number"));
        write(file, "force (N),elongation (mm)\n0,0\n20,1\n,1.5\n40,2\n60,3\n80,4\n100,5\n");
        dialog.read(file);
        QVERIFY(says(dialog, "Line 4 has an empty cell and is left out."));
        dialog.read(m_home->filePath("none.csv"));
        QVERIFY(says(dialog, "cannot be read"));
        QVERIFY(!button(dialog, "Save")->isEnabled());
    }

private:
    std::unique_ptr<QTemporaryDir> m_home;
};

const RegisteredTest registered("test_material_dialogs", runWithWidgets<TestMaterialDialogs>);

} // namespace ripstop::test_material_dialogs
#include "test_material_dialogs.moc"
