// The runs that are kept, which of them is looked back at, and where.
//
// Each run of the player is kept as it goes, and what was opened from files stands beside. All of
// it is called from the window's thread; frames are unpacked and moments computed on threads of
// their own, and of several that are asked for the newest comes.
#pragma once

#include "document/player.h"
#include "document/worker.h"
#include "recording/recording.h"

#include <QElapsedTimer>
#include <QObject>
#include <QRgb>
#include <QString>
#include <QTimer>

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace ripstop {

// A ghost as views draw it.
struct GhostFrame
{
    std::shared_ptr<const Frame> frame;
    std::optional<QRgb> color;
    Vec3 shift{0.0, 0.0, 0.0}; // m, that the frame was moved by
};

class Recordings final : public QObject
{
    Q_OBJECT

public:
    explicit Recordings(Player& player, QObject* parent = nullptr);
    ~Recordings() override;

    using List = std::vector<std::shared_ptr<Recording>>;
    const List& list() const { return m_list; } // in the order in which they came
    const std::shared_ptr<Recording>& current() const { return m_current; } // null: there is none

    void setCurrent(const std::shared_ptr<Recording>& recording); // one of the list
    void add(std::shared_ptr<Recording> recording);               // and makes it the current one
    void setMemory(std::size_t bytes) { m_player.setRecordingMemory(bytes); } // of each run
    void clear();
    // Says names that nobody has chosen ("Run 1") in the language that is spoken now.
    void retranslate();
    void rename(const std::shared_ptr<Recording>& recording, const QString& name);
    void remove(std::shared_ptr<Recording> recording);

    // --- how true they are ---
    // What the design was certified by last, and the runs of the list that carry a certificate.
    std::vector<std::shared_ptr<const Certificate>> certificates() const;
    void takeCertificate(std::shared_ptr<const Certificate> certificate); // of the design

    // --- looking back ---
    bool isLookingBack() const { return m_player.isLookingBack(); }
    std::size_t frame() const { return m_frame; } // the newest one while not looking back
    double time() const; // s; where a new branch begins until it has frames of its own
    void seek(std::size_t frame);
    void seekTime(double time); // s
    // The last frame of that run before then, s, in which what breaks at that time is still whole;
    // false where that is not recorded.
    bool seekRun(std::uint64_t run, double time);
    void move(std::ptrdiff_t frames);
    void backToLive();

    enum class Way { Back, Forward };
    bool toEvent(Way way);    // false when there is no event that way
    bool toBookmark(Way way); // false when there is no bookmark that way

    // --- playing back ---
    // At the speed of the player, recorded seconds per second of the clock; ten of them where that
    // is as fast as it can.
    bool isPlaying() const { return m_tick.isActive(); }
    void play();
    void pause();

    struct Range
    {
        double from; // s
        double to;   // s
    };
    const std::optional<Range>& loop() const { return m_loop; }
    void setLoop(std::optional<Range> range);

    // --- bookmarks ---
    void addBookmark(const QString& name); // here
    void removeBookmark(std::size_t number);

    // --- branches ---
    void continueHere(); // a new run from the exact state, with the design as it is now
    bool isComputing() const { return m_computing; }
    void cancel(); // what is being computed

    // Other recordings whose frames of the same time are shown as ghosts.
    struct Ghost
    {
        std::shared_ptr<Recording> recording;
        Vec3 shift{0.0, 0.0, 0.0};      // m, to the side of where it flew
        std::optional<QRgb> color = {}; // none: that of all ghosts
    };
    const std::vector<Ghost>& ghosts() const { return m_ghosts; }
    void setGhosts(std::vector<Ghost> ghosts);

    std::shared_ptr<Recording> ghost() const // the first, or null
    {
        return m_ghosts.empty() ? nullptr : m_ghosts.front().recording;
    }
    void setGhost(std::shared_ptr<Recording> recording); // that one alone, or none

signals:
    void listChanged();  // the list, which run is the current one, or the name of a run
    void certified();    // there is another certificate of the design
    void grew();         // the current recording has more frames, or other bookmarks
    void moved();        // where one looks
    void stateChanged(); // playing, loop, computing, looking back or not
    void failed(const QString& why);
    void said(const QString& words); // what has been done, for the status bar
    // An event has been jumped to; `more` further events belong to the same frame.
    void reached(const ripstop::RunEvent& event, int more);
    void ghostsShown(const std::vector<ripstop::GhostFrame>& ghosts); // empty: none

private:
    struct Wish
    {
        std::shared_ptr<Recording> recording;
        std::size_t frame = 0;
        std::vector<Ghost> ghosts; // at the same time
    };
    struct Shown
    {
        std::shared_ptr<const Frame> frame;
        std::vector<GhostFrame> ghosts;
        Message failure;
    };
    struct Start
    {
        std::shared_ptr<Recording> recording;
        std::int64_t step = 0;
    };
    struct Begin
    {
        std::shared_ptr<const Moment> moment;
        Message failure;
    };

    // Where a branch begins.
    struct Origin
    {
        std::weak_ptr<Recording> recording;
        double time = 0.0;     // s
        std::uint64_t run = 0; // that begins there; 0 while its first moment is computed
    };
    // What a run was called by the program: once more in another language, unless it was renamed.
    struct Given
    {
        std::weak_ptr<Recording> recording;
        int number = 0;
        std::optional<Origin> origin;
        std::string name;
    };

    void nameRun(const std::shared_ptr<Recording>& recording);
    static void say(Given& given);
    static Shown fetch(const Wish& wish);
    Begin compute(const Start& start);
    void take();
    void takeMoment();
    void tick();
    void leavePast();
    void makeCurrent(const std::shared_ptr<Recording>& recording);
    void ask();
    void watch();

    Player& m_player;
    List m_list;
    std::shared_ptr<Recording> m_current;
    std::vector<Ghost> m_ghosts;
    std::shared_ptr<const Certificate> m_certificate; // of the design, or null
    std::size_t m_frame = 0;
    std::size_t m_seen = 0;   // frames when grew() was last emitted
    int m_count = 0;          // of runs so far
    bool m_wantsPast = false; // a past frame is asked for or shown
    bool m_showsPast = false;
    std::shared_ptr<Recording> m_live; // of the run of the player
    std::optional<Origin> m_origin;    // of the branch that is about to begin
    std::vector<Given> m_given;        // of the runs of the list
    QTimer m_watch;
    QElapsedTimer m_clock; // since the last tick
    QTimer m_tick;
    double m_time = 0.0; // s, of the playback
    std::optional<Range> m_loop;
    bool m_computing = false;
    std::optional<double> m_begins; // s, where a branch has been made that has no frame yet
    std::atomic<bool> m_cancelled = false;
    Worker<Wish, Shown> m_fetcher; // last: these end before what they use
    Worker<Start, Begin> m_starter;
};

} // namespace ripstop
