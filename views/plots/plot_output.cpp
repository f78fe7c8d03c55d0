#include "plots/plot_output.h"

#include "io/csv.h"

#include <QTextStream>

#include <cmath>

namespace ripstop {

void writeCurves(QIODevice& device, const History& history, const std::vector<Curve>& curves,
                 char separator)
{
    QTextStream out(&device);
    out << "time (s)";
    for (const Curve& curve : curves) {
        const QString name =
            curve.unit.isEmpty() ? curve.name : curve.name + " (" + curve.unit + ')';
        out << separator << QString::fromStdString(csvCell(name.toStdString(), separator));
    }
    out << '\n';
    const auto time = history.time();
    for (std::size_t i = 0; i < time.size(); ++i) {
        out << QString::number(time[i], 'g', QLocale::FloatingPointShortest);
        for (const Curve& curve : curves) {
            const auto values = history.valuesOf(curve.probe);
            out << separator;
            if (i < values.size() && !std::isnan(values[i]))
                out << QString::number(values[i], 'g', QLocale::FloatingPointShortest);
        }
        out << '\n';
    }
}

} // namespace ripstop
