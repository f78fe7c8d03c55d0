// Stages: the constructor puts two labels at the right of the bar and connects what changes them.
// The counts of the scene follow each edit; the words for the selection are made by a short timer,
// because a drag can select many times in between. Messages and what is under the mouse share the
// left side, and the later one stands there.
#include "editor/status_line.h"

#include "document/document.h"
#include "document/event_words.h"
#include "document/measurement.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/selection.h"
#include "document/words.h"
#include "inspector/totals.h"
#include "tools/pointing.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"

#include <QLabel>
#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace ripstop {

StatusLine::StatusLine(QStatusBar& bar, Document& document, Selection& selection, Player& player)
    : QObject(&bar)
    , m_bar(bar)
    , m_document(document)
    , m_selection(selection)
    , m_player(player)
    , m_selected(new QLabel)
    , m_counts(new QLabel)
{
    for (QLabel* label : {m_selected, m_counts}) {
        label->setTextFormat(Qt::PlainText); // names of things
        label->setContentsMargins(8, 0, 8, 0);
        bar.addPermanentWidget(label);
    }
    m_selectedSoon.setSingleShot(true);
    m_selectedSoon.setInterval(50); // ms; a drag may select many times
    connect(&m_selectedSoon, &QTimer::timeout, this, &StatusLine::showSelected);
    connect(&selection, &Selection::changed, this, [this] { m_selectedSoon.start(); });
    connect(&document, &Document::changed, this, &StatusLine::showCounts);
    connect(&document, &Document::replaced, this, &StatusLine::showCounts);
    connect(&document, &Document::replaced, &bar, &QStatusBar::clearMessage); // of the other scene
    connect(&player, &Player::stopped, this, [this](const QString& why) { say(why, read); });
    showCounts();
}

void StatusLine::say(const QString& message, int time) { m_bar.showMessage(message, time); }

void StatusLine::follow(const Recordings& recordings)
{
    hear(recordings);
    connect(&recordings, &Recordings::failed, this, [this](const QString& why) { say(why); });
    connect(&recordings, &Recordings::grew, this, [&, this] { tellTears(recordings); });
    connect(&recordings, &Recordings::reached, this, [this](const RunEvent& one, int more) {
        say(describe(one, m_document.scene(), more));
    });
}

void StatusLine::tellTears(const Recordings& recordings)
{
    const auto& recording = recordings.current();
    // What is shown may be of before it: a short run is over when its first frame is drawn.
    if (!recording || m_player.run() != recording->run())
        return;
    if (std::exchange(m_watched, recording->run()) != recording->run())
        m_heard = 0;
    const std::vector<RunEvent> news = recording->events(m_heard);
    m_heard += news.size();
    const auto tear = std::ranges::find(news, RunEvent::Kind::Tear, &RunEvent::kind);
    if (tear != news.end())
        say(describeInGust(*tear, m_document.scene()), read);
}

void StatusLine::follow(Viewport& viewport)
{
    hear(viewport.transformTool());
    connect(&viewport.pointing(), &Pointing::hoveredChanged, this, &StatusLine::showHovered);
}

void StatusLine::showCounts()
{
    qsizetype particles = 0;
    qsizetype links = 0;
    qsizetype panels = 0;
    forEachPart(m_document.scene(), [&](Id, const Part& part) {
        particles += qsizetype(part.particles.size());
        links += qsizetype(part.links.size());
        panels += qsizetype(part.panels.size());
    });
    m_counts->setText(QStringList{counted(Kind::Particle, particles), counted(Kind::Link, links),
                                  counted(Kind::Panel, panels)}
                          .join(" · "));
    m_selectedSoon.start();
}

void StatusLine::showSelected()
{
    const auto& ids = m_selection.ids();
    if (ids.empty())
        return m_selected->clear();
    m_selected->setText(tr("Selected: %1").arg(summary(ids)));
}

void StatusLine::showHovered(Id id)
{
    if (id == noId)
        return m_bar.clearMessage();
    const auto& frame = m_player.frame();
    const QString reading = frame ? readingOf(*frame, id) : QString();
    m_bar.showMessage(reading.isEmpty() ? summary({id}) : summary({id}) + " · " + reading);
}

// "3 particles of kite · 0.2 kg"
QString StatusLine::summary(const std::vector<Id>& ids) const
{
    const QString what = describe(m_document.scene(), ids);
    const QString sums = totals(m_document.scene(), ids);
    return sums.isEmpty() ? what : what + " · " + sums;
}

} // namespace ripstop
