// A line that holds the text of a value.
//
// While a person types, the text is judged and a broken one gets a red outline, and its tool tip
// says why; Enter commits, Escape and leaving a broken text revert. A text that is being typed is
// not overwritten by values from outside. The unit stands at the right end and is not part of the
// text.
#pragma once

#include "document/number_line.h"

#include <functional>

namespace ripstop {

class ValueEdit final : public NumberLine
{
    Q_OBJECT

public:
    // Says what is wrong with a text, as a sentence; an empty one when the text is fine.
    using Judge = std::function<QString(const QString&)>;

    explicit ValueEdit(Judge judge, QWidget* parent = nullptr);

    void setUnit(const QString& unit);
    void setSteps(bool on) { m_steps = on; } // the arrow keys emit stepped()

    // Shows a value from outside; a text that is being typed stays. `hint` is shown while the text
    // is empty.
    void show(const QString& text, const QString& hint = {});

    bool isBroken() const { return !m_complaint.isEmpty(); }
    const QString& complaint() const { return m_complaint; }
    void leave(); // commits or reverts what was typed, as when the focus goes

signals:
    void committed(const QString& text);
    void complained(const QString& sentence); // empty when all is well again
    void stepped(int steps, bool isRepeat);   // by an arrow key that is held

private:
    void judge();
    bool commit();
    void revert();
    void complain(const QString& sentence);
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

    Judge m_judge;
    QString m_shown;
    QString m_unit;
    QString m_complaint;
    bool m_steps = false;
};

} // namespace ripstop
