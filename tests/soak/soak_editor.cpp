// The editor, flown and edited by a script, round after round, until it is told to end.
// scripts/soak starts it, reads what it prints, and looks at its memory and its open files.
//
//     xvfb-run build/release/bin/ripstop-soak SECONDS [SAMPLE ...]
//
// In a round each sample (all of scenes/ unless some are named) is opened, flown for so many
// seconds as fast as it can, edited in flight, looked at from all sides, looked back at, gone on
// with, saved, and read again; then the window is emptied. Printed, a line each:
//
//     hash SAMPLE HASH       of the flight, before anything is edited
//     empty BYTES            of the heap that are taken then; it waits for a line of input
//
// What should not be goes to the standard error.
#include "app/window_shop.h"
#include "base/hash_text.h"
#include "document/recordings.h"
#include "editor/allocator_settings.h"
#include "editor/end_signals.h"
#include "io/scene_file.h"
#include "model/sample_scenes.h"
#include "scene/property.h"

#include <QClipboard>
#include <QPixmapCache>
#include <QTemporaryDir>

#include <cstdio>
#include <iostream>

#include <malloc.h>

using namespace ripstop;

namespace {

constexpr int longest = 300000; // ms that anything is waited for; the machine may be busy

void complain(const QString& sample, const QString& what)
{
    std::fprintf(stderr, "%s: %s\n", qPrintable(sample), qPrintable(what));
}

class Script
{
public:
    Script(double seconds, QStringList samples)
        : m_seconds(seconds)
        , m_samples(std::move(samples))
        , m_ends([this](int) { m_isOver = true; })
    {
        m_shop.window.resize(900, 560); // small, as it is mostly drawn without a graphics card
        m_shop.window.show();
        QObject::connect(&m_shop.player, &Player::stopped, &m_shop.window,
                         [this](const QString& why) {
                             if (!m_mayStop)
                                 complain(m_sample, why);
                         });
        QObject::connect(&m_shop.window.recordings(), &Recordings::failed, &m_shop.window,
                         [this](const QString& why) { complain(m_sample, why); });
    }

    void run()
    {
        for (qsizetype i = 0; !m_isOver; ++i)
            visit(m_samples[i % m_samples.size()]);
    }

private:
    void visit(const QString& sample)
    {
        m_sample = sample;
        m_mayStop = false;
        open(SCENES_DIR "/" + sample + QString::fromUtf8(sceneExtension));
        fly();
        m_shop.player.play();
        showPanels();
        editNumbers();
        editElements();
        look();
        lookBack();
        saveAndRead();
        empty();
    }

    // So that all visits end alike.
    void empty()
    {
        m_shop.run("reset");
        m_shop.document.replace(Scene{});
        m_shop.window.showScene();
        turn(300);
        QGuiApplication::clipboard()->clear(); // it holds what was copied of the sample
        QPixmapCache::clear();                 // it is bounded, and fills for hours
        ::malloc_trim(0); // what is free goes back, so that the rest can be compared
        std::printf("empty %zu\n", ::mallinfo2().uordblks + ::mallinfo2().hblkhd);
        std::fflush(stdout);
        std::string line;
        std::getline(std::cin, line);
        m_isOver |= !std::cin;
    }

    // --- what a person does ---------------------------------------------------------------------

    void open(const QString& file)
    {
        if (const auto failure = m_shop.document.open(file))
            return complain(m_sample, QString::fromStdString(failure->message.english()));
        m_shop.window.showScene();
        m_shop.selection.set({});
        turn();
    }

    void fly()
    {
        m_shop.player.playUntil(m_seconds);
        waitUntil("flies", [this] {
            return !m_shop.player.isPlaying() && m_shop.player.frame()
                   && m_shop.player.frame()->step > 0;
        });
        if (!m_isOver)
            std::printf("hash %s %s\n", qPrintable(m_sample),
                        hashText(m_shop.frame().hash).c_str());
        std::fflush(stdout);
    }

    void showPanels()
    {
        for (const Docks::Dock& dock : m_shop.window.docks().all()) {
            m_shop.window.docks().show(dock.row.id);
            turn();
        }
    }

