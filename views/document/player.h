#pragma once

#include "run/runner.h"
#include "scene/edit.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>

namespace ripstop {

class Document;

// The Qt face of the runner: compiles the document off the window's thread whenever it changes,
// hands the system to the runner, and brings back the newest frame once per displayed frame.
class Player final : public QObject
{
    Q_OBJECT

public:
    explicit Player(Document& document, QObject* parent = nullptr);
    ~Player() override;

    bool isPlaying() const { return m_playing; }
    double speed() const { return m_speed; }
    const std::shared_ptr<const Frame>& frame() const { return m_frame; } // null before the first

    // Why there is nothing to play ("particle 3 is free and has no mass ..."), or empty.
    const QString& problem() const { return m_problem; }

    void play();
    void pause();
    void toggle();
    void step();  // one time step; pauses
    void reset(); // back to the design; controls return to zero
    void setSpeed(double ratio);
    void playUntil(double time); // s; as fast as it can, then pauses exactly there

    // Moves the command of a control by whole steps, within its limit.
    void nudge(Id control, int steps);

signals:
    void frameReady(const std::shared_ptr<const ripstop::Frame>& frame);
    void stateChanged();                               // playing, speed or problem
    void stopped(const QString& why, quint32 culprit); // the simulation cannot go on

private:
    void scheduleCompile();
    void poll();

    class Compiler;

    Document& m_document;
    Runner m_runner;
    std::unique_ptr<Compiler> m_compiler; // its thread and mailboxes
    std::shared_ptr<const Frame> m_frame;
    Commands m_commands;
    QTimer m_poll;
    QString m_problem;
    double m_speed = 1.0;
    std::uint64_t m_run = 1;
    bool m_playing = false;
};

} // namespace ripstop
