// The constructor lays out the row and ties buttons to the player. refresh() shows what the player
// is asked to do, and runs when its state changes; refreshRun() shows where the run stands, and
// runs with each frame. Labels of numbers have a fixed size, so that digits that change do not have
// the window laid out anew.
#include "transport/transport.h"

#include "document/document.h"
#include "document/plain_text.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/words.h"
#include "icons/icon.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

constexpr std::array speeds{0.05, 0.1, 0.25, 0.5,
                            1.0,  2.0, 4.0,  10.0}; // simulated seconds per second
constexpr double asFastAsItCan = 0.0;               // as Player::setSpeed() has it
constexpr int edge = 6;                             // px, left and right
constexpr int between = 4;                          // px, of its widgets
constexpr double keepsUp = 0.9;                     // of the speed that was asked for

QString ratioText(double ratio, int decimals)
{
    return QLocale().toString(ratio, 'f', decimals) + QChar(0x00d7); // multiplication sign
}

QString speedText(double speed)
{
    return speed == asFastAsItCan ? Transport::tr("as fast as possible")
                                  : QLocale().toString(speed) + QChar(0x00d7);
}

// A label that does not push its neighbours about when its digits change, nor has the window laid
// out anew.
QLabel* steadyLabel(const QString& widest, const QString& toolTip)
{
    auto* label = new QLabel;
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setFixedSize(label->fontMetrics().size(Qt::TextSingleLine, widest));
    label->setToolTip(toolTip);
    return label;
}

} // namespace

