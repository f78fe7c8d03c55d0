// A bar that shows how far a control has moved between its limits, m, as a filled part from the
// middle, and where it is told to go, as a pointer. ControlStrip has one for each control. Only the
// window's thread uses it.
#pragma once

#include <QWidget>

namespace ripstop {

class ValueBar final : public QWidget
{
    Q_OBJECT

public:
    explicit ValueBar(QWidget* parent = nullptr);

    void setLimit(double limit);             // m, either way
    void show(double value, double command); // m
    using QWidget::show;

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double place(double value) const; // px from the left

    double m_limit = 1.0;   // m
    double m_value = 0.0;   // m
    double m_command = 0.0; // m
};

} // namespace ripstop
