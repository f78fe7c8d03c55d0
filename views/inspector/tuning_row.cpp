// The constructor lays out label, field, remove button, range and notes. rangeLine() makes slider,
// ends and the switch to a logarithmic range; endEdit() makes the field of one end, which refuses
// what the property or the slider cannot have. note() says what the slider acts on or why it acts
// on nothing. refresh() shows all of it, and nothing where a thing of the slider no longer exists.
#include "inspector/tuning_row.h"

#include "document/document.h"
#include "document/words.h"
#include "icons/complaint.h"
#include "icons/icon.h"
#include "inspector/remedies.h"
#include "inspector/scrub_label.h"
#include "inspector/tuning.h"
#include "inspector/usage_watch.h"
#include "inspector/value_edit.h"
#include "materials/marks.h"
#include "materials/presets.h"

#include <QAction>
#include <QGridLayout>
#include <QSlider>
#include <QToolButton>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int endWidth = 52;  // px, "130000"; longer numbers take what they need
constexpr int endMargins = 8; // px, of a number in its field
constexpr int logWidth = 26;  // px

void showEnd(ValueEdit& edit, double value)
{
    edit.show(compactNumber(value));
    const int number = edit.fontMetrics().horizontalAdvance(edit.text());
    edit.setFixedWidth(std::max(endWidth, number + endMargins));
}

QString plural(std::size_t count, Kind kind) { return counted(kind, qsizetype(count)); }

// What the trade calls it, which is shorter beside a number; the help says the rest.
QString tradeLabel(const Property& property)
{
    if (isOneOf<&Material::membraneStiffness>(property))
        return QStringLiteral("E t");
    if (isOneOf<&Material::weftStiffness>(property))
        return TuningRow::tr("E t of the weft");
    if (isOneOf<&Material::shearStiffness>(property))
        return QStringLiteral("G t");
    if (isOneOf<&Material::axialStiffness>(property))
        return QStringLiteral("EA");
    if (isOneOf<&Material::flexuralRigidity>(property))
        return QStringLiteral("EI");
    return labelOf(property);
}

// Of the library's materials in the language of the editor, of the author's own as it was typed.
QString spoken(const Preset& preset, std::string_view label)
{
    return preset.own ? QString::fromUtf8(label.data(), qsizetype(label.size()))
                      : translated(label);
}

} // namespace

TuningRow::TuningRow(Document& document, UsageWatch& usage, LastDirections& directions,
                     Slider slider, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_usage(usage)
    , m_subject(document, directions)
    , m_slider(std::move(slider))
    , m_label(new ScrubLabel({}))
    , m_note(new QLabel)
    , m_complaint(new Complaint)
{
    const Property& property = *m_slider.property;
    m_subject.set(property.kind, m_slider.ids);
    m_label->setTextFormat(Qt::PlainText);
    m_label->setWrapping(); // long names leave the number its room
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::RichText);
    connect(m_note, &QLabel::linkActivated, this, [this](const QString& which) {
        const Property& tuned = *m_slider.property;
        const Remedies remedies = m_usage.remedies(tuned, m_slider.ids);
        if (const auto i = which.toUInt(); i < remedies.size())
            m_complaint->tell(performRemedy(*remedies[i], tuned, m_subject));
    });
    m_note->setForegroundRole(QPalette::PlaceholderText);
    const auto complain = [this](const QString& sentence) { m_complaint->tell(sentence); };
    m_field = makeField({m_subject, property, *m_label, complain, false});
    m_label->setBuddy(m_field.focus[0]);
    for (QWidget* focus : m_field.focus)
        if (focus && focus->accessibleName().isEmpty())
            focus->setAccessibleName(labelOf(property));
    auto* select = new QAction(tr("Select"), m_label);
    connect(select, &QAction::triggered, this, &TuningRow::chosen);
    auto* study = new QAction(tr("Study this…"), m_label);
    connect(study, &QAction::triggered, this, &TuningRow::studyWanted);
    for (QWidget* place : std::initializer_list<QWidget*>{m_label, this}) { // the slider, too
        place->addActions({select, study});
        place->setContextMenuPolicy(Qt::ActionsContextMenu);
    }

    auto* remove = new QToolButton;
    remove->setIcon(icon(QStringLiteral("close")));
    remove->setIconSize(QSize(12, 12));
    remove->setAutoRaise(true);
    remove->setToolTip(tr("Take this slider away. The value stays as it is."));
    remove->setAccessibleName(tr("Remove slider for %1").arg(labelOf(property).toLower()));
    connect(remove, &QToolButton::clicked, this, &TuningRow::removed);

    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(8, 4, 4, 6);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 5);
    grid->setColumnStretch(1, 4);
    const bool isWide = std::holds_alternative<Vec3>(property.initial) || !property.choices.empty();
    grid->addWidget(m_label, 0, 0, 1, isWide ? 2 : 1);
    grid->addWidget(m_field.widget, isWide ? 1 : 0, isWide ? 0 : 1, 1, isWide ? 2 : 1);
    grid->addWidget(remove, 0, 2, Qt::AlignTop);
    if (hasRange(property))
        grid->addWidget(rangeLine(), 2, 0, 1, 2);
    grid->addWidget(m_note, 3, 0, 1, 2);
    grid->addWidget(m_complaint, 4, 0, 1, 2);
    refresh();
}

