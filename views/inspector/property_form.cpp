// addRow() makes label, field, buttons and complaint of one property; addMenu() gives the label a
// menu with what the buttons do and with the path for the command line. tipOf() puts help, unit,
// range and effect into the tool tip.
//
// filter() notes the words that are searched for; showRows() shows the rows whose label, key or
// help has all of them, or without any those that do something and are not folded away.
// placeChoices() puts choices beside their labels or below them, by the room that the labels which
// are shown leave. refresh()
// asks the subject once for all things and shows, row by row, the common value, whether it differs
// from the default, and whether it has an effect.
#include "inspector/property_form.h"

#include "document/words.h"
#include "icons/complaint.h"
#include "icons/fold_button.h"
#include "icons/icon.h"
#include "inspector/remedies.h"
#include "inspector/slider_shelf.h"
#include "inspector/usage_watch.h"
#include "inspector/value_edit.h"
#include "scene/weigh.h"

#include <QAction>
#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>

#include <algorithm>

namespace ripstop {
namespace {

QString tipOf(const Property& property)
{
    const auto number = [](double value) { return compactNumber(value); };
    QString text = helpOf(property).toHtmlEscaped();
    const QString unit = QString::fromUtf8(property.unit.data());
    QStringList facts;
    if (!unit.isEmpty())
        facts << PropertyForm::tr("Unit: %1").arg(unit);
    const bool hasLow = std::isfinite(property.range.low);
    if (hasLow && std::isfinite(property.range.high))
        facts << PropertyForm::tr("Range: %1 to %2")
                     .arg(number(property.range.low), number(property.range.high));
    else if (hasLow)
        facts << (property.range.openLow ? PropertyForm::tr("Above %1")
                                         : PropertyForm::tr("From %1"))
                     .arg(number(property.range.low));
    if (property.effect == Effect::OnReset)
        facts << PropertyForm::tr("Takes effect on reset");
    if (!facts.isEmpty())
        text += QStringLiteral("<br>") + facts.join(QStringLiteral(" \u00b7 "));
    const Value& shape = property.initial;
    if (property.optional || std::holds_alternative<double>(shape)
        || std::holds_alternative<int>(shape) || std::holds_alternative<Vec3>(shape))
        text +=
            QStringLiteral("<br><i>")
            + PropertyForm::tr(
                "Also with a unit (25 g, 2*15 cm), or *1.1, +5 %, +0.2; drag the label sideways.")
            + QStringLiteral("</i>");
    return text;
}

constexpr int rowButtonWidth = 18; // px
constexpr int columns = 4;         // label, field and two buttons

// A small button at the end of a row, in a column that keeps its width while it is hidden.
QToolButton* rowButton(const QString& picture, const QString& tip, const QString& name)
{
    auto* button = new QToolButton;
    button->setIcon(icon(picture));
    button->setIconSize(QSize(12, 12));
    button->setFixedWidth(rowButtonWidth);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus); // the menu of the label and a key do the same
    button->setToolTip(tip);
    button->setAccessibleName(name);
    return button;
}

// Who makes a kite comes for the air.
bool isOfSolver(const Property& property) { return property.traits.contains(Trait::Solving); }

bool isOffered(const Property& property) { return !property.traits.contains(Trait::Noted); }

bool isTunable(const Property& property)
{
    return canBeTuned(property) && (property.effect != Effect::DisplayOnly || weighs(property));
}

} // namespace

