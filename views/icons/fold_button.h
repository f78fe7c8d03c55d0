// A discreet line of a form that shows and hides fields which hardly matter now. The form asks it
// what is open, and is told when that changes.
#pragma once

#include <QToolButton>

namespace ripstop {

class FoldButton final : public QToolButton
{
    Q_OBJECT

public:
    explicit FoldButton(const char* name);

    bool isOpen() const { return m_isOpen; }
    void say(const QString& words);

    // So many fields do nothing now; it is not there where that is none.
    void sayIdle(int fields);

signals:
    void toggledOpen();

private:
    bool m_isOpen = false;
};

} // namespace ripstop
