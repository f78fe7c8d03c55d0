// rebuild() follows the shelf and each edit: rows are made anew where sliders came or went, and
// otherwise only show their values again. refresh() also notes the values of a slider that is new,
// which reset() goes back to.
//
// captured() takes the present values of all rows; restoring() makes an edit of what differs from a
// set of values. Switching sets, resetting and the words about the difference are all made from
// these two.
#include "inspector/tuning_panel.h"

#include "document/document.h"
#include "document/selection.h"
#include "inspector/slider_shelf.h"
#include "inspector/tuning_row.h"
#include "inspector/usage_watch.h"
#include "scene/weigh.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QToolButton>

#include <algorithm>
#include <ranges>

namespace ripstop {

// Shows its short text where there is no room for the long one, and asks for no more of it: a dock
// that grew while a slider is dragged would take the handle from under the mouse.
class DifferenceLabel final : public QLabel
{
public:
    void say(const QString& text, const QString& inShort)
    {
        m_short = inShort;
        setText(text);
        setToolTip(text);
        update();
    }
    QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

private:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        const QRect room = contentsRect();
        const bool fits = fontMetrics().horizontalAdvance(text()) <= room.width();
        style()->drawItemText(&painter, room, int(alignment()), palette(), isEnabled(),
                              fits ? text() : m_short, foregroundRole());
    }

    QString m_short;
};

namespace {

bool isAbout(const TuningRow& row, const Slider& slider)
{
    return row.slider().property == slider.property && row.slider().ids == slider.ids;
}

} // namespace

