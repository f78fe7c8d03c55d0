#pragma once

#include <QLabel>

namespace ripstop {

// A label that changes its number when it is dragged sideways. Shift is finer, Ctrl coarser; the
// right button, pressed while dragging, takes the drag back.
class ScrubLabel final : public QLabel
{
    Q_OBJECT

public:
    explicit ScrubLabel(const QString& text, QWidget* parent = nullptr);

    void setScrubbing(bool on);
    void setIdle(bool idle); // pale: what it names does nothing

signals:
    void began();
    void dragged(double distance); // px from where it began
    void cancelled();

private:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

    bool m_scrubbing = false; // can be dragged
    bool m_pressed = false;
    bool m_moving = false;
    double m_last = 0.0;     // px
    double m_distance = 0.0; // px
};

} // namespace ripstop
