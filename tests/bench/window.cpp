// How the window keeps up with a large design: prints figures, bounds nothing.
//
//     xvfb-run build/release/bin/ripstop-bench-window [SIDE] [SECONDS] [unseen]
//     xvfb-run build/release/bin/ripstop-bench-window SCENE...
//     xvfb-run build/release/bin/ripstop-bench-window FILE.ripstop-study.json
//
// With files of scenes it says what a picture of each costs, in a window of 1280 x 800, while the
// camera turns: with its ground, sky, people and shadows, and without any ground.
//
// With a study, whose design has to lie beside it, the panel flies what is missing of it: of each
// tenth of its flights it says how often the window had its turn, where one is due sixty times a
// second.
//
// With "unseen" the 3D view is hidden: what is left is the window's own work, without the drawing,
// which takes long where no graphics card does it.
//
// A cloth of SIDE x SIDE particles (317, about 100 000) is saved, opened, flown and edited while it
// flies. Blocks are times in which the window answers nobody: between two beats of a timer that
// asks for one each millisecond. Of the longest it says how long the window's thread worked: the
// rest it waited, for a core or for another thread.
#include "builders/builder.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/allocator_settings.h"
#include "editor/main_window.h"
#include "inspector/inspector.h"
#include "inspector/tuning_panel.h"
#include "inspector/tuning_row.h"
#include "io/scene_file.h"
#include "scene/property.h"
#include "study/study_panel.h"
#include "thread_time.h"
#include "viewport/viewport.h"

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QSlider>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string_view>
#include <vector>

using namespace ripstop;

namespace {

// How long the window was deaf, ms.
class Pulse
{
public:
    Pulse()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_timer, &QTimer::timeout, [this] { beat(); });
        m_timer.start(1);
    }
    void start()
    {
        m_blocks.clear();
        restart();
    }
    void tell(const char* what)
    {
        beat();
        std::ranges::sort(m_blocks, {}, &Block::length);
        const double common = m_blocks[std::size_t(0.99 * double(m_blocks.size()))].length;
        const auto longer = std::ranges::count_if(
            m_blocks, [](double ms) { return ms > 33.0; }, &Block::length);
        std::printf(
            "%-34s longest block %6.1f ms (%.1f ms of work), 99 %% below %5.1f ms, %td above "
            "33 ms\n",
            what, m_blocks.back().length, m_blocks.back().work, common, longer);
    }

private:
    struct Block
    {
        double length; // ms
        double work;   // ms of the processor
    };

    void restart()
    {
        m_clock.restart();
        m_worked = threadTime();
    }
    void beat()
    {
        m_blocks.push_back({double(m_clock.nsecsElapsed()) * 1e-6, threadTime() - m_worked});
        restart();
    }

    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_worked = 0.0; // ms
    std::vector<Block> m_blocks;
};

void wait(int ms)
{
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < ms)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

template <typename Condition>
double waitFor(Condition holds) // s
{
    QElapsedTimer clock;
    clock.start();
    while (!holds())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return double(clock.nsecsElapsed()) * 1e-9;
}

Id materialOf(const Scene& scene, std::string_view name)
{
    for (const Entry& entry : scene.items)
        if (const auto* material = std::get_if<Material>(&entry.item);
            material && material->name == name)
            return entry.id;
    return noId;
}

// The processor's time of a picture in which the camera has turned by half a degree, ms, on all its
// cores: the median. Unlike the time of the clock it does not count other programs.
double pictureTime(MainWindow& window)
{
    constexpr int pictures = 120;
    std::vector<double> times;
    Camera camera = window.viewport().camera();
    for (int i = 0; i < pictures; ++i) {
        camera.azimuth += 0.009;
        const std::clock_t before = std::clock();
        window.viewport().look(camera);
        QCoreApplication::processEvents();
        times.push_back(1e3 * double(std::clock() - before) / CLOCKS_PER_SEC);
    }
    std::ranges::nth_element(times, times.begin() + pictures / 2);
    return times[pictures / 2];
}

struct OpenWindow
{
    Document document;
    Selection selection{document};
    Player player{document};
    MainWindow window{document, selection, player, MainWindow::Memory::Ignore};

    OpenWindow()
    {
        window.resize(1280, 800);
        window.show();
    }
};

void timePictures(const QStringList& files)
{
    for (const QString& file : files) {
        OpenWindow open;
        Document& document = open.document;
        Player& player = open.player;
        MainWindow& window = open.window;
        window.files().open(file);
        waitFor([&] { return player.frame() != nullptr; });
        wait(500);
        const double with = pictureTime(window);
        Scene bare = document.scene();
        std::erase_if(bare.items, [](const Entry& entry) {
            return std::holds_alternative<Collider>(entry.item);
        });
        document.replace(bare);
        wait(500);
        const double without = pictureTime(window);
        std::printf(
            "%-40s %6.2f ms of the processor a picture, %6.2f ms without ground: %.2f times\n",
            qPrintable(QFileInfo(file).fileName()), with, without, with / without);
    }
}

