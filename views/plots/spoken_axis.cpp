// A ticker that asks for the scale of the range in sight each time it makes marks, and a label that
// follows changes of that range.
#include "plots/spoken_axis.h"

#include "document/spoken.h"
#include "plots/chart_style.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int steps = 4; // over an axis, about

SpokenScale scaleOf(const AxisWords& words, const QCPRange& range)
{
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    return spokenScale(largest, words.unit.toStdString(), words.isShare);
}

class RoundTicker final : public QCPAxisTicker
{
public:
    explicit RoundTicker(AxisWords words)
        : m_words(std::move(words))
    {}

protected:
    double getTickStep(const QCPRange& range) override
    {
        m_scale = scaleOf(m_words, range);
        // nearer to the wanted number of marks than the next round step above would be
        m_step = roundStep(0.75 * range.size() / steps / m_scale.factor) * m_scale.factor;
        return m_step;
    }
    QString getTickLabel(double tick, const QLocale&, QChar, int) override
    {
        return m_scale.atStep(tick, m_step);
    }
    int getSubTickCount(double) override { return 0; }

private:
    AxisWords m_words;
    SpokenScale m_scale;
    double m_step = 1.0;
};

} // namespace

SpokenAxis::SpokenAxis(QCPAxis& axis)
    : QObject(&axis)
    , m_axis(axis)
{
    connect(&axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &SpokenAxis::label);
    setLogarithmic(false);
}

void SpokenAxis::say(const AxisWords& words)
{
    if (words == m_words)
        return label();
    m_words = words;
    setLogarithmic(m_axis.scaleType() == QCPAxis::stLogarithmic);
}

void SpokenAxis::setLogarithmic(bool logarithmic)
{
    m_axis.setScaleType(logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    QSharedPointer<QCPAxisTicker> ticker;
    if (logarithmic) {
        ticker.reset(new QCPAxisTickerLog);
        ticker->setTickCount(steps);
    } else {
        ticker.reset(new RoundTicker(m_words));
    }
    m_axis.setTicker(ticker);
    m_axis.setNumberFormat(QStringLiteral("gb"));
    m_axis.setNumberPrecision(3); // 80, not 8e+01
    label();
}

void SpokenAxis::label()
{
    const bool isPlain = m_axis.scaleType() == QCPAxis::stLogarithmic;
    const QString unit = isPlain ? m_words.unit : scaleOf(m_words, m_axis.range()).unit;
    m_axis.setLabel(m_words.name.isEmpty() ? unit : withUnit(m_words.name, unit));
}

} // namespace ripstop
