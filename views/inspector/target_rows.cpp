// show() takes the old rows away and adds one for each target of the item. A row has the name, the
// value and the wanted value, and the difference in a colour that says whether the target is met;
// that of the mass also has the button. spread() asks the model for the edit and pushes it, or says
// why it cannot be done.
#include "inspector/target_rows.h"

#include "document/document.h"
#include "document/plain_text.h"
#include "document/spoken.h"
#include "document/words.h"

#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QToolButton>

#include <cmath>

namespace ripstop {
namespace {

constexpr int darkBelow = 128; // of 255, lightness of what is behind

QColor inkOf(bool isMet, const QPalette& palette)
{
    const bool dark = palette.color(QPalette::Window).lightness() < darkBelow;
    if (isMet)
        return dark ? QColor(0x7f, 0xd1, 0x8b) : QColor(0x1e, 0x77, 0x2e);
    return dark ? QColor(0xff, 0x8a, 0x7a) : QColor(0xb3, 0x26, 0x1e);
}

QString quantity(double value, std::string_view unit) { return spokenText(value, unit); }

QString differenceOf(const Target& target)
{
    if (target.isMet())
        return TargetRows::tr("on target");
    const double excess = target.excess();
    const QString amount = quantity(std::abs(excess), target.property->unit);
    const QString share = spokenText(100.0 * std::abs(excess) / target.wanted, "%", 3);
    return excess > 0.0 ? TargetRows::tr("%1 too much (%2)").arg(amount, share)
                        : TargetRows::tr("%1 missing (%2)").arg(amount, share);
}

QString nameOf(const Target& target)
{
    switch (target.of) {
    case TargetOf::Mass:
        return TargetRows::tr("Mass");
    case TargetOf::Length:
        return TargetRows::tr("Length of line");
    case TargetOf::Area:
        return TargetRows::tr("Area");
    }
    return {};
}

} // namespace

TargetRows::TargetRows(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_rows(new QGridLayout(this))
{
    m_rows->setContentsMargins(8, 0, 8, 4);
    m_rows->setHorizontalSpacing(8);
    m_rows->setVerticalSpacing(2);
    m_rows->setColumnStretch(1, 1);
    hide();
}

void TargetRows::show(Id id)
{
    m_id = id;
    while (QLayoutItem* item = m_rows->takeAt(0)) {
        if (QWidget* widget = item->widget())
            widget->deleteLater(); // its click may have led here
        delete item;
    }
    const std::vector<Target> targets = targetsOf(m_document.scene(), id);
    for (const Target& target : targets)
        addRow(target);
    setVisible(!targets.empty());
}

void TargetRows::addRow(const Target& target)
{
    const int row = m_rows->rowCount();
    auto* name = new QLabel(nameOf(target));
    name->setForegroundRole(QPalette::PlaceholderText);
    auto* value =
        new QLabel(tr("%1 of %2")
                       .arg(quantity(target.value, target.property->unit),
                            quantity(target.wanted, target.property->unit))
                   + QStringLiteral("<br><span style='color:%1'>%2</span>")
                         .arg(inkOf(target.isMet(), palette()).name(), differenceOf(target)));
    value->setTextFormat(Qt::RichText);
    value->setWordWrap(true);
    value->setObjectName(QString::fromUtf8(target.property->key.data()));
    m_rows->addWidget(name, row, 0, Qt::AlignTop);
    m_rows->addWidget(value, row, 1);
    if (target.of != TargetOf::Mass || target.isMet())
        return;
    auto* button = new QToolButton;
    button->setText(tr("Spread"));
    button->setObjectName(QStringLiteral("spreadDifference"));
    button->setToolTip(tr("Spread the difference over the particles, in proportion to their "
                          "masses, so that they weigh what they should."));
    connect(button, &QToolButton::clicked, this, &TargetRows::spread);
    m_rows->addWidget(button, row, 2, Qt::AlignTop);
}

void TargetRows::spread()
{
    Result<Edit> edit = massBroughtToTarget(m_document.scene(), m_id);
    if (!edit) {
        QMessageBox::information(window(), tr("Target mass"),
                                 shownAsIs(translated(edit.message())));
        return;
    }
    m_document.push(std::move(*edit));
}

} // namespace ripstop
