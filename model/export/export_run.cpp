#include "export/export_run.h"

#include "export/format.h"
#include "io/whole_file.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

const Failure exportCancelled{"The export was cancelled and what was written has been removed."};

namespace {

namespace fs = std::filesystem;

constexpr double shareOfFlight = 0.8; // of the progress; the rest is writing

Failure stopped(const Simulation& simulation, const std::string& rest)
{
    return Failure{"The simulation stopped: " + simulation.trouble()->message + " " + rest};
}

Failure unknownFormat(const fs::path& target)
{
    return Failure{target.string() + " has no known ending: " + knownEndings(EndingsOf::All) + "."};
}

enum class Arrival { There, Cancelled, Stopped };

double shareDone(const Simulation& simulation, double begin, double end)
{
    return std::min((simulation.state().time - begin) / std::max(end - begin, 1e-9), 1.0);
}

// Steps to `time`, like Simulation::runUntil(), and tells of progress on the way.
Arrival advance(Simulation& simulation, ControlPlayer& controls, double time, double begin,
                double end, const Progress& progress)
{
    constexpr int stepsBetweenReports = 50;
    const double timeStep = simulation.system().timeStep;
    for (int i = 0; !hasReached(simulation.state().time, time, timeStep); ++i) {
        if (i % stepsBetweenReports == 0 && !goesOn(progress, shareDone(simulation, begin, end)))
            return Arrival::Cancelled;
        controls.giveTo(simulation);
        if (!simulation.step())
            return Arrival::Stopped;
    }
    return Arrival::There;
}

std::optional<Failure> exportMoment(Simulation& simulation, const Dress& dress,
                                    const ExportRange& range, const fs::path& target,
                                    const Progress& progress)
{
    const double begin = simulation.state().time;
    ControlPlayer controls(range.controls);
    switch (advance(simulation, controls, range.to, begin, range.to, progress)) {
    case Arrival::Cancelled:
        return Failure{"The export was cancelled; nothing was written."};
    case Arrival::Stopped:
        return stopped(simulation, "Nothing was written.");
    case Arrival::There:
        break;
    }
    if (auto failure = writeMoment(*simulation.frame(), dress, target))
        return failure;
    if (progress)
        progress(1.0);
    return std::nullopt;
}

std::optional<Failure> wrongRange(const Simulation& simulation, const ExportRange& range)
{
    if (!(range.fps > 0.0) || !std::isfinite(range.fps))
        return Failure{"The number of frames per second must be above 0."};
    if (!std::isfinite(range.from) || !std::isfinite(range.to) || range.to < range.from)
        return Failure{"The end of the range must not lie before its start."};
    const double halfStep = 0.5 * simulation.system().timeStep;
    if (range.from < simulation.state().time - halfStep)
        return Failure{"The range starts before the present time of the simulation; reset it."};
    return std::nullopt;
}

} // namespace

std::optional<Failure> exportSeries(Simulation& simulation, const ExportRange& range,
                                    FrameSink& sink, const Progress& progress)
{
    if (auto failure = wrongRange(simulation, range))
        return failure;
    ControlPlayer controls(range.controls);
    const Progress flight = stageOf(progress, 0.0, shareOfFlight);
    const double begin = simulation.state().time;
    const std::size_t count = frameCount(range);
    std::int64_t last = -1; // step; a rate above that of the steps must not repeat frames
    for (std::size_t i = 0; i < count; ++i) {
        const Arrival arrival = advance(simulation, controls, range.from + double(i) / range.fps,
                                        begin, range.to, flight);
        if (arrival == Arrival::Cancelled
            || !goesOn(flight, shareDone(simulation, begin, range.to)))
            return exportCancelled;
        if (simulation.state().step != last)
            if (auto failure = sink.add(*simulation.frame()))
                return failure;
        last = simulation.state().step;
        if (arrival == Arrival::Stopped)
            break;
    }
    if (auto failure = sink.finish(stageOf(progress, shareOfFlight, 1.0)))
        return failure;
    if (progress)
        progress(1.0);
    if (simulation.trouble())
        return stopped(simulation, "What was written ends there.");
    return std::nullopt;
}

std::size_t frameCount(const ExportRange& range)
{
    return std::size_t(std::floor((range.to - range.from) * range.fps + 1e-9)) + 1;
}

std::optional<Failure> writeMoment(const Frame& frame, const Dress& dress, const fs::path& target)
{
    const ExportFormat* format = formatOf(target);
    if (!format)
        return unknownFormat(target);
    if (!format->content)
        return Failure{target.string() + " is a series; for one moment "
                       + knownEndings(EndingsOf::Moments) + "."};
    const auto content = format->content(frame, dress);
    return content ? replaceFile(target, *content, Flush::Later) : content.failure();
}

std::optional<Failure> exportRun(Simulation& simulation, const Dress& dress,
                                 const ExportRange& range, const fs::path& target,
                                 const Progress& progress)
{
    const ExportFormat* format = formatOf(target);
    if (!format)
        return unknownFormat(target);
    const bool isMoment = format->of == ExportFormat::Of::Moment;
    ExportRange whole = range;
    if (isMoment)
        whole.from = whole.to;
    if (auto failure = wrongRange(simulation, whole))
        return failure;
    if (isMoment)
        return exportMoment(simulation, dress, whole, target, progress);
    Result<std::unique_ptr<FrameSink>> sink = openSink(*format, target, dress);
    return sink ? exportSeries(simulation, whole, **sink, progress) : sink.failure();
}

} // namespace ripstop
