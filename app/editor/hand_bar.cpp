// Stages: the constructor takes the actions of the three tools; addFields() lists the numbers as
// rows of limits, a reader and a writer, so that one function judges what is typed into any of them
// (complaintAbout()) and one takes it (take()); layOut() puts them into one line over the hint.
// refresh() shows the bar for the tool that is on, with its fields: a number that is left to the
// program stands as a grey placeholder.
#include "editor/hand_bar.h"

#include "actions/actions.h"
#include "base/angle.h"
#include "document/document.h"
#include "document/player.h"
#include "document/words.h"
#include "icons/complaint.h"
#include "inspector/value_edit.h"
#include "scene/typed_number.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr int fieldMargins = 18;  // pixels, of a field beside its text
constexpr int betweenFields = 12; // pixels, so that a unit does not run into the next name

QString shortText(double value) { return compactNumber(QString::number(value, 'g', 4).toDouble()); }

} // namespace

HandBar::HandBar(Document& document, Player& player, Viewport& viewport, const Actions& actions)
    : ViewBar(viewport, QStringLiteral("handBar"))
    , m_document(document)
    , m_player(player)
    , m_settings(viewport.hands())
    , m_hints{{actions["toolGrab"], tr("Grab"),
               tr("Drag fabric, lines, controls, colliders. Wheel: nearer or farther. P: pin.")},
              {actions["toolCut"], tr("Cut"),
               tr("Draw across links and fabric. Cuts belong to the run: Reset (Ctrl+R) takes them "
                  "back. A right drag turns the view.")},
              {actions["toolFan"], tr("Fan"),
               tr("Hold the button and aim. Wheel: strength, with Ctrl: spread.")}}
    , m_title(new QLabel)
    , m_unpin(new QPushButton)
{
    addFields();
    layOut(actions["through"]);
    for (const Hint& hint : m_hints)
        connect(hint.tool, &QAction::toggled, this, &HandBar::refresh);
    connect(m_unpin, &QPushButton::clicked, actions["unpinHands"], &QAction::trigger);
    connect(&document, &Document::replaced, this, &HandBar::refresh);
    connect(&document, &Document::changed, this, &HandBar::refresh);
    connect(&player, &Player::stateChanged, this, &HandBar::refresh);
    connect(&player, &Player::frameReady, this, [this] {
        if (isVisible())
            m_unpin->setVisible(!m_player.hands().hands.pins.empty());
    });
}

void HandBar::addFields()
{
    QAction* const grab = m_hints[0].tool;
    QAction* const fan = m_hints[2].tool;
    addField(tr("Stiffness"),
             {grab, nullptr, nullptr, QStringLiteral("N/m"), 1e-6, 1e9,
              [this] { return m_settings.stiffnessIn(m_document.scene()); },
              [this] { return m_settings.stiffness.has_value(); },
              [this](std::optional<double> value) { m_settings.stiffness = value; }},
             tr("How stiff the spring is between the cursor and what it holds. Empty, it follows "
                "from the weight and the size of the design. A time step that is too long for it "
                "makes it softer; the view says so."));
    addField(tr("at most"),
             {grab, nullptr, nullptr, QStringLiteral("N"), 1e-9, 1e9,
              [this] { return m_settings.mostIn(m_document.scene()); },
              [this] { return m_settings.most.has_value(); },
              [this](std::optional<double> value) { m_settings.most = value; }},
             tr("The most that the hand pulls with, however far it goes. Empty, it is five times "
                "the weight of all that is free, and 5 N or more."));
    addField(tr("Speed"),
             {fan, nullptr, nullptr, QStringLiteral("m/s"), HandSettings::slowestFan,
              HandSettings::fastestFan, [this] { return m_settings.fanSpeed; }, [] { return true; },
              [this](std::optional<double> value) {
                  m_settings.fanSpeed = value.value_or(HandSettings().fanSpeed);
              }},
             tr("Of the air in the nozzle; it slows down as the jet widens."));
    addField(tr("Spread"),
             {fan, nullptr, nullptr, QStringLiteral("\u00b0"),
              std::atan(HandSettings::narrowestFan) / degrees,
              std::atan(HandSettings::widestFan) / degrees,
              [this] { return std::atan(m_settings.fanWidening) / degrees; }, [] { return true; },
              [this](std::optional<double> value) {
                  m_settings.fanWidening =
                      value ? std::tan(*value * degrees) : HandSettings().fanWidening;
              }},
             tr("Half the angle of the jet. A narrow one reaches farther."));
}

