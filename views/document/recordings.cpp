// Stages, in the order of the sections: the list of runs, which grows with each run of the player;
// looking back, where seek() asks the fetcher for a frame and take() shows it, so that dragging
// along the timeline never waits for frames to be unpacked; playing back, by the clock rather than
// by frames, because ticks are late where drawing is slow; bookmarks; and branches, whose first
// moment is computed on a thread and then begins a new run of the player.
#include "document/recordings.h"

#include "document/words.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

constexpr int watchInterval = 100; // ms
constexpr int tickInterval = 16;   // ms
constexpr double fastest = 10.0;   // s of the recording per s of the clock

QString secondsText(double time) { return QLocale().toString(time, 'f', 2); }

} // namespace

Recordings::Recordings(Player& player, QObject* parent)
    : QObject(parent)
    , m_player(player)
    , m_fetcher(
          [](const Wish& wish) { return fetch(wish); },
          [this] { QMetaObject::invokeMethod(this, &Recordings::take, Qt::QueuedConnection); })
    , m_starter([this](const Start& start) { return compute(start); },
                [this] {
                    QMetaObject::invokeMethod(this, &Recordings::takeMoment, Qt::QueuedConnection);
                })
{
    connect(&player, &Player::recordingBegan, this,
            [this](const std::shared_ptr<Recording>& recording) {
                nameRun(recording);
                m_live = recording;
                add(recording);
            });
    connect(&player, &Player::stateChanged, this, [this] {
        if (m_begins && m_origin && m_origin->run != 0 && m_origin->run != m_player.run()) {
            m_begins.reset(); // the player was reset before the branch began
            m_origin.reset();
        }
        if (!m_player.isLookingBack() && std::exchange(m_showsPast, false) && !m_begins)
            leavePast(); // the run goes on
    });
    connect(&m_watch, &QTimer::timeout, this, &Recordings::watch);
    m_watch.start(watchInterval);
    m_tick.setTimerType(Qt::PreciseTimer);
    m_tick.setInterval(tickInterval);
    connect(&m_tick, &QTimer::timeout, this, &Recordings::tick);
}

Recordings::~Recordings() { m_cancelled = true; }

void Recordings::nameRun(const std::shared_ptr<Recording>& recording)
{
    Given given{recording, m_count + 1, std::exchange(m_origin, std::nullopt), recording->name()};
    if (given.origin && given.origin->run != recording->run())
        given.origin.reset(); // the player was reset meanwhile
    say(given);
    m_given.push_back(std::move(given));
}

void Recordings::say(Given& given)
{
    const auto recording = given.recording.lock();
    if (!recording)
        return;
    if (recording->name() == given.name) { // nobody has renamed it
        given.name = tr("Run %1").arg(given.number).toStdString();
        recording->setName(given.name);
    }
    if (!given.origin)
        return;
    if (const auto from = given.origin->recording.lock())
        recording->setOrigin(
            tr("%1 s of %2")
                .arg(secondsText(given.origin->time), QString::fromStdString(from->name()))
                .toStdString());
}

void Recordings::retranslate()
{
    for (Given& given : m_given)
        say(given);
    emit listChanged();
}

void Recordings::add(std::shared_ptr<Recording> recording)
{
    ++m_count;
    m_list.push_back(recording);
    setCurrent(recording);
}

void Recordings::setCurrent(const std::shared_ptr<Recording>& recording)
{
    makeCurrent(recording);
    if (!m_current || m_current == m_live)
        backToLive();
    else
        seek(0); // it was opened from a file or is over, so there is no live run to show
}

void Recordings::makeCurrent(const std::shared_ptr<Recording>& recording)
{
    pause();
    m_current = recording;
    m_loop.reset();
    m_seen = 0;
    watch();
    emit listChanged();
    emit stateChanged();
}

void Recordings::clear()
{
    setGhost(nullptr);
    m_list.clear();
    m_live = nullptr;
    m_certificate = nullptr;
    m_count = 0;
    m_given.clear();
    m_origin.reset();
    setCurrent(nullptr);
}

void Recordings::rename(const std::shared_ptr<Recording>& recording, const QString& name)
{
    recording->setName(name.toStdString());
    emit listChanged();
}

void Recordings::remove(std::shared_ptr<Recording> recording)
{
    std::erase(m_list, recording);
    std::erase_if(m_given, [&](const Given& one) { return one.recording.lock() == recording; });
    if (m_live == recording)
        m_live = nullptr;
    if (std::erase_if(m_ghosts, [&](const Ghost& one) { return one.recording == recording; }) > 0)
        setGhosts(m_ghosts);
    if (m_current == recording)
        setCurrent(m_list.empty() ? nullptr : m_list.back());
    emit listChanged();
}

// Called by a timer, because a run that goes on has more frames each time.
void Recordings::watch()
{
    const std::size_t count = m_current ? m_current->frameCount() : 0;
    if (count == m_seen)
        return;
    m_seen = count;
    if (m_current == m_live && !m_wantsPast)
        m_begins.reset();
    if (!m_wantsPast)
        m_frame = count == 0 ? 0 : count - 1;
    emit grew();
}