PropertyForm::PropertyForm(Subject& subject, UsageWatch& usage, SliderShelf& sliders, Kind kind,
                           QWidget* parent)
    : QWidget(parent)
    , m_subject(subject)
    , m_usage(usage)
    , m_sliders(sliders)
    , m_grid(new QGridLayout(this))
{
    m_grid->setContentsMargins(8, 4, 4, 8);
    m_grid->setHorizontalSpacing(4);
    m_grid->setVerticalSpacing(4);
    m_grid->setColumnStretch(1, 1);
    for (const int column : {2, 3})
        m_grid->setColumnMinimumWidth(column, rowButtonWidth);
    m_grid->setColumnMinimumWidth(0,
                                  fontMetrics().horizontalAdvance(QStringLiteral("Skin friction")));
    for (const Property& property : propertiesOf(kind))
        if (!isOfSolver(property) && isOffered(property))
            addRow(property);
    if (kind == Kind::Settings) {
        m_solver = foldButton("solverFields");
        m_grid->addWidget(m_solver, m_grid->rowCount(), 0, 1, columns);
        for (const Property& property : propertiesOf(kind))
            if (isOfSolver(property))
                addRow(property);
    }
    m_idle = foldButton("idleFields");
    m_grid->addWidget(m_idle, m_grid->rowCount(), 0, 1, columns);
    m_grid->setRowStretch(m_grid->rowCount(), 1);
}

FoldButton* PropertyForm::foldButton(const char* name)
{
    auto* button = new FoldButton(name);
    connect(button, &FoldButton::toggledOpen, this, &PropertyForm::refresh);
    return button;
}

void PropertyForm::addRow(const Property& property)
{
    const int row = m_grid->rowCount();
    const QString tip = tipOf(property);

    auto* label = new ScrubLabel(labelOf(property));
    label->setWrapping();
    auto* complaint = new Complaint;
    const auto complain = [complaint](const QString& sentence) { complaint->tell(sentence); };
    Field field = makeField({m_subject, property, *label, complain});
    for (QWidget* focus : field.focus)
        if (focus) {
            focus->setToolTip(QStringLiteral("<qt>%1</qt>").arg(tip));
            if (focus->accessibleName().isEmpty())
                focus->setAccessibleName(labelOf(property));
        }
    label->setBuddy(field.focus[0]);
    // by which F1 finds the page about it (app/manual/manual_pages.h)
    const QString name =
        QStringLiteral("property %1.%2").arg(text(kindName(property.kind)), text(property.key));
    label->setObjectName(name);
    field.widget->setObjectName(name);

    auto* slider = rowButton(QStringLiteral("slider"),
                             tr("Keep a slider for this in the tuning panel (Ctrl+T)."),
                             tr("Slider for %1").arg(labelOf(property).toLower()));
    slider->setCheckable(true);
    slider->setVisible(isTunable(property));
    connect(slider, &QToolButton::clicked, this, [this, &property] { toggleSlider(property); });
    auto* reset = rowButton(QStringLiteral("undo"), tr("Back to the default."),
                            tr("Reset %1").arg(labelOf(property).toLower()));
    reset->hide();
    connect(reset, &QToolButton::clicked, this,
            [this, &property] { m_subject.edit(property, setTo(property.initial)); });

    const bool isTall = field.widget->sizeHint().height() > 36; // px
    m_grid->addWidget(label, row, 0, isTall ? Qt::AlignTop : Qt::AlignVCenter);
    label->setMinimumHeight(isTall ? reset->sizeHint().height() : 0); // level with the first line
    m_grid->addWidget(field.widget, row, 1);
    auto* remedy = remedyButton(property, *complaint);
    m_grid->addWidget(slider, row, 2, isTall ? Qt::AlignTop : Qt::AlignVCenter);
    m_grid->addWidget(remedy, row, 2, isTall ? Qt::AlignTop : Qt::AlignVCenter);
    m_grid->addWidget(reset, row, 3, isTall ? Qt::AlignTop : Qt::AlignVCenter);
    m_grid->addWidget(complaint, row + 2, 1, 1, columns - 1);
    m_rows.push_back(
        {&property, label, tip, complaint, slider, remedy, reset, std::move(field), row});
    addMenu(m_rows.back());
}

// One remedy is made at a press; of several a menu is shown.
QToolButton* PropertyForm::remedyButton(const Property& property, QLabel& complaint)
{
    auto* button = rowButton(QStringLiteral("remedy"), {},
                             tr("Make %1 count").arg(labelOf(property).toLower()));
    button->hide();
    const auto perform = [this, &property, &complaint](const Remedy& remedy) {
        const QString failure = performRemedy(remedy, property, m_subject);
        complaint.setText(failure);
        complaint.setVisible(!failure.isEmpty());
    };
    connect(button, &QToolButton::clicked, this, [this, button, perform, &property] {
        const Remedies remedies = m_usage.remedies(property, m_subject.ids());
        if (remedies.size() == 1)
            return perform(*remedies.front());
        auto* menu = new QMenu(button);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        for (const Remedy* remedy : remedies)
            menu->addAction(translated(remedy->label), this, [=] { perform(*remedy); });
        menu->popup(button->mapToGlobal(QPoint(0, button->height())));
    });
    return button;
}

