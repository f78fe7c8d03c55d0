// A small form over the view for the values at both ends of the colours.
//
// Enter takes what is typed, in the unit of the legend or any other of its kind; Escape leaves it.
// What cannot be read, or a range without extent, is answered by a sentence in the form, and
// nothing is emitted.
#pragma once

#include "look/steady_range.h"

#include <QFrame>

#include <optional>

class QLabel;
class QLineEdit;

namespace ripstop {

class Legend;

class RangeEditor final : public QFrame
{
    Q_OBJECT

public:
    RangeEditor(Legend& legend, QWidget* parent); // a click on its colours opens it

    void open(); // not while the view shows what has no range, as materials

    QLineEdit& low() { return *m_low; }
    QLineEdit& high() { return *m_high; }
    QString complaint() const; // why it cannot be taken; empty when it can

signals:
    // The range in SI units; nothing lets it follow the values.
    void chosen(const std::optional<ripstop::ValueRange>& range);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    std::optional<ValueRange> typed();
    void take();

    const Legend& m_legend;
    QLineEdit* m_low;
    QLineEdit* m_high;
    QLabel* m_complaint;
};

} // namespace ripstop
