#include "editor/empty_hint.h"

#include "document/document.h"
#include "look/scene_frame.h"
#include "viewport/viewport.h"

#include <QEvent>

namespace ripstop {
namespace {

constexpr int fromUpperEdge = 24; // px

} // namespace

EmptyHint::EmptyHint(Document& document, Viewport& viewport)
    : QLabel(&viewport)
    , m_document(document)
    , m_viewport(viewport)
{
    setObjectName(QStringLiteral("emptyHint"));
    setText(tr("This scene is empty: it has no ground either.\n\n"
               "Insert brings in a whole kite, glider, parachute or cloth.\n"
               "File, Import makes fabric of a mesh (Ctrl+Shift+I).\n"
               "Draw, Links draws one particle after the other (D)."));
    setAlignment(Qt::AlignCenter);
    setAttribute(Qt::WA_TransparentForMouseEvents); // clicks of a drawing tool go through it
    viewport.installEventFilter(this);
    connect(&document, &Document::changed, this, &EmptyHint::refresh);
    connect(&document, &Document::replaced, this, &EmptyHint::refresh);
    refresh();
}

void EmptyHint::refresh()
{
    setVisible(hasNothing(m_document.scene()));
    adjustSize();
    move((m_viewport.width() - width()) / 2, fromUpperEdge);
}

bool EmptyHint::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_viewport && event->type() == QEvent::Resize)
        refresh();
    return QLabel::eventFilter(watched, event);
}

} // namespace ripstop
