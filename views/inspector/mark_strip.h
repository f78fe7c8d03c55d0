// Named marks below a slider: where the materials of the library lie along its track.
//
// Each mark has a tick; names are written where there is room, spread along the track, and
// the tool tip of a tick has all of them. A click on a mark takes its value, and a slider that is
// dragged near one snaps to it: nearTo() says to which.
#pragma once

#include <QWidget>

#include <optional>
#include <vector>

class QSlider;

namespace ripstop {

struct SliderMark
{
    double place; // 0..1 along the track
    double value;
    QString name; // short, below the tick
    QString tip;  // who else is there
};

class MarkStrip final : public QWidget
{
    Q_OBJECT

public:
    // The bar and this strip lie in the same widget, the strip below.
    explicit MarkStrip(QSlider& bar, QWidget* parent = nullptr);

    // `value` is the present one; the mark that has it stands out.
    void show(std::vector<SliderMark> marks, double value);

    // The mark within a few pixels of this position of the bar.
    std::optional<double> nearTo(int position) const;

    const std::vector<SliderMark>& marks() const { return m_marks; }
    int xOf(const SliderMark& mark) const; // px, in this widget

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void chosen(double value);

private:
    struct Label
    {
        std::size_t mark;
        QRect place;
    };

    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;
    std::vector<std::size_t> inOrderOfNaming() const;
    std::vector<Label> labels() const; // where names have room
    const SliderMark* markAt(const QPoint& point) const;
    int trackX(double place) const; // px, in this widget
    QFont smallFont() const;
    int nameHeight() const; // px

    QSlider& m_bar;
    std::vector<SliderMark> m_marks;
    double m_value = 0.0;
};

} // namespace ripstop
