// A ticker that asks for the scale of the range in sight each time it makes marks, and a label that
// follows changes of that range.
#include "plots/spoken_axis.h"

#include "document/spoken.h"
#include "plots/chart_style.h"

#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

constexpr int steps = 4; // over an axis, about
constexpr int mostOfDecades = 6;

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

// 1, 2 and 5 times the powers of ten, or fewer of them where they would be too many; QCustomPlot's
// own marks of less than a few decades are evenly spaced, and lie upon each other at the upper end.
class DecadeTicker final : public QCPAxisTicker
{
protected:
    QVector<double> createTickVector(double step, const QCPRange& range) override
    {
        constexpr double narrow = 5.0; // where even steps stand apart
        if (range.upper < narrow * range.lower)
            return QCPAxisTicker::createTickVector(step, range);
        for (const int mantissas : {3, 1})
            if (const QVector<double> marks = marksIn(range, mantissas, 1);
                marks.size() <= tickCount())
                return marks;
        const double decades = std::log10(range.upper / range.lower);
        return marksIn(range, 1, int(std::ceil(decades / tickCount())));
    }
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override
    {
        return tick >= 1e-3 && tick < 1e6
                   ? spokenNumber(tick)
                   : QCPAxisTicker::getTickLabel(tick, locale, format, precision);
    }
    int getSubTickCount(double) override { return 0; }

private:
    static QVector<double> marksIn(const QCPRange& range, int mantissas, int everyDecade)
    {
        QVector<double> marks;
        if (!(range.lower > 0.0))
            return marks;
        const auto first = int(std::floor(std::log10(range.lower)));
        for (int decade = first; std::pow(10.0, decade) <= range.upper; ++decade)
            for (int i = 0; i < mantissas && decade % everyDecade == 0; ++i)
                if (const double mark =
                        std::array{1.0, 2.0, 5.0}[std::size_t(i)] * std::pow(10.0, decade);
                    range.contains(mark))
                    marks << mark;
        return marks;
    }
};

} // namespace

QSharedPointer<QCPAxisTicker> decadeTicker(int mostMarks)
{
    const QSharedPointer<QCPAxisTicker> ticker(new DecadeTicker);
    ticker->setTickCount(mostMarks);
    return ticker;
}

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
    m_axis.setTicker(logarithmic ? decadeTicker(mostOfDecades)
                                 : QSharedPointer<QCPAxisTicker>(new RoundTicker(m_words)));
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
