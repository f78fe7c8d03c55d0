// The panels around the view: transport, controls, plots, outline, problems, start page, builders.
//
// Stages: each panel stands beside a document and a player of its own, is used by its buttons and
// rows, and has to change the document or follow it; plots are held against free fall.
#include "builders/builder.h"
#include "document/document.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/selection.h"
#include "icons/tinted.h"
#include "outline/outline.h"
#include "plots/plot_panel.h"
#include "plots/polar_chart.h"
#include "problems/problem_list.h"
#include "problems/stability_list.h"
#include "small_scenes.h"
#include "start/samples.h"
#include "start/start_page.h"
#include "transport/control_strip.h"
#include "transport/transport.h"
#include "views/run_with_widgets.h"

#include <QBuffer>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTextLayout>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>
#include <QtTest>

namespace ripstop::test_panels {

namespace {

struct Bench
{
    Document document;
    Selection selection{document};
    Player player{document};

    explicit Bench(Scene scene) { document.replace(std::move(scene)); }
    bool isReady() const { return player.frame() != nullptr; }
};

QToolButton* buttonNamed(QWidget& widget, const QString& part)
{
    for (QToolButton* button : widget.findChildren<QToolButton*>())
        if (button->accessibleName().contains(part, Qt::CaseInsensitive)
            || button->text().contains(part, Qt::CaseInsensitive)
            || button->toolTip().contains(part, Qt::CaseInsensitive))
            return button;
    return nullptr;
}

} // namespace

class TestPanels : public QObject
{
    Q_OBJECT

private slots:
    void transportPlaysStepsAndResets()
    {
        Bench bench(fallingPair());
        Recordings recordings(bench.player);
        Transport transport(bench.document, bench.player, recordings);
        transport.show();
        QTRY_VERIFY(bench.isReady());
        buttonNamed(transport, "play")->click();
        QVERIFY(bench.player.isPlaying());
        QTRY_VERIFY(bench.player.frame()->step > 3);
        buttonNamed(transport, "pause")->click();
        QVERIFY(!bench.player.isPlaying());
        QTest::qWait(50);
        const auto step = bench.player.frame()->step;
        buttonNamed(transport, "step")->click();
        QTRY_COMPARE(bench.player.frame()->step, step + 1);
        buttonNamed(transport, "reset")->click();
        QTRY_COMPARE(bench.player.frame()->step, std::int64_t(0));
    }

    // The automatic solver has chosen no substeps before its first step, and those of another one
    // are a number of the author. Looking back, nobody knows what it had chosen.
    void substepsAreToldOnceTheyAreKnown()
    {
        Bench bench(fallingPair()); // with the automatic solver
        Recordings recordings(bench.player);
        Transport transport(bench.document, bench.player, recordings);
        transport.show();
        QTRY_VERIFY(bench.isReady());
        auto* substeps = transport.findChild<QLabel*>("substeps");
        QVERIFY2(substeps->text().isEmpty(), qPrintable(substeps->text()));
        buttonNamed(transport, "step")->click();
        QTRY_COMPARE(substeps->text(), QString("1 substep"));
        bench.player.playUntil(0.5);
        QTRY_VERIFY(bench.player.frame()->time > 0.49 && !bench.player.isPlaying());
        QCOMPARE(substeps->text(), QString("1 substep"));
        recordings.seekTime(0.25);
        QTRY_VERIFY(bench.player.frame()->time < 0.3);
        QVERIFY2(substeps->text().isEmpty(), qPrintable(substeps->text()));
        recordings.backToLive();
        QTRY_COMPARE(substeps->text(), QString("1 substep"));
        buttonNamed(transport, "reset")->click();
        QTRY_VERIFY2(substeps->text().isEmpty(), qPrintable(substeps->text()));
        bench.document.push(
            {Message("Sweeps"),
             {setValue(bench.document.scene(), settingsId, "solver", std::string("averaged_jacobi"))
                  .changes.front(),
              setValue(bench.document.scene(), settingsId, "substeps", 3).changes.front()}});
        QTRY_COMPARE(substeps->text(), QString("3 substeps"));
    }

