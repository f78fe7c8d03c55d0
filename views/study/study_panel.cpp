// The form edits a study that is not yet written; saveStudy() writes it, the runner opens what was
// written, and showOpened() shows that: so the map is always that of a file, to which its flights
// belong. m_fliesOnceOpen remembers that somebody has pressed Fly meanwhile.
#include "study/study_panel.h"

#include "document/ask_file.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "document/recordings.h"
#include "document/time_left.h"
#include "document/words.h"
#include "io/whole_file.h"
#include "study/point_scene.h"
#include "study/probe_names.h"
#include "study/study_form.h"
#include "study/study_table.h"
#include "study/study_view.h"
#include "study/suggested_variable.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedLayout>
#include <QThread>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int formWidth = 320; // px

QString studyFilter() { return StudyPanel::tr("Studies (*.ripstop-study.json);;All files (*)"); }

QString ending() { return QString::fromUtf8(studyEnding.data(), qsizetype(studyEnding.size())); }

// All but one, so that the window and what runs in it have one to themselves.
int jobs() { return std::max(1, QThread::idealThreadCount() - 1); }

} // namespace

StudyPanel::StudyPanel(Document& document, Recordings& recordings, std::function<bool()> saveDesign,
                       QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_recordings(recordings)
    , m_saveDesign(std::move(saveDesign))
    , m_pages(new QStackedLayout(this))
    , m_title(new QLabel)
    , m_form(new StudyForm)
    , m_view(new StudyView)
    , m_run(new QPushButton)
    , m_progress(new QProgressBar)
    , m_state(new QLabel)
    , m_runner(std::make_unique<StudyRunner>())
{
    m_pages->addWidget(emptyPage());
    auto* sides = new QSplitter;
    sides->setChildrenCollapsible(false);
    sides->addWidget(formSide());
    sides->addWidget(m_view);
    sides->setStretchFactor(1, 1);
    sides->setSizes({formWidth, 2 * formWidth});
    // A dock must not make the window wide: what is narrower is scrolled.
    auto* scrolled = new QScrollArea;
    scrolled->setWidgetResizable(true);
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setWidget(sides);
    m_pages->addWidget(scrolled);

    connect(m_form, &StudyForm::edited, this, [this] {
        m_isEdited = true;
        showState();
    });
    connect(m_run, &QPushButton::clicked, this, [this] {
        if (m_runner->task() == StudyRunner::Task::None)
            run();
        else
            stop();
    });
    hearRunner();
    connect(m_view, &StudyView::watchWanted, this, [this](std::size_t point) {
        m_runner->watch(point);
        showState();
    });
    connect(m_view, &StudyView::compareWanted, this, &StudyPanel::compare);
    connect(m_view, &StudyView::ghostsWanted, this, &StudyPanel::showGhosts);
    connect(m_view, &StudyView::applyWanted, this, &StudyPanel::applyToDesign);
    connect(m_view, &StudyView::tableWanted, this, &StudyPanel::saveTable);
    connect(m_view, &StudyView::said, this, &StudyPanel::said);
    // A study that was never written is one of the design that is gone.
    connect(&document, &Document::replaced, this, [this] {
        if (m_file.isEmpty())
            m_pages->setCurrentIndex(0);
    });
}

void StudyPanel::hearRunner()
{
    connect(m_runner.get(), &StudyRunner::opened, this, &StudyPanel::showOpened);
    connect(m_runner.get(), &StudyRunner::recorded, this, &StudyPanel::showState);
    connect(m_runner.get(), &StudyRunner::progressed, this, &StudyPanel::showState);
    connect(m_runner.get(), &StudyRunner::compared, this, &StudyPanel::showCompared);
    connect(m_runner.get(), &StudyRunner::grew, this, &StudyPanel::refreshSometimes);
    connect(m_runner.get(), &StudyRunner::ended, this, [this] {
        m_sinceRefresh.invalidate();
        refreshSometimes();
    });
    connect(m_runner.get(), &StudyRunner::failed, this, &StudyPanel::showFailure);
    connect(m_runner.get(), &StudyRunner::watched, this, &StudyPanel::watched);
}

void StudyPanel::takeOver(StudyPanel& before)
{
    before.m_view->setStudy(nullptr, nullptr);
    before.m_runner->disconnect(&before);
    std::swap(m_runner, before.m_runner);
    hearRunner();
    m_file = before.m_file;
    m_isEdited = before.m_isEdited;
    m_fliesOnceOpen = before.m_fliesOnceOpen;
    if (before.m_pages->currentIndex() == 0)
        return;
    showForm(before.m_form->study());
    if (const OpenedStudy* study = m_runner->study())
        m_view->setStudy(study, &m_runner->flights());
    m_pages->setCurrentIndex(1);
    showState();
}

void StudyPanel::showForm(const Study& study)
{
    m_form->setStudy(
        study, [this](const StudyVariable& variable) { return unitOf(variable); }, probes());
}

QWidget* StudyPanel::emptyPage()
{
    auto* text = new QLabel(
        tr("A study flies the design many times with other values and shows what came of it as a "
           "map: for which stiffness and which strength does it hold?\n\nRight-click the name of a "
           "property, in the inspector or beside a slider, and choose Study this."));
    text->setAlignment(Qt::AlignCenter);
    text->setWordWrap(true);
    text->setForegroundRole(QPalette::PlaceholderText);
    auto* open = new QPushButton(tr("&Open a study…"));
    connect(open, &QPushButton::clicked, this, &StudyPanel::browse);
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(40, 8, 40, 8);
    layout->addStretch();
    layout->addWidget(text);
    layout->addWidget(open, 0, Qt::AlignHCenter);
    layout->addStretch();
    auto* scrolled = new QScrollArea; // in a low dock
    scrolled->setWidgetResizable(true);
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setWidget(page);
    return scrolled;
}

QWidget* StudyPanel::formSide()
{
    auto* browseButton = new QPushButton(tr("&Open…"));
    browseButton->setToolTip(tr("Open the file of another study."));
    connect(browseButton, &QPushButton::clicked, this, &StudyPanel::browse);
    auto* newButton = new QPushButton(tr("&New"));
    newButton->setToolTip(tr("A new study of the open design; this one stays in its file."));
    connect(newButton, &QPushButton::clicked, this, &StudyPanel::startNew);
    m_title->setTextFormat(Qt::PlainText);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(8, 4, 8, 0);
    top->addWidget(m_title, 1);
    top->addWidget(newButton);
    top->addWidget(browseButton);

    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(m_form);
    m_progress->setTextVisible(true);
    m_state->setTextFormat(Qt::PlainText);
    m_state->setWordWrap(true);
    m_state->setObjectName(QStringLiteral("state"));
    auto* go = new QHBoxLayout;
    go->setContentsMargins(8, 0, 8, 0);
    go->addWidget(m_run);
    go->addWidget(m_progress, 1);
    m_state->setContentsMargins(8, 0, 8, 4);
    auto* side = new QWidget;
    side->setMinimumWidth(formWidth);
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(top);
    layout->addWidget(area, 1);
    layout->addLayout(go);
    layout->addWidget(m_state);
    return side;
}

QString StudyPanel::state() const { return m_state->text(); }

// --- the study ----------------------------------------------------------------------------------

QString StudyPanel::unitOf(const StudyVariable& variable) const
{
    const Scene& scene = m_runner->study() ? m_runner->study()->scene : m_document.scene();
    return QString::fromStdString(ripstop::unitOf(scene, variable.paths.front()));
}

// Of the scene that is flown, with names that tell them apart.
QStringList StudyPanel::probes() const
{
    const Scene& scene = m_runner->study() ? m_runner->study()->scene : m_document.scene();
    std::vector<Layout::Probe> all;
    for (const Entry& entry : scene.items)
        if (const auto* probe = std::get_if<Probe>(&entry.item))
            all.push_back({0, probe->name, {}, false});
    QStringList names;
    for (const std::string& name : distinctNames(all))
        names << QString::fromStdString(name);
    return names;
}

void StudyPanel::startNew()
{
    m_runner->close();
    m_view->setStudy(nullptr, nullptr);
    m_file.clear();
    m_isEdited = true;
    showForm({});
    m_pages->setCurrentIndex(1);
    showState();
}

void StudyPanel::study(const Property& property, const std::vector<Id>& ids,
                       const std::optional<SliderRange>& range)
{
    auto variable = suggestedVariable(m_document.scene(), property, ids, range);
    if (!variable) {
        emit said(translated(variable.message()));
        return;
    }
    if (m_pages->currentIndex() != 1 || !(m_file.isEmpty() || isOfTheDesign()))
        startNew();
    m_form->add(std::move(*variable));
}

bool StudyPanel::isStudy(const QString& file)
{
    return file.endsWith(ending(), Qt::CaseInsensitive);
}

void StudyPanel::browse()
{
    const QString folder =
        m_document.file().isEmpty() ? QString() : QFileInfo(m_document.file()).path();
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Open a study"), folder, studyFilter());
    if (!file.isEmpty())
        open(file);
}

void StudyPanel::open(const QString& file)
{
    m_fliesOnceOpen = false;
    m_runner->open(pathOf(file));
    showState();
}

void StudyPanel::showOpened()
{
    const OpenedStudy& study = *m_runner->study();
    m_file = QString::fromStdString(study.file.string());
    m_isEdited = false;
    showForm(study.study);
    m_view->setStudy(&study, &m_runner->flights());
    m_pages->setCurrentIndex(1);
    const QString design = QString::fromStdString(study.sceneFile.string());
    const bool flies = std::exchange(m_fliesOnceOpen, false);
    if (flies)
        m_runner->fly(jobs());
    showState();
    if (!flies)
        emit opened();
    if (m_document.scene().items.empty())
        emit designWanted(design);
}

bool StudyPanel::isOfTheDesign() const
{
    const OpenedStudy* study = m_runner->study();
    return study
           && QFileInfo(QString::fromStdString(study->sceneFile.string()))
                  == QFileInfo(m_document.file());
}

// --- running ------------------------------------------------------------------------------------

// Beside the design, and never a file that is there.
QString StudyPanel::freeName() const
{
    const QFileInfo design(m_document.file());
    QString name = design.fileName();
    for (const char* known : {".json", ".ripstop"})
        if (name.endsWith(QLatin1String(known)))
            name.chop(qsizetype(qstrlen(known)));
    QString file = design.dir().filePath(name + ending());
    for (int i = 2; QFileInfo::exists(file); ++i)
        file = design.dir().filePath(name + QChar(' ') + QString::number(i) + ending());
    return file;
}

bool StudyPanel::saveStudy()
{
    Study study = m_form->study();
    QString file = m_file;
    if (file.isEmpty()) {
        if (!m_saveDesign())
            return false;
        file = freeName();
        study.scene = QFileInfo(m_document.file()).fileName().toStdString();
    }
    const std::string text = studyText(study);
    if (const auto again = studyOf(text); !again) { // what cannot be read is not written
        m_state->setText(tr("The study %1.").arg(translated(again.message())));
        return false;
    }
    if (const auto failure = replaceFile(pathOf(file), text)) {
        m_state->setText(translated(failure->message));
        return false;
    }
    if (m_file.isEmpty())
        showForm(study); // with its design, should it not open and be written once more
    m_file = file;
    return true;
}

void StudyPanel::run()
{
    if (m_form->study().variables.empty()) {
        m_state->setText(tr("Nothing varies yet: choose Study this on a property."));
        return;
    }
    if (isOfTheDesign() && m_document.isModified() && !m_saveDesign())
        return;
    if ((!m_runner->study() || m_isEdited) && !saveStudy())
        return;
    // opened again in any case: the design may have been saved since
    m_fliesOnceOpen = true;
    m_runner->open(pathOf(m_file));
    showState();
}

// A picture of very many flights takes long to draw, and the window is to have most of its time for
// what else goes on in it.
void StudyPanel::refreshSometimes()
{
    constexpr qint64 share = 20; // of the time, at most one part of these
    if (m_sinceRefresh.isValid() && m_sinceRefresh.elapsed() < share * m_refreshTime)
        return;
    QElapsedTimer clock;
    clock.start();
    if (isVisible())
        m_view->refresh();
    showState();
    m_refreshTime = clock.elapsed();
    m_sinceRefresh.start();
}

void StudyPanel::stop()
{
    m_fliesOnceOpen = false;
    m_runner->stop();
}

// In thousandths, as a flight may take long.
void StudyPanel::showProgress(double flown, double all)
{
    constexpr int steps = 1000;
    m_progress->setMaximum(steps);
    m_progress->setValue(int(steps * flown / std::max(1.0, all)));
}

void StudyPanel::showState()
{
    using Task = StudyRunner::Task;
    const Task task = m_runner->task();
    m_title->setText(m_file.isEmpty() ? tr("New study")
                                      : QFileInfo(m_file).fileName().remove(ending()));
    m_title->setToolTip(shownAsIs(QDir::toNativeSeparators(m_file)));
    m_run->setText(task == Task::None ? tr("&Fly") : tr("&Stop"));
    m_form->setEnabled(task != Task::Flying);
    const bool isKnown = m_runner->study() != nullptr;
    const StudyTally tally = m_runner->tally();
    // a search does not fly all, and how many is known when it is over
    const bool isSearch =
        isKnown && m_runner->study()->study.plan.kind == StudyPlan::Kind::Frontier;
    const bool isOptimised = isKnown && m_runner->study()->optimiser;
    const auto all = int(isSearch      ? tally.flown
                         : isOptimised ? Optimiser::most(m_runner->study()->study.plan)
                                       : m_runner->flights().size());
    m_progress->setVisible(isKnown || task != Task::None);
    if (task == Task::Comparing) {
        showProgress(m_runner->flown(), double(m_runner->planned()));
        m_progress->setFormat(
            tr("%1 of %2 flown again").arg(m_runner->done()).arg(m_runner->planned()));
        return m_state->setText(tr("Flying them again…"));
    }
    const StudyRunner::Recorded best = m_runner->bestRecorded();
    if (task == Task::Flying && best.wanted > 0) {
        showProgress(m_runner->flown(), double(best.wanted));
        m_progress->setFormat(tr("%1 of the %2 best recorded").arg(best.done).arg(best.wanted));
        return m_state->setText(tr("Flying the best again for their recordings…"));
    }
    const double underWay = m_runner->flown() - double(m_runner->done());
    if (task == Task::Opening)
        m_progress->setMaximum(0);
    else if (task == Task::Watching)
        showProgress(m_runner->flown(), 1.0);
    else
        showProgress(double(tally.flown) + (task == Task::Flying ? underWay : 0.0), all);
    const QString flown = QLocale().toString(qulonglong(tally.flown));
    m_progress->setFormat(isSearch ? tr("%1 flown along the tear line").arg(flown)
                          : isOptimised
                              ? tr("%1 of up to %2 flown").arg(flown, QLocale().toString(all))
                              : tr("%1 of %2 flown").arg(flown, QLocale().toString(all)));
    if (task == Task::Opening)
        return m_state->setText(tr("Opening…"));
    if (task == Task::Watching)
        return m_state->setText(tr("Flying it again…"));
    if (!isKnown)
        return m_state->clear();
    QString words;
    if (tally.flown > 0)
        words = tr("Something tore in %1, %2 ended early.").arg(tally.torn).arg(tally.stopped);
    if (tally.inaccurate > 0)
        words += ' ' + tr("%1 missed the wanted accuracy.").arg(tally.inaccurate);
    if (const QString left = timeLeftText(m_runner->secondsLeft()); !left.isEmpty())
        words += ' ' + left;
    if (const OtherBuild& other = m_runner->otherBuild(); other.rows > tally.flown)
        words += ' '
                 + tr("Flown by another build, %1: %2. They stay, and are flown anew.")
                       .arg(QString::fromStdString(other.program), QString::number(other.rows));
    if (!isOfTheDesign())
        words += ' '
                 + tr("It flies %1, which is not the design that is open.")
                       .arg(QString::fromStdString(m_runner->study()->study.scene));
    if (m_isEdited)
        words += ' ' + tr("The map is that of the study before you changed it; Fly adds the rest.");
    m_state->setText(words.trimmed());
}

void StudyPanel::showFailure(const Message& why)
{
    m_fliesOnceOpen = false;
    showState();
    if (m_pages->currentIndex() == 1)
        m_state->setText(translated(why));
    else
        QMessageBox::warning(this, tr("Cannot open the study"), translated(why));
}

void StudyPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_view->refresh();
}

// --- what is done with a flight -----------------------------------------------------------------

void StudyPanel::saveTable()
{
    if (!m_runner->study())
        return;
    const QString file =
        askWhereToSave(this, tr("Save the table"), QString(m_file).replace(ending(), ".csv"),
                       tr("Tables (*.csv)"), QStringLiteral("csv"));
    if (file.isEmpty())
        return;
    if (const auto failure = replaceFile(
            pathOf(file), studyTable(*m_runner->study(), m_runner->flights()), Flush::ToDisk))
        QMessageBox::warning(this, tr("Cannot save the table"), translated(failure->message));
    else
        emit said(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
}

} // namespace ripstop
