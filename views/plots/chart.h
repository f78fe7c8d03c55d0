// Curves over time, in one strip for each unit, with marks of what happened in the run.
//
// The chart has no data of its own: draw() points it at a History, which has to live until another
// one is drawn. Only as many points as the screen can show are drawn (plots/drawn_curve.h), so that
// long runs cost little. The time axis follows the run until the user drags or zooms it; each value
// axis fits what is in sight until the user drags or zooms it. A double click lets go of both.
//
// Times are in s; values are in the unit of their strip. It is a widget: only the window's thread
// uses it. PlotView shows it as one of its pages.
#pragma once

#include "plots/band_graphs.h"
#include "plots/drawn_curve.h"
#include "plots/history.h"
#include "recording/run_event.h"
#include "scene/items.h"

#include <QColor>
#include <QString>
#include <QWidget>

#include <array>
#include <optional>
#include <utility>
#include <vector>

class QCPAxis;
class QCPAxisRect;
class QCPGraph;
class QCPLegend;
class QCPMarginGroup;
class QCPRange;
class QCustomPlot;

namespace ripstop {

class ErrorBands;
class SpokenAxis;

// A probe as the chart draws it.
struct Curve
{
    std::uint32_t probe; // id
    QString name;        // "kite height"
    QString unit;        // "m"; empty when dimensionless
    QColor color;
    bool isShare = false; // said in percent

    friend bool operator==(const Curve&, const Curve&) = default;
};

// An event of the run, drawn as a thin line through all strips.
struct Mark
{
    RunEvent::Kind kind;
    double time;  // s
    QString text; // what happened
};

class Chart final : public QWidget
{
    Q_OBJECT

public:
    explicit Chart(QWidget* parent = nullptr);

    void setCurves(std::vector<Curve> curves);
    const std::vector<Curve>& curves() const { return m_curves; }
    // Both are kept by address and must outlive the next drawing. `bands` are of that history; null
    // where none are to be seen.
    void draw(const History& history, const ErrorBands* bands = nullptr);
    void setEarlier(const std::vector<EarlierRun>& earlier); // drawn thin, behind the curves
    void setMarks(std::vector<Mark> marks); // tears are taken from the history instead
    void setPlot(const Plot& plot);         // its length of time, its scale and its range of values

    // Lines over the curves, s: the instant that is looked back at, and the time under the mouse,
    // which may be over another chart.
    void setCursor(std::optional<double> time);
    void setHover(std::optional<double> time);

    void follow(); // does what a double click does
    bool follows() const { return m_following; }

    QCustomPlot& plot() { return *m_plot; }

    // The range of values that is shown, in the unit of the strip; nothing unless there is exactly
    // one strip.
    std::optional<std::pair<double, double>> valueRange() const;

    // For tests: what is in sight, s, and how many points are drawn.
    double timeFrom() const;
    double timeTo() const;
    int stripCount() const { return int(m_strips.size()); }
    int pointCount() const;
    int markCount(RunEvent::Kind kind) const;
    int bandCount() const; // that are in sight

    QSize minimumSizeHint() const override;

signals:
    void followed();
    void hovered(std::optional<double> time); // s, under the mouse; nothing when it has left

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Strip
    {
        QString unit;
        bool isShare;
        QCPAxisRect* rect;
        QCPAxis* time;
        QCPAxis* values;
        SpokenAxis* saidTime; // what stands beside the axes
        SpokenAxis* said;
        QCPLegend* legend;
        std::array<QCPGraph*, runEventNames.size()> marks;
        QCPGraph* cursor;
        std::vector<int> curves;       // indices into m_curves
        std::vector<BandGraphs> bands; // [curves]
        std::vector<QCPGraph*> past;   // of earlier runs, curve by curve for each
        DrawnCurve inSight;            // without points: what its curves span
        bool showsBands = false;       // and says so in the legend
        bool held = false;             // the user has chosen the range of values
    };

    static constexpr int stripHeight = 100; // px, at least, with its legend

    void layOut();
    void addStrip(const Curve& first);
    void addCurve(Strip& strip, int curve);
    void addPast();
    bool isCrowded() const; // so that curves are drawn coarser
    void style();
    void style(Strip& strip);
    void fitLegends();
    void fitLegend(const Strip& strip);
    void fill();
    void fill(Strip& strip);
    void fillBands(Strip& strip, const TimeWindow& window);
    void fillMarks();
    void drawCursors();
    void drawCursor(const Strip& strip) const;
    QCPRange timeToShow() const; // the time to show
    void fitValues(Strip& strip);
    const Mark* markAt(double x) const; // px
    QString bandAt(const QPointF& place) const;
    void takeTime(const QCPRange& range); // from one strip to all
    void aim(const QPointF& place);       // which axis the mouse is about to move
    void hover(const QPointF& place);

    QCustomPlot* m_plot;
    QCPMarginGroup* m_margins; // of all strips; a plot keeps each that it ever had
    std::vector<Curve> m_curves;
    std::vector<QCPGraph*> m_graphs; // [curves]
    std::vector<EarlierRun> m_earlier;
    std::vector<Strip> m_strips;
    std::vector<Mark> m_marks;
    Plot m_settings;
    const History* m_history = nullptr;  // that was drawn last
    const ErrorBands* m_bands = nullptr; // around its curves, or null
    std::optional<double> m_cursor;      // s
    std::optional<double> m_hover;       // s
    bool m_following = true;
    bool m_setting = false; // ranges change by program, not by hand
};

} // namespace ripstop
