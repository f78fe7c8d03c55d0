// A text in the view of a scene without parts and colliders that says what to do first.
//
// The main window makes it over the view, which owns it. It lets the mouse through, so that
// drawing tools work below it, and hides as soon as the document has something to be seen.
#pragma once

#include <QLabel>

namespace ripstop {

class Document;
class Viewport;

class EmptyHint final : public QLabel
{
    Q_OBJECT

public:
    EmptyHint(Document& document, Viewport& viewport); // the view owns it

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();

    Document& m_document;
    Viewport& m_viewport;
};

} // namespace ripstop
