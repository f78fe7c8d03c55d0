#pragma once

#include "plots/history.h"

#include <QColor>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QCPAxis;
class QCPAxisRect;
class QCPGraph;
class QCPRange;
class QCustomPlot;

namespace ripstop {

struct Curve
{
    std::uint32_t probe; // id
    QString name;        // "kite height"
    QString unit;        // "m"; empty when dimensionless
    QColor color;

    friend bool operator==(const Curve&, const Curve&) = default;
};

// Curves over time, in one strip for each unit; tears as thin lines through all strips.
//
// The time axis follows the run until the user drags or zooms it; the value axes fit what is in
// sight until the user drags or zooms them. A double click lets go of both.
class Chart final : public QWidget
{
    Q_OBJECT

public:
    explicit Chart(QWidget* parent = nullptr);

    void setCurves(std::vector<Curve> curves);
    const std::vector<Curve>& curves() const { return m_curves; }
    void draw(const History& history);
    void setEarlier(const std::vector<EarlierRun>& earlier); // thin, behind the curves
    void setLogarithmic(bool logarithmic);                   // the axes of values
    bool isLogarithmic() const { return m_logarithmic; }

    void setCursor(std::optional<double> time); // s; a line there, or none

    void follow(); // as after a double click
    bool follows() const { return m_following; }
    void setWholeRun(bool whole); // follow from the start, not only the latest half minute
    bool showsWholeRun() const { return m_wholeRun; }

    QCustomPlot& plot() { return *m_plot; }

    // For tests: what is in sight, s.
    double timeFrom() const;
    double timeTo() const;
    int stripCount() const { return int(m_strips.size()); }

    QSize minimumSizeHint() const override;

signals:
    void followed();
    void hovered(std::optional<double> time); // s, under the mouse; nothing when it has left

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Strip
    {
        QString unit;
        QCPAxisRect* rect;
        QCPAxis* time;
        QCPAxis* values;
        QCPGraph* tears;
        QCPGraph* cursor;
        std::vector<int> curves; // indices into m_curves
        bool held = false;       // the user has chosen the range of values
    };

    void layOut();
    void addStrip(const QString& unit);
    void addCurve(Strip& strip, int curve);
    void addPast();
    void scale(Strip& strip) const;
    void label(Strip& strip) const;
    void style();
    void style(Strip& strip);
    void fill(const History& history);
    void drawCursor(const Strip& strip) const;
    void showTime(const History& history);
    void fitValues(Strip& strip);
    void takeTime(const QCPRange& range); // from one strip to all
    void aim(const QPointF& place);       // which axis the mouse is about to move
    void hover(const QPointF& place);

    QCustomPlot* m_plot;
    std::vector<Curve> m_curves;
    std::vector<QCPGraph*> m_graphs; // [curves]
    std::vector<QCPGraph*> m_past;   // of earlier runs
    std::vector<EarlierRun> m_earlier;
    std::vector<Strip> m_strips;
    std::size_t m_drawn = 0;        // samples
    int m_revision = -1;            // of the history that was drawn
    std::optional<double> m_cursor; // s
    bool m_following = true;
    bool m_wholeRun = false;
    bool m_logarithmic = false;
    bool m_setting = false; // ranges change by program, not by hand
};

} // namespace ripstop
