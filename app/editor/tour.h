#pragma once

#include <QPointer>
#include <QWidget>

#include <vector>

class QFrame;
class QLabel;
class QPushButton;

namespace ripstop {

// A place of the window, and what it is for.
struct TourStop
{
    QPointer<QWidget> place;
    QString title;
    QString text;
};

// Goes through a window place by place: the place stays bright, a bubble beside it says what it is
// for. Deletes itself at the end.
class Tour final : public QWidget
{
    Q_OBJECT

public:
    Tour(std::vector<TourStop> stops, QWidget* window);

    int stop() const { return m_stop; }
    void goTo(int stop); // past the last one: the end

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QRect place() const;
    void arrange();
    bool take(int key); // false: not one of the tour's

    std::vector<TourStop> m_stops;
    int m_stop = -1;
    QFrame* m_bubble;
    QLabel* m_title;
    QLabel* m_text;
    QLabel* m_count;
    QPushButton* m_back;
    QPushButton* m_next;
};

} // namespace ripstop
