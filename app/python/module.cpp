// The Python module `ripstop`: scenes, simulations, recordings and studies, without a window.
//
// What can take long releases the interpreter's lock. Arrays are read-only views of what the engine
// made, without a copy: a frame (simulation/frame.h) never changes, and lives as long as a view of
// it. What the engine refuses is raised as ripstop.Error with the engine's sentence. A simulation
// and its hash are those of ripstop-cli, to the bit.
#include "base/hash_text.h"
#include "base/program_version.h"
#include "builders/typed_parameters.h"
#include "compile/compile.h"
#include "io/recording_file.h"
#include "io/scene_file.h"
#include "recording/recording.h"
#include "scene/path.h"
#include "simulation/simulation.h"
#include "study/many.h"
#include "study/point_scene.h"
#include "study/study_map.h"
#include "study/study_run.h"
#include "study/study_search.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <thread>

namespace py = pybind11;

namespace ripstop {
namespace {

struct Error : std::runtime_error
{
    explicit Error(const Message& message)
        : std::runtime_error(message.english())
    {}
};

template <typename T>
T orRaise(Result<T> result)
{
    if (!result)
        throw Error(result.message());
    return std::move(*result);
}

void orRaise(const std::optional<Failure>& failure)
{
    if (failure)
        throw Error(failure->message);
}

int jobsOr(int jobs)
{
    return jobs > 0 ? jobs : int(std::max(1u, std::thread::hardware_concurrency()));
}

// --- values -------------------------------------------------------------------------------------

py::object toPython(const Value& value)
{
    if (const auto* flag = std::get_if<bool>(&value))
        return py::bool_(*flag);
    if (const auto* whole = std::get_if<int>(&value))
        return py::int_(*whole);
    if (const auto* number = std::get_if<double>(&value))
        return py::float_(*number);
    if (const auto* vector = std::get_if<Vec3>(&value))
        return py::make_tuple(vector->x(), vector->y(), vector->z());
    if (std::holds_alternative<std::monostate>(value))
        return py::none();
    return py::str(textFromValue(value));
}

// As people type it: numbers with all of their digits, vectors with commas.
std::string textOfPython(const py::handle& value)
{
    if (py::isinstance<py::bool_>(value))
        return value.cast<bool>() ? "true" : "false";
    if (py::isinstance<py::str>(value))
        return value.cast<std::string>();
    if (py::isinstance<py::sequence>(value)) {
        std::string all;
        for (const py::handle& one : value)
            all += (all.empty() ? "" : ", ") + textOfPython(one);
        return all;
    }
    return py::str(py::float_(value.cast<double>())).cast<std::string>();
}

std::string numberText(const py::handle& value)
{
    return py::isinstance<py::int_>(value) && !py::isinstance<py::bool_>(value)
               ? py::str(value).cast<std::string>()
               : textOfPython(value);
}

// --- scenes -------------------------------------------------------------------------------------

Scene buildScene(const std::string& name, const py::kwargs& given)
{
    const Builder* builder = findBuilder(name);
    if (!builder) {
        std::vector<std::string_view> names;
        for (const Builder& one : allBuilders())
            names.push_back(one.name);
        throw Error(Message("There is no builder \"%1\"; did you mean \"%2\"?", name,
                            nearest(name, names)));
    }
    std::vector<std::string> texts;
    for (const auto& [key, value] : given)
        texts.push_back(py::str(key).cast<std::string>() + '=' + numberText(value));
    return orRaise(build(*builder, newDesign(*builder, orRaise(parametersFrom(*builder, texts)))));
}

py::object getValue(const Scene& scene, const std::string& path)
{
    const Place place = orRaise(findPlace(scene, path));
    const auto thing = find(scene, place.targets.front());
    return toPython(place.property->get(*thing));
}

void setValue(Scene& scene, const std::string& path, const py::object& value)
{
    scene = orRaise(sceneWith(scene, {path + '=' + numberText(value)}));
}

// --- simulations --------------------------------------------------------------------------------

using FramePointer = std::shared_ptr<const Frame>;

// A view of an array of a frame, which keeps the frame.
template <typename T>
py::array viewOf(const FramePointer& frame, const T* data, std::vector<py::ssize_t> shape)
{
    const py::capsule keeper(new FramePointer(frame),
                             [](void* kept) { delete static_cast<FramePointer*>(kept); });
    py::array_t<T> view(std::move(shape), data, keeper);
    py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return view;
}

py::array vectorsOf(const FramePointer& frame, const std::vector<Vec3>& vectors)
{
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return viewOf(frame, vectors.empty() ? nullptr : vectors.front().data(),
                  {py::ssize_t(vectors.size()), 3});
}

py::array numbersOf(const FramePointer& frame, const std::vector<double>& numbers)
{
    return viewOf(frame, numbers.data(), {py::ssize_t(numbers.size())});
}

py::dict probesOf(const Frame& frame)
{
    py::dict probes;
    for (std::size_t i = 0; i < frame.probe.size(); ++i)
        probes[py::str(frame.layout->probes[i].name)] = frame.probe[i];
    return probes;
}

// A simulation that knows the names of its controls.
class Run
{
public:
    explicit Run(Scene scene, int threads)
        : m_scene(std::move(scene))
        , m_threads(threads)
        , m_simulation(orRaise(compile(m_scene)), threads)
    {}

