#include "plots/curve_views.h"

#include "plots/spectrum.h"

#include <cmath>

namespace ripstop {
namespace {

constexpr std::size_t mostPoints = 4000; // of a curve

XyCurve against(const History& history, const Curve& curve, std::uint32_t across)
{
    const auto x = history.valuesOf(across);
    const auto y = history.valuesOf(curve.probe);
    XyCurve points{curve.name, curve.color, {}, {}};
    const std::size_t count = std::min(x.size(), y.size());
    for (std::size_t i = 0; i < count; i += count / mostPoints + 1)
        if (std::isfinite(x[i]) && std::isfinite(y[i])) {
            points.x.push_back(x[i]);
            points.y.push_back(y[i]);
        }
    return points;
}

XyCurve linesOf(const History& history, const Curve& curve)
{
    Spectrum spectrum = spectrumOf(history.time(), history.valuesOf(curve.probe));
    return {curve.name, curve.color, std::move(spectrum.frequency), std::move(spectrum.amplitude)};
}

// Curves of earlier runs come first, so that the present run lies above them.
template <typename Make>
std::vector<XyCurve> ofAllRuns(const History& history, const std::vector<EarlierRun>& earlier,
                               const std::vector<Curve>& curves, Make make)
{
    std::vector<XyCurve> all;
    for (const EarlierRun& run : earlier)
        for (const Curve& curve : curves) {
            all.push_back(make(*run.history, curve));
            all.back().name = QStringLiteral("%1, %2").arg(curve.name, run.name);
            all.back().past = true;
        }
    for (const Curve& curve : curves)
        all.push_back(make(history, curve));
    return all;
}

} // namespace

std::vector<XyCurve> phaseCurves(const History& history, const std::vector<EarlierRun>& earlier,
                                 const std::vector<Curve>& curves, std::uint32_t across)
{
    return ofAllRuns(history, earlier, curves, [across](const History& run, const Curve& curve) {
        return against(run, curve, across);
    });
}

std::vector<XyCurve> spectra(const History& history, const std::vector<EarlierRun>& earlier,
                             const std::vector<Curve>& curves)
{
    return ofAllRuns(history, earlier, curves,
                     [](const History& run, const Curve& curve) { return linesOf(run, curve); });
}

} // namespace ripstop