TuningPanel::TuningPanel(Document& document, Selection& selection, SliderShelf& sliders,
                         QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_sliders(sliders)
    , m_usage(std::make_unique<UsageWatch>(document))
{
    auto* inside = new QWidget;
    m_list = new QVBoxLayout(inside);
    m_list->setContentsMargins(0, 0, 0, 0);
    m_list->setSpacing(2);
    m_list->addStretch(1);
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(inside);
    m_bar = buildBar();
    m_empty = buildEmpty();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addWidget(m_empty);
    layout->addWidget(area, 1);

    connect(&document, &Document::replaced, this, [this] {
        m_sets = {};
        m_switches.clear();
        m_kept.clear();
        m_active = 0;
        rebuild();
    });
    connect(&document, &Document::changed, this, &TuningPanel::rebuild);
    connect(&document.history(), &QUndoStack::indexChanged, this, &TuningPanel::followHistory);
    connect(&sliders, &SliderShelf::changed, this, &TuningPanel::rebuild);
    rebuild();
}

TuningPanel::~TuningPanel() = default;

QWidget* TuningPanel::buildBar()
{
    auto* bar = new QWidget;
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(8, 6, 8, 2);
    layout->setSpacing(4);
    for (const int set : {0, 1}) {
        auto* letter = new QToolButton;
        letter->setText(set == 0 ? tr("A") : tr("B"));
        letter->setCheckable(true);
        letter->setToolTip(tr("Two sets of values, to compare: what you tune belongs to the one "
                              "that is pressed. Ctrl+Shift+T switches."));
        connect(letter, &QToolButton::clicked, this, [this, set] {
            if (m_active != set)
                switchSets();
            showSets();
        });
        m_letters[std::size_t(set)] = letter;
        layout->addWidget(letter);
    }
    m_difference = new DifferenceLabel;
    m_difference->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(m_difference, 1);
    auto* keep = new QPushButton(tr("&Keep"));
    keep->setToolTip(tr("Make the present values those that Reset goes back to. They are in the "
                        "scene already: each drag was an edit, and saving writes them."));
    connect(keep, &QPushButton::clicked, this, &TuningPanel::keep);
    m_reset = new QPushButton(tr("Rese&t"));
    m_reset->setToolTip(tr("All sliders back to the values they had when they were added or last "
                           "kept."));
    connect(m_reset, &QPushButton::clicked, this, &TuningPanel::reset);
    layout->addWidget(keep);
    layout->addWidget(m_reset);
    return bar;
}

QWidget* TuningPanel::buildEmpty()
{
    auto* empty = new QWidget;
    auto* layout = new QVBoxLayout(empty);
    auto* words = new QLabel(
        tr("No sliders yet. Press the slider sign beside a property in the inspector, or Ctrl+T in "
           "its field: the slider stays here, whatever is selected, and acts while the design "
           "flies."));
    words->setWordWrap(true);
    words->setForegroundRole(QPalette::PlaceholderText);
    auto* usual = new QPushButton(tr("Add the &usual ones"));
    usual->setToolTip(tr("Wind, E t, G t, EA, EI and strength of what materials are, stiffness, "
                         "damping and tear limit of what they are not, and the settings of the "
                         "solver, as far as they have an effect here. Of what is selected only, if "
                         "it is made of something."));
    connect(usual, &QPushButton::clicked, this, &TuningPanel::addUsual);
    layout->addWidget(words);
    layout->addWidget(usual, 0, Qt::AlignLeft);
    return empty;
}

void TuningPanel::addUsual() { m_sliders.addUsual(m_selection.ids()); }

// Makes new rows where sliders came or went, and otherwise only shows their values.
void TuningPanel::rebuild()
{
    const std::vector<Slider> sliders = m_sliders.sliders();
    const bool isSame = std::ranges::equal(
        m_rows, sliders, [](const TuningRow* row, const Slider& s) { return isAbout(*row, s); });
    if (!isSame) {
        for (TuningRow* row : m_rows) {
            row->hide();
            row->deleteLater(); // it may be the one that asked for this
        }
        m_rows.clear();
        for (std::size_t i = 0; i < sliders.size(); ++i) {
            auto* row = new TuningRow(m_document, *m_usage, m_sliders.directions(), sliders[i]);
            connect(row, &TuningRow::rangeEdited, this, [this, row](const SliderRange& range) {
                m_sliders.setRange(*row->slider().property, row->slider().ids, range);
            });
            connect(row, &TuningRow::removed, this, [this, row] {
                (void)m_sliders.toggle(*row->slider().property, row->slider().ids);
            });
            connect(row, &TuningRow::chosen, this,
                    [this, row] { m_selection.set(row->slider().ids); });
            connect(row, &TuningRow::studyWanted, this,
                    [this, row] { m_sliders.study(*row->slider().property, row->slider().ids); });
            m_list->insertWidget(int(i), row);
            m_rows.push_back(row);
        }
    }
    for (std::size_t i = 0; i < sliders.size(); ++i)
        m_rows[i]->setRange(sliders[i].range);
    refresh();
}

void TuningPanel::refresh()
{
    for (TuningRow* row : m_rows)
        row->refresh();
    // a slider that is new is kept as it was found
    const Set now = captured();
    for (const Held& held : now)
        if (std::ranges::none_of(m_kept, [&](const Held& kept) {
                return kept.property == held.property && kept.ids == held.ids;
            }))
            m_kept.push_back(held);
    m_bar->setVisible(!m_rows.empty());
    m_empty->setVisible(m_rows.empty());
    m_reset->setEnabled(!restoring(m_kept, {}).changes.empty());
    showSets();
}

void TuningPanel::showSets()
{
    for (const int set : {0, 1}) {
        QToolButton* letter = m_letters[std::size_t(set)];
        letter->setChecked(set == m_active);
        QFont font = this->font();
        font.setBold(set == m_active); // dark styles hardly show what is pressed
        letter->setFont(font);
    }
    const Set& other = m_sets[std::size_t(1 - m_active)];
    const QString name = m_active == 0 ? tr("B") : tr("A");
    const auto count = restoring(other, {}).changes.size();
    const QString difference = other.empty() ? QString()
                               : count == 0
                                   ? tr("as %1").arg(name)
                                   : tr("%n differ(s) from %1", nullptr, int(count)).arg(name);
    m_difference->say(difference,
                      count == 0 ? difference : QStringLiteral("%1 ≠ %2").arg(count).arg(name));
}

TuningPanel::Set TuningPanel::captured() const
{
    Set set;
    for (const TuningRow* row : m_rows) {
        const Slider& slider = row->slider();
        Held held{slider.property, slider.ids, {}};
        for (const Id id : slider.ids)
            if (const auto ref = ripstop::find(m_document.scene(), id))
                held.values.push_back(slider.property->get(*ref));
        if (held.values.size() == held.ids.size())
            set.push_back(std::move(held));
    }
    return set;
}

// An edit that sets only what differs, so that no change is empty.
Edit TuningPanel::restoring(const Set& set, const QString& label) const
{
    Edit edit{Message::verbatim(label.toStdString()), {}};
    for (const Held& now : captured())
        for (const Held& held : set)
            if (held.property == now.property && held.ids == now.ids && held.values != now.values)
                edit.changes.emplace_back(SetValues{held.property, held.ids, held.values});
    return edit;
}

void TuningPanel::apply(const Set& set, const QString& label)
{
    Edit edit = restoring(set, label);
    const Result<Edit> withMasses = weighed(m_document.scene(), edit);
    m_document.push(withMasses ? *withMasses : std::move(edit));
}

void TuningPanel::switchSets()
{
    if (m_rows.empty())
        return;
    const int before = m_document.history().index();
    m_sets[std::size_t(m_active)] = captured();
    m_active = 1 - m_active;
    const Set& next = m_sets[std::size_t(m_active)];
    if (next.empty())
        m_sets[std::size_t(m_active)] = captured(); // a set that is new begins as the other one
    else
        apply(Set(next), m_active == 0 ? tr("Tuning set A") : tr("Tuning set B"));
    if (const QUndoStack& history = m_document.history(); history.index() > before)
        m_switches.push_back({history.index(), history.command(history.index() - 1), m_active});
    showSets();
    emit setsSwitched();
}

// The set whose values undo and redo have brought back is the one that is tuned: the values of the
// other must not be taken for its own.
void TuningPanel::followHistory(int index)
{
    const QUndoStack& history = m_document.history();
    std::erase_if(m_switches, [&](const Switch& one) {
        return one.index > history.count() || history.command(one.index - 1) != one.command;
    });
    const int before = std::exchange(m_historyIndex, index);
    int active = m_active;
    for (const Switch& one : m_switches) // done again
        if (before < one.index && one.index <= index)
            active = one.set;
    for (const Switch& one : m_switches | std::views::reverse) // undone
        if (index < one.index && one.index <= before)
            active = 1 - one.set;
    if (std::exchange(m_active, active) != active)
        showSets();
}

void TuningPanel::keep()
{
    m_kept = captured();
    refresh();
}

void TuningPanel::reset() { apply(Set(m_kept), tr("Reset sliders")); }

} // namespace ripstop