void PropertyForm::refreshRemedy(const Row& row)
{
    const Remedies remedies = row.idle.isEmpty() || row.label->isHidden()
                                  ? Remedies()
                                  : m_usage.remedies(*row.property, m_subject.ids());
    row.remedy->setVisible(!remedies.empty());
    row.slider->setVisible(remedies.empty() && isTunable(*row.property) && !row.label->isHidden());
    row.remedy->setToolTip(
        QStringLiteral("<qt>%1</qt>")
            .arg(tr("<b>Does nothing now:</b> %1.<br>Press: %2.")
                     .arg(row.idle.toHtmlEscaped(), remedyWords(remedies).toHtmlEscaped())));
}

// Gives the label a menu with what the buttons do, and the field a key for the slider.
void PropertyForm::addMenu(const Row& row)
{
    const Property& property = *row.property;
    row.label->setContextMenuPolicy(Qt::ActionsContextMenu);
    const auto add = [&](const QString& text, auto run) {
        auto* action = new QAction(text, row.label);
        connect(action, &QAction::triggered, this, run);
        row.label->addAction(action);
        return action;
    };
    if (isTunable(property)) {
        auto* tune =
            add(tr("Slider in the tuning panel"), [this, &property] { toggleSlider(property); });
        tune->setShortcut(QKeySequence(QStringLiteral("Ctrl+T")));
        tune->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        row.field.widget->addAction(tune);
    }
    if (isTunable(property))
        add(tr("Study this…"), [this, &property] { m_sliders.study(property, m_subject.ids()); });
    if (isResettable(property))
        add(tr("Back to the default"),
            [this, &property] { m_subject.edit(property, setTo(property.initial)); });
    add(tr("Copy path, for --set"), [this, &property] {
        const std::vector<Id>& ids = m_subject.ids();
        const QString owner = property.kind == Kind::Settings
                                  ? QStringLiteral("settings")
                                  : QStringLiteral("#%1").arg(std::uint32_t(ids.front()));
        QGuiApplication::clipboard()->setText(owner + QChar('.')
                                              + QString::fromUtf8(property.key.data()));
    });
}

void PropertyForm::toggleSlider(const Property& property)
{
    const auto failure = m_sliders.toggle(property, m_subject.ids());
    for (const Row& row : m_rows)
        if (row.property == &property) {
            row.slider->setChecked(m_sliders.has(property, m_subject.ids()));
            row.complaint->setText(failure ? translated(failure->message) : QString());
            row.complaint->setVisible(failure.has_value());
        }
}

bool PropertyForm::fits(const Row& row) const
{
    const QStringList wanted = m_words.simplified().split(QChar(' '), Qt::SkipEmptyParts);
    if (wanted.isEmpty())
        return true;
    const QString about = labelOf(*row.property) + QChar(' ')
                          + QString::fromUtf8(row.property->key.data()) + QChar(' ')
                          + helpOf(*row.property);
    return std::all_of(wanted.begin(), wanted.end(), [&](const QString& word) {
        return about.contains(word, Qt::CaseInsensitive);
    });
}

int PropertyForm::filter(const QString& words)
{
    m_words = words;
    return showRows();
}

