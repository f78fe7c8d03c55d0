#include "icons/fold_button.h"

namespace ripstop {

FoldButton::FoldButton(const char* name)
{
    setObjectName(QLatin1String(name));
    setAutoRaise(true);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setForegroundRole(QPalette::PlaceholderText);
    connect(this, &QToolButton::clicked, this, [this] {
        m_isOpen = !m_isOpen;
        emit toggledOpen();
    });
}

void FoldButton::say(const QString& words)
{
    setArrowType(m_isOpen ? Qt::DownArrow : Qt::RightArrow);
    setText(words);
}

void FoldButton::sayIdle(int fields)
{
    setVisible(fields > 0);
    say(m_isOpen      ? tr("Hide what does nothing now")
        : fields == 1 ? tr("1 more field does nothing now")
                      : tr("%1 more fields do nothing now").arg(fields));
}

} // namespace ripstop