    Simulation& simulation() { return m_simulation; }
    const Scene& scene() const { return m_scene; }

    void step(int count)
    {
        for (int i = 0; i < count; ++i)
            if (!m_simulation.step())
                throw Error(m_simulation.trouble()->message);
        m_frame = nullptr;
    }

    void runUntil(double time)
    {
        m_frame = nullptr;
        if (!m_simulation.runUntil(time) && m_simulation.trouble())
            throw Error(m_simulation.trouble()->message);
    }

    void command(const std::string& name, double value)
    {
        m_simulation.command(
            {{std::uint32_t(orRaise(findNamed(m_scene, Kind::Control, name))), value}});
    }

    FramePointer frame() // of this instant, made once
    {
        if (!m_frame)
            m_frame = m_simulation.frame();
        return m_frame;
    }

    State checkpoint() const { return m_simulation.state(); }
    void restore(const State& state)
    {
        m_simulation = Simulation(m_simulation.compiled(), state, m_threads);
        m_frame = nullptr;
    }

private:
    Scene m_scene;
    int m_threads;
    Simulation m_simulation;
    FramePointer m_frame;
};

// commands [runs][rows][controls] of m, each row for `steps` steps; probes [runs][rows][probes].
py::array rollout(const Scene& scene, const std::vector<std::string>& controls,
                  const py::array_t<double, py::array::c_style | py::array::forcecast>& commands,
                  int steps, int jobs)
{
    if (commands.ndim() != 3 || std::size_t(commands.shape(2)) != controls.size() || steps < 1)
        throw Error(Message("rollout() takes commands of the shape [runs, rows, controls], with as "
                            "many as it names, and at least one step for each row."));
    const auto runs = std::size_t(commands.shape(0));
    const auto rows = std::size_t(commands.shape(1));
    std::vector<std::uint32_t> ids;
    for (const std::string& name : controls)
        ids.push_back(std::uint32_t(orRaise(findNamed(scene, Kind::Control, name))));
    const auto system = orRaise(compile(scene));
    const std::size_t probes = Simulation(system).sample().probe.size();
    py::array_t<double> read({runs, rows, probes});
    const double* told = commands.data();
    double* target = read.mutable_data();
    std::fill(target, target + read.size(), std::nan(""));
    {
        const py::gil_scoped_release release;
        forEachOfMany(runs, jobsOr(jobs), [&](std::size_t run) {
            Simulation simulation(system);
            for (std::size_t row = 0; row < rows; ++row) {
                Commands all;
                for (std::size_t c = 0; c < ids.size(); ++c)
                    all[ids[c]] = told[(run * rows + row) * ids.size() + c];
                simulation.command(all);
                for (int i = 0; i < steps; ++i)
                    if (!simulation.step())
                        return true; // what follows of it is not a number
                const ProbeSample sample = simulation.sample();
                std::copy(sample.probe.begin(), sample.probe.end(),
                          target + (run * rows + row) * probes);
            }
            return true;
        });
    }
    return read;
}

// --- studies ------------------------------------------------------------------------------------

// The columns of the table, by their headings; what is not flown is not a number.
py::dict columnsOf(OpenedStudy& opened)
{
    const LedgerContent known = orRaise(readLedgers(ledgerFolder(opened.file)));
    followSearch(opened, known.rows);
    const StudyFlights flights = flightsOf(opened, known.rows);
    py::dict table;
    for (std::size_t v = 0; v < opened.study.variables.size(); ++v) {
        py::list column;
        for (std::size_t i = 0; i < flights.size(); ++i)
            column.append(opened.points.values(i)[v]);
        table[py::str(opened.study.variables[v].name)] = column;
    }
    const std::vector<std::string> readings = readingsOf(opened);
    for (std::size_t r = 0; r < readings.size(); ++r) {
        py::array_t<double> column(py::ssize_t(flights.size()));
        for (std::size_t i = 0; i < flights.size(); ++i)
            column.mutable_at(py::ssize_t(i)) =
                flights[i] ? readingOf(*flights[i], r) : std::nan("");
        table[py::str(readings[r])] = column;
    }
    py::list hashes, stopped, accuracy;
    for (const FlightResult* flight : flights) {
        hashes.append(flight ? flight->hash : std::string());
        stopped.append(flight ? flight->whyEarly() : std::string());
        accuracy.append(flight ? flight->inaccurate : std::string());
    }
    table["hash"] = hashes;
    table["stopped"] = stopped;
    table["accuracy"] = accuracy;
    return table;
}

std::size_t runStudy(const OpenedStudy& opened, int jobs)
{
    const auto nobody = [](const FlightNews&) {};
    // Ctrl-C, which only a thread with the lock can see
    const auto isInterrupted = [] {
        const py::gil_scoped_acquire lock;
        return PyErr_CheckSignals() != 0;
    };
    std::optional<Result<StudyFlown>> flown;
    {
        const py::gil_scoped_release release;
        flown.emplace(flyMissing(opened, {}, jobsOr(jobs), isInterrupted, nobody));
    }
    if (PyErr_Occurred())
        throw py::error_already_set();
    return orRaise(std::move(*flown)).tally.flown;
}

} // namespace

PYBIND11_MODULE(_engine, module)
{
    module.doc() = "The engine of Ripstop: fabric that flies.";
    module.attr("__version__") = std::string(releaseVersion());
    py::register_exception<Error>(module, "Error", PyExc_ValueError);
    const auto unlocked = py::call_guard<py::gil_scoped_release>();

    py::class_<Scene>(module, "Scene", "A design, as it is authored: a value that can be copied.")
        .def(py::init<const Scene&>(), "A copy.")
        .def_static(
            "load", [](const std::string& file) { return orRaise(readScene(file)); },
            py::arg("file"))
        .def_static(
            "build", &buildScene, py::arg("builder"),
            "A design of a builder (ripstop-cli builders), with its parameters as keywords.")
        .def(
            "save",
            [](const Scene& scene, const std::string& file) { orRaise(saveScene(scene, file)); },
            py::arg("file"))
        .def("__getitem__", &getValue, "The value of a property by its path, as of --set.")
        .def("__setitem__", &setValue);

    py::class_<State>(module, "Checkpoint", "An exact instant of a simulation.");

    py::class_<Frame, std::shared_ptr<Frame>>(module, "Frame"); // what views keep

    py::class_<Run>(module, "Simulation", "A design in motion; of the same bits as ripstop-cli.")
        .def(py::init<Scene, int>(), py::arg("scene"), py::arg("threads") = 1)
        .def("step", &Run::step, py::arg("count") = 1, unlocked, "So many time steps.")
        .def("run_until", &Run::runUntil, py::arg("time"), unlocked, "Until this time, s.")
        .def("command", &Run::command, py::arg("control"), py::arg("value"),
             "Where a control is told to go, m or rad.")
        .def("checkpoint", &Run::checkpoint)
        .def("restore", &Run::restore, py::arg("checkpoint"), "Goes on from there, to the bit.")
        .def_property_readonly("time", [](Run& run) { return run.simulation().state().time; })
        .def_property_readonly("steps", [](Run& run) { return run.simulation().state().step; })
        .def_property_readonly("time_step",
                               [](Run& run) { return run.simulation().system().timeStep; })
        .def_property_readonly("hash", [](Run& run) { return hashText(run.frame()->hash); })
        .def_property_readonly(
            "positions", [](Run& run) { return vectorsOf(run.frame(), run.frame()->position); },
            "[particles, 3] m, read-only")
        .def_property_readonly(
            "velocities", [](Run& run) { return vectorsOf(run.frame(), run.frame()->velocity); },
            "[particles, 3] m/s, read-only")
        .def_property_readonly(
            "tensions", [](Run& run) { return numbersOf(run.frame(), run.frame()->tension); },
            "[links] N, read-only")
        .def_property_readonly("tears", [](Run& run) { return run.frame()->tears.size(); })
        .def_property_readonly(
            "probes", [](Run& run) { return probesOf(*run.frame()); },
            "The values of the probes by their names.");

    module.def("rollout", &rollout, py::arg("scene"), py::arg("controls"), py::arg("commands"),
               py::arg("steps"), py::arg("jobs") = 0,
               "Flies many at a time: commands [runs, rows, controls], each row for so many steps; "
               "returns the probes [runs, rows, probes].");

    py::class_<Recording, std::shared_ptr<Recording>>(module, "Recording", "A run that was kept.")
        .def_static(
            "load",
            [](const std::string& file) {
                auto opened = orRaise(openRecording(file, {}));
                return opened.recording;
            },
            py::arg("file"))
        .def("__len__", &Recording::frameCount)
        .def_property_readonly("scene", &Recording::scene)
        .def(
            "time",
            [](const Recording& recording, std::size_t i) {
                if (i >= recording.frameCount())
                    throw py::index_error();
                return recording.timeOf(i);
            },
            py::arg("frame"))
        .def(
            "positions",
            [](const Recording& recording, std::size_t i) {
                if (i >= recording.frameCount())
                    throw py::index_error();
                const FramePointer frame = orRaise(recording.frame(i));
                return vectorsOf(frame, frame->position);
            },
            py::arg("frame"), "[particles, 3] m, read-only");

    py::class_<OpenedStudy>(module, "Study", "A study: a design flown with many values.")
        .def(py::init([](const std::string& file) { return orRaise(openStudy(file)); }),
             py::arg("file"))
        .def("__len__", [](const OpenedStudy& opened) { return opened.points.count(); })
        .def("run", &runStudy, py::arg("jobs") = 0, "Flies what is missing; returns how many.")
        .def("table", &columnsOf, "The columns of what is flown, by their headings.");
}

} // namespace ripstop
