// How long it takes to write a flight for other programs, without flying it.
//
// The cloth has 100 x 100 particles. Thirty moments of its fall are given again and again, to and
// fro, until they are 600 frames: what is written is that of a flight, and nothing is computed
// meanwhile.
#include "bench/races.h"
#include "bench/report.h"
#include "builders/builder.h"
#include "bundle/temporary_folder.h"
#include "compile/compile.h"
#include "export/export_run.h"
#include "export/format.h"
#include "simulation/simulation.h"

#include <chrono>
#include <ctime>

namespace ripstop {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int frames = 600;
constexpr double framesPerSecond = 60.0;

// Time of the processor is taken, because wall time has the shares of disks and other programs in
// it.
struct Cost
{
    double seconds;
    double processorSeconds;
};

const std::vector<Column> exportColumns{{"format", -14}, {"frames", 8},    {"MB", 10},
                                        {"s", 9},        {"ms/frame", 10}, {"processor s", 13}};

Result<std::vector<std::shared_ptr<Frame>>> moments(const Scene& scene, int count)
{
    const auto system = compile(scene);
    if (!system)
        return system.failure();
    Simulation simulation(*system);
    std::vector<std::shared_ptr<Frame>> moments;
    for (int i = 0; i < count && !interrupted(); ++i) {
        moments.push_back(simulation.frame());
        simulation.step();
        simulation.step();
    }
    return moments;
}

double megabytesIn(const fs::path& folder)
{
    double bytes = 0.0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            bytes += double(entry.file_size());
    return 1e-6 * bytes;
}

Result<Cost> write(const ExportFormat& format, const MeshAppearance& appearance,
                   const fs::path& folder, const std::vector<std::shared_ptr<Frame>>& moments)
{
    const auto start = Clock::now();
    const std::clock_t worked = std::clock();
    auto sink = openSink(format, folder / ("cloth" + std::string(format.ending)), appearance);
    if (!sink)
        return sink.failure();
    const int turn = 2 * int(moments.size()) - 2; // there and back
    for (int i = 0; i < frames; ++i) {
        if (interrupted())
            return exportCancelled;
        const int place = i % turn;
        Frame& frame = *moments[std::size_t(std::min(place, turn - place))];
        frame.time = i / framesPerSecond;
        if (auto failure = (*sink)->add(frame))
            return *failure;
    }
    if (auto failure = (*sink)->finish([](double) { return !interrupted(); }))
        return *failure;
    return Cost{std::chrono::duration<double>(Clock::now() - start).count(),
                double(std::clock() - worked) / CLOCKS_PER_SEC};
}

} // namespace

std::optional<Json> exportRace(const BenchOptions& options)
{
    if (!isWanted(options, "cloth_100"))
        return Json::object();
    auto scene = build(*findBuilder("cloth"), {{"columns", 99}, {"rows", 99}});
    if (!scene)
        return std::nullopt;
    const auto flown = moments(*scene, options.quick ? 5 : 30);
    if (!flown || interrupted())
        return std::nullopt;
    const MeshAppearance appearance(*scene);
    Json rows = Json::array();
    Table table("Export of 600 frames of a cloth of 100 x 100 particles", exportColumns,
                !options.json);
    for (const ExportFormat& format : exportFormats()) {
        if (format.of != ExportFormat::Of::Series)
            continue;
        const auto folder = TemporaryFolder::make(fs::temp_directory_path() / "ripstop-bench");
        const auto cost = folder ? write(format, appearance, folder->path(), *flown)
                                 : Result<Cost>(folder.failure());
        if (interrupted())
            return std::nullopt;
        if (!cost) {
            (void)fail(BadInput, cost.message());
            continue;
        }
        const double megabytes = megabytesIn(folder->path());
        const std::string ending(format.ending);
        table.row({ending, std::to_string(frames), fixed(megabytes, 1), fixed(cost->seconds, 2),
                   fixed(1e3 * cost->seconds / frames, 2), fixed(cost->processorSeconds, 2)});
        rows.push_back({{"network", "cloth_100"},
                        {"format", ending},
                        {"frames", frames},
                        {"megabytes", megabytes},
                        {"seconds", cost->seconds},
                        {"processor_seconds", cost->processorSeconds}});
    }
    return Json{{"export", rows}};
}

} // namespace ripstop
