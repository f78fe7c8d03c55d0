// The base of the bars over the lower edge of the view: it keeps a bar in the middle of that edge,
// beside the strip of tools where the bar would cover it, when the view is resized, and makes the
// lists of choices and the fields of numbers that they use.
//
// A subclass fills the layout, shows and hides itself, and calls settle() after its contents have
// changed. The view is the parent and owns it.
#pragma once

#include <QFrame>

#include <functional>
#include <vector>

class QComboBox;
class QLabel;

namespace ripstop {

class Complaint;
class ParameterField;
struct Parameter;
class Viewport;

class ViewBar : public QFrame
{
    Q_OBJECT

public:
    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    ViewBar(Viewport& viewport, const QString& name); // it is hidden at first

    void hideEvent(QHideEvent* event) override;

    void settle(); // takes its place, as large as what it shows now
    QComboBox* chooser(const QString& name, const QString& help, const QStringList& choices,
                       int chosen, const std::function<void(int)>& choose);

    // What is wrong with what is typed into it, where that is seen; empty while nothing is.
    virtual QString refusal() const;

    // What cannot be read, or is out of range, is not taken, and refusal() says what is wanted.
    ParameterField* numberField(const Parameter& parameter, double value,
                                const std::function<void(double)>& take);

    Viewport& m_viewport;
    QLabel* m_hint;         // what the tool does; in several lines where there is no room for one
    Complaint* m_complaint; // says refusal() below all else

private:
    QRect inSeveralLines();
    void tellView();

    std::vector<ParameterField*> m_numbers;
};

} // namespace ripstop
