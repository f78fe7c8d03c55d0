// refresh() compares the controls of the scene with those that have rows and rebuilds the rows only
// when they differ, because every edit of anything comes here, and a button that is held down must
// not be replaced. showValues() runs with each frame and only moves the bars.
#include "transport/control_strip.h"

#include "document/document.h"
#include "document/plain_text.h"
#include "document/player.h"
#include "document/words.h"
#include "transport/value_bar.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
ControlStrip::ControlStrip(Document& document, Player& player, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_empty(new QLabel(tr("No controls. Add one in the outline to steer with keys.")))
{
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->addWidget(m_empty);

    connect(&document, &Document::changed, this, &ControlStrip::refresh);
    connect(&document, &Document::replaced, this, &ControlStrip::refresh);
    connect(&player, &Player::frameReady, this, &ControlStrip::showValues);
    refresh();
}

void ControlStrip::refresh()
{
    std::vector<Entry> controls;
    for (const Entry& entry : m_document.scene().items)
        if (std::holds_alternative<Control>(entry.item))
            controls.push_back(entry);
    if (controls != m_controls) {
        m_controls = std::move(controls);
        rebuild();
    }
    showValues();
}

void ControlStrip::rebuild()
{
    delete m_body;
    m_rows.clear();
    m_body = new QWidget;
    m_grid = new QGridLayout(m_body);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setVerticalSpacing(2);
    m_grid->setColumnStretch(2, 1);
    for (const Entry& entry : m_controls)
        addRow(entry.id, std::get<Control>(entry.item));
    layout()->addWidget(m_body);
    m_body->setVisible(!m_controls.empty());
    m_empty->setVisible(m_controls.empty());
}

void ControlStrip::addRow(Id id, const Control& control)
{
    const int row = int(m_rows.size());
    auto* name = new QLabel(QString::fromStdString(control.name));
    name->setTextFormat(Qt::PlainText);
    auto* bar = new ValueBar;
    bar->setLimit(control.limit);
    bar->setAccessibleName(name->text());
    m_grid->addWidget(name, row, 0);
    m_grid->addWidget(nudgeButton(id, control, -1), row, 1);
    m_grid->addWidget(bar, row, 2);
    m_grid->addWidget(nudgeButton(id, control, +1), row, 3);
    m_rows.push_back({id, bar});
}

// direction: -1 is less, +1 is more
QWidget* ControlStrip::nudgeButton(Id id, const Control& control, int direction)
{
    const QString sign = direction < 0 ? QString(QChar(0x2212)) : QStringLiteral("+");
    const QString key = keyText(direction < 0 ? control.keyLess : control.keyMore);
    auto* button = new QToolButton;
    button->setObjectName(QString::fromStdString(control.name) + sign);
    button->setText(key.isEmpty() ? sign : inMenu(sign + QStringLiteral("  ") + key));
    button->setAccessibleName(QString::fromStdString(control.name) + QChar(' ') + sign);
    button->setAutoRepeat(true);
    button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    const QString step = QLocale().toString(control.step);
    button->setToolTip(
        key.isEmpty() ? tr("%1%2 m. It has no key yet; set one in the inspector.").arg(sign, step)
                      : tr("%1%2 m for each press of %3").arg(sign, step, key));
    connect(button, &QToolButton::clicked, this,
            [this, id, direction] { m_player.nudge(id, direction); });
    return button;
}

void ControlStrip::showValues()
{
    const auto& frame = m_player.frame();
    for (const Row& row : m_rows) {
        double value = 0.0;
        double command = 0.0;
        if (frame) {
            const auto& inputs = frame->layout->inputId;
            const auto found = std::find(inputs.begin(), inputs.end(), std::uint32_t(row.control));
            if (found != inputs.end()) {
                value = frame->inputValue[std::size_t(found - inputs.begin())];
                command = frame->inputCommand[std::size_t(found - inputs.begin())];
            }
        }
        row.bar->show(value, command);
    }
}

} // namespace ripstop
