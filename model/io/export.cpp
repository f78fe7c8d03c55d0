#include "io/export.h"

#include "io/csv.h"
#include "io/json_text.h"
#include "io/whole_file.h"

#include <cmath>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

using WriteFrame = std::function<std::optional<Failure>(const Frame&, const fs::path&)>;

WriteFrame writerOfOneMoment(const std::string& extension, const Scene* scene)
{
    if (extension == ".obj")
        return [scene](const Frame& frame, const fs::path& file) {
            return writeObj(frame, file, scene);
        };
    if (extension == ".ply")
        return writePly;
    if (extension == ".vtp")
        return writeVtp;
    return {};
}

const Failure cancelled{"The export was cancelled and what was written has been removed."};

Failure stopped(const Simulation& simulation, const std::string& rest)
{
    return Failure{"The simulation stopped: " + simulation.trouble()->message + " " + rest};
}

enum class Arrival { There, Cancelled, Stopped };

// Steps to `time`, like Simulation::runUntil(), and tells of progress on the way.
Arrival advance(Simulation& simulation, double time, double begin, double end,
                const Progress& progress)
{
    constexpr int stepsBetweenReports = 50;
    const double timeStep = simulation.system().timeStep;
    for (int i = 0; !hasReached(simulation.state().time, time, timeStep); ++i) {
        if (progress && i % stepsBetweenReports == 0
            && !progress((simulation.state().time - begin) / std::max(end - begin, 1e-9)))
            return Arrival::Cancelled;
        if (!simulation.step())
            return Arrival::Stopped;
    }
    return Arrival::There;
}

std::optional<Failure> exportMoment(Simulation& simulation, const ExportRange& range,
                                    const fs::path& target, const WriteFrame& write,
                                    const Progress& progress)
{
    const double begin = simulation.state().time;
    switch (advance(simulation, range.to, begin, range.to, progress)) {
    case Arrival::Cancelled:
        return Failure{"The export was cancelled; nothing was written."};
    case Arrival::Stopped:
        return stopped(simulation, "Nothing was written.");
    case Arrival::There:
        break;
    }
    if (auto failure = write(*simulation.frame(), target))
        return failure;
    if (progress)
        progress(1.0);
    return std::nullopt;
}

// Calls add(frame) for each frame of the range; add returns a failure or nothing.
template <typename Add>
std::optional<Failure> forEachFrame(Simulation& simulation, const ExportRange& range,
                                    const Progress& progress, Add add)
{
    const double begin = simulation.state().time;
    const auto count = std::llround(std::floor((range.to - range.from) * range.fps + 1e-9)) + 1;
    std::int64_t last = -1; // step; a rate above that of the steps must not repeat frames
    for (long long i = 0; i < count; ++i) {
        const Arrival arrival =
            advance(simulation, range.from + double(i) / range.fps, begin, range.to, progress);
        if (arrival == Arrival::Cancelled)
            return cancelled;
        if (simulation.state().step != last)
            if (auto failure = add(*simulation.frame()))
                return failure;
        last = simulation.state().step;
        if (arrival == Arrival::Stopped)
            break;
    }
    if (progress && !progress(1.0))
        return cancelled;
    return std::nullopt;
}

std::optional<Failure> exportTable(Simulation& simulation, const ExportRange& range,
                                   const fs::path& target, const Progress& progress)
{
    const auto layout = simulation.frame()->layout;
    if (layout->probes.empty())
        return Failure{"The scene has no probes, so there is nothing to put into " + target.string()
                       + "; add a probe first."};
    Result<CsvWriter> table = CsvWriter::open(target, *layout);
    if (!table)
        return table.failure();
    auto failure = forEachFrame(simulation, range, progress,
                                [&](const Frame& frame) -> std::optional<Failure> {
                                    table->add(frame);
                                    return std::nullopt;
                                });
    if (!failure)
        failure = table->close();
    if (failure) {
        std::error_code ignored;
        fs::remove(target, ignored);
    }
    return failure;
}

std::string xmlText(const std::string& text)
{
    std::string escaped;
    for (const char c : text)
        switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += c;
        }
    return escaped;
}

// The index kite.pvd and the moments kite/kite_0000.vtp, ...
std::optional<Failure> exportSeries(Simulation& simulation, const ExportRange& range,
                                    const fs::path& target, const Progress& progress)
{
    const std::string stem = target.stem().string();
    const fs::path folder = target.parent_path() / stem;
    std::error_code error;
    const bool newFolder = fs::create_directory(folder, error);
    if (error || !fs::is_directory(folder))
        return Failure{"The folder " + folder.string() + " for the series cannot be made: "
                       + error.message() + "; choose another target."};

    std::vector<fs::path> written;
    std::string index = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                        "<Collection>\n";
    auto failure = forEachFrame(
        simulation, range, progress, [&](const Frame& frame) -> std::optional<Failure> {
            std::string number = std::to_string(written.size());
            number.insert(0, std::string(number.size() < 4 ? 4 - number.size() : 0, '0'));
            std::string name = stem;
            name.append("_").append(number).append(".vtp");
            written.push_back(folder / name);
            index += "<DataSet timestep=\"";
            appendNumber(index, frame.time);
            index += R"(" part="0" file=")" + xmlText(stem) + "/" + xmlText(name) + "\"/>\n";
            return writeVtp(frame, written.back());
        });
    if (!failure)
        failure = replaceFile(target, index + "</Collection>\n</VTKFile>\n");
    if (failure) {
        for (const fs::path& file : written)
            fs::remove(file, error);
        if (newFolder)
            fs::remove(folder, error); // only when it is empty
    }
    return failure;
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

std::optional<Failure> exportRun(Simulation& simulation, const ExportRange& range,
                                 const fs::path& target, const Progress& progress)
{
    const std::string extension = target.extension().string();
    ExportRange whole = range;
    if (const WriteFrame write = writerOfOneMoment(extension, range.scene)) {
        whole.from = whole.to;
        if (auto failure = wrongRange(simulation, whole))
            return failure;
        return exportMoment(simulation, whole, target, write, progress);
    }
    if (extension != ".pvd" && extension != ".csv")
        return Failure{target.string()
                       + " has no known extension: use .obj, .ply or .vtp for one moment, .pvd for "
                         "a series, .csv for the probes."};
    if (auto failure = wrongRange(simulation, whole))
        return failure;
    auto failure = extension == ".pvd" ? exportSeries(simulation, range, target, progress)
                                       : exportTable(simulation, range, target, progress);
    if (!failure && simulation.trouble())
        return stopped(simulation, "What was written ends there.");
    return failure;
}

} // namespace ripstop
