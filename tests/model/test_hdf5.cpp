// A series as HDF5: what the library reads back is what the frames have, to the bit, also where a
// tear makes another mesh of it.
#include "compile/compile.h"
#include "model/written_series.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

#ifdef RIPSTOP_HAS_HDF5
#include <hdf5.h>
#include <sys/resource.h>
#endif

namespace ripstop::test_hdf5 {

namespace {

// A triangle of fabric on two pins, and a probe of its tip.
Frame frameOfTriangle()
{
    Part part;
    part.particles = {{.id = Id{11}, .pinned = true},
                      {.id = Id{12}, .position = Vec3(1.0, 0.0, 0.0), .pinned = true},
                      {.id = Id{13}, .position = Vec3(0.5, -1.0, 0.25)}};
    part.links = {{.id = Id{21}, .from = Id{11}, .to = Id{13}, .restLength = 1.2}};
    part.panels = {{Id{31}, Id{11}, Id{12}, Id{13}}};
    Scene scene;
    scene.items = {{Id{1}, part}, {Id{2}, Probe{.name = "tip/y", .target = Id{13}}}};
    scene.nextId = Id{40};
    return *Simulation(*compile(scene)).frame();
}

} // namespace

class TestHdf5 : public QObject
{
    Q_OBJECT

private slots: // moc does not see what the compiler is told, so they are the same in each build
    void readsBack()
    {
#ifndef RIPSTOP_HAS_HDF5
        const auto refused = writeSeries({}, {}, "flight.h5");
        QVERIFY(refused && refused->message.english().find("libhdf5-dev") != std::string::npos);
#else
        std::vector<Frame> frames(3, frameOfTriangle());
        for (std::size_t i = 0; i < 3; ++i) {
            frames[i].time = 0.1 * double(i);
            frames[i].step = std::int64_t(24 * i);
            frames[i].position[2].y() = -1.0 / double(i + 3);
            frames[i].probe = {frames[i].position[2].y()};
        }
        // the last one has another mesh
        auto layout = std::make_shared<Layout>(*frames[2].layout);
        layout->particleId.push_back(13);
        frames[2].layout = layout;
        frames[2].position.push_back(Vec3(7.0, 8.0, 9.0));
        frames[2].velocity.push_back(Vec3::Zero());

        const QTemporaryDir folder;
        const std::string target = folder.filePath("flight.h5").toStdString();
        QVERIFY(!writeSeries(frames, {}, target));
        m_file = H5Fopen(target.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
        QVERIFY(m_file >= 0);
        QCOMPARE(numbers("/time"), (std::vector<double>{0.0, 0.1, 0.2}));
        QCOMPARE(numbers("/step"), (std::vector<double>{0.0, 24.0, 48.0}));
        QCOMPARE(numbers("/probes/tip_y"), (std::vector<double>{-1.0 / 3.0, -0.25, -0.2}));
        const auto places = numbers("/mesh0/particles/position");
        QCOMPARE(places.size(), std::size_t(2 * 3 * 3));
        QCOMPARE(places[7], -1.0 / 3.0);
        QCOMPARE(places[16], -0.25);
        QCOMPARE(numbers("/mesh0/links/ends"), (std::vector<double>{0.0, 2.0}));
        QCOMPARE(numbers("/mesh0/panels/corners"), (std::vector<double>{0.0, 1.0, 2.0}));
        QCOMPARE(numbers("/mesh0/panels/load").size(), std::size_t(6));
        QCOMPARE(numbers("/mesh1/particles/id"), (std::vector<double>{11, 12, 13, 13}));
        QCOMPARE(numbers("/mesh1/particles/position").back(), 9.0);
        H5Fclose(m_file);
#endif
    }

    // What cannot be written leaves the old file, and nothing else.
    void leavesTheOldFile()
    {
#ifdef RIPSTOP_HAS_HDF5
        const QTemporaryDir folder;
        const std::string target = folder.filePath("flight.h5").toStdString();
        const std::vector frames{frameOfTriangle()};
        QVERIFY(!writeSeries(frames, {}, target));
        {
            auto sink = openSink(*formatOf(target), target, {});
            QVERIFY(!(*sink)->add(frames.front())); // and given up
        }
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"flight.h5"});
        const auto failure = writeSeries(frames, {}, "/nowhere/flight.h5");
        QVERIFY(failure && failure->message.english().find("/nowhere/flight.h5") == 0);
#endif
    }

    // The limit on the size of files makes the library fail in its middle, and it cannot close what
    // it could not write.
    void fillsTheDisk()
    {
#ifdef RIPSTOP_HAS_HDF5
        const QTemporaryDir folder;
        QProcess program;
        program.setChildProcessModifier([] {
            const rlimit limit{200'000, 200'000};
            ::setrlimit(RLIMIT_FSIZE, &limit);
        });
        program.setWorkingDirectory(folder.path());
        program.start(CLI_PROGRAM, {"export", SCENES_DIR "/delta_kite.ripstop.json", "-o",
                                    "kite.h5", "--to", "5"});
        QVERIFY(program.waitForFinished(120000));
        const QString said = program.readAllStandardError();
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QVERIFY2(program.exitCode() == 1
                     && said.contains("kite.h5 was not written: File too large"),
                 qPrintable(said));
        QVERIFY(QDir(folder.path()).isEmpty());
#endif
    }

private:
#ifdef RIPSTOP_HAS_HDF5
    std::vector<double> numbers(const char* name) const
    {
        const hid_t set = H5Dopen2(m_file, name, H5P_DEFAULT);
        const hid_t space = H5Dget_space(set);
        std::vector<double> values(
            std::size_t(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0)));
        H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        H5Sclose(space);
        H5Dclose(set);
        return values;
    }

    hid_t m_file = -1;
#endif
};

const RegisteredTest registered("test_hdf5", runPlain<TestHdf5>);

} // namespace ripstop::test_hdf5
#include "test_hdf5.moc"
