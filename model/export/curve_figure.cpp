// add() collects: times, a curve for each probe by its id with gaps where it was not read, and the
// tears of the newest frame, which lists all since the start. Nothing is drawn before finish(),
// since the axes need the extremes of the whole series.
//
// text() then groups the curves by unit and draws a panel for each unit below the other, over one
// axis of time. drawPanel() settles the axis of values at round numbers and draws grid, marks of
// tears, names and curves; drawCurve() takes the samples that drawnSamples() leaves and lifts the
// pen at gaps, over the band of what the values may be off by where that is known. OutputFiles puts
// the figure into its place.
#include "export/curve_figure.h"

#include "base/program_version.h"
#include "export/output_files.h"
#include "export/xml_text.h"
#include "io/csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace ripstop {
namespace {

// Lengths in pixels of the figure.
constexpr double width = 720.0;
constexpr double panelHeight = 170.0;
constexpr double left = 76.0, right = 16.0, above = 26.0, below = 24.0;
constexpr double axisHeight = 24.0; // labels of the time, below the last panel
constexpr double plotWidth = width - left - right;
constexpr double plotHeight = panelHeight - above - below;

// Okabe and Ito 2008: told apart by all eyes.
constexpr std::array colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                            "#56b4e9", "#e69f00", "#000000"};

struct Curve
{
    Layout::Probe probe;
    std::vector<double> values; // [samples] NaN where nothing was read
    std::vector<double> errors; // [samples] the same, where nothing is certified
};

struct Axis
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    double step = 1.0;

    void take(double value)
    {
        if (!std::isfinite(value))
            return;
        low = std::min(low, value);
        high = std::max(high, value);
    }

    // Ends at round numbers, with about `count` steps between them.
    void settle(int count)
    {
        if (!(low <= high))
            low = 0.0, high = 1.0;
        const double least = 1e-9 * std::max({std::abs(low), std::abs(high), 1e-3});
        if (high - low < least) {
            low -= 0.5 * std::max(std::abs(low), 1.0);
            high += 0.5 * std::max(std::abs(high), 1.0);
        }
        const double rough = (high - low) / count;
        const double power = std::pow(10.0, std::floor(std::log10(rough)));
        step = power
               * (rough < 1.5 * power   ? 1.0
                  : rough < 3.5 * power ? 2.0
                  : rough < 7.5 * power ? 5.0
                                        : 10.0);
        low = step * std::floor(low / step + 1e-9);
        high = step * std::ceil(high / step - 1e-9);
    }

    int ticks() const { return int(std::round((high - low) / step)) + 1; }
    double tick(int i) const
    {
        const double value = low + i * step;
        return std::abs(value) < 1e-9 * step ? 0.0 : value;
    }
    double share(double value) const { return (value - low) / (high - low); }
};

