// The range is checked, a sink of the format is opened, and frames are taken from the source one
// after the other. Finishing the sink is the last fifth of the
// progress.
#include "export/export_run.h"

#include "export/format.h"
#include "export/moment.h"
#include "io/whole_file.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

const Failure exportCancelled{"It was cancelled; what was written has been removed."};

namespace {

namespace fs = std::filesystem;

constexpr double shareOfFlight = 0.8; // of the progress; the rest is writing

Failure unknownFormat(const fs::path& target)
{
    return Failure("%1 has no known ending: %2.", target.string(), knownEndings(EndingsOf::All));
}

// Progress from the time of the source to `end`, s.
FrameSource::Reached told(const FrameSource& source, double end, const Progress& progress)
{
    const double begin = source.begin();
    return [=, &progress](double time) {
        return goesOn(progress, std::clamp((time - begin) / std::max(end - begin, 1e-9), 0.0, 1.0));
    };
}

std::optional<Failure> exportMoment(FrameSource& source, const MeshAppearance& appearance,
                                    const ExportRange& range, const fs::path& target,
                                    const Progress& progress)
{
    const auto taken = source.take(range.to, told(source, range.to, progress));
    if (!taken.end.empty())
        return Failure("%1 Nothing was written.", taken.end);
    if (!taken.frame)
        return Failure{"It was cancelled; nothing was written."};
    if (auto failure = writeMoment(*taken.frame, appearance, target))
        return failure;
    if (progress)
        progress(1.0);
    return std::nullopt;
}

std::optional<Failure> wrongRange(const FrameSource& source, const ExportRange& range)
{
    if (!(range.fps > 0.0) || !std::isfinite(range.fps))
        return Failure{"The number of frames per second must be above 0."};
    if (!std::isfinite(range.from) || !std::isfinite(range.to) || range.to < range.from)
        return Failure{"The end of the range must not lie before its start."};
    const double halfStep = 0.5 * source.timeStep();
    if (range.from < source.begin() - halfStep)
        return Failure("The range starts at %1, but the run begins only at %2.",
                       inSeconds(range.from), inSeconds(source.begin()));
    if (range.from > source.end() + halfStep)
        return Failure("The range starts at %1, but the run ends at %2.", inSeconds(range.from),
                       inSeconds(source.end()));
    return std::nullopt;
}

} // namespace

std::optional<Failure> exportSeries(FrameSource& source, const ExportRange& range, FrameSink& sink,
                                    const Progress& progress)
{
    if (auto failure = wrongRange(source, range))
        return failure;
    const Progress flight = stageOf(progress, 0.0, shareOfFlight);
    const auto reached = told(source, range.to, flight);
    const std::size_t count = frameCount(range);
    sink.certify(source.certificate());
    std::int64_t last = -1; // step
    Message end;
    for (std::size_t i = 0; i < count && end.empty(); ++i) {
        const auto taken = source.take(range.from + double(i) / range.fps, reached);
        end = taken.end;
        if (end.empty() && !(taken.frame && reached(taken.frame->time)))
            return exportCancelled;
        if (taken.frame && (range.repeats || taken.frame->step != last)) {
            if (auto failure = sink.add(*taken.frame))
                return failure;
            last = taken.frame->step;
        }
    }
    if (last < 0)
        return Failure("%1 Nothing was written.", end);
    if (auto failure = sink.finish(stageOf(progress, shareOfFlight, 1.0)))
        return failure;
    if (progress)
        progress(1.0);
    if (!end.empty())
        return Failure("%1 What was written ends there.", end);
    return std::nullopt;
}

std::size_t frameCount(const ExportRange& range)
{
    return std::size_t(std::floor((range.to - range.from) * range.fps + 1e-9)) + 1;
}

std::size_t frameCount(const ExportRange& range, double timeStep)
{
    ExportRange ofSteps = range;
    if (!range.repeats)
        ofSteps.fps = std::min(range.fps, 1.0 / timeStep);
    return frameCount(ofSteps);
}

std::optional<Failure> writeMoment(const Frame& frame, const MeshAppearance& appearance,
                                   const fs::path& target)
{
    const ExportFormat* format = formatOf(target);
    if (!format)
        return unknownFormat(target);
    if (!format->content)
        return Failure("%1 is a series; for one moment %2.", target.string(),
                       knownEndings(EndingsOf::Moments));
    auto content = format->content(frame, appearance);
    if (!content)
        return content.failure();
    if (const auto materials = objMaterials(target, appearance)) {
        *content = materials->line + *content;
        if (auto failure = replaceFile(materials->file, materials->text, Flush::Later))
            return failure;
    }
    return replaceFile(target, *content, Flush::Later);
}

std::optional<Failure> exportRun(FrameSource& source, const MeshAppearance& appearance,
                                 const ExportRange& range, const fs::path& target,
                                 const Progress& progress)
{
    const ExportFormat* format = formatOf(target);
    if (!format)
        return unknownFormat(target);
    const bool isMoment = format->of == ExportFormat::Of::Moment;
    ExportRange whole = range;
    whole.repeats = format->isPaced;
    if (isMoment)
        whole.from = whole.to;
    if (auto failure = wrongRange(source, whole))
        return failure;
    if (isMoment)
        return exportMoment(source, appearance, whole, target, progress);
    Result<std::unique_ptr<FrameSink>> sink = openSink(*format, target, appearance);
    return sink ? exportSeries(source, whole, **sink, progress) : sink.failure();
}

} // namespace ripstop