void HandBar::addField(const QString& name, Field field, const QString& help)
{
    field.edit = new ValueEdit([this, place = m_fields.size()](const QString& text) {
        return complaintAbout(m_fields[place], text);
    });
    field.edit->setObjectName(name);
    field.edit->setAccessibleName(name);
    field.edit->setToolTip(tr("%1 From %2 to %3 %4.")
                               .arg(help, shortText(field.low), shortText(field.high), field.unit));
    field.edit->setAlignment(Qt::AlignRight);
    field.edit->setFixedWidth(
        field.edit->fontMetrics().horizontalAdvance(tr("automatic %1").arg(QStringLiteral("00.00")))
        + fieldMargins);
    field.row = new QWidget;
    auto* label = new QLabel(name);
    label->setBuddy(field.edit);
    auto* row = new QHBoxLayout(field.row);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(label);
    row->addWidget(field.edit);
    row->addWidget(new QLabel(field.unit));
    m_fields.push_back(field);
    connect(
        field.edit, &ValueEdit::committed, this,
        [this, place = m_fields.size() - 1](const QString& text) { take(m_fields[place], text); });
    connect(field.edit, &ValueEdit::complained, this, [this] { settle(); });
}

void HandBar::layOut(QAction* through)
{
    setCursor(Qt::ArrowCursor);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    // it has a text of its own, which a default action would replace
    auto* button = new QToolButton;
    button->setCheckable(true);
    button->setChecked(through->isChecked());
    button->setIcon(through->icon());
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setText(tr("All the way through"));
    connect(button, &QToolButton::clicked, through, &QAction::trigger);
    connect(through, &QAction::toggled, button, &QToolButton::setChecked);
    button->setToolTip(tr("Off, the knife goes through the first fabric under it; on, through all "
                          "that lies behind as well."));
    button->setFocusPolicy(Qt::NoFocus);
    m_through = button;
    m_unpin->setText(tr("Pull out pins"));
    m_unpin->setFocusPolicy(Qt::NoFocus);
    m_unpin->setToolTip(tr("Let go of all that was pinned by hand in this run."));
    auto* above = new QHBoxLayout;
    above->setSpacing(betweenFields);
    above->addWidget(m_title);
    for (const Field& field : m_fields)
        above->addWidget(field.row);
    above->addWidget(m_through);
    above->addWidget(m_unpin);
    above->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 5, 8, 5);
    layout->setSpacing(4);
    layout->addLayout(above);
    layout->addWidget(m_hint);
    layout->addWidget(m_complaint);
}

const HandBar::Hint* HandBar::shown() const
{
    const auto found =
        std::ranges::find_if(m_hints, [](const Hint& hint) { return hint.tool->isChecked(); });
    return found == m_hints.end() ? nullptr : &*found;
}

void HandBar::refresh()
{
    const Hint* const hint = shown();
    setVisible(hint != nullptr);
    if (!hint)
        return;
    m_title->setText(hint->title);
    m_hint->setText(m_player.isPlaying()
                        ? hint->words
                        : tr("Paused: nothing moves until it runs (Space). ") + hint->words);
    for (const Field& field : m_fields) {
        field.row->setVisible(field.tool == hint->tool);
        const QString text = shortText(field.value());
        field.edit->show(field.isOwn() ? text : QString(), tr("automatic %1").arg(text));
    }
    m_through->setVisible(hint == &m_hints[1]);
    m_unpin->setVisible(!m_player.hands().hands.pins.empty());
    settle();
}

QString HandBar::refusal() const
{
    const auto broken = std::ranges::find_if(m_fields, [this](const Field& field) {
        return field.edit->isVisibleTo(this) && field.edit->isBroken();
    });
    return broken == m_fields.end() ? QString() : broken->edit->complaint();
}

QString HandBar::complaintAbout(const Field& field, const QString& text) const
{
    if (text.trimmed().isEmpty())
        return {};
    const Typed typed = typedNumber(text.toStdString(), field.unit.toStdString());
    if (!typed.number)
        return tr("The number %1.").arg(translated(typed.complaint));
    const double number = typed.number->appliedTo(field.value());
    if (number >= field.low && number <= field.high)
        return {};
    return tr("The number must be from %1 to %2 %3.")
        .arg(shortText(field.low), shortText(field.high), field.unit);
}

// Of a text that nothing is wrong with.
void HandBar::take(const Field& field, const QString& text)
{
    const auto typed = typedNumber(text.toStdString(), field.unit.toStdString()).number;
    field.set(typed ? std::optional(typed->appliedTo(field.value())) : std::nullopt);
    refresh();
}

} // namespace ripstop
