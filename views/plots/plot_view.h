// One panel of the plots dock: the curves of a Plot over time, against a probe, or as spectra; and
// a hint in their place while there is nothing to draw. PlotPanel makes it, gives it what to draw,
// and does what its signals ask for. It is a widget: only the window's thread uses it.
#pragma once

#include "plots/chart.h"
#include "plots/xy_chart.h"

class QLabel;
class QStackedWidget;
class QToolButton;

namespace ripstop {

class PlotView final : public QWidget
{
    Q_OBJECT

public:
    explicit PlotView(QWidget* parent = nullptr);

    // `across` names the probe that the curves are against; its name is empty without one.
    void setPlot(const Plot& plot, std::vector<Curve> curves, const AxisWords& across);
    const Plot& plot() const { return m_plot; }
    const std::vector<Curve>& curves() const { return m_chart->curves(); }

    // Why there is nothing to draw, said in place of the curves; empty where there is something.
    void setLack(const QString& why);

    enum class Title { Hidden, Shown, Current }; // the list and the menu are about the current one
    void setTitle(Title title);

    // `bands` around curves over time, or null; see Chart::draw().
    void draw(const History& history, const ErrorBands* bands,
              const std::vector<EarlierRun>& earlier);
    double drawingTime() const; // ms, mean of the latest drawings

    Chart& chart() { return *m_chart; }
    QCustomPlot& plotInSight() const;

    // The range of values that is shown, in their unit; nothing when there are several strips.
    std::optional<std::pair<double, double>> valueRange() const;

signals:
    void chosen(); // it has been clicked
    void menuWanted(const QPoint& place);
    void removeWanted();
    void drawWanted();

protected:
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    void showPage();
    void styleTitle();

    Plot m_plot;
    AxisWords m_across;
    QString m_lack;
    Title m_title = Title::Hidden;
    QWidget* m_bar;
    QLabel* m_name;
    QToolButton* m_close;
    QStackedWidget* m_pages;
    QLabel* m_hint;
    Chart* m_chart;
    XyChart* m_xy;
};

} // namespace ripstop