QWidget* TuningRow::rangeLine()
{
    auto* line = new QWidget;
    auto* layout = new QGridLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(4);
    layout->setVerticalSpacing(0);
    layout->setColumnStretch(1, 1);
    const auto snap = [this](int position) {
        return m_marks ? m_marks->nearTo(position) : std::nullopt;
    };
    m_bar = makeSlider(
        m_subject, *m_slider.property, [this] { return m_slider.range; }, snap);
    m_low = endEdit(&SliderRange::low, tr("Left end"));
    m_high = endEdit(&SliderRange::high, tr("Right end"));
    m_log = new QToolButton;
    m_log->setText(tr("log"));
    m_log->setFixedWidth(logWidth);
    m_log->setCheckable(true);
    m_log->setAutoRaise(true);
    m_log->setToolTip(tr("Equal ways of the slider are equal factors, not equal differences."));
    connect(m_log, &QToolButton::clicked, this, [this](bool on) {
        SliderRange range = m_slider.range;
        range.logarithmic = on;
        if (on && range.low <= 0.0)
            range.low = range.high / 1000.0;
        editRange(range);
    });
    layout->addWidget(m_low, 0, 0);
    layout->addWidget(m_bar, 0, 1);
    layout->addWidget(m_high, 0, 2);
    layout->addWidget(m_log, 0, 3);
    if (isTradeNumber(*m_slider.property)) {
        m_own = readOwnMaterials(ownMaterialsFile());
        m_marks = new MarkStrip(*m_bar);
        connect(m_marks, &MarkStrip::chosen, this,
                [this](double value) { m_subject.edit(*m_slider.property, setTo(value)); });
        layout->addWidget(m_marks, 1, 0, 1, 4);
    }
    return line;
}

ValueEdit* TuningRow::endEdit(double SliderRange::*end, const QString& name)
{
    const auto rangeOf = [this, end](const QString& text, QString& complaint) {
        const Property& property = *m_slider.property;
        const auto refs = m_subject.refs();
        const std::string_view unit =
            refs.empty() ? property.unit : unitOf(m_document.scene(), property, refs.front());
        const Typed typed = typedNumber(text.toStdString(), unit);
        SliderRange range = m_slider.range;
        if (!typed.number) {
            complaint = translated(typed.complaint);
            return range;
        }
        range.*end = typed.number->appliedTo(range.*end);
        if (const auto reason = refusal(property, range))
            complaint = translated(*reason);
        return range;
    };
    auto* edit = new ValueEdit([rangeOf, name](const QString& text) {
        QString complaint;
        rangeOf(text, complaint);
        return complaint.isEmpty() ? QString() : tr("%1: the range %2.").arg(name, complaint);
    });
    edit->setFrame(false);
    edit->setAlignment(end == &SliderRange::low ? Qt::AlignRight : Qt::AlignLeft);
    edit->setAccessibleName(name);
    edit->setToolTip(end == &SliderRange::low
                         ? tr("Left end of the slider; type another one. A logarithmic slider that "
                              "begins below 1 gives 0 there.")
                         : tr("Right end of the slider; type another one."));
    connect(edit, &ValueEdit::complained, m_complaint, &Complaint::tell);
    connect(edit, &ValueEdit::committed, this, [this, rangeOf](const QString& text) {
        QString complaint;
        const SliderRange range = rangeOf(text, complaint);
        if (complaint.isEmpty())
            editRange(range);
    });
    return edit;
}

