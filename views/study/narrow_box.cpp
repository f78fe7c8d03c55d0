// Styles cut what is too long in the middle of a letter, so that it is made shorter for them.
#include "study/narrow_box.h"

#include "document/plain_text.h"
#include "document/words.h"

#include <QStyleOptionComboBox>
#include <QStylePainter>

namespace ripstop {

NarrowBox::NarrowBox(const QString& name, const QStringList& texts, int letters)
    : m_name(name)
{
    setAccessibleName(name);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(letters);
    addItems(texts);
    connect(this, &QComboBox::currentTextChanged, this, &NarrowBox::tellWhole);
    tellWhole();
}

void NarrowBox::tellWhole()
{
    setToolTip(shownAsIs(currentText().isEmpty() ? m_name : labelled(m_name, currentText())));
}

void NarrowBox::paintEvent(QPaintEvent*)
{
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QRect room =
        style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    constexpr int besideText = 4; // px
    option.currentText = option.fontMetrics.elidedText(option.currentText, Qt::ElideRight,
                                                       room.width() - besideText);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

} // namespace ripstop
