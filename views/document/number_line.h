// A line for a number. A double click takes the whole number: what Qt takes for a word of 2.4 is
// the 2, and who types 3 over it gets 3.4. A third click takes it, too, as in any other line, for
// which Qt has to be told of the second one.
#pragma once

#include <QLineEdit>

namespace ripstop {

class NumberLine : public QLineEdit
{
public:
    using QLineEdit::QLineEdit;

protected:
    void mouseDoubleClickEvent(QMouseEvent* event) override
    {
        QLineEdit::mouseDoubleClickEvent(event);
        selectAll();
    }
};

} // namespace ripstop
