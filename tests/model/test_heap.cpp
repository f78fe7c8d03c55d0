// Steps take no memory from the heap.
//
// This program counts what its operator new and malloc are asked for, on every thread, while a
// flag is set. TBB's own are left out: it keeps the tasks that it hands out in a pool for each
// thread, and such a pool grows whenever more of them are under way than ever before, which depends
// on how threads were scheduled. The sanitizers have allocators of their own: under them the same
// steps run uncounted.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "compile/compile.h"
#include "io/scene_file.h"
#include "simulation/simulation.h"

#include <QDir>
#include <QtTest>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <new>
#include <thread>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RIPSTOP_COUNTS 1
#else
#define RIPSTOP_COUNTS 0
#endif

namespace {

std::atomic<bool> counting = false;
std::atomic<int> onOthers = 0; // allocations of threads that do not call step()
thread_local bool callsStep = false;
thread_local int here = 0; // allocations of this thread

#if RIPSTOP_COUNTS
bool isOfTbb(const void* code)
{
    Dl_info info;
    return dladdr(code, &info) != 0 && std::strstr(info.dli_fname, "libtbb") != nullptr;
}

void note(const void* caller)
{
    if (!counting.load(std::memory_order_relaxed) || isOfTbb(caller))
        return;
    if (callsStep)
        ++here;
    else
        onOthers.fetch_add(1, std::memory_order_relaxed);
}
#endif

} // namespace

#if RIPSTOP_COUNTS
extern "C" {

// glibc's own names for what these replace; its free() takes back what they return.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size)
{
    note(__builtin_return_address(0));
    return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size)
{
    note(__builtin_return_address(0));
    return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size)
{
    note(__builtin_return_address(0));
    return __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size)
{
    note(__builtin_return_address(0));
    return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size)
{
    note(__builtin_return_address(0));
    return __libc_memalign(alignment, size);
}

int posix_memalign(void** place, std::size_t alignment, std::size_t size)
{
    note(__builtin_return_address(0));
    *place = __libc_memalign(alignment, size);
    return *place ? 0 : ENOMEM;
}

} // extern "C"

// Each counts for who called it, so none calls another of these.
void* operator new(std::size_t size)
{
    note(__builtin_return_address(0));
    void* const place = __libc_malloc(size > 0 ? size : 1);
    return place ? place : throw std::bad_alloc();
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
    note(__builtin_return_address(0));
    void* const place = __libc_memalign(std::size_t(alignment), size > 0 ? size : 1);
    return place ? place : throw std::bad_alloc();
}

void* operator new[](std::size_t size)
{
    note(__builtin_return_address(0));
    void* const place = __libc_malloc(size > 0 ? size : 1);
    return place ? place : throw std::bad_alloc();
}

void* operator new[](std::size_t size, std::align_val_t alignment)
{
    note(__builtin_return_address(0));
    void* const place = __libc_memalign(std::size_t(alignment), size > 0 ? size : 1);
    return place ? place : throw std::bad_alloc();
}