void flyStudy(const QString& file)
{
    OpenWindow open;
    MainWindow& window = open.window;
    window.docks().show("study");
    auto& panel = window.docks().panel<StudyPanel>();
    panel.open(file);
    waitFor([&] { return panel.runner().task() == StudyRunner::Task::None; });
    if (!panel.runner().study())
        return void(std::fprintf(stderr, "%s\n", qPrintable(panel.state())));
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    int turns = 0;
    QObject::connect(&timer, &QTimer::timeout, [&] { ++turns; });
    timer.start(1000 / 60);
    panel.run();
    const StudyRunner& runner = panel.runner();
    waitFor([&] { return runner.planned() > 0; });
    Pulse pulse;
    for (std::size_t tenth = 1; tenth <= 10; ++tenth) {
        pulse.start();
        turns = 0;
        const double seconds = waitFor([&] {
            return runner.done() * 10 >= runner.planned() * tenth
                   || runner.task() != StudyRunner::Task::Flying;
        });
        std::printf("%zu of %zu flights after %.1f s more: %.1f turns a second\n", runner.done(),
                    runner.planned(), seconds, turns / seconds);
        pulse.tell("");
    }
}

template <typename Change>
void forEachLink(Scene& scene, Change change)
{
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item))
            std::ranges::for_each(part->links, change);
}

} // namespace

int main(int argc, char** argv)
{
    setUpAllocator();
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    QApplication::setApplicationName("RipstopBench");
    std::setvbuf(stdout, nullptr, _IOLBF, 0); // each line as it is known
    if (argc > 1 && StudyPanel::isStudy(argv[1])) {
        flyStudy(argv[1]);
        return 0;
    }
    if (argc > 1 && std::string_view(argv[1]).ends_with(".json")) {
        timePictures(application.arguments().mid(1));
        return 0;
    }
    const int side = argc > 1 ? std::atoi(argv[1]) : 317;
    const int seconds = argc > 2 ? std::atoi(argv[2]) : 5;

    const QTemporaryDir folder;
    const QString file = folder.filePath("cloth.ripstop.json");
    auto cloth = build(*findBuilder("cloth"), {{"columns", side - 1}, {"rows", side - 1}});
    if (cloth) { // stable and cheap: what is measured is the window
        cloth->settings.solver = Solver::SmallSteps;
        cloth->settings.substeps = 8;
        forEachLink(*cloth, [](Link& link) { link.kind = LinkKind::Rod; });
    }
    if (!cloth || saveScene(*cloth, file.toStdString())) {
        std::fprintf(stderr, "the cloth cannot be built and saved\n");
        return 1;
    }

    OpenWindow open;
    Document& document = open.document;
    Player& player = open.player;
    MainWindow& window = open.window;
    wait(500);
    Pulse pulse;
    int frames = 0;
    QObject::connect(&player, &Player::frameReady, [&] { ++frames; });

    QElapsedTimer clock;
    clock.start();
    window.files().open(file);
    const double read = double(clock.nsecsElapsed()) * 1e-9;
    waitFor([&] { return frames > 0; });
    wait(0);
    const double shown = double(clock.nsecsElapsed()) * 1e-9;
    if (argc > 3 && std::string_view(argv[3]) == "unseen")
        window.viewport().hide();
    std::printf("%d particles\nopen: read %.2f s, on the screen %.2f s\n", side * side, read,
                shown);

    pulse.start();
    wait(1000 * seconds);
    pulse.tell("at rest:");

    pulse.start();
    frames = 0;
    player.play();
    wait(1000 * seconds);
    pulse.tell("while it flies:");
    std::printf("%-34s %.1f pictures a second, %.3f of real time\n", "", double(frames) / seconds,
                player.frame()->realTimeRatio);

    SliderShelf& sliders = window.docks().panel<Inspector>().sliders();
    auto& tuning = window.docks().panel<TuningPanel>();
    sliders.remember(false);
    sliders.toggle(*findProperty(Kind::Material, "compliance"),
                   {materialOf(document.scene(), "structural")});
    for (auto* dock : window.findChildren<QDockWidget*>())
        if (dock->isAncestorOf(&tuning))
            dock->raise();
    wait(500);
    auto* slider = tuning.findChild<TuningRow*>()->findChild<QSlider*>();
    pulse.start();
    frames = 0;
    std::vector<double> calls; // ms
    const int moves = 60 * seconds;
    slider->setSliderDown(true);
    for (int i = 0; i < moves; ++i) {
        clock.restart();
        slider->setSliderPosition(slider->minimum()
                                  + i * (slider->maximum() - slider->minimum()) / moves);
        calls.push_back(double(clock.nsecsElapsed()) * 1e-6);
        wait(16);
    }
    slider->setSliderDown(false);
    pulse.tell("a slider pulled while it flies:");
    std::ranges::sort(calls);
    std::printf("%-34s a move %.2f ms, the longest %.2f ms; %.1f pictures a second\n", "",
                calls[calls.size() / 2], calls.back(), double(frames) / seconds);

    pulse.start();
    open.selection.set({document.scene().items.front().id});
    wait(1000);
    pulse.tell("a part is selected:");
    return 0;
}
