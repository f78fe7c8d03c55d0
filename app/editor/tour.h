// A guided tour over any window: it shades the window except for one place and puts a bubble
// beside it that says what the place is for; buttons and keys go on, back and end it.
//
// It knows nothing of the window but its stops; which they are is said in window_tour.h. A stop
// whose widget is gone or hidden is passed over. It is a child of the window, filters its events
// while it is there, and deletes itself at the end. It lives on the thread of the window.
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

class Tour final : public QWidget
{
    Q_OBJECT

public:
    Tour(std::vector<TourStop> stops, QWidget* window);

    int stop() const { return m_stop; }
    void goTo(int stop); // past the last stop the tour ends

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QRect place() const;
    void arrange();
    bool take(int key); // false when the tour has no use for that key

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