    // The control of the scene moves 0.1 m each time, 0.25 m at most.
    void controlButtonsNudgeWithinTheLimit()
    {
        Bench bench(fallingPair());
        bench.document.push(
            setValue(bench.document.scene(), Id{7}, "keyMore", std::string("Right")));
        ControlStrip strip(bench.document, bench.player);
        strip.show();
        QTRY_VERIFY(bench.isReady());
        bench.player.play();
        QToolButton* more = buttonNamed(strip, "right");
        QVERIFY(more);
        more->click();
        QTRY_COMPARE(bench.player.frame()->inputCommand.at(0), 0.1);
        more->click();
        more->click();
        QTRY_COMPARE(bench.player.frame()->inputCommand.at(0), 0.25);
    }

    // Falling from 10 m: the curve must be the law of free fall, y = 10 - g t^2 / 2, up to the
    // g t h / 2 by which semi-implicit Euler falls ahead (h = 0.01 s).
    void plotsFollowTheRun()
    {
        Bench bench(measuredPair());
        PlotPanel plots(bench.document, bench.player);
        plots.resize(600, 300);
        plots.show();
        QTRY_VERIFY(bench.isReady());
        for (double time = 0.1; time < 0.95; time += 0.1) {
            bench.player.playUntil(time);
            QTRY_VERIFY(!bench.player.isPlaying());
        }
        QCOMPARE(plots.chart().stripCount(), 2); // one for m, one for m/s
        QBuffer table;
        table.open(QIODevice::ReadWrite);
        plots.writeCsv(table);
        const QStringList rows = QString::fromUtf8(table.data()).split('\n', Qt::SkipEmptyParts);
        QVERIFY(rows.first().contains("height (m)") && rows.first().contains("speed (m/s)"));
        QVERIFY(rows.size() >= 9);
        for (qsizetype i = 1; i < rows.size(); ++i) {
            const double t = rows[i].section(',', 0, 0).toDouble();
            const double y = rows[i].section(',', 1, 1).toDouble();
            QVERIFY2(std::abs(y - (10.0 - 0.5 * 9.80665 * t * (t + 0.01))) < 1e-4,
                     qPrintable(rows[i]));
        }
        bench.player.reset();
        QTRY_VERIFY(bench.player.frame()->step == 0);
        QBuffer empty;
        empty.open(QIODevice::ReadWrite);
        plots.writeCsv(empty);
        QVERIFY(QString::fromUtf8(empty.data()).split('\n', Qt::SkipEmptyParts).size() <= 2);
    }

    void tickingAProbeIsAnEdit()
    {
        Bench bench(measuredPair());
        PlotPanel plots(bench.document, bench.player);
        plots.show();
        QTRY_VERIFY(bench.isReady());
        auto* list = plots.findChild<QTreeWidget*>();
        list->topLevelItem(1)->setCheckState(0, Qt::Unchecked);
        QTRY_VERIFY(!findItem<Probe>(bench.document.scene(), Id{9})->plotted);
        bench.document.history().undo();
        QVERIFY(findItem<Probe>(bench.document.scene(), Id{9})->plotted);
        QTRY_COMPARE(list->topLevelItem(1)->checkState(0), Qt::Checked);
    }

    void outlineAndSelectionFollowEachOther()
    {
        Bench bench(oneOfEverything());
        Outline outline(bench.document, bench.selection);
        outline.show();
        auto* tree = outline.findChild<QTreeView*>();
        bench.selection.set({Id{13}});
        QCOMPARE(tree->selectionModel()->selectedRows().size(), 1);
        QCOMPARE(tree->selectionModel()->selectedRows().first().data().toString(),
                 QString::fromStdString(findItem<Wind>(bench.document.scene(), Id{13})->name));
        outline.removeSelected();
        QVERIFY(!findItem(bench.document.scene(), Id{13}));
        QVERIFY(bench.selection.ids().empty());
        bench.document.history().undo();
        QVERIFY(findItem(bench.document.scene(), Id{13}));
        for (int row = 0; row < tree->model()->rowCount();
             ++row) { // a list that has come back, too
            const QModelIndex list = tree->model()->index(row, 0);
            QVERIFY(tree->isExpanded(list) || !tree->model()->hasChildren(list));
        }
        const auto actions = outline.addMenu()->actions();
        const auto items = bench.document.scene().items.size();
        actions.first()->trigger();
        QCOMPARE(bench.document.scene().items.size(), items + 1);
    }

