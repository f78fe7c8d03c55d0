// Edits start a timer; when it runs out, check() asks the follower. Its findings come in two
// signals, the problems first and the figures of stability right after them; the second one
// rebuilds the list. noteStop() adds why the player stopped, until a frame of a running simulation
// comes; noteFrame() that the run is not as true as wanted.
//
// told() leaves out what the list beside tells; rebuild() makes a row of each finding and announces
// the counts, those of the list beside included.
#include "problems/problem_list.h"

#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/tinted.h"
#include "problems/stability_list.h"

#include <QLabel>
#include <QListWidget>
#include <QSplitter>
#include <QStackedLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

namespace ripstop {
namespace {

constexpr int patience = 250;    // ms after the last edit
constexpr int oldFigures = 1000; // ms

QIcon signOf(Severity severity)
{
    return severity == Severity::Error
               ? tinted(QStringLiteral("error"), QColor(0xd6, 0x3b, 0x3b))
               : tinted(QStringLiteral("warning"), QColor(0xd9, 0x8e, 0x1f));
}

// What is wrong with forces comes first, and alone.
std::vector<Finding> untruthsOf(const Frame& frame)
{
    const RunAccuracy& accuracy = frame.accuracy;
    if (!accuracy.isMet())
        return {{Severity::Warning, accuracy.complaint(), {Id{accuracy.worstLink}}}};
    std::vector<Finding> untruths;
    if (const Message complaint = accuracy.loadComplaint(frame.worstOfRun); !complaint.empty())
        untruths.push_back(
            {Severity::Warning, complaint, {Id{frame.worstOfRun.all().front().element}}});
    if (const Message complaint = accuracy.dampingComplaint(); !complaint.empty())
        untruths.push_back({Severity::Warning, complaint, {}});
    return untruths;
}

} // namespace

ProblemList::ProblemList(Document& document, Selection& selection, Player& player, QWidget* parent)
    : QWidget(parent)
    , m_selection(selection)
    , m_player(player)
    , m_side(new QWidget)
    , m_pages(new QStackedLayout)
    , m_empty(new QLabel(tr("No problems")))
    , m_list(new QListWidget)
    , m_stability(new StabilityList(document, selection))
{
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setAccessibleName(tr("Problems"));
    m_list->setToolTip(tr("Click a problem to select what causes it."));
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_list);
    m_side->setLayout(m_pages);
    auto* beside = new QSplitter;
    beside->addWidget(m_side);
    beside->addWidget(m_stability);
    beside->setSizes({430, 430}); // px; either has sentences of several lines
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(beside);

    m_delay.setSingleShot(true);
    m_delay.setInterval(patience);
    connect(&m_delay, &QTimer::timeout, this, &ProblemList::check);
    connect(&document, &Document::changed, &m_delay, qOverload<>(&QTimer::start));
    connect(&document, &Document::replaced, this, &ProblemList::check);
    connect(&player.follower(), &Follower::checked, this,
            [this](const std::vector<Finding>& problems) { m_problems = problems; });
    connect(&player.follower(), &Follower::examined, this,
            [this](const std::vector<Finding>& findings) { // this comes right after checked()
                m_stability->showFindings(findings);
                rebuild();
            });
    connect(&player, &Player::stopped, this, &ProblemList::noteStop);
    connect(&player, &Player::frameReady, this,
            [this](const std::shared_ptr<const Frame>& frame) { noteFrame(*frame); });

    const auto select = [this](QListWidgetItem* item) {
        const Id culprit{item->data(Qt::UserRole).toUInt()};
        if (culprit != noId)
            m_selection.set({culprit});
    };
    connect(m_list, &QListWidget::itemClicked, this, select);
    connect(m_list, &QListWidget::itemActivated, this, select);
    check();
}

void ProblemList::check() { m_player.follower().check(); }

void ProblemList::noteStop(const QString& why, quint32 culprit)
{
    if (why == m_player.problem())
        return; // the check says it as well
    m_stops = {{Severity::Error, Message::verbatim(why.toStdString()), {Id{culprit}}}};
    rebuild();
}

// The sentence about the accuracy has figures of now; once in a while is enough to read them.
void ProblemList::noteFrame(const Frame& frame)
{
    const bool goesOn = frame.stopped.empty() && !m_stops.empty();
    std::vector<Finding> untrue = untruthsOf(frame);
    const bool turned = untrue.size() != m_untrue.size();
    const bool isOld = !untrue.empty() && m_sinceUntrue.hasExpired(oldFigures);
    if (!goesOn && !turned && !isOld)
        return;
    if (goesOn)
        m_stops.clear();
    if (turned || isOld) {
        m_untrue = std::move(untrue);
        m_sinceUntrue.start();
    }
    rebuild();
}

std::vector<Finding> ProblemList::told() const
{
    std::vector<Finding> all = m_stops;
    std::ranges::copy(m_untrue, std::back_inserter(all));
    std::ranges::copy_if(m_problems, std::back_inserter(all), [this](const Finding& problem) {
        return problem.severity == Severity::Error || !m_stability->tellsPoor(problem.sort);
    });
    return all;
}

void ProblemList::rebuild()
{
    const std::vector<Finding> all = told();
    m_list->clear();
    for (const Finding& problem : all) {
        const bool isError = problem.severity == Severity::Error;
        auto* item =
            new QListWidgetItem(signOf(problem.severity), translated(problem.message), m_list);
        item->setData(Qt::UserRole, std::uint32_t(problem.culprit()));
        item->setData(Qt::AccessibleTextRole,
                      (isError ? tr("Error: %1") : tr("Warning: %1")).arg(item->text()));
    }
    // "No problems" beside a warning would be two truths
    m_side->setVisible(!all.empty() || m_stability->poor() == 0);
    m_pages->setCurrentWidget(all.empty() ? static_cast<QWidget*>(m_empty) : m_list);

    m_errors = int(std::count_if(all.begin(), all.end(),
                                 [](const Finding& p) { return p.severity == Severity::Error; }));
    m_warnings = int(all.size()) - m_errors + m_stability->poor();
    emit countChanged(m_errors, m_warnings);
}

} // namespace ripstop
