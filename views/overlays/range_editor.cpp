// open() fills the two lines with the range of the legend and stands beside it. typed() reads both
// lines as numbers with units and complains about the first that it cannot take. take() closes the
// form and emits the range in SI units; the other button emits none, so that the range follows the
// values.
#include "overlays/range_editor.h"

#include "document/words.h"
#include "overlays/legend.h"
#include "scene/typed_number.h"

#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace ripstop {

RangeEditor::RangeEditor(Legend& legend, QWidget* parent)
    : QFrame(parent, Qt::Popup)
    , m_legend(legend)
    , m_low(new QLineEdit)
    , m_high(new QLineEdit)
    , m_complaint(new QLabel)
{
    setFrameShape(QFrame::StyledPanel);
    setAccessibleName(tr("Range of colours"));
    m_complaint->setWordWrap(true);
    m_complaint->hide();
    auto* follow = new QPushButton(tr("&Follow the values"));
    follow->setToolTip(
        tr("The colours reach as far as the values of the moment, but for the largest 2 %."));
    auto* take = new QPushButton(tr("&Keep this range"));
    take->setDefault(true);
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Highest"), m_high);
    form->addRow(tr("&Lowest"), m_low);
    form->addRow(m_complaint);
    form->addRow(follow, take);
    connect(take, &QPushButton::clicked, this, &RangeEditor::take);
    connect(follow, &QPushButton::clicked, this, [this] {
        hide();
        emit chosen({});
    });
    connect(&legend, &Legend::rangeClicked, this, &RangeEditor::open);
}

void RangeEditor::open()
{
    if (m_legend.isHidden() || !m_legend.hasRange())
        return;
    const auto text = [&](double value) { return compactNumber(value) + ' ' + m_legend.unit(); };
    m_low->setText(text(m_legend.range().low));
    m_high->setText(text(m_legend.range().high));
    m_complaint->hide();
    adjustSize();
    move(m_legend.mapToGlobal(QPoint(-width() - 8, 0)));
    show();
    m_high->setFocus();
    m_high->selectAll();
}

QString RangeEditor::complaint() const
{
    return m_complaint->isHidden() ? QString() : m_complaint->text();
}

// The range that is typed; nothing after a complaint.
std::optional<ValueRange> RangeEditor::typed()
{
    const auto complain = [this](QLineEdit* line, const QString& text) {
        m_complaint->setText(text);
        m_complaint->show();
        line->setFocus();
        adjustSize();
    };
    ValueRange range;
    for (const auto& [line, value] :
         {std::pair{m_low, &range.low}, std::pair{m_high, &range.high}}) {
        const Typed one = typedValue(line->text().toStdString(), m_legend.unit().toStdString());
        if (!one.number) {
            complain(line, (line == m_low ? tr("The lowest %1.") : tr("The highest %1."))
                               .arg(translated(one.complaint)));
            return std::nullopt;
        }
        *value = one.number->number;
    }
    if (range.low < range.high)
        return range;
    complain(m_high, tr("The highest has to be above the lowest."));
    return std::nullopt;
}

void RangeEditor::take()
{
    if (const auto range = typed()) {
        hide();
        emit chosen(m_legend.meant(*range));
    }
}

void RangeEditor::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        return take();
    QFrame::keyPressEvent(event);
}

} // namespace ripstop