    // A particle takes its links and panels along, so that is asked first; what is selected itself
    // goes without a question.
    void deletingSaysWhatHangsOnIt()
    {
        Bench bench(oneOfEverything());
        Outline outline(bench.document, bench.selection);
        QStringList questions;
        bool answer = false;
        outline.confirm = [&](const QString& question) {
            questions << question;
            return answer;
        };
        bench.selection.set({Id{3}});
        outline.removeSelected();
        QCOMPARE(questions.size(), 1);
        QVERIFY(questions.first().contains("2 links, 1 panel"));
        QVERIFY(find(bench.document.scene(), Id{3}));
        answer = true;
        outline.removeSelected();
        QVERIFY(!find(bench.document.scene(), Id{3}) && !find(bench.document.scene(), Id{8}));
        bench.document.history().undo();
        bench.selection.set({Id{5}});
        outline.removeSelected();
        QCOMPARE(questions.size(), 2);
        QVERIFY(!find(bench.document.scene(), Id{5}));
    }

    // Without its material a design has no strength: that is asked, too, but not where all that is
    // made of it goes as well.
    void deletingAMaterialSaysWhatIsMadeOfIt()
    {
        Bench bench(oneOfEverything());
        Outline outline(bench.document, bench.selection);
        QStringList questions;
        outline.confirm = [&](const QString& question) {
            questions << question;
            return false;
        };
        bench.selection.set({Id{9}});
        outline.removeSelected();
        QCOMPARE(questions.size(), 1);
        QVERIFY(questions.first().contains("3 links"));
        QVERIFY(find(bench.document.scene(), Id{9}));
        bench.selection.set({Id{1}, Id{9}, Id{10}});
        outline.removeSelected();
        QCOMPARE(questions.size(), 1);
        QVERIFY(!find(bench.document.scene(), Id{9}));
    }

    void problemsLeadToTheirCulprit()
    {
        Bench bench(fallingPair());
        ProblemList problems(bench.document, bench.selection, bench.player);
        problems.show();
        QTRY_COMPARE(problems.errorCount(), 0);
        bench.document.push(setValue(bench.document.scene(), Id{3}, "mass", 0.0));
        QTRY_COMPARE(problems.errorCount(), 1);
        auto* list = problems.findChild<QListWidget*>();
        const QRect row = list->visualItemRect(list->item(0));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(bench.selection.ids(), std::vector{Id{3}});
        bench.document.history().undo();
        QTRY_COMPARE(problems.errorCount(), 0);
    }

    // A row of the stability list selects what it is about; its button repairs it in one step.
    void whatIsPoorIsRepaired()
    {
        Bench bench(fallingPair());
        ProblemList problems(bench.document, bench.selection, bench.player);
        problems.resize(700, 200); // as in a window of 1280 pixels
        problems.show();
        bench.document.push(setValue(bench.document.scene(), Id{4}, "restLength", 0.8));
        auto* list = problems.findChild<QTreeWidget*>();
        const auto poor = [list]() -> QPushButton* {
            const auto buttons = list->findChildren<QPushButton*>();
            return buttons.isEmpty() ? nullptr : buttons.front();
        };
        QTRY_VERIFY(poor() && poor()->isEnabled());
        const QTreeWidgetItem* row = list->topLevelItem(0);
        QVERIFY(row->text(1).contains("25 %")); // 1 m at the start, 0.8 m at rest

        // the sentence has its room, and the button stands below it
        QTest::qWait(50); // they are laid out
        const QRect place = list->visualItemRect(row);
        const int words = list->fontMetrics()
                              .boundingRect(QRect(0, 0, list->columnWidth(1) - 12, 10000),
                                            Qt::TextWordWrap, row->text(1))
                              .height();
        const int top = poor()->mapTo(list->viewport(), QPoint(0, 0)).y();
        QVERIFY2(list->columnWidth(1) >= 200, qPrintable(QString::number(list->columnWidth(1))));
        QVERIFY(top >= place.top() + words);
        QVERIFY(poor()->width() >= poor()->sizeHint().width());
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(row).center());
        QCOMPARE(bench.selection.ids(), std::vector{Id{4}});
        QTest::mouseClick(poor(), Qt::LeftButton);
        const auto& part = std::get<Part>(*findItem(bench.document.scene(), Id{1}));
        QCOMPARE(part.links[0].restLength, 1.0);
        QCOMPARE(bench.document.history().count(), 2);
        QTRY_VERIFY(!poor());
    }

