// The window in French: nothing English is left on it, and nothing but words depends on it.
//
// Stages: the catalogue against what lupdate and the tables have; then the whole window is walked
// and its texts compared with those in English; sentences of the engine, plurals and numbers; and
// what must not depend on the language: files, and what is typed.
#include "actions/keys_dialog.h"
#include "app/screen_texts.h"
#include "app/window_shop.h"
#include "author/stability.h"
#include "builders/builder.h"
#include "check/check.h"
#include "dialogs/builder_dialog.h"
#include "dialogs/operation_dialog.h"
#include "dialogs/work_dialog.h"
#include "document/words.h"
#include "editor/table_texts.h"
#include "language/language.h"
#include "scene/typed_number.h"
#include "shaping/operation.h"

#include <QDir>
#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QMenuBar>
#include <QProcess>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

Q_DECLARE_METATYPE(ripstop::Message)

namespace ripstop::test_language {

namespace {

// What a person sees who opens the sample, goes through its things and opens the dialogs.
QSet<QString> textsOfEditor()
{
    ScreenReader reader;
    WindowShop shop;
    shop.window.show();
    if (shop.document.open(SCENES_DIR "/delta_kite.ripstop.json"))
        qFatal("the sample is gone");
    shop.window.showScene();
    reader.read(shop.window);
    for (const Entry& entry : shop.document.scene().items) {
        shop.selection.set({entry.id});
        QTest::qWait(60);
        reader.read(shop.window);
    }
    std::vector<Id> elements;
    forEachPart(shop.document.scene(), [&](Id, const Part& part) {
        if (elements.empty())
            elements = {part.particles[0].id, part.links[0].id, part.panels[0].id};
    });
    for (const Id id : elements) {
        shop.selection.set({id});
        QTest::qWait(60);
        reader.read(shop.window);
    }
    for (const Operation& operation : allOperations()) {
        OperationDialog dialog(operation, shop.document, shop.selection, &shop.window);
        reader.read(dialog);
        dialog.reject();
    }
    for (const Builder& builder : allBuilders()) {
        BuilderDialog dialog(QString::fromUtf8(builder.name.data(), qsizetype(builder.name.size())),
                             &shop.window);
        reader.read(dialog);
    }
    KeysDialog keys(shop.window.actions().keys(), shop.document.scene(), &shop.window);
    reader.read(keys);
    return reader.texts();
}

} // namespace

class TestLanguage : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QSettings().remove("recentFiles"); // names of files have no language
    }

    // What lupdate finds, names of menus, and tables; also that nothing is kept that nobody says.
    void catalogueIsComplete()
    {
        QProcess script;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("RIPSTOP", EDITOR_PROGRAM);
        script.setProcessEnvironment(environment);
        script.start(SOURCE_DIR "/scripts/translations", {"--check"});
        QVERIFY(script.waitForFinished(60000));
        QVERIFY2(script.exitCode() == 0,
                 script.readAllStandardOutput() + script.readAllStandardError());
    }

    // A line must not begin with the sign that a number or a word ends with. What people type, as
    // conditions and +5 %, has the blanks that they type.
    void signsStayWithTheirWords()
    {
        static const QRegularExpression torn(
            QStringLiteral("[ ][;:!?\u00bb]|\u00ab[ ]|\\d %(?![\\dn])"));
        static const QRegularExpression typed(QStringLiteral("[<>=]|\\+5 %|condition \\?"));
        for (const QString& french : catalogue())
            QVERIFY2(!torn.match(french).hasMatch() || typed.match(french).hasMatch(),
                     qPrintable(french));
    }

    void tablesOfTheModelAreFrench()
    {
        const Translation translation(Language::French);
        const QHash<QString, QString> french = catalogue();
        QVERIFY(tableTexts().size() > 500);
        for (const QString& text : tableTexts())
            if (hasWords(text))
                QCOMPARE(translated(text.toStdString()), french.value(text));
    }

    // Texts that are the same with and without French.
    void nothingOnTheScreenIsEnglish()
    {
        const QSet<QString> english = textsOfEditor();
        QVERIFY(english.size() > 500);
        QSet<QString> same = textsOfEditorInFrench();
        same.intersect(english).subtract(alike());
        QStringList left;
        for (const QString& text : std::as_const(same))
            if (!isContent(text)) {
                qWarning() << text; // a long list would be cut
                left << text;
            }
        QCOMPARE(left.size(), 0);
    }

    void textsOfQtAreFrench()
    {
        const Translation translation(Language::French);
        QCOMPARE(QCoreApplication::translate("QPlatformTheme", "Cancel"), QString("Annuler"));
    }

    void sentencesOfTheEngineAreFrench_data()
    {
        QTest::addColumn<Message>("said");
        QTest::addColumn<QString>("english");
        QTest::addColumn<QString>("french");
        const auto row = [](const Message& said, const char* english, const char* french) {
            QTest::newRow(english) << said << QString(english) << QString(french);
        };
        row(Message("must be above %1", 0), "must be above 0", "doit être au-dessus de 0");
        row(Message("%1 free particles have no mass.", 3), "3 free particles have no mass.",
            "3 particules libres n’ont pas de masse.");
        row(Message("%1: %2 points at %3, which does not exist; choose another or remove it.",
                    Message("%1 %2", Message::word("Link"), 17), "from", 4),
            "Link 17: from points at 4, which does not exist; choose another or remove it.",
            "Liaison 17\u00a0: from désigne 4, qui n’existe pas\u202f; en choisir un autre ou le "
            "retirer.");
        row(Message(
                "A pull has to pass %1 to cross the network; the direct solver takes it there at "
                "once.",
                Message("%1 links", 20)),
            "A pull has to pass 20 links to cross the network; the direct solver takes it there at "
            "once.",
            "Une traction doit passer 20 liaisons pour traverser le réseau\u202f; le solveur "
            "direct l’y porte d’un coup.");
        row(Message("%1 was not written: %2; make room or choose another folder.", "/a/kite.pvd",
                    Message("there is no room for the shapes of the series")),
            "/a/kite.pvd was not written: there is no room for the shapes of the series; make room "
            "or choose another folder.",
            "/a/kite.pvd n’a pas été écrit\u00a0: il n’y a pas de place pour les formes de la "
            "série\u202f; faire de la place ou choisir un autre dossier.");
        row(Message("Take %1 substeps", Message::number("%.3g", 12.5)), "Take 12.5 substeps",
            "Prendre 12,5 sous-pas");
        row(Message("Part %1 %2, or set its canopyPressure to 0.", "kite",
                    Message("has canopy pressure and no panels to hold the air: add panels")),
            "Part kite has canopy pressure and no panels to hold the air: add panels, or set its "
            "canopyPressure to 0.",
            "La pièce kite a une pression de voilure et pas de panneaux pour tenir l’air\u00a0: "
            "ajouter des panneaux, ou mettre sa pression de voilure à 0.");
        row(Message("Keep %1", "particle"), "Keep particle", "Garder particle"); // a name
    }
    void sentencesOfTheEngineAreFrench()
    {
        QFETCH(Message, said);
        QFETCH(QString, english);
        QFETCH(QString, french);
        QCOMPARE(QString::fromStdString(said.english()), english);
        QCOMPARE(translated(said), english);
        const Translation translation(Language::French);
        QCOMPARE(translated(said), french);
        QCOMPARE(QString::fromStdString(said.english()), english);
    }

    void findingsAndProblemsAreFrench_data()
    {
        QTest::addColumn<QString>("file");
        const QDir folder(SCENES_DIR);
        for (const QString& file : folder.entryList({"*.ripstop.json"}))
            QTest::newRow(qPrintable(file)) << folder.filePath(file);
    }
    void findingsAndProblemsAreFrench()
    {
        QFETCH(QString, file);
        const Translation translation(Language::French);
        const Result<Scene> scene = readScene(file.toStdString());
        QVERIFY(scene);
        std::vector<Message> said;
        for (const Finding& finding : stabilityOf(*scene)) {
            said.push_back(finding.message);
            if (finding.repair)
                said.push_back(finding.repair->label);
        }
        for (const Finding& problem : problemsOf(*scene))
            said.push_back(problem.message);
        for (const Message& sentence : said)
            QVERIFY2(translated(sentence) != QString::fromStdString(sentence.english()),
                     sentence.english().c_str());
    }

    void labelsHaveABlankBeforeTheColon()
    {
        QCOMPARE(labelled("Picture", "%1"), QString("Picture: %1"));
        const Translation translation(Language::French);
        QCOMPARE(labelled("Image", "%1"), QString("Image\u00a0: %1"));
    }

    // Work of a thread is shown by a dialog of Qt with a button of ours.
    void workIsCancelledInFrench()
    {
        const Translation translation(Language::French);
        QStringList buttons;
        workWithProgress(nullptr, "Certification", [&](const Progress& progress) {
            while (progress(0.5)) {
                QMetaObject::invokeMethod(
                    qApp,
                    [&] {
                        for (QWidget* window : QApplication::topLevelWidgets())
                            if (auto* bar = qobject_cast<QProgressDialog*>(window)) {
                                for (auto* button : bar->findChildren<QPushButton*>()) {
                                    buttons << button->text();
                                    button->click();
                                }
                            }
                    },
                    Qt::BlockingQueuedConnection);
            }
        });
        QCOMPARE(buttons, QStringList{"Annuler"});
    }

    void pluralsFollowTheLanguage()
    {
        const Translation translation(Language::French);
        QCOMPARE(counted(Kind::Particle, 0), QString("0 particule"));
        QCOMPARE(counted(Kind::Particle, 1), QString("1 particule"));
        QCOMPARE(counted(Kind::Panel, 2), QString("2 panneaux"));
        QCOMPARE(counted(Kind::Link, 20000), QString("20\u202f000 liaisons"));
    }

    void numbersAreShownWithACommaAndReadWithEither()
    {
        const Translation translation(Language::French);
        QCOMPARE(compactNumber(0.5), QString("0,5"));
        QCOMPARE(compactNumber(-9.80665), QString("-9,80665"));
        for (const char* typed : {"0,5", "0.5", "50 %", "0,25 + 0,25"})
            QCOMPARE(typedNumber(typed, "").number->number, 0.5);
        QCOMPARE(typedNumber("12,5 cm", "m").number->number, 0.125);
    }

    void spinBoxesTakePointAndComma_data()
    {
        QTest::addColumn<int>("language");
        QTest::addColumn<QString>("shown");
        QTest::newRow("French") << int(Language::French) << "1,25";
        QTest::newRow("English") << int(Language::English) << "1.25";
    }
    void spinBoxesTakePointAndComma()
    {
        QFETCH(int, language);
        QFETCH(QString, shown);
        const Translation translation{Language(language)};
        for (const char* typed : {"1.25", "1,25"}) {
            QDoubleSpinBox box;
            box.setRange(0.0, 10.0);
            box.selectAll();
            QTest::keyClicks(&box, typed);
            QCOMPARE(box.value(), 1.25);
            QCOMPARE(box.text(), shown);
        }
    }

    void filesDoNotDependOnTheLanguage()
    {
        QTemporaryDir folder;
        const auto written = [&](Language language) {
            const Translation translation(language);
            Document document;
            if (document.open(SCENES_DIR "/delta_kite.ripstop.json"))
                qFatal("the sample is gone");
            const QString file = folder.filePath("copy.ripstop.json");
            if (document.save(file))
                qFatal("cannot save");
            QFile copy(file);
            if (!copy.open(QIODevice::ReadOnly))
                qFatal("cannot read");
            return copy.readAll();
        };
        const QByteArray english = written(Language::English);
        QVERIFY(english.size() > 1000);
        QCOMPARE(written(Language::French), english);
    }

    void choiceIsKept()
    {
        QSettings().remove("language");
        QVERIFY(keptLanguage() == Language::System);
        WindowShop shop;
        QVERIFY(shop.window.actions()["languageSystem"]->isChecked());
        shop.run("languageFrench");
        QVERIFY(keptLanguage() == Language::French);
        WindowShop next;
        QVERIFY(next.window.actions()["languageFrench"]->isChecked());
        QSettings().remove("language");
    }

    // A desktop in another language gets English with English numbers.
    void unknownLanguagesBecomeEnglish()
    {
        QVERIFY(!languageFromCode("de"));
        QVERIFY(languageFromCode("fr") == Language::French);
        const Translation translation(Language::English);
        QCOMPARE(compactNumber(0.5), QString("0.5"));
        QCOMPARE(kindLabel(Kind::Link), QString("Link"));
    }

private:
    static QSet<QString> textsOfEditorInFrench()
    {
        const Translation translation(Language::French);
        return textsOfEditor();
    }
};

const RegisteredTest registered("test_language", runWithView<TestLanguage>);

} // namespace ripstop::test_language
#include "test_language.moc"
