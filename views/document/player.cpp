// Stages, in the order of the source: what the user asks for (play, step, settle, hands, controls)
// becomes a change of state or Orders; compileSoon() to giveOrders() have the scene compiled and
// pass orders on once the runner has that system; halt() and the questions about where the run
// stands; takeCompiled() with what the follower answers; and takeFrame(), which the timer calls
// about 60 times a second, with what the runner has done. Each answer is held against the present
// run first, because it may be about a design that has changed since. The header has the states and
// their transitions.
#include "document/player.h"

#include "document/document.h"
#include "document/words.h"
#include "recording/recording.h"
#include "simulation/reached.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace ripstop {
namespace {

constexpr int frameInterval = 16; // ms, about 60 frames a second
constexpr double never = -std::numeric_limits<double>::infinity();

} // namespace

Player::Player(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_follower(document)
{
    connect(&m_follower, &Follower::compiled, this, &Player::takeCompiled);
    connect(&document, &Document::changed, this, &Player::changed);
    connect(&document, &Document::replaced, this, [this] {
        m_frame.reset();
        startOver();
    });
    connect(&m_poll, &QTimer::timeout, this, &Player::takeFrame);
    m_poll.setTimerType(Qt::PreciseTimer);
    m_poll.start(frameInterval);
    compileSoon();
}

void Player::play()
{
    goBack();
    if (!isPlaying() && !refuse())
        begin(Activity::Playing, {.play = true});
}

void Player::pause()
{
    if (!isPlaying())
        return;
    halt();
    emit stateChanged();
}

void Player::toggle() { isPlaying() ? pause() : play(); }

void Player::step()
{
    pause();
    goBack();
    if (!refuse())
        order({.steps = 1 + (m_orders ? m_orders->steps : 0)});
}

void Player::playUntil(double time)
{
    halt();
    goBack();
    if (!refuse())
        begin(Activity::Racing, {.until = time});
}

void Player::settle(SettleGoal goal)
{
    halt();
    goBack();
    if (refuse())
        return;
    goal.number = ++m_goals;
    begin(Activity::Settling, {.settle = goal});
}

void Player::begin(Activity activity, const Orders& orders)
{
    m_activity = activity;
    order(orders);
    emit stateChanged();
}

void Player::handle(const HandNote::What& what)
{
    goBack();
    using Stroke = std::shared_ptr<const Cut>;
    if (std::holds_alternative<Stroke>(what) || std::holds_alternative<HandNote::Pin>(what))
        leaveDesign(); // what runs is no longer the design, though it stands at its start
    add(what, m_hands);
    m_runner.handle(m_hands);
}

void Player::reset() { startOver(); }

void Player::lookAt(std::shared_ptr<const Frame> past)
{
    if (!past)
        return goBack();
    const bool isNew = !std::exchange(m_past, std::move(past)) || isPlaying();
    if (isPlaying())
        halt();
    emit frameReady(m_past);
    if (isNew)
        emit stateChanged();
}

void Player::goBack()
{
    if (!std::exchange(m_past, nullptr))
        return;
    if (m_frame)
        emit frameReady(m_frame);
    emit stateChanged();
}

void Player::continueFrom(std::shared_ptr<const Moment> moment)
{
    if (m_past) // what is looked at stays until the new run has a frame
        m_frame = m_past;
    startOver();
    leaveDesign();
    m_hands.hands = handsOf(*moment);
    m_moment = std::move(moment);
    emit stateChanged();
}

void Player::setSpeed(double ratio)
{
    if (ratio == m_speed)
        return;
    m_speed = ratio;
    m_runner.setSpeed(ratio);
    emit stateChanged();
}

void Player::nudge(Id id, int steps)
{
    if (const Control* control = findItem<Control>(m_document.scene(), id))
        steer(id, commandOf(id) + steps * control->step);
}

void Player::steer(Id id, double asked)
{
    const Control* control = findItem<Control>(m_document.scene(), id);
    if (!control)
        return;
    const double command = std::clamp(asked, -control->limit, control->limit);

    // The simulation moves the commands of automatic controls; an old one must not set them back.
    std::erase_if(m_commands, [this](const auto& held) {
        const Control* other = findItem<Control>(m_document.scene(), Id{held.first});
        return !other || other->automaticRate != 0.0;
    });
    m_commands[std::uint32_t(id)] = command;
    m_runner.command(m_commands);
}

double Player::commandOf(Id id) const
{
    if (const auto held = m_commands.find(std::uint32_t(id)); held != m_commands.end())
        if (const Control* control = findItem<Control>(m_document.scene(), id);
            control && control->automaticRate == 0.0)
            return held->second;
    if (m_frame && m_frame->run == m_run) {
        const auto& inputs = m_frame->layout->inputId;
        const auto found = std::find(inputs.begin(), inputs.end(), std::uint32_t(id));
        if (found != inputs.end())
            return m_frame->inputCommand[std::size_t(found - inputs.begin())];
    }
    return 0.0;
}

void Player::changed(const Edit& applied)
{
    const Effect effect = worstEffect(applied);
    if (effect == Effect::Recompile || (effect == Effect::OnReset && m_runState == Run::AtDesign))
        compileSoon();
}

void Player::leaveDesign()
{
    if (m_runState == Run::AtDesign)
        m_runState = Run::UnderWay;
}

void Player::startOver()
{
    halt();
    m_runner.cancelSteps();
    m_runState = Run::AtDesign;
    m_past.reset();
    m_moment.reset();
    m_commands.clear();
    m_hands = {};
    m_runner.command(m_commands);
    m_runner.handle(m_hands);
    compileSoon();
    emit stateChanged();
}

void Player::compileSoon()
{
    if (m_runState == Run::AtDesign)
        ++m_run; // nothing moves yet: the run begins anew from the edited design
    if (std::exchange(m_compile, Compile::Due) == Compile::Due)
        return;
    QMetaObject::invokeMethod(this, &Player::post, Qt::QueuedConnection);
}

void Player::post()
{
    if (m_compile != Compile::Due)
        return;
    m_compile = Compile::UnderWay;
    m_follower.compile(++m_generation, m_run);
    if (m_orders && m_runState == Run::AtDesign)
        m_orders->generation = m_generation;
}

void Player::order(Orders orders)
{
    post();
    orders.generation = m_generation;
    m_orders = orders;
    giveOrders();
}

void Player::giveOrders()
{
    if (!m_orders || m_compiled < m_orders->generation)
        return;
    const Orders orders = *std::exchange(m_orders, std::nullopt);
    leaveDesign();
    for (int i = 0; i < orders.steps; ++i)
        m_runner.stepOnce();
    m_until = orders.until;
    m_runner.playUntil(m_until.value_or(never));
    m_runner.settle(orders.settle);
    m_runner.setPlaying(orders.play);
    if (hasArrived()) { // there is nothing to run, so no frame will say so
        halt();
        emit stateChanged();
    }
}

bool Player::hasArrived() const
{
    const double timeStep = m_document.scene().settings.timeStep;
    return m_until && m_frame && m_frame->run == m_run
           && hasReached(m_frame->time, *m_until, timeStep);
}

bool Player::hasSettled() const
{
    const auto& settling = m_frame->settling;
    return isSettling() && settling && settling->number == m_goals
           && settling->outcome != Settling::Outcome::Under;
}

void Player::halt()
{
    const Activity halted = std::exchange(m_activity, Activity::Paused);
    m_orders.reset();
    m_until.reset();
    m_runner.playUntil(never);
    if (halted == Activity::Settling)
        m_runner.settle(std::nullopt);
    m_runner.setPlaying(false);
}

bool Player::stands() const
{
    return m_compile == Compile::Done && m_frame && m_frame->run == m_run
           && m_frame->generation == m_generation;
}

QString Player::problem() const { return translated(m_problem); }

bool Player::isCurrent() const { return !m_past && m_problem.empty() && stands(); }

bool Player::refuse()
{
    // What was wrong before the newest edit may have been cured by it.
    if (m_compile == Compile::Done && !m_problem.empty())
        emit stopped(problem(), m_culprit);
    else if (stands() && !m_frame->stopped.empty())
        emit stopped(translated(m_frame->stopped), m_frame->culprit);
    else
        return false;
    return true;
}

void Player::takeCompiled(const Compiled& outcome)
{
    const bool runs = outcome.update.system || outcome.update.patch;
    if (runs) { // the next one builds on it, even when it comes too late
        Update update = outcome.update;
        if (outcome.run == m_run)
            update.moment = std::exchange(m_moment, nullptr);
        m_runner.load(std::move(update));
    }
    if (outcome.run != m_run)
        return; // the design has changed since; a newer compile is under way
    m_compiled = outcome.generation;
    if (m_compile == Compile::UnderWay && m_compiled == m_generation)
        m_compile = Compile::Done;
    if (runs && m_runState == Run::AtDesign)
        m_runner.command(m_commands); // a new run starts with its controls at zero
    if (runs)
        m_runner.handle(m_hands); // and with empty hands

    const bool disappoints = !outcome.problem.empty() && (isPlaying() || m_orders);
    const bool isNews = outcome.problem != m_problem || disappoints;
    m_problem = outcome.problem;
    m_culprit = quint32(outcome.culprit);
    if (disappoints)
        halt();
    if (isNews)
        emit stateChanged();
    if (disappoints)
        emit stopped(problem(), m_culprit);
    giveOrders();
}

// Samples that came after the frame was made wait for the next frame. The sample of the same
// instant is left out, because the frame says what the probes read then.
void Player::passSamples(const Frame& frame)
{
    const auto isLater = [&](const ProbeSample& sample) {
        return sample.run == frame.run && sample.time > frame.time;
    };
    const auto later = std::ranges::find_if(m_samples, isLater);
    std::vector<ProbeSample> waiting(std::make_move_iterator(later),
                                     std::make_move_iterator(m_samples.end()));
    m_samples.erase(later, m_samples.end());
    for (const ProbeSample& sample : std::exchange(m_samples, std::move(waiting)))
        if (sample.run == frame.run && sample.time < frame.time)
            emit sampled(sample);
}

void Player::takeFrame()
{
    for (const std::shared_ptr<Recording>& recording : m_runner.takeRecordings())
        emit recordingBegan(recording);
    auto frame = m_runner.takeFrame();
    std::ranges::move(m_runner.takeSamples(), std::back_inserter(m_samples));
    if (!frame || frame->run != m_run)
        return; // it belongs to a run that is over
    passSamples(*frame);
    m_frame = std::move(frame);

    const bool wasStuck = m_runState == Run::Stuck;
    if (!m_frame->stopped.empty())
        m_runState = Run::Stuck;
    else if (wasStuck)
        m_runState = Run::UnderWay;
    const bool gotStuck = m_runState == Run::Stuck && !wasStuck;
    const bool isStill = hasSettled();
    const bool halts = gotStuck || isStill || hasArrived();
    if (halts)
        halt();
    if (!m_past)
        emit frameReady(m_frame);
    if (isStill)
        emit settled(*m_frame->settling);
    if (halts)
        emit stateChanged();
    if (gotStuck)
        emit stopped(translated(m_frame->stopped), m_frame->culprit);
}

} // namespace ripstop