    // Where a row is selected, its sign has the colour of its words.
    void signsAreSeenInSelectedRows()
    {
        const QColor red(0xd6, 0x3b, 0x3b);
        const QIcon sign = tinted(QStringLiteral("error"), red);
        const auto hasColor = [&](QIcon::Mode mode, const QColor& color) {
            const QImage picture = sign.pixmap(20, mode).toImage();
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    if (picture.pixelColor(x, y) == color)
                        return true;
            return false;
        };
        const QColor words = qApp->palette().color(QPalette::HighlightedText);
        QVERIFY(hasColor(QIcon::Normal, red) && !hasColor(QIcon::Normal, words));
        QVERIFY(hasColor(QIcon::Selected, words) && !hasColor(QIcon::Selected, red));
    }

    // Whatever their width and language, sentences of the stability list are not cut: the row that
    // a view paints in that width is not higher than the room that it has.
    void sentencesOfStabilityHaveTheirRoom()
    {
        Bench bench(fallingPair());
        StabilityList list(bench.document, bench.selection);
        const char* sentences[] = {
            "Tout se trouve dans un même plan vertical, au dernier chiffre près, et sans vent rien "
            "ne l’en écarte : il y reste. Un vent de 0,1 m/s en travers, ou un peu de vitesse "
            "à une particule, le laisse se balancer et se plier.",
            "Everything lies in one upright plane to the last digit, and without wind nothing "
            "leaves it: a wind of 0.1 m/s lets it sway and fold."};
        std::vector<Finding> findings;
        for (const char* sentence : sentences) {
            findings.push_back({Severity::Warning, Message::verbatim(sentence), {}});
            findings.back().subject = Message::verbatim("Tissu");
        }
        list.resize(350, 120);
        list.show();
        list.showFindings(findings);
        for (int width = 220; width < 420; ++width) {
            list.resize(width, 120);
            QCoreApplication::processEvents();
            for (int row = 0; row < list.topLevelItemCount(); ++row) {
                QTextLayout text(list.topLevelItem(row)->text(1), list.font());
                QTextOption wrap;
                wrap.setWrapMode(QTextOption::WordWrap);
                text.setTextOption(wrap);
                const int margin = list.style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1;
                text.beginLayout();
                double height = 0.0;
                for (QTextLine line = text.createLine(); line.isValid(); line = text.createLine()) {
                    line.setLineWidth(list.columnWidth(1) - 2 * margin);
                    height += line.height();
                }
                text.endLayout();
                const int room = list.visualItemRect(list.topLevelItem(row)).height();
                QVERIFY2(
                    room >= height,
                    qPrintable(QStringLiteral("%1 px: %2 of %3").arg(width).arg(room).arg(height)));
            }
        }
    }

