// The numbers and the unit of an axis as people say them: round steps, no exponents, and the prefix
// that leaves numbers one can read, which follows the range that is in sight.
//
// A logarithmic axis has powers of ten in the unit itself. Values stay in that unit, in the chart
// and in what is saved of it; only what is written beside the axis is said otherwise. One of these
// belongs to its axis and lives as long as it does.
#pragma once

#include <QObject>
#include <QSharedPointer>
#include <QString>

class QCPAxis;
class QCPAxisTicker;

namespace ripstop {

// What an axis is of.
struct AxisWords
{
    QString name;         // may be empty
    QString unit;         // of the values; empty when dimensionless
    bool isShare = false; // said in percent

    friend bool operator==(const AxisWords&, const AxisWords&) = default;
};

class SpokenAxis final : public QObject
{
    Q_OBJECT

public:
    explicit SpokenAxis(QCPAxis& axis);

    void say(const AxisWords& words);
    // Evenly or logarithmic, with round numbers; also takes the place of other marks.
    void setLogarithmic(bool logarithmic);

private:
    void label();

    QCPAxis& m_axis;
    AxisWords m_words;
};

// Marks of a logarithmic axis that are no more than so many and stand apart.
QSharedPointer<QCPAxisTicker> decadeTicker(int mostMarks);

} // namespace ripstop