int PropertyForm::showRows()
{
    const bool isSearch = !m_words.trimmed().isEmpty();
    int fitting = 0;
    int idle = 0;
    int ofSolver = 0;
    for (const Row& row : m_rows) {
        const bool isFolded = isOfSolver(*row.property) && !m_solver->isOpen() && !isSearch;
        const bool isIdle = !row.idle.isEmpty() && !isFolded;
        const bool isTyped = std::ranges::any_of(
            row.field.focus, [](const QWidget* one) { return one && one->hasFocus(); });
        const bool doesFit = fits(row);
        const bool isShown =
            doesFit && !isFolded && (!isIdle || m_idle->isOpen() || isSearch || isTyped);
        row.label->setVisible(isShown);
        row.field.widget->setVisible(isShown);
        row.complaint->setVisible(isShown && !row.complaint->text().isEmpty());
        row.reset->setVisible(isShown && row.isChanged);
        refreshRemedy(row);
        fitting += doesFit;
        idle += isIdle;
        ofSolver += isOfSolver(*row.property);
    }
    m_idle->sayIdle(isSearch ? 0 : idle);
    m_idle->setToolTip(tr("Fields that do nothing in the design as it is. Their names say why, and "
                          "some can be made to count."));
    if (m_solver) {
        m_solver->setVisible(!isSearch);
        m_solver->say(tr("How it is computed (%1 fields)").arg(ofSolver));
        m_solver->setToolTip(tr("Time step, solver and accuracy. The automatic solver chooses "
                                "what fits."));
    }
    placeChoices();
    return fitting;
}

void PropertyForm::placeChoices()
{
    const int room = roomBesideLabels();
    for (Row& row : m_rows) {
        QWidget* field = row.field.widget;
        const bool isBelow = !row.property->choices.empty() && field->sizeHint().width() > room;
        if (row.isBelow == isBelow)
            continue;
        row.isBelow = isBelow;
        m_grid->removeWidget(field);
        if (isBelow)
            m_grid->addWidget(field, row.place + 1, 0, 1, columns);
        else
            m_grid->addWidget(field, row.place, 1);
    }
}

int PropertyForm::roomBesideLabels() const
{
    int others = m_grid->columnMinimumWidth(0);
    for (const Row& row : m_rows)
        if (!row.label->isHidden())
            others = std::max(others, row.label->sizeHint().width());
    others += (columns - 2) * rowButtonWidth + (columns - 1) * m_grid->horizontalSpacing();
    return contentsRect().marginsRemoved(m_grid->contentsMargins()).width() - others;
}

void PropertyForm::refresh()
{
    const std::vector<ConstRef> refs = m_subject.refs();
    if (refs.empty() || kindOf(refs.front()) != m_rows.front().property->kind)
        return;
    for (Row& row : m_rows) {
        const Property& property = *row.property;
        const Common common = Subject::common(property, refs);
        row.field.refresh(common);
        row.isChanged = !common.isDefault && isResettable(property);
        QFont font = this->font();
        font.setBold(row.isChanged);
        row.label->setFont(font);
        if (isTunable(property))
            row.slider->setChecked(m_sliders.has(property, m_subject.ids()));
        row.idle = m_usage.whyIdle(property, m_subject.ids());
        row.label->setIdle(!row.idle.isEmpty());
        QString tip = row.tip;
        if (row.isChanged)
            tip = tr("%1<br>The default is %2.")
                      .arg(tip, property.choices.empty()
                                    ? QString::fromStdString(textFromValue(property.initial))
                                    : choiceLabel(std::get<std::string>(property.initial)));
        if (!row.idle.isEmpty())
            tip = tr("<b>Does nothing now:</b> %1.<br>%2").arg(row.idle.toHtmlEscaped(), tip);
        row.label->setToolTip(QStringLiteral("<qt>%1</qt>").arg(tip));
        row.label->setWhatsThis(row.label->toolTip());
    }
    showRows();
}

// Labels lose their bold font when they are first given the font of their window, so it is set
// again.
void PropertyForm::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

void PropertyForm::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placeChoices();
}

void PropertyForm::leave()
{
    for (const Row& row : m_rows)
        for (QWidget* focus : row.field.focus)
            if (auto* edit = qobject_cast<ValueEdit*>(focus))
                edit->leave();
}

QWidget* PropertyForm::field(std::string_view key, int axis) const
{
    for (const Row& row : m_rows)
        if (row.property->key == key)
            return row.field.focus[std::size_t(axis)];
    return nullptr;
}

} // namespace ripstop
