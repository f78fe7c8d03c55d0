#include "plots/band_graphs.h"

#include "plots/curve_color.h"

#include <qcustomplot.h>

namespace ripstop {
namespace {

constexpr float opacity = 0.26F;    // of what is filled: grid and curves show through
constexpr float edgeOpacity = 0.5F; // of its edge, which tells bands apart that overlap
constexpr float legendOpacity = 0.4F;
constexpr double farBelow = 1e-6; // of what is shown, on a logarithmic axis

QColor faded(QColor color, float alpha)
{
    color.setAlphaF(alpha);
    return color;
}

// Shows in a legend the shade that it stands for, and no line.
class UpperEdge final : public QCPGraph
{
public:
    UpperEdge(QCPAxis& time, QCPAxis& values)
        : QCPGraph(&time, &values)
    {}

    QColor legendColor;

protected:
    void drawLegendIcon(QCPPainter* painter, const QRectF& rect) const override
    {
        painter->fillRect(rect, faded(legendColor, legendOpacity));
    }
};

} // namespace

BandGraphs addBand(QCustomPlot& plot, QCPAxis& time, QCPAxis& values)
{
    BandGraphs band{plot.addGraph(&time, &values), new UpperEdge(time, values)}; // the plot's
    for (QCPGraph* edge : {band.low, band.high}) {
        edge->setAdaptiveSampling(false); // both keep the same times
        edge->setLayer(QStringLiteral("grid"));
    }
    band.high->setChannelFillGraph(band.low);
    return band;
}

DrawnCurve fillBand(const BandGraphs& band, std::span<const double> time,
                    std::span<const double> low, std::span<const double> high,
                    const TimeWindow& window)
{
    TimeWindow all = window;
    all.positiveOnly = false;
    DrawnCurve below = drawnCurve(time, low, all);
    DrawnCurve above = drawnCurve(time, high, all);
    DrawnCurve spanned;
    if (window.positiveOnly) {
        const double least = farBelow * above.high;
        for (QVector<double>* values : {&below.value, &above.value})
            for (double& value : *values)
                value = value < least ? least : value;
        spanned.any = above.any && above.high > 0.0;
        spanned.low = spanned.high = above.high;
    } else {
        spanned.span(below);
        spanned.span(above);
    }
    band.low->setData(below.time, below.value, true);
    band.high->setData(above.time, above.value, true);
    return spanned;
}

void styleBand(const BandGraphs& band, const QColor& curve, const QColor& legend)
{
    for (QCPGraph* graph : {band.low, band.high})
        graph->setPen(QPen(faded(curve, edgeOpacity), 0.8));
    band.high->setBrush(faded(curve, opacity));
    static_cast<UpperEdge*>(band.high)->legendColor = legend; // as addBand() has made it
}

} // namespace ripstop
