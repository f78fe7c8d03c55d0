#pragma once

#include <QLabel>

namespace ripstop {

class Document;
class Viewport;

// What to do first, in the middle of the view of a scene that has nothing to be seen in it.
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