void operator delete(void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t) noexcept { std::free(place); }
void operator delete(void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete(void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t) noexcept { std::free(place); }
void operator delete[](void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }
#endif

namespace ripstop::test_heap {

namespace {

struct Count
{
    int here = 0;   // on the thread that calls
    int others = 0; // on those that help it
};

template <typename Work>
Count allocationsOf(Work work)
{
    callsStep = true;
    here = 0;
    onOthers = 0;
    counting = true;
    work();
    counting = false;
    return {here, onOthers};
}

std::vector<double> kept; // what an optimizer must not leave out

constexpr double never = 1e15; // m, 1 or N: what tears is recorded, and a record takes memory
constexpr int warmUp = RIPSTOP_COUNTS ? 3 : 1;
constexpr int counted =
    RIPSTOP_COUNTS ? 8 : 3; // sanitizers are slow, and there is nothing to count

// A strip of 4 x 2200 particles in a wind: rods along, across and on the diagonals, some of them
// soft or one-way, springs to the second neighbour, panels; it hangs over a floor by a line that a
// weight on two rods can shift, and one pin of it is moved. Links may tear but do not. Every loop
// is long enough to be shared between threads, and a strip is what the direct solver can take.
// Obstacles reach it from below, and nothing begins inside one: it would be thrown out by more than
// its rods are long, which takes as many iterations, or hundreds of substeps, as there may be.
System strip(Integrator integrator, Solver solver)
{
    constexpr int across = 4;
    constexpr int along = 2200;
    System system = emptySystem(1.0 / 240.0, integrator);
    system.solver = solver;
    system.sweeps = solver == Solver::Direct ? 2 : 4;
    system.substeps = 2;
    system.gravity = {0.0, -standardGravity, 0.0};
    system.wind = {1.0, 0.0, 2.0};
    system.viscosity = 0.5;
    system.obstacles = {
        {ColliderShape::Plane,
         {0.0, -0.01, 0.0},
         {0.0, 1.0, 0.0},
         0.0,
         Response::Contact,
         0.3,
         0.4},
        {ColliderShape::Sphere, {5.0, -0.4, 0.0}, {0.0, 1.0, 0.0}, 0.4, Response::Slide, 0.0, 0.0}};
    addCostlyObstacles(system, {10.0, -0.725, 0.0});
    for (int i = 0; i < along; ++i)
        for (int k = 0; k < across; ++k) {
            const Vec3 place(0.01 * i, 0.0, 0.01 * k);
            if (i % 100 == 0 && k == 0)
                addPin(system, place, 0.001);
            else
                addParticle(system, place, 0.001);
        }
    const auto at = [](int i, int k) { return i * across + k; };
    const auto rod = [&](int a, int b) {
        const auto count = system.rods.size();
        Rod& added = addRod(system, a, b, distance(system, a, b), count % 7 == 0 ? 1e-6 : 0.0);
        added.resists = count % 11 == 0 ? Resists::Tension : Resists::Both;
        added.tear = {count % 2 ? TearRule::Force : TearRule::Length, never};
    };
    for (int i = 0; i < along; ++i)
        for (int k = 0; k < across; ++k) {
            if (k + 1 < across)
                rod(at(i, k), at(i, k + 1));
            if (i + 1 == along)
                continue;
            rod(at(i, k), at(i + 1, k));
            if (i + 2 < along)
                addSpring(system, at(i, k), at(i + 2, k), 0.02, 1.0, 1e-4).tear = {TearRule::Strain,
                                                                                   never};
            if (k + 1 == across)
                continue;
            rod(at(i, k), at(i + 1, k + 1));
            rod(at(i, k + 1), at(i + 1, k));
            addPanel(system, at(i, k), at(i + 1, k), at(i, k + 1), AirLaw::LinearNormal, 2.0, 0.02);
            addPanel(system, at(i, k + 1), at(i + 1, k), at(i + 1, k + 1), AirLaw::Paper, 1.2);
        }
    const int weight = addParticle(system, {0.005, -0.009, 0.0}, 0.1);
    for (const int end : {at(0, 1), at(1, 2)}) {
        const int index = int(system.rods.size());
        rod(weight, end);
        system.shiftedRods.push_back(
            {index, weight,
             system.start.position[std::size_t(end)] - system.start.position[std::size_t(weight)]});
    }
    system.inputs = {{1, ControlKind::Move, Vec3::UnitX(), 0.05, 0.1, 0.05, {at(200, 0)}},
                     {2, ControlKind::WeightShift, Vec3::UnitX(), 0.02, 0.1, 0.05, {weight}}};
    finish(system);
    return system;
}

QStringList sceneNames()
{
    return QDir(QStringLiteral(SCENES_DIR)).entryList({"*.ripstop.json"}, QDir::Files, QDir::Name);
}

void report(const Count& count)
{
    if (!RIPSTOP_COUNTS)
        qInfo("not counted under a sanitizer");
    QCOMPARE(count.here, 0);
    QCOMPARE(count.others, 0);
}

} // namespace

class TestHeap : public QObject
{
    Q_OBJECT

private slots:
    // The counter counts: on this thread, aligned memory, and on the others of a pool.
    void counts()
    {
        if (!RIPSTOP_COUNTS)
            return;
        QCOMPARE(allocationsOf([] {}).here, 0);
        QVERIFY(allocationsOf([] { std::vector<PaddedVec3> aligned(3); }).here >= 1);
        QVERIFY(allocationsOf([] { std::vector<double>(3).swap(kept); }).here >= 1);
        QVERIFY(allocationsOf([] { QByteArray(1000, 'x'); }).here >= 1); // in a library
        const Count count = allocationsOf([] {
            std::thread other([] { std::vector<double>(3).swap(kept); });
            other.join();
        });
        QVERIFY(count.others >= 1);
    }

    // Large enough for coarser networks, of threads with a real stiffness.
    void largeSheet()
    {
        constexpr int side = 40;
        System system = heavySystem(0.01);
        system.solver = Solver::Auto;
        for (int i = 0; i < side * side; ++i) {
            const Vec3 place(0.02 * (i % side), -0.02 * (i / side), 0.0);
            if (i < side)
                addPin(system, place);
            else
                addParticle(system, place, 2e-5);
        }
        const auto rod = [&](int a, int b) {
            addRod(system, a, b, distance(system, a, b)).compliance = 2.5e-5;
        };
        for (int i = 0; i < side * side; ++i) {
            if (i % side + 1 < side)
                rod(i, i + 1);
            if (i + side < side * side)
                rod(i, i + side);
        }
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (int i = 0; i < warmUp; ++i)
            stepper.step(system, state);
        report(allocationsOf([&] {
            for (int i = 0; i < counted; ++i)
                stepper.step(system, state);
        }));
        QVERIFY(stepper.choice(system).english().find("together") != std::string::npos);
    }

    void solvers_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<Solver>("solver");
        QTest::addColumn<bool>("beside");
        QTest::addColumn<bool>("byHand");
        for (std::size_t i = 0; i < choiceNames<Integrator>.size(); ++i)
            for (std::size_t s = 0; s < choiceNames<Solver>.size(); ++s)
                QTest::addRow("%s, %s", choiceNames<Integrator>[i].data(),
                              choiceNames<Solver>[s].data())
                    << Integrator(i) << Solver(s) << false << false;
        QTest::newRow("gauss_seidel beside a direct block")
            << Integrator::SemiImplicitEuler << Solver::GaussSeidel << true << false;
        QTest::newRow("pulled, blown and pushed by hand")
            << Integrator::SemiImplicitEuler << Solver::GaussSeidel << false << true;
    }

    void solvers()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        QFETCH(bool, beside);
        QFETCH(bool, byHand);
        System system = strip(integrator, solver);
        if (beside) {
            system.direct.assign(system.rods.size(), 0);
            for (std::size_t i = 0; i < 400; ++i)
                system.direct[i] = 1;
        }
        for (const int threads : {1, 2}) {
            Stepper stepper(threads);
            State state = system.start;
            if (byHand) {
                state.hands.pull = HandPull{{{50, 51, 54}, {0.3, 0.3, 0.4}}, {0.0, 1.0, 0.0}};
                state.hands.fan = Airflow{WindKind::Jet, {0.0, 0.0, 5.0}};
                state.hands.carries = {{system.obstacles[1].key, {0.1, 0.0, 0.0}}};
                state.carried = {Vec3::Zero()};
            }
            for (int i = 0; i < warmUp; ++i)
                stepper.step(system, state);
            const Count count = allocationsOf([&] {
                for (int i = 0; i < counted; ++i)
                    stepper.step(system, state);
            });
            report(count);
            if (QTest::currentTestFailed())
                return;
            QVERIFY(state.tears.empty());
            QVERIFY(state.inputValue[0] > 0.0 && state.inputValue[1] > 0.0);
            for (const Vec3& position : state.position)
                QVERIFY(position.allFinite());
        }
    }

    void scenes_data()
    {
        QTest::addColumn<QString>("file");
        for (const QString& name : sceneNames())
            QTest::newRow(qPrintable(name)) << name;
    }

    void scenes()
    {
        QFETCH(QString, file);
        const Result<Scene> scene =
            readScene((QStringLiteral(SCENES_DIR) + "/" + file).toStdString());
        QVERIFY2(bool(scene), scene ? "" : scene.message().english().c_str());
        const auto system = compile(*scene);
        QVERIFY(bool(system));
        for (const int threads : {1, 2}) {
            Simulation simulation(*system, threads);
            Commands commands;
            for (const Input& input : (*system)->inputs)
                commands[input.key] = 0.5 * input.limit;
            simulation.command(commands);
            for (int i = 0; i < warmUp; ++i)
                QVERIFY(simulation.step());
            bool whole = true;
            const Count count = allocationsOf([&] {
                for (int i = 0; i < counted; ++i)
                    whole &= simulation.step();
            });
            QVERIFY(whole);
            report(count);
            if (QTest::currentTestFailed())
                return;
            QVERIFY(simulation.state().tears.empty());
        }
    }
};

const RegisteredTest registered("test_heap", runPlain<TestHeap>);

} // namespace ripstop::test_heap
#include "test_heap.moc"