// Between two looks of watch() a run may have made many frames.
double Recordings::time() const
{
    const std::size_t count = m_current ? m_current->frameCount() : 0;
    if (m_begins && (count == 0 || m_current != m_live || m_wantsPast))
        return *m_begins;
    if (count == 0)
        return 0.0;
    return m_current->timeOf(m_wantsPast ? std::min(m_frame, count - 1) : count - 1);
}

// --- how true they are -------------------------------------------------------------------------

std::vector<std::shared_ptr<const Certificate>> Recordings::certificates() const
{
    std::vector<std::shared_ptr<const Certificate>> found;
    if (m_certificate)
        found.push_back(m_certificate);
    for (const auto& recording : m_list)
        if (auto certificate = recording->certificate())
            found.push_back(std::move(certificate));
    return found;
}

void Recordings::takeCertificate(std::shared_ptr<const Certificate> certificate)
{
    m_certificate = std::move(certificate);
    emit certified();
}

// --- looking back ------------------------------------------------------------------------------

void Recordings::seek(std::size_t frame)
{
    if (!m_current || m_current->frameCount() == 0)
        return;
    m_begins.reset();
    m_frame = std::min(frame, m_current->frameCount() - 1);
    m_wantsPast = true;
    if (!isPlaying())
        m_time = time();
    ask();
    emit moved();
}

void Recordings::seekTime(double time)
{
    if (m_current && m_current->frameCount() > 0)
        seek(m_current->frameAt(time));
}

bool Recordings::seekRun(std::uint64_t run, double time)
{
    constexpr double between = 0.1; // s, that the next frame of a run under way may be off
    const auto has = [&](const std::shared_ptr<Recording>& one) {
        const std::size_t count = one && one->run() == run ? one->frameCount() : 0;
        return count > 0 && time >= one->timeOf(0) && time <= one->timeOf(count - 1) + between;
    };
    if (!has(m_current)) {
        const auto found = std::ranges::find_if(m_list, has);
        if (found == m_list.end())
            return false;
        makeCurrent(*found);
    }
    pause();
    const std::size_t nearest = m_current->frameAt(time);
    seek(nearest > 0 && m_current->timeOf(nearest) >= time ? nearest - 1 : nearest);
    return true;
}

void Recordings::move(std::ptrdiff_t frames)
{
    if (!m_current || m_current->frameCount() == 0)
        return;
    const auto last = std::ptrdiff_t(m_current->frameCount()) - 1;
    pause();
    seek(std::size_t(std::clamp(std::ptrdiff_t(m_frame) + frames, std::ptrdiff_t(0), last)));
}

void Recordings::backToLive()
{
    m_showsPast = false;
    m_player.lookAt(nullptr);
    leavePast();
}

void Recordings::leavePast()
{
    pause();
    m_wantsPast = false;
    if (m_live && m_current != m_live)
        makeCurrent(m_live);
    emit ghostsShown({});
    m_seen = 0;
    watch();
    emit moved();
}

bool Recordings::toEvent(Way way)
{
    if (!m_current || m_current->frameCount() == 0)
        return false;
    const std::int64_t here = m_current->stepOf(m_frame);
    const auto frameOf = [this](const RunEvent& event) {
        return m_current->frameOfStep(event.step); // frames leave out steps
    };
    const std::vector<RunEvent> events = m_current->events();
    const auto isBehind = [&](const RunEvent& event) {
        const std::int64_t there = m_current->stepOf(frameOf(event));
        return way == Way::Forward ? there <= here : there < here;
    };
    auto found = std::ranges::partition_point(events, isBehind);
    if (way == Way::Forward ? found == events.end() : found == events.begin())
        return false;
    if (way == Way::Back)
        --found;
    pause();
    seek(frameOf(*found));
    emit reached(*found, int(std::ranges::count(events, frameOf(*found), frameOf)) - 1);
    return true;
}

bool Recordings::toBookmark(Way way)
{
    if (!m_current || m_current->frameCount() == 0)
        return false;
    const std::int64_t here = m_current->stepOf(m_frame);
    std::optional<std::int64_t> found;
    for (const Bookmark& bookmark : m_current->bookmarks())
        if (way == Way::Forward ? bookmark.step > here && !found : bookmark.step < here)
            found = bookmark.step;
    if (found) {
        pause();
        seek(m_current->frameOfStep(*found));
    }
    return found.has_value();
}

void Recordings::ask() { m_fetcher.post({m_current, m_frame, m_ghosts}); }

// Null where it has none.
static std::shared_ptr<const Frame> ghostFrame(const Recordings::Ghost& ghost, double time)
{
    if (ghost.recording->frameCount() == 0)
        return nullptr;
    const auto frame = ghost.recording->frame(ghost.recording->frameAt(time));
    if (!frame)
        return nullptr;
    if (ghost.shift == Vec3(0.0, 0.0, 0.0))
        return *frame;
    const auto shifted = std::make_shared<Frame>(**frame);
    for (Vec3& position : shifted->position)
        position += ghost.shift;
    return shifted;
}