std::string printed(const char* format, double number)
{
    char text[32];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

std::string pixels(double number) { return printed("%.2f", number); }
std::string label(double number) { return printed("%.6g", number); }

std::string line(double x1, double y1, double x2, double y2, const char* color)
{
    return "<line x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" + pixels(x2)
           + "\" y2=\"" + pixels(y2) + "\" stroke=\"" + color + "\"/>\n";
}

std::string words(double x, double y, const char* anchor, const std::string& text,
                  const char* color = "#333")
{
    return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" + anchor
           + "\" fill=\"" + color + "\">" + xmlText(text) + "</text>\n";
}

// Where a column of pixels has many samples, its least and its greatest stand for all.
std::vector<std::size_t> drawnSamples(const std::vector<double>& values)
{
    constexpr auto columns = std::size_t(plotWidth);
    std::vector<std::size_t> drawn;
    const std::size_t each = values.size() / columns + 1;
    for (std::size_t first = 0; first < values.size(); first += each) {
        const std::size_t last = std::min(first + each, values.size());
        std::size_t least = first, most = first;
        for (std::size_t i = first; i < last; ++i) {
            if (values[i] < values[least] || std::isnan(values[least]))
                least = i;
            if (values[i] > values[most] || std::isnan(values[most]))
                most = i;
        }
        drawn.push_back(std::min(least, most));
        if (least != most)
            drawn.push_back(std::max(least, most));
    }
    return drawn;
}

class Figure final : public FrameSink
{
public:
    explicit Figure(std::filesystem::path target)
        : m_target(std::move(target))
    {}

    void certify(std::shared_ptr<const Certificate> certificate) override
    {
        m_certificate = std::move(certificate);
    }

    std::optional<Failure> add(const Frame& frame) override
    {
        if (frame.layout->probes.empty())
            return Failure(
                "The scene has no probes, so there is nothing to draw in %1; add a probe "
                "first.",
                m_target.string());
        m_time.push_back(frame.time);
        for (std::size_t i = 0; i < frame.probe.size(); ++i) {
            Curve& curve = curveOf(frame.layout->probes[i]);
            curve.values.resize(m_time.size() - 1, std::numeric_limits<double>::quiet_NaN());
            curve.values.push_back(frame.probe[i]);
            curve.errors.resize(m_time.size() - 1, std::numeric_limits<double>::quiet_NaN());
            curve.errors.push_back(m_certificate
                                       ? m_certificate->errorAt(curve.probe.name, frame.time)
                                       : std::numeric_limits<double>::quiet_NaN());
        }
        m_tears.clear();
        for (const Tear& tear : frame.tears)
            m_tears.push_back(tear.time);
        return std::nullopt;
    }

    std::optional<Failure> finish(const Progress&) override
    {
        OutputFiles files;
        if (auto failure = files.write(m_target, text()))
            return failure;
        return files.commit();
    }

private:
    Curve& curveOf(const Layout::Probe& probe)
    {
        const auto found = std::ranges::find_if(
            m_curves, [&](const Curve& curve) { return curve.probe.id == probe.id; });
        return found != m_curves.end() ? *found : m_curves.emplace_back(Curve{probe, {}, {}});
    }

    // In the order of the probes, those of a unit together.
    std::vector<std::vector<const Curve*>> panels() const
    {
        std::vector<std::vector<const Curve*>> panels;
        for (const Curve& curve : m_curves) {
            const auto same = std::ranges::find_if(panels, [&](const auto& panel) {
                return panel.front()->probe.unit == curve.probe.unit;
            });
            if (same != panels.end())
                same->push_back(&curve);
            else
                panels.push_back({&curve});
        }
        return panels;
    }

    std::string text() const
    {
        const auto all = panels();
        const double height = panelHeight * double(all.size()) + axisHeight;
        std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + pixels(width)
                          + " " + pixels(height) + "\" width=\"" + pixels(width) + "\" height=\""
                          + pixels(height)
                          + "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                            "<title>Ripstop "
                          + std::string(releaseVersion())
                          + "</title>\n"
                            "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
        Axis time;
        time.take(m_time.front());
        time.take(m_time.back());
        time.settle(8);
        double top = 0.0;
        for (const auto& panel : all) {
            drawPanel(svg, panel, time, top);
            top += panelHeight;
        }
        svg += words(left + 0.5 * plotWidth, height - 8.0, "middle", "time (s)");
        return svg + "</svg>\n";
    }

    void drawPanel(std::string& svg, const std::vector<const Curve*>& curves, const Axis& time,
                   double top) const
    {
        Axis value;
        for (const Curve* curve : curves)
            for (std::size_t i = 0; i < curve->values.size(); ++i) {
                value.take(curve->values[i]);
                value.take(curve->values[i] - curve->errors[i]);
                value.take(curve->values[i] + curve->errors[i]);
            }
        value.settle(4);
        const double y0 = top + above, y1 = y0 + plotHeight;
        const auto x = [&](double t) { return left + plotWidth * time.share(t); };
        const auto y = [&](double v) { return y1 - plotHeight * value.share(v); };
        for (int i = 0; i < value.ticks(); ++i) {
            const double place = y(value.tick(i));
            svg += line(left, place, left + plotWidth, place, "#ddd");
            svg += words(left - 6.0, place + 4.0, "end", label(value.tick(i)));
        }
        for (int i = 0; i < time.ticks(); ++i) {
            const double place = x(time.tick(i));
            svg += line(place, y1, place, y1 + 4.0, "#333");
            svg += words(place, y1 + 17.0, "middle", label(time.tick(i)));
        }
        for (const double tear : m_tears)
            svg += line(x(tear), y0, x(tear), y0 + 8.0, "#c00");
        svg += line(left, y0, left, y1, "#333") + line(left, y1, left + plotWidth, y1, "#333");
        double at = left;
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const char* color = colors[i % colors.size()];
            const Layout::Probe& probe = curves[i]->probe;
            const std::string name = withUnit(probe.name, probe.unit);
            svg += words(at, y0 - 8.0, "start", name, color);
            at += 7.0 * double(name.size()) + 16.0; // letters are not wider than that
            drawBand(svg, *curves[i], color, x, y);
            drawCurve(svg, curves[i]->values, color, x, y);
        }
    }

    // Forth along the upper edge and back along the lower one; a value that is not certified ends a
    // piece of it.
    void drawBand(std::string& svg, const Curve& curve, const char* color, auto x, auto y) const
    {
        std::string forth, back;
        const auto finishPiece = [&] {
            if (!forth.empty())
                svg += "<path stroke=\"none\" fill=\"" + std::string(color)
                       + "\" fill-opacity=\"0.2\" d=\"M" + forth.substr(2) + back + " Z\"/>\n";
            forth.clear();
            back.clear();
        };
        for (const std::size_t i : drawnSamples(curve.values)) {
            const double value = curve.values[i], error = curve.errors[i];
            if (!std::isfinite(value) || !std::isfinite(error)) {
                finishPiece();
                continue;
            }
            const std::string at = " L" + pixels(x(m_time[i])) + " ";
            forth += at + pixels(y(value + error));
            back = at + pixels(y(value - error)) + back;
        }
        finishPiece();
    }

    void drawCurve(std::string& svg, const std::vector<double>& values, const char* color, auto x,
                   auto y) const
    {
        bool pen = false;
        svg +=
            "<path fill=\"none\" stroke=\"" + std::string(color) + "\" stroke-width=\"1.5\" d=\"";
        for (const std::size_t i : drawnSamples(values)) {
            if (std::isfinite(values[i])) {
                svg += pen ? " L" : " M";
                svg += pixels(x(m_time[i])) + " " + pixels(y(values[i]));
            }
            pen = std::isfinite(values[i]);
        }
        svg += "\"/>\n";
    }

    std::filesystem::path m_target;
    std::shared_ptr<const Certificate> m_certificate; // or null
    std::vector<double> m_time;                       // s
    std::vector<double> m_tears;                      // s
    std::vector<Curve> m_curves;
};

} // namespace

Result<std::unique_ptr<FrameSink>> figureSink(const std::filesystem::path& target,
                                              const MeshAppearance&)
{
    return std::unique_ptr<FrameSink>(std::make_unique<Figure>(target));
}

} // namespace ripstop
