// Sentences that say what is wrong, shown below the field where it was typed.
//
// The colour follows the palette, so that they can be read on light and dark grounds.
#pragma once

#include <QLabel>

namespace ripstop {

// The colour of such words for the ground of this palette: it can be read as easily (4.5 : 1 at
// least) on a light ground as on a dark one.
QColor wrongColor(const QPalette& ground);

// A label that shows a sentence in that colour, and is hidden while there is none.
class Complaint : public QLabel
{
    Q_OBJECT

public:
    explicit Complaint(QWidget* parent = nullptr);

    void tell(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void takeColor();
};

} // namespace ripstop
