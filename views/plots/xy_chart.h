// Curves of anything against anything: phase curves and spectra in the plots dock. The axes fit the
// curves until the user drags or zooms; a double click lets them fit again. It copies what it
// draws. It is a widget: only the window's thread uses it.
#pragma once

#include "plots/spoken_axis.h"

#include <QColor>
#include <QString>
#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

class QCustomPlot;

namespace ripstop {

// A curve through points that need not be in order of x.
struct XyCurve
{
    QString name;
    QColor color;
    std::vector<double> x; // [points]
    std::vector<double> y; // [points]
    bool past = false;     // belongs to an earlier run and is drawn thin
};

class XyChart final : public QWidget
{
    Q_OBJECT

public:
    explicit XyChart(QWidget* parent = nullptr);

    void show(const AxisWords& x, const AxisWords& y, const std::vector<XyCurve>& curves);
    using QWidget::show;
    void setLogarithmic(bool logarithmic);                                // the y axis
    void setRange(std::optional<double> low, std::optional<double> high); // y axis, where given
    std::pair<double, double> valueRange() const; // limits of the y axis as it is shown

    QCustomPlot& plot() { return *m_plot; }

    // For tests.
    int curveCount() const;

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();
    void fitNames();

    QCustomPlot* m_plot;
    SpokenAxis* m_x;
    SpokenAxis* m_y;
    std::optional<double> m_low;
    std::optional<double> m_high;
    std::ptrdiff_t m_pastCount = 0; // curves of earlier runs, which come first
    bool m_logarithmic = false;
    bool m_held = false;    // the user has chosen what is in sight
    bool m_setting = false; // ranges change by program, not by hand
};

} // namespace ripstop
