// A bundle is flown or replayed into a folder beside the target: files of colliders are copied,
// probes are written on the way, then scene, controls, recording, readme and last the manifest.
// Only then is it zipped and renamed into its place. What a killed process leaves is one folder
// beside the target, which the next one removes.
#include "base/program_version.h"
#include "bundle/bundle.h"

#include "base/hash_text.h"
#include "base/lower_case.h"
#include "base/new_file.h"
#include "bundle/manifest.h"
#include "bundle/readme.h"
#include "bundle/zip_file.h"
#include "compile/compile.h"
#include "derived/named_files.h"
#include "export/export_run.h"
#include "export/format.h"
#include "io/recording_file.h"
#include "io/scene_file.h"
#include "io/whole_file.h"
#include "recording/recorder.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

bool isZipName(const fs::path& target) { return lowerCase(target.extension().string()) == ".zip"; }

// "out/" is the folder out.
fs::path plain(const fs::path& target)
{
    const fs::path path = target.lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

std::optional<Failure> whyNotThere(const fs::path& target)
{
    std::error_code error;
    if (target.empty() || target == "." || target == "..")
        return Failure{"Name the bundle: a new folder, or a file that ends with .zip."};
    if (isZipName(target))
        return fs::is_directory(target, error)
                   ? std::optional(Failure("%1 is a folder; name a file.", target.string()))
                   : std::nullopt;
    if (!fs::exists(target, error))
        return std::nullopt;
    if (!fs::is_directory(target, error))
        return Failure("%1 is a file; name a new folder, or a file that ends with .zip.",
                       target.string());
    if (fs::is_empty(target, error) || fs::exists(target / bundled::manifest, error))
        return std::nullopt;
    return Failure("%1 is a folder with other things in it; name a new one.", target.string());
}

// Puts the folder into its place. An older bundle changes places with it in one go, so that there
// is one of the two at any time, and goes with `away`.
std::optional<Failure> place(const fs::path& folder, const fs::path& target, const fs::path& away)
{
    std::error_code error;
    if (!fs::exists(target, error))
        fs::rename(folder, target, error);
    else if (!swapped(folder, target)) { // not every file system can
        fs::rename(target, away / "old", error);
        if (!error)
            fs::rename(folder, target, error);
        std::error_code ignored;
        if (error && !fs::exists(target, ignored))
            fs::rename(away / "old", target, ignored);
    }
    if (!error)
        return std::nullopt;
    return Failure("%1 was not written: %2; choose another folder.", target.string(),
                   error.message());
}

// Copies of the files that colliders and materials name, so that the bundle needs nothing else.
class Copies
{
public:
    explicit Copies(fs::path folder)
        : m_folder(std::move(folder))
    {}

    // The scene with the copies in place of the files.
    Result<Scene> instead(const Scene& scene)
    {
        Scene own = scene;
        std::optional<Failure> failure;
        forEachFile(own, [&](const std::string& owner, std::string& name) {
            const fs::path file = placeOfFile(scene.folder.path, name);
            if (std::error_code error; !fs::exists(file, error))
                return; // a picture, which the design flies without
            const auto [copied, isNew] = m_names.try_emplace(file);
            if (isNew) // the number keeps files of one name apart
                copied->second =
                    fs::path(bundled::files)
                    / (std::to_string(m_names.size()) + "_" + file.filename().string());
            if (auto problem = isNew ? copy(file, copied->second) : std::nullopt)
                failure = Failure("%1: %2", owner, problem->message);
            name = copied->second.generic_string();
        });
        if (failure)
            return *failure;
        own.folder.path = m_folder.string();
        return own;
    }

private:
    std::optional<Failure> copy(const fs::path& file, const fs::path& name) const
    {
        std::error_code error;
        fs::create_directory(m_folder / bundled::files, error);
        fs::copy_file(file, m_folder / name, error);
        if (!error)
            return std::nullopt;
        return Failure("%1 cannot be copied into the bundle: %2.", file.string(), error.message());
    }

    fs::path m_folder;
    std::map<fs::path, fs::path> m_names; // in the bundle
};

bool namesFiles(const Scene& scene)
{
    bool names = false;
    forEachFile(scene, [&](const std::string&, const std::string&) { names = true; });
    return names;
}

// The recording with the copies in place of the files of its designs.
Result<std::shared_ptr<const Recording>> instead(const std::shared_ptr<const Recording>& recording,
                                                 Copies& copies)
{
    std::vector<Design> designs;
    bool names = false;
    for (std::size_t i = 0; i < recording->designCount(); ++i) {
        designs.push_back(recording->design(int(i)));
        const Scene scene = designs.back().scene();
        if (!namesFiles(scene))
            continue;
        Result<Scene> own = copies.instead(scene);
        if (!own)
            return own.failure();
        designs.back() = {std::make_shared<const Scene>(std::move(*own)), {}};
        names = true;
    }
    if (!names)
        return recording;

    auto own = std::make_shared<Recording>();
    for (Design& design : designs)
        own->addDesign(std::move(design));
    for (std::size_t i = 0; i < recording->chunkCount(); ++i)
        own->addChunk(
            recording->chunk(i), [recording, i] { return recording->chunkBytes(i); }, 0);
    own->setName(recording->name());
    own->setOrigin(recording->origin());
    own->setBookmarks(recording->bookmarks());
    own->finish();
    return std::shared_ptr<const Recording>(std::move(own));
}

// Table and figure of the probes, and what the manifest says of the flight.
class Findings final : public FrameSink
{
public:
    explicit Findings(fs::path folder)
        : m_folder(std::move(folder))
    {}

    std::optional<Failure> add(const Frame& frame) override
    {
        if (m_manifest.hashAtStart.empty()) {
            m_manifest.hashAtStart = hashText(frame.hash);
            m_manifest.begin = frame.time;
            m_first = frame.step;
            if (!frame.layout->probes.empty())
                if (auto failure = open())
                    return failure;
        }
        m_manifest.hashAtEnd = hashText(frame.hash);
        m_manifest.end = frame.time;
        m_manifest.steps = frame.step - m_first;
        for (const auto& sink : m_sinks)
            if (auto failure = sink->add(frame))
                return failure;
        return std::nullopt;
    }

    std::optional<Failure> finish(const Progress& progress) override
    {
        for (const auto& sink : m_sinks)
            if (auto failure = sink->finish(progress))
                return failure;
        m_isFinished = true;
        return std::nullopt;
    }

    bool isFinished() const { return m_isFinished; }
    bool hasProbes() const { return !m_sinks.empty(); }
    const Manifest& manifest() const { return m_manifest; }

private:
    std::optional<Failure> open()
    {
        for (const char* name : {bundled::probes, bundled::curves}) {
            auto sink = openSink(*formatOf(name), m_folder / name, MeshAppearance());
            if (!sink)
                return sink.failure();
            m_sinks.push_back(std::move(*sink));
        }
        return std::nullopt;
    }

    fs::path m_folder;
    std::vector<std::unique_ptr<FrameSink>> m_sinks;
    Manifest m_manifest;
    std::int64_t m_first = 0; // step
    bool m_isFinished = false;
};

// One frame for each step.
ExportRange everyStep(double begin, double end, double timeStep)
{
    // up to the step that hasReached() the end
    const double steps = std::max(0.0, std::ceil((end - begin) / timeStep - 0.5 - 1e-6));
    return {begin, begin + steps * timeStep, 1.0 / timeStep};
}

// The time step of the first design, unless later ones are so much longer that most moments would
// be of no step.
double timeStepOf(const RecordedFrames& source, const Recording& recording)
{
    constexpr double mostMoments = 64.0; // for each step
    const auto steps = double(recording.lastStep() - recording.firstStep());
    const double mean = (source.end() - source.begin()) / std::max(1.0, steps);
    return std::max(source.timeStep(), mean / mostMoments);
}

// Flies and writes into a folder beside the target, then puts it into its place.
class Writer
{
public:
    Writer(const BundleOrder& order, fs::path target, const Progress& progress)
        : m_order(order)
        , m_target(plain(target))
        , m_progress(progress)
    {}

    BundleWritten writeScene(const Scene& scene)
    {
        if (auto failure = open())
            return {failure};
        const Result<Scene> own = m_copies->instead(scene);
        if (!own)
            return {own.failure()};
        const auto system = compile(*own);
        if (!system)
            return {system.failure()};
        Simulation simulation(*system, m_order.threads);
        Recorder recorder;
        recorder.loaded(simulation, {std::make_shared<const Scene>(*own), {}});
        FlownFrames source(simulation, m_order.controls, &recorder);
        if (auto failure = fly(source, everyStep(0.0, m_order.seconds, (*system)->timeStep)))
            return {failure};
        const auto recording = recorder.recording();
        if (!recording)
            return {Failure{"Nothing was flown: a bundle needs one time step at least."}};
        recorder.finish();
        recording->setName(fs::path(bundled::recording).stem().string()); // as run --record does
        return write(*own, *recording, Manifest::From::Scene);
    }

    BundleWritten writeRecording(const std::shared_ptr<const Recording>& recording)
    {
        if (auto failure = open())
            return {failure};
        const auto own = instead(recording, *m_copies);
        if (!own)
            return {own.failure()};
        RecordedFrames source(*own, RecordedFrames::Places::Exact, m_order.threads);
        if (auto failure =
                fly(source, everyStep(source.begin(), source.end(), timeStepOf(source, **own))))
            return {failure};
        return write((*own)->scene(), **own, Manifest::From::Recording);
    }

private:
    fs::path folder() const { return m_folder->path() / "bundle"; }

    std::optional<Failure> open()
    {
        if (auto failure = whyNotThere(m_target))
            return failure;
        auto made = TemporaryFolder::make(m_target);
        if (!made)
            return made.failure();
        m_folder.emplace(std::move(*made));
        std::error_code ignored; // writing into it says it
        fs::create_directory(folder(), ignored);
        m_findings.emplace(folder());
        m_copies.emplace(folder());
        return std::nullopt;
    }

    // A flight that stops is no failure here.
    std::optional<Failure> fly(FrameSource& source, const ExportRange& range)
    {
        auto failure = exportSeries(source, range, *m_findings, stageOf(m_progress, 0.0, 0.8));
        if (failure && m_findings->isFinished())
            m_stopped = std::exchange(failure, std::nullopt);
        return failure;
    }

    BundleWritten write(const Scene& scene, const Recording& recording, Manifest::From from)
    {
        if (auto failure = writeFiles(scene, recording, from))
            return {failure};
        const Progress packing = stageOf(m_progress, 0.9, 1.0);
        if (auto failure =
                isZipName(m_target) ? zip(packing) : place(folder(), m_target, m_folder->path()))
            return {failure};
        if (m_progress)
            m_progress(1.0);
        return {m_stopped, m_stopped.has_value()};
    }

    std::optional<Failure> zip(const Progress& progress)
    {
        const fs::path packed = m_folder->path() / "bundle.zip"; // libzip writes a file beside it
        if (auto failure = zipFolder(folder(), m_target.stem().string(), packed, progress))
            return failure;
        if (const auto why = takePlace(packed, m_target, Flush::ToDisk))
            return Failure("%1 was not written: %2; choose another folder.", m_target.string(),
                           *why);
        return std::nullopt;
    }

    std::optional<Failure> writeFiles(const Scene& scene, const Recording& recording,
                                      Manifest::From from)
    {
        if (auto failure = saveScene(scene, folder() / bundled::scene))
            return failure;
        const ControlTrack& controls = m_order.controls;
        const bool isSteered = !controls.commands.empty() || !controls.hands.empty();
        if (isSteered)
            if (auto failure = writeControlTrack(scene, controls, folder() / bundled::controls))
                return failure;
        if (auto failure = saveRecording(recording, folder() / bundled::recording,
                                         stageOf(m_progress, 0.8, 0.9)))
            return failure;
        if (!recording.trouble().empty())
            return Failure("The run cannot be kept whole: %1", recording.trouble());
        if (m_order.decorate)
            if (auto failure = m_order.decorate(folder()))
                return failure;

        Manifest manifest = m_findings->manifest();
        manifest.program = "ripstop " + programVersion();
        manifest.title = scene.settings.title;
        manifest.from = from;
        manifest.timeStep = scene.settings.timeStep;
        manifest.stopped = m_stopped ? m_stopped->message.english() : "";
        manifest.commands = commandsOf(manifest, m_findings->hasProbes(), isSteered);
        if (auto failure = replaceFile(folder() / bundled::readme, readmeText(manifest, folder())))
            return failure;
        auto files = filesIn(folder());
        if (!files)
            return files.failure();
        manifest.files = std::move(*files);
        return replaceFile(folder() / bundled::manifest, manifestText(manifest));
    }

    const BundleOrder& m_order;
    const fs::path m_target;
    const Progress& m_progress;
    std::optional<TemporaryFolder> m_folder;
    std::optional<Findings> m_findings;
    std::optional<Copies> m_copies;
    std::optional<Failure> m_stopped; // why the flight ended early
};

} // namespace

BundleWritten writeBundle(const Scene& scene, const BundleOrder& order, const fs::path& target,
                          const Progress& progress)
{
    return Writer(order, target, progress).writeScene(scene);
}

BundleWritten writeBundle(const std::shared_ptr<const Recording>& recording,
                          const BundleOrder& order, const fs::path& target,
                          const Progress& progress)
{
    return Writer(order, target, progress).writeRecording(recording);
}

} // namespace ripstop
