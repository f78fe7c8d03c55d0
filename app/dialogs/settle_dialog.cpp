// Stages: the constructor connects the frames and the ends of a run, of which there are four: it
// is still or the time is over (Player::settled), it stopped by itself (Player::stopped), or
// somebody paused or reset it. start() gives the player a goal; follow() writes the speed and the
// energy of each frame and moves the bar; end() says what came of it. refresh() keeps the fields
// locked while it runs.
#include "dialogs/settle_dialog.h"

#include "dialogs/beside.h"
#include "document/player.h"
#include "document/spoken.h"
#include "run/settle.h"
#include "start/parameter_field.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

constexpr double forgetting = 0.97; // share of the speed shown that is left a frame later
constexpr int wholeBar = 1000;

const Parameter speedParameter{"--settle",
                               "m/s",
                               SettleGoal().speed,
                               1e-6,
                               100.0,
                               false,
                               "Still is what has moved slower than this everywhere for half a "
                               "swing of a pendulum of its size, "
                               "half a second at least."};
const Parameter withinParameter{"--seconds",
                                "s",
                                SettleGoal().within,
                                0.5,
                                1e6,
                                false,
                                "Simulated time; what is not still by then is left as it is."};

QString number(double value) { return spokenNumber(value, 3); }

} // namespace

SettleDialog::SettleDialog(Player& player, std::function<void()> adopt, QWidget* parent)
    : QDialog(parent)
    , m_player(player)
    , m_adopt(std::move(adopt))
    , m_speed(new ParameterField(speedParameter))
    , m_within(new ParameterField(withinParameter))
    , m_damped(new QCheckBox(tr("&Shorten the way (kinetic damping)")))
    , m_bar(new QProgressBar)
    , m_state(new QLabel)
    , m_start(new QPushButton(tr("&Settle")))
    , m_pose(new QPushButton(tr("&Adopt pose…")))
{
    setWindowTitle(tr("Settle"));
    setAttribute(Qt::WA_DeleteOnClose);
    layOut();
    connect(m_start, &QPushButton::clicked, this, [this] { m_runs ? stop() : start(); });
    connect(m_pose, &QPushButton::clicked, this, [this] { m_adopt(); });
    connect(m_speed, &ParameterField::changed, this, &SettleDialog::refresh);
    connect(m_within, &ParameterField::changed, this, &SettleDialog::refresh);
    connect(&player, &Player::frameReady, this,
            [this](const std::shared_ptr<const Frame>& frame) { follow(*frame); });
    connect(&player, &Player::settled, this, &SettleDialog::end);
    connect(&player, &Player::stopped, this, [this](const QString& why) {
        if (!std::exchange(m_runs, false))
            return;
        say(why);
        refresh();
    });
    connect(&player, &Player::stateChanged, this, [this] {
        if (m_runs && !m_player.isSettling()) { // paused or reset from elsewhere
            m_runs = false;
            say(tr("Stopped before it was still."));
        }
        refresh();
    });
    say(tr("The wind blows on meanwhile: what flies never settles, what hangs or stands does."));
    refresh();
    adjustSize();
    moveBesideDesign(*this, parent);
}

void SettleDialog::layOut()
{
    auto* help = new QLabel(tr("Runs as fast as it can until all hangs still, then pauses."));
    help->setWordWrap(true);
    help->setForegroundRole(QPalette::PlaceholderText);
    m_speed->setObjectName(QStringLiteral("speed"));
    m_within->setObjectName(QStringLiteral("within"));
    m_damped->setObjectName(QStringLiteral("damped"));
    m_damped->setChecked(true);
    m_damped->setToolTip(tr("Stops all motion whenever its energy has passed a peak. It ends where "
                            "it would without, in much less time; the way there is not what the "
                            "real thing would do."));
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const auto add = [&](const QString& name, ParameterField* field) {
        auto* label = new QLabel(name);
        label->setToolTip(field->toolTip());
        label->setBuddy(field);
        form->addRow(label, field);
    };
    add(tr("Un&til all is slower than"), m_speed);
    add(tr("&For at most"), m_within);
    form->addRow(m_damped);
    m_bar->setRange(0, wholeBar);
    m_bar->setTextVisible(false);
    m_state->setTextFormat(Qt::PlainText);
    m_state->setObjectName(QStringLiteral("state"));
    m_state->setWordWrap(true);
    m_state->setMinimumHeight(3 * fontMetrics().lineSpacing()); // for a long sentence
    m_state->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_start, QDialogButtonBox::ActionRole);
    buttons->addButton(m_pose, QDialogButtonBox::ActionRole);
    m_start->setObjectName(QStringLiteral("start"));
    m_start->setDefault(true);
    m_pose->setToolTip(tr("Makes the shape that the run has come to the design."));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(help);
    layout->addLayout(form);
    layout->addWidget(m_bar);
    layout->addWidget(m_state);
    layout->addWidget(buttons);
    setMinimumWidth(420);
}

void SettleDialog::say(const QString& words) { m_state->setText(words); }

void SettleDialog::refresh()
{
    const bool valid = m_speed->isInRange() && m_within->isInRange();
    m_start->setText(m_runs ? tr("&Stop") : tr("&Settle"));
    m_start->setEnabled(m_runs || valid);
    for (QWidget* field : {static_cast<QWidget*>(m_speed), static_cast<QWidget*>(m_within),
                           static_cast<QWidget*>(m_damped)})
        field->setEnabled(!m_runs);
    const auto& frame = m_player.frame();
    m_pose->setEnabled(!m_runs && frame && frame->underWay);
}

void SettleDialog::start()
{
    SettleGoal goal;
    goal.speed = m_speed->value();
    goal.within = m_within->value();
    goal.damped = m_damped->isChecked();
    m_fastest = m_lately = 0.0;
    m_bar->setValue(0);
    say({});
    m_runs = true; // unless the player says at once why it cannot
    m_player.settle(goal);
    refresh();
}

void SettleDialog::stop()
{
    m_runs = false;
    m_player.pause();
    say(tr("Stopped before it was still."));
    refresh();
}

// The bar goes by orders of magnitude, from the fastest so far to the goal.
void SettleDialog::follow(const Frame& frame)
{
    if (!m_runs || !frame.settling)
        return;
    const Settling& now = *frame.settling;
    m_fastest = std::max(m_fastest, now.speed);
    m_lately = std::max(now.speed, forgetting * m_lately);
    if (m_lately > 0.0 && m_fastest > now.goal)
        m_bar->setValue(
            int(wholeBar
                * std::clamp(std::log(m_fastest / m_lately) / std::log(m_fastest / now.goal), 0.0,
                             1.0)));
    say(tr("%1 s of %2 s; the fastest particle has %3 m/s, all motion %4 J.")
            .arg(QLocale().toString(now.since, 'f', 1), number(now.within), number(now.speed),
                 number(now.kinetic)));
}

void SettleDialog::end(const Settling& end)
{
    m_runs = false;
    const bool still = end.outcome == Settling::Outcome::Still;
    if (still)
        m_bar->setValue(wholeBar);
    say(still ? tr("Still after %1 s: nothing has moved faster than %2 m/s for half a swing.")
                    .arg(QLocale().toString(end.since, 'f', 1), number(end.goal))
              : tr("Not still after %1 s: in the last half swing the fastest particle had %2 m/s. "
                   "Try kinetic damping, viscosity, a higher speed or more time.")
                    .arg(QLocale().toString(end.since, 'f', 1), number(end.speed)));
    refresh();
}

void SettleDialog::done(int result)
{
    if (m_runs)
        stop();
    QDialog::done(result);
}

} // namespace ripstop