    // 65 kg on a line that one sweep makes far too soft: the run says so, in the bar and in the
    // list, and a click leads to the link. A solver that can do it is content.
    void aRunThatIsNotTrueIsToldOf()
    {
        Scene scene = *build(
            *findBuilder("rope"),
            {{"segments", 50}, {"length", 10}, {"axial", 1e5}, {"end_mass", 65}, {"angle", 0}});
        scene.settings.solver = Solver::SmallSteps;
        Bench bench(scene);
        ProblemList problems(bench.document, bench.selection, bench.player);
        Recordings recordings(bench.player);
        Transport transport(bench.document, bench.player, recordings);
        problems.resize(900, 200);
        problems.show();
        transport.show();
        auto* list = problems.findChild<QListWidget*>();
        auto* error = transport.findChild<QLabel*>("pull_error");
        const auto isTold = [list] {
            return list->count() == 1 && list->item(0)->text().contains("wanted accuracy");
        };
        QTRY_VERIFY(bench.isReady());
        QVERIFY(error->text().isEmpty());
        bench.player.play();
        QTRY_VERIFY(isTold());
        bench.player.pause();
        QVERIFY(error->font().bold());
        QVERIFY(error->toolTip().contains("wanted accuracy"));
        QVERIFY(error->sizeHint().width() <= error->width());
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualItemRect(list->item(0)).center());
        QCOMPARE(bench.selection.ids().size(), std::size_t(1));

        bench.player.reset();
        bench.document.push(
            setValue(bench.document.scene(), settingsId, "solver", std::string("auto")));
        bench.player.play();
        QTRY_VERIFY(!error->text().isEmpty() && !error->font().bold());
        bench.player.pause();
        QTRY_COMPARE(list->count(), 0);
    }

    // Both the check and the stability list know of it; the one with a repair tells it.
    void aDoubleLinkIsToldOnce()
    {
        Scene scene = fallingPair();
        std::get<Part>(*findItem(scene, Id{1})).links.push_back(rod(Id{8}, Id{2}, Id{3}, Id{5}));
        scene.nextId = Id{9};
        Bench bench(scene);
        ProblemList problems(bench.document, bench.selection, bench.player);
        problems.show();
        auto* list = problems.findChild<QTreeWidget*>();
        QTRY_VERIFY(!list->findItems("Double links", Qt::MatchExactly).isEmpty());
        QCOMPARE(problems.findChild<QListWidget*>()->count(), 0);
        QCOMPARE(problems.warningCount(), 1);

        // beside the warning nothing says that there are no problems
        const auto labels = problems.findChildren<QLabel*>();
        const auto none = std::ranges::find(labels, QString("No problems"), &QLabel::text);
        QVERIFY(none != labels.end());
        QTRY_VERIFY(!(*none)->isVisible());
        bench.document.push(removal(bench.document.scene(), {Id{8}}));
        QTRY_COMPARE(problems.warningCount(), 0);
        QVERIFY((*none)->isVisible());
    }

    void theStartPageOffersEverySampleAndBuilder()
    {
        QVERIFY(!sampleFiles().empty());
        for (const QString& file : sampleFiles())
            QVERIFY2(!pictureOf(readSample(file)).isNull(), qPrintable(file));
        StartPage page;
        page.resize(1000, 700);
        page.show();
        QSignalSpy opened(&page, &StartPage::openRequested);
        QSignalSpy built(&page, &StartPage::builderRequested);
        for (QAbstractButton* button : page.findChildren<QAbstractButton*>())
            if (button->isEnabled())
                button->click();
        QCOMPARE(opened.size(), qsizetype(sampleFiles().size()));
        const auto moves = [](const Builder& one) { return one.family != Family::Obstacles; };
        QCOMPARE(built.size(), std::ranges::count_if(allBuilders(), moves));
    }

    void thePolarChartShowsItsCurves()
    {
        PolarChart chart;
        static_cast<QWidget&>(chart).show();
        chart.show("C_N", {{"law", {0, 45, 90}, {0, 1, 2}}, {"published", {0, 20}, {0, 1}, true}});
        QCOMPARE(chart.curveCount(), 2);
        chart.show("C_L", {});
        QCOMPARE(chart.curveCount(), 0);
    }
};

const RegisteredTest registered("test_panels", runWithWidgets<TestPanels>);

} // namespace ripstop::test_panels
#include "test_panels.moc"