    // Pulls each number of the settings and of the first item of each kind up by a little and down
    // again, in flight; then takes it all back.
    void editNumbers()
    {
        std::map<Kind, Id> targets{{Kind::Settings, settingsId}};
        for (const Entry& entry : m_shop.document.scene().items)
            targets.emplace(kindOf(*find(m_shop.document.scene(), entry.id)), entry.id);
        for (const auto& [kind, id] : targets) {
            m_shop.selection.set({id});
            m_shop.window.docks().show("inspector");
            for (const Property& property : propertiesOf(kind))
                pull(id, property);
            turn();
        }
        while (m_shop.document.history().canUndo())
            m_shop.document.history().undo();
        turn();
    }

    void pull(Id id, const Property& property)
    {
        const Value before = property.get(*find(m_shop.document.scene(), id));
        const double* number = std::get_if<double>(&before);
        const int gesture = m_shop.document.beginGesture();
        for (const double factor : {1.001, 1.002, 1.0}) {
            if (!number || refusal(property, *number * factor))
                continue;
            m_shop.document.drag(
                {Message("pull"), {SetValues{&property, {id}, {*number * factor}}}}, gesture);
        }
    }

    // Takes a link out of the network while it flies, puts it back, and copies what there is. A
    // link whose ends have parted meanwhile may pull them together faster than the watchdog lets
    // them.
    void editElements()
    {
        m_mayStop = true;
        m_shop.run("allLinks");
        if (m_shop.selection.ids().empty())
            return;
        m_shop.selection.set({m_shop.selection.ids().front()});
        for (const char* action : {"delete", "undo", "redo", "undo"}) {
            m_shop.run(action);
            turn();
        }
        for (const char* action : {"selectAll", "copy", "paste", "invert", "undo", "deselect"}) {
            m_shop.run(action);
            turn();
        }
    }

    void look()
    {
        for (const char* action :
             {"byStrain",  "byTension",   "bySpeed",     "byLoad",     "byTear",
              "byStress",  "byWrinkles",  "byMargin",    "byMaterial", "trails",
              "windField", "loadArrows",  "designGhost", "noArrows",   "trails",
              "windField", "designGhost", "left",        "top",        "home"}) {
            m_shop.run(action);
            turn();
        }
        const QPointF middle(0.5 * m_shop.viewport.width(), 0.5 * m_shop.viewport.height());
        m_shop.drag(middle, middle + QPointF(80, 30));
        m_shop.wheel(middle, 2);
        m_shop.run("home");
        turn();
    }

    void lookBack()
    {
        Recordings& runs = m_shop.window.recordings();
        m_shop.player.pause();
        turn();
        for (const double part : {0.0, 0.9, 0.5}) {
            runs.seekTime(part * m_seconds);
            turn();
        }
        waitUntil("looks back", [&] { return runs.isLookingBack(); });
        runs.continueHere();
        waitUntil("goes on from there", [&] { return !runs.isComputing(); });
        m_shop.player.play();
        turn(300);
        m_shop.player.pause();
    }

    void saveAndRead()
    {
        const QString file = m_folder.filePath(m_sample + QString::fromUtf8(sceneExtension));
        const Scene scene = m_shop.document.scene();
        if (const auto failure = m_shop.document.save(file))
            return complain(m_sample, QString::fromStdString(failure->message.english()));
        open(file);
        if (m_shop.document.scene().items.size() != scene.items.size())
            complain(m_sample, "what was saved is not what is read");
    }

    // --- waiting --------------------------------------------------------------------------------

    static void turn(int ms = 20) { QTest::qWait(ms); }

    template <typename Condition>
    void waitUntil(const char* what, Condition holds)
    {
        if (!QTest::qWaitFor([&] { return m_isOver || holds(); }, longest))
            complain(m_sample, QString("never %1").arg(what));
    }

    double m_seconds; // s, of each flight
    QStringList m_samples;
    QString m_sample; // at hand
    QTemporaryDir m_folder;
    WindowShop m_shop;
    EndSignals m_ends;
    bool m_mayStop = false; // without a complaint
    bool m_isOver = false;
};

} // namespace

int main(int argc, char** argv)
{
    setUpAllocator();
    QSurfaceFormat format; // before the application exists, as VTK needs it
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    QApplication::setApplicationName("RipstopSoak");
    const QStringList arguments = application.arguments();
    const QStringList samples = arguments.mid(2);
    Script(arguments.value(1, "1").toDouble(), samples.isEmpty() ? sampleNames() : samples).run();
    return 0;
}
