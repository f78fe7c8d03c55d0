#include "plots/plot_output.h"

#include "io/csv.h"
#include "plots/chart_style.h"
#include "plots/error_bands.h"

#include <QTextStream>

#include <cmath>

namespace ripstop {
namespace {

void writeName(QTextStream& out, const QString& name, const QString& unit, char separator)
{
    const std::string cell = withUnit(name, unit).toStdString();
    out << separator << QString::fromStdString(csvCell(cell, separator));
}

void writeNumber(QTextStream& out, double value, char separator)
{
    out << separator;
    if (!std::isnan(value))
        out << QString::number(value, 'g', QLocale::FloatingPointShortest);
}

double at(std::span<const double> values, std::size_t i)
{
    return i < values.size() ? values[i] : std::nan("");
}

} // namespace

void writeCurves(QIODevice& device, const History& history, const std::vector<Curve>& curves,
                 const ErrorBands* bands, char separator)
{
    const auto bandOf = [&](const Curve& curve) {
        return bands ? bands->of(curve.probe) : ErrorBands::Band();
    };
    QTextStream out(&device);
    out << "time (s)";
    for (const Curve& curve : curves) {
        writeName(out, curve.name, curve.unit, separator);
        if (!bandOf(curve).low.empty())
            writeName(out, curve.name + " error", curve.unit, separator);
    }
    out << '\n';
    const auto time = history.time();
    for (std::size_t i = 0; i < time.size(); ++i) {
        out << QString::number(time[i], 'g', QLocale::FloatingPointShortest);
        for (const Curve& curve : curves) {
            writeNumber(out, at(history.valuesOf(curve.probe), i), separator);
            if (const auto band = bandOf(curve); !band.low.empty())
                writeNumber(out, 0.5 * (at(band.high, i) - at(band.low, i)), separator);
        }
        out << '\n';
    }
}

} // namespace ripstop
