// A label that changes its number when it is dragged sideways.
//
// Shift is finer, Ctrl coarser; the right button, pressed while dragging, takes the drag back. The
// label only tells how far it has been dragged: what that means for a number is said in tuning.h.
// It can also be pale, for what does nothing.
#pragma once

#include <QLabel>

namespace ripstop {

class ScrubLabel final : public QLabel
{
    Q_OBJECT

public:
    explicit ScrubLabel(const QString& text, QWidget* parent = nullptr);

    void setScrubbing(bool on);
    void setIdle(bool idle); // shows the label pale, for what does nothing

    void setWrapping(); // long names take two lines rather than more room than a dock has

    // As large as it is in bold, so that nothing moves when its value is changed.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void began();
    void dragged(double distance); // pixels from where it began, finer or coarser with the keys
    void cancelled();

private:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

    bool m_wraps = false;
    bool m_scrubbing = false; // can be dragged
    bool m_pressed = false;
    bool m_moving = false;
    double m_last = 0.0;     // pixels
    double m_distance = 0.0; // pixels
};

} // namespace ripstop