Transport::Transport(Document& document, Player& player, Recordings& recordings, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_recordings(recordings)
    , m_reset(button("reset", tr("Reset"),
                     tr("Back to the design: the run is thrown away, controls return to zero.")))
    , m_step(button("step", tr("Step"),
                    tr("One time step, then pause. Repeats while it is held down.")))
    , m_play(button("play", tr("Play"), {}))
    , m_speed(new QComboBox)
    , m_badge(new QLabel)
    , m_time(steadyLabel(QStringLiteral("00000.000 s"), tr("Simulated time since the start")))
    , m_ratio(steadyLabel(QStringLiteral("00000.00x"), {}))
    , m_substeps(steadyLabel(tr("%1 substeps").arg(2000), {}))
    , m_accuracy(steadyLabel(tr("error %1 %").arg(QStringLiteral("00.000")), {}))
{
    m_badge->setObjectName(QStringLiteral("mode"));
    m_badge->setAlignment(Qt::AlignCenter);
    m_time->setObjectName(QStringLiteral("time"));
    m_ratio->setObjectName(QStringLiteral("ratio"));
    m_substeps->setObjectName(QStringLiteral("substeps"));
    m_accuracy->setObjectName(QStringLiteral("pull_error"));
    m_step->setAutoRepeat(true);
    fillSpeeds();
    m_spared = {m_time, m_speed, m_badge, m_ratio, m_accuracy, m_substeps};

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(edge, 2, edge, 2);
    layout->setSpacing(between);
    layout->addWidget(m_reset);
    layout->addWidget(m_step);
    layout->addWidget(m_play);
    layout->addWidget(m_speed);
    layout->addWidget(m_badge);
    layout->addWidget(m_time);
    layout->addWidget(m_ratio);
    layout->addWidget(m_substeps);
    layout->addWidget(m_accuracy);
    layout->addStretch(1);

    connect(m_reset, &QToolButton::clicked, &player, &Player::reset);
    connect(m_step, &QToolButton::clicked, &player, &Player::step);
    connect(m_play, &QToolButton::clicked, this, &Transport::toggle);
    connect(m_speed, &QComboBox::activated, this,
            [this] { m_player.setSpeed(m_speed->currentData().toDouble()); });
    connect(&player, &Player::stateChanged, this, &Transport::refresh);
    connect(&player, &Player::frameReady, this, &Transport::refreshRun);
    connect(&recordings, &Recordings::stateChanged, this, &Transport::refresh);
    connect(&document, &Document::replaced, this, &Transport::refresh);
    refresh();
}

QSize Transport::sizeHint() const
{
    QSize size = minimumSizeHint();
    for (const QWidget* one : m_spared)
        size.rwidth() += one->sizeHint().expandedTo(one->minimumSize()).width() + between;
    return size;
}

QSize Transport::minimumSizeHint() const
{
    QSize size(2 * edge, m_speed->sizeHint().height() + 4);
    for (const QWidget* one : {m_reset, m_step, m_play})
        size.rwidth() += one->sizeHint().width() + between;
    return size.expandedTo({0, m_play->sizeHint().height() + 4});
}

// In a narrow window what is only told goes before what is pressed.
void Transport::resizeEvent(QResizeEvent* event)
{
    int room = event->size().width() - minimumSizeHint().width();
    bool fits = true;
    for (QWidget* one : m_spared) {
        room -= one->sizeHint().expandedTo(one->minimumSize()).width() + between;
        fits = fits && room >= 0;
        one->setVisible(fits);
    }
    QWidget::resizeEvent(event);
}

QToolButton* Transport::button(const char* name, const QString& text, const QString& toolTip)
{
    auto* made = new QToolButton(this);
    made->setObjectName(QLatin1String(name));
    made->setIcon(icon(QLatin1String(name)));
    made->setText(text);
    made->setAccessibleName(text);
    made->setToolTip(toolTip);
    made->setIconSize({20, 20});
    made->setAutoRaise(true);
    return made;
}

void Transport::fillSpeeds()
{
    m_speed->setObjectName(QStringLiteral("speed"));
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setToolTip(tr("Simulated seconds per second of the clock, also of a recording that is "
                           "played back"));
    for (const double speed : speeds)
        m_speed->addItem(speedText(speed), speed);
    m_speed->addItem(speedText(asFastAsItCan), asFastAsItCan);
}

bool Transport::isPast() const { return m_player.isLookingBack() || m_recordings.isPlaying(); }

void Transport::toggle()
{
    if (!isPast())
        return m_player.toggle();
    m_recordings.isPlaying() ? m_recordings.pause() : m_recordings.play();
}

void Transport::refresh()
{
    const bool playing = m_player.isPlaying() || m_recordings.isPlaying();
    m_play->setIcon(icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
    m_play->setText(playing ? tr("Pause") : tr("Play"));
    m_play->setAccessibleName(m_play->text());
    m_play->setToolTip(
        isPast()  ? playing ? tr("Pause: the recording stands still.")
                            : tr("Play the recording back from where you look (Shift+Space). The "
                                  "Space key leaves it and goes on with the run.")
         : playing ? tr("Pause: the run stands still and can be played on.")
                  : tr("Play: run the simulation from where it stands."));

    int index = m_speed->findData(m_player.speed());
    if (index < 0) { // the speed was set from elsewhere
        m_speed->addItem(speedText(m_player.speed()), m_player.speed());
        index = m_speed->count() - 1;
    }
    m_speed->setCurrentIndex(index);
    refreshRun();
}

void Transport::refreshRun()
{
    const auto& frame = m_player.frame();
    m_time->setText(tr("%1 s").arg(QLocale().toString(frame ? frame->time : 0.0, 'f', 3)));
    m_reset->setEnabled(m_player.isPlaying() || (frame && frame->underWay));
    refreshRatio();
    refreshSubsteps();
    refreshAccuracy();
    refreshBadge();
}

void Transport::refreshRatio()
{
    const auto& frame = m_player.frame();
    const double asked = m_player.speed();
    const double ratio = frame ? frame->realTimeRatio : 0.0;
    const bool moves = m_player.isPlaying() && ratio > 0.0;
    m_ratio->setText(moves ? ratioText(ratio, ratio < 0.01 ? 4 : 2)
                           : QString(QChar(0x2013))); // dash
    const bool lags = moves && asked != asFastAsItCan && ratio < keepsUp * asked;
    m_ratio->setToolTip(lags ? tr("Simulated seconds per second of the clock, lately: this machine "
                                  "cannot reach the %1 that is asked for.")
                                   .arg(speedText(asked))
                             : tr("Simulated seconds per second of the clock, lately"));
}

// The automatic solver's number changes while the scene runs. It has none before the first step of
// a run, and no recording has kept it.
void Transport::refreshSubsteps()
{
    const auto& frame = m_player.frame();
    const bool isOpen = frame && (frame->solverChoice.empty() || !frame->underWay)
                        && m_document.scene().settings.solver == Solver::Auto;
    m_substeps->setText(!frame || isOpen       ? QString()
                        : frame->substeps == 1 ? tr("1 substep")
                                               : tr("%1 substeps").arg(frame->substeps));
    const QString choice = frame ? translated(frame->solverChoice) : QString();
    m_substeps->setToolTip(choice.isEmpty()
                               ? tr("Parts that each time step is cut into")
                               : tr("Parts that the automatic solver cuts each time step into, "
                                    "lately. It began so: %1.")
                                     .arg(choice));
}

// How true the last step was. It stands out while the run misses what is wanted.
void Transport::refreshAccuracy()
{
    const auto& frame = m_player.frame();
    const RunAccuracy accuracy = frame ? frame->accuracy : RunAccuracy();
    if (accuracy.steps == 0) {
        m_accuracy->setText({});
        m_accuracy->setToolTip({});
        return;
    }
    const auto percent = [](double share) {
        return share < 0.1 ? QLocale().toString(100.0 * share, 'g', 2)
                           : QLocale().toString(100.0 * share, 'f', 0);
    };
    const bool byPulls =
        accuracy.pulls / accuracy.wantedPulls >= accuracy.strain / accuracy.wantedStrain;
    const double shown = byPulls ? accuracy.pulls : accuracy.strain;
    m_accuracy->setText(tr("error %1 %")
                            .arg(shown < 1e-4   ? QStringLiteral("0")
                                 : shown < 9.99 ? percent(shown)
                                                : QStringLiteral(">999")));
    QFont font = this->font();
    font.setBold(!accuracy.isMet());
    m_accuracy->setFont(font);
    const QString told =
        tr("Error of the pulls in links in the last step, against what their stiffness says: "
           "%1 %, wanted %2 %. Largest strain of rods that never stretch: %3 %, wanted %4 %.")
            .arg(percent(accuracy.pulls), percent(accuracy.wantedPulls), percent(accuracy.strain),
                 percent(accuracy.wantedStrain))
        + QLatin1Char('\n')
        + tr("Swings of up to %1 Hz keep their frequency within 1 % at this step, and their height "
             "from one to the next; faster ones come out with another frequency, or die away. A "
             "shorter time step tells them.")
              .arg(QLocale().toString(accuracy.fastestSwing, 'g', 3))
        + QLatin1Char('\n')
        + tr("Beside what the design has, the steps have damped its motion of the last ten seconds "
             "by %1 % of critical.")
              .arg(accuracy.damping > 1.0 ? tr("more than 100") : percent(accuracy.damping));
    m_accuracy->setToolTip(
        accuracy.isMet() ? told : shownAsIs(told + QChar('\n') + translated(accuracy.complaint())));
}

void Transport::refreshBadge()
{
    const auto& frame = m_player.frame();
    const bool stuck = frame && !frame->stopped.empty();
    const bool runs = m_player.isPlaying() || (frame && frame->underWay);
    m_badge->setText(isPast() ? tr("Past") : stuck ? tr("Stopped") : runs ? tr("Run") : tr("Edit"));
    if (isPast())
        return m_badge->setToolTip(
            tr("Past: what you see is a moment of a recording. Continue from "
               "here begins a new run at it; Live goes back to the run."));
    m_badge->setToolTip(stuck  ? shownAsIs(translated(frame->stopped))
                        : runs ? tr("Run: what you see is the simulation. Reset returns to the "
                                    "design; properties can be edited in both.")
                               : tr("Edit: what you see is the design. Play starts from here."));
}

} // namespace ripstop