void TuningRow::editRange(SliderRange range)
{
    if (!refusal(*m_slider.property, range) && range != m_slider.range)
        emit rangeEdited(range);
    else
        refresh();
}

void TuningRow::setRange(const SliderRange& range) { m_slider.range = range; }

// The materials of the library that lie within the range, with their names.
std::vector<SliderMark> TuningRow::marks() const
{
    const Property& property = *m_slider.property;
    const auto refs = m_subject.refs();
    const Material& material = *std::get<const Material*>(refs.front());
    const Preset* present = presetOf(material, m_own.presets);
    std::vector<SliderMark> marks;
    for (const LibraryMark& mark : marksOf(property, material, m_own.presets)) {
        if (mark.value < m_slider.range.low || mark.value > m_slider.range.high)
            continue;
        QStringList names;
        for (const Preset* preset : mark.presets)
            names << spoken(*preset, preset->label);
        const bool hasPresent = std::ranges::find(mark.presets, present) != mark.presets.end();
        const Preset& named = hasPresent ? *present : *mark.presets.front();
        marks.push_back(
            {placeOf(m_slider.range, mark.value), mark.value, spoken(named, shortLabelOf(named)),
             tr("%1 %2: %3")
                 .arg(compactNumber(mark.value), QString::fromUtf8(property.unit.data()),
                      names.join(QStringLiteral("; ")))});
    }
    return marks;
}

// What the slider acts on, or why it acts on nothing.
QString TuningRow::note()
{
    const Property& property = *m_slider.property;
    const QString idle = m_usage.whyIdle(property, m_slider.ids);
    if (!idle.isEmpty())
        return tr("Does nothing now: %1.").arg(idle);
    if (property.effect == Effect::OnReset)
        return tr("Takes effect on reset.");
    if (property.kind != Kind::Material)
        return {};
    const auto& uses = m_usage.usage().ofMaterial;
    Use sum;
    for (const Id id : m_slider.ids)
        if (const auto found = uses.find(id); found != uses.end()) {
            sum.springs += found->second.springs;
            sum.rods += found->second.rods;
            sum.panels += found->second.panels;
        }
    QStringList what;
    if (sum.links() > 0)
        what << plural(sum.links(), Kind::Link);
    if (sum.panels > 0)
        what << plural(sum.panels, Kind::Panel);
    return tr("Of %1.").arg(what.join(tr(" and ")));
}

void TuningRow::refresh()
{
    const Property& property = *m_slider.property;
    const std::vector<ConstRef> refs = m_subject.refs();
    if (refs.size() != m_slider.ids.size())
        return; // the panel is about to take this row away
    const QString what = describe(m_document.scene(), m_slider.ids);
    m_label->setText(property.kind == Kind::Settings
                         ? labelOf(property)
                         : what + QStringLiteral(" \u00b7 ") + tradeLabel(property));
    QString words = note().toHtmlEscaped();
    const QString links = remedyLinks(m_usage.remedies(property, m_slider.ids));
    if (!links.isEmpty())
        words += QChar(' ') + links;
    m_note->setText(words);
    m_note->setVisible(!words.isEmpty());
    const bool isIdle = !m_usage.whyIdle(property, m_slider.ids).isEmpty();
    m_label->setIdle(isIdle);
    m_label->setToolTip(
        QStringLiteral("<qt><b>%1.</b> %2</qt>")
            .arg(labelOf(property).toHtmlEscaped(), helpOf(property).toHtmlEscaped()));

    const Common common = Subject::common(property, refs);
    m_field.refresh(common);
    if (!m_bar)
        return;
    showEnd(*m_low, m_slider.range.low);
    showEnd(*m_high, m_slider.range.high);
    m_log->setChecked(m_slider.range.logarithmic);
    showOn(*m_bar, m_slider.range, m_subject, property);
    if (m_marks)
        m_marks->show(marks(), magnitude(common.value));
}

} // namespace ripstop
