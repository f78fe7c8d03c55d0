// A choice that takes little room, as the panel stands in a dock.
#pragma once

#include <QComboBox>
#include <QStringList>

namespace ripstop {

inline QComboBox* narrowBox(const QString& name, const QStringList& texts = {}, int letters = 4)
{
    auto* box = new QComboBox;
    box->setAccessibleName(name);
    box->setToolTip(name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(letters);
    box->addItems(texts);
    return box;
}

} // namespace ripstop
