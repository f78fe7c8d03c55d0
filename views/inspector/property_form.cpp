#include "inspector/property_form.h"

#include "document/words.h"
#include "icons/icon.h"
#include "inspector/typed_number.h"
#include "inspector/usage.h"
#include "inspector/value_edit.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

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
        text += QStringLiteral("<br><i>")
                + PropertyForm::tr("Also *1.1, +5%, +0.2, -=0.2 or 1/240; drag the label sideways.")
                + QStringLiteral("</i>");
    return QStringLiteral("<qt>%1</qt>").arg(text);
}

// A name, a place or what something points at has no default worth going back to.
bool canReset(const Property& property)
{
    return property.pointsAt.empty() && property.key != "name" && property.key != "builder"
           && property.key != "position" && property.key != "restLength" && property.key != "title"
           && property.key != "notes";
}

} // namespace

PropertyForm::PropertyForm(Subject& subject, Kind kind, QWidget* parent)
    : QWidget(parent)
    , m_subject(subject)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(8, 4, 4, 8);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    grid->setColumnMinimumWidth(0,
                                fontMetrics().horizontalAdvance(QStringLiteral("Skin friction")));
    for (const Property& property : propertiesOf(kind))
        addRow(*grid, property);
    grid->setRowStretch(grid->rowCount(), 1);
}

void PropertyForm::addRow(QGridLayout& grid, const Property& property)
{
    const int row = grid.rowCount();
    const QString tip = tipOf(property);

    auto* label = new ScrubLabel(labelOf(property));
    label->setToolTip(tip);
    auto* complaint = new QLabel;
    complaint->setWordWrap(true);
    complaint->hide();
    QPalette red = complaint->palette();
    red.setColor(QPalette::WindowText, QColor(0xd6, 0x3b, 0x3b));
    complaint->setPalette(red);

    const auto complain = [complaint](const QString& sentence) {
        complaint->setText(sentence);
        complaint->setVisible(!sentence.isEmpty());
    };
    Field field = makeField({m_subject, property, *label, complain});
    for (QWidget* focus : field.focus)
        if (focus) {
            focus->setToolTip(tip);
            if (focus->accessibleName().isEmpty())
                focus->setAccessibleName(labelOf(property));
        }
    label->setBuddy(field.focus[0]);

    auto* reset = new QToolButton;
    reset->setIcon(icon(QStringLiteral("undo")));
    reset->setIconSize(QSize(12, 12));
    reset->setAutoRaise(true);
    reset->setFocusPolicy(Qt::NoFocus);
    reset->setToolTip(tr("Back to the default."));
    reset->setAccessibleName(tr("Reset %1").arg(labelOf(property).toLower()));
    QSizePolicy keepsPlace = reset->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    reset->setSizePolicy(keepsPlace);
    reset->hide();
    connect(reset, &QToolButton::clicked, this,
            [this, &property] { m_subject.edit(property, setTo(property.initial)); });

    const bool isTall = field.widget->sizeHint().height() > 36; // px
    grid.addWidget(label, row, 0, isTall ? Qt::AlignTop : Qt::AlignVCenter);
    label->setMinimumHeight(isTall ? reset->sizeHint().height() : 0); // level with the first line
    grid.addWidget(field.widget, row, 1);
    grid.addWidget(reset, row, 2, isTall ? Qt::AlignTop : Qt::AlignVCenter);
    grid.addWidget(complaint, row + 1, 1, 1, 2);
    m_rows.push_back({&property, label, tip, reset, std::move(field)});
}

void PropertyForm::refresh()
{
    const std::vector<ConstRef> refs = m_subject.refs();
    if (refs.empty() || kindOf(refs.front()) != m_rows.front().property->kind)
        return;
    for (const Row& row : m_rows) {
        const Property& property = *row.property;
        const Common common = Subject::common(property, refs);
        row.field.refresh(common);
        row.reset->setVisible(!common.isDefault && canReset(property));
        const bool used = std::any_of(refs.begin(), refs.end(),
                                      [&](const ConstRef& ref) { return isUsed(property, ref); });
        row.label->setForegroundRole(used ? QPalette::WindowText : QPalette::PlaceholderText);
        row.label->setToolTip(used ? row.tip
                                   : tr("<qt><b>Has no effect here.</b><br>%1").arg(row.tip));
    }
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