Recordings::Shown Recordings::fetch(const Wish& wish)
{
    Shown shown;
    const auto frame = wish.recording->frame(wish.frame);
    if (!frame)
        return {nullptr, {}, frame.message()};
    shown.frame = *frame;
    for (const Ghost& ghost : wish.ghosts)
        if (auto there = ghostFrame(ghost, shown.frame->time))
            shown.ghosts.push_back({std::move(there), ghost.color, ghost.shift});
    return shown;
}

void Recordings::take()
{
    const auto shown = m_fetcher.take();
    if (!shown || !m_wantsPast || m_begins)
        return; // the user has gone back to the live run meanwhile
    if (!shown->frame) {
        pause();
        emit failed(translated(shown->failure));
        return;
    }
    const bool isNew = !std::exchange(m_showsPast, true);
    m_player.lookAt(shown->frame);
    emit ghostsShown(shown->ghosts);
    if (isNew)
        emit stateChanged(); // there is a way back from now on
}

void Recordings::setGhost(std::shared_ptr<Recording> recording)
{
    std::vector<Ghost> ghosts;
    if (recording)
        ghosts.push_back({std::move(recording)});
    setGhosts(std::move(ghosts));
}

void Recordings::setGhosts(std::vector<Ghost> ghosts)
{
    m_ghosts = std::move(ghosts);
    if (m_ghosts.empty())
        emit ghostsShown({});
    else if (m_wantsPast)
        ask();
    else
        seek(m_frame);
    emit stateChanged();
}

// --- playing back ------------------------------------------------------------------------------

void Recordings::play()
{
    if (!m_current || m_current->frameCount() == 0 || isPlaying())
        return;
    const double last = m_current->timeOf(m_current->frameCount() - 1);
    m_time = time() >= last ? m_current->timeOf(0) : time();
    if (m_loop && (m_time < m_loop->from || m_time >= m_loop->to))
        m_time = m_loop->from;
    m_tick.start();
    m_clock.start();
    seekTime(m_time);
    emit stateChanged();
}

void Recordings::pause()
{
    if (!isPlaying())
        return;
    m_tick.stop();
    emit stateChanged();
}

void Recordings::setLoop(std::optional<Range> range)
{
    m_loop = range;
    emit stateChanged();
}

void Recordings::tick()
{
    const double last = m_current->timeOf(m_current->frameCount() - 1);
    const double speed = m_player.speed() > 0.0 ? m_player.speed() : fastest;
    m_time += speed * double(m_clock.restart()) / 1000.0; // ticks are late where drawing is slow
    if (m_loop && m_time > m_loop->to)
        m_time = m_loop->from;
    const std::size_t frame = m_current->frameAt(m_time);
    if (frame != m_frame)
        seek(frame);
    if (m_time >= last)
        pause();
}

// --- bookmarks ---------------------------------------------------------------------------------

void Recordings::addBookmark(const QString& name)
{
    if (!m_current || m_current->frameCount() == 0)
        return;
    std::vector<Bookmark> bookmarks = m_current->bookmarks();
    bookmarks.push_back({m_current->stepOf(m_frame), time(), name.toStdString()});
    m_current->setBookmarks(std::move(bookmarks));
    emit grew();
}

void Recordings::removeBookmark(std::size_t number)
{
    std::vector<Bookmark> bookmarks = m_current->bookmarks();
    if (number >= bookmarks.size())
        return;
    bookmarks.erase(bookmarks.begin() + std::ptrdiff_t(number));
    m_current->setBookmarks(std::move(bookmarks));
    emit grew();
}

// --- branches ----------------------------------------------------------------------------------

void Recordings::continueHere()
{
    if (!m_current || m_current->frameCount() == 0 || m_computing)
        return;
    pause();
    m_origin = Origin{m_current, time()};
    m_computing = true;
    m_cancelled = false;
    m_starter.post({m_current, m_current->stepOf(m_frame)});
    emit stateChanged();
}

void Recordings::cancel() { m_cancelled = true; }

Recordings::Begin Recordings::compute(const Start& start)
{
    auto moment = start.recording->moment(start.step, [this](double) { return !m_cancelled; });
    if (!moment)
        return {nullptr, moment.message()};
    return {std::move(*moment), {}};
}

void Recordings::takeMoment()
{
    const auto begin = m_starter.take();
    if (!begin)
        return;
    m_computing = false;
    if (begin->moment) {
        m_begins = timeOf(*begin->moment); // the old run stays in the timeline until Play
        m_player.continueFrom(begin->moment);
        if (m_origin)
            m_origin->run = m_player.run();
        emit said(tr("Play goes on from %1 s with the design as it is now, as a run of its own.")
                      .arg(secondsText(timeOf(*begin->moment))));
    } else {
        m_origin.reset();
    }
    if (!begin->moment && !m_cancelled)
        emit failed(translated(begin->failure));
    emit stateChanged();
}

} // namespace ripstop
