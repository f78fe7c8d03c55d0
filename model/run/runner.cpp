#include "run/runner.h"

#include "run/runner_loop.h"
#include "run/runner_mail.h"

#include <utility>

namespace ripstop {

Runner::Runner()
    : m_mail(std::make_unique<RunnerMail>())
    , m_thread([mail = m_mail.get()](const std::stop_token& stop) { RunnerLoop(*mail).run(stop); })
{}

Runner::~Runner() = default;

void Runner::load(Update update)
{
    m_mail->putUpdate(std::move(update));
    m_mail->wake();
}

void Runner::setPlaying(bool playing)
{
    m_mail->playing = playing;
    m_mail->wake();
}

void Runner::setSpeed(double ratio)
{
    m_mail->speed = ratio;
    m_mail->wake();
}

void Runner::stepOnce()
{
    ++m_mail->stepsLeft;
    m_mail->wake();
}

void Runner::cancelSteps() { m_mail->stepsLeft = 0; }

void Runner::playUntil(double time)
{
    m_mail->until = time;
    m_mail->wake();
}

void Runner::command(Commands commands)
{
    m_mail->commands.put(std::make_shared<const Commands>(std::move(commands)));
    m_mail->wake();
}

void Runner::handle(HandCommands commands)
{
    m_mail->hands.put(std::make_shared<const HandCommands>(std::move(commands)));
    m_mail->wake();
}

void Runner::settle(std::optional<SettleGoal> goal)
{
    m_mail->settle.put(std::make_shared<const std::optional<SettleGoal>>(goal));
    m_mail->wake();
}

std::shared_ptr<const Frame> Runner::takeFrame() { return m_mail->frames.take(); }

std::vector<ProbeSample> Runner::takeSamples() { return m_mail->takeSamples(); }

void Runner::setRecordingMemory(std::size_t bytes) { m_mail->recordingMemory = bytes; }

std::vector<std::shared_ptr<Recording>> Runner::takeRecordings()
{
    return m_mail->takeRecordings();
}

} // namespace ripstop
