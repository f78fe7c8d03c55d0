// What `run --final` writes of a mesh that has split: a scene of its own.
#include "check/check.h"
#include "compile/compile.h"
#include "io/scene_file.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace ripstop::test_final_scene {

class TestFinalScene : public QObject
{
    Q_OBJECT

private slots:
    // Compiled, it is the split system: particles in the same order and place, of the same mass,
    // and between them links of the same stiffness; it goes on without a jump.
    void splitSheet()
    {
        const QString flown = SCENES_DIR "/split_sheet.ripstop.json";
        QTemporaryDir folder;
        const QString file = folder.filePath("final.ripstop.json");
        QCOMPARE(QProcess::execute(CLI_PROGRAM,
                                   {"run", flown, "--seconds", "3.1", "--json", "--final", file}),
                 0);
        const auto scene = readScene(flown.toStdString());
        QVERIFY(bool(scene));
        Simulation simulation(*compile(*scene));
        QVERIFY(simulation.runUntil(3.1));
        const auto written = readScene(file.toStdString());
        QVERIFY2(bool(written), written ? "" : written.message().english().c_str());
        QVERIFY(!hasErrors(problemsOf(*written)));
        const auto system = compile(*written);
        QVERIFY2(bool(system), system ? "" : system.message().english().c_str());

        const System& split = simulation.system();
        const State& state = simulation.state();
        QVERIFY(!state.splits.empty());
        QVERIFY((*system)->mass == split.mass);
        QVERIFY((*system)->inverseMass == split.inverseMass);
        for (std::size_t i = 0; i < split.mass.size(); ++i)
            QCOMPARE(Vec3((*system)->start.position[i]), Vec3(state.position[i]));
        QVERIFY(std::equal(split.panels.begin(), split.panels.end(), (*system)->panels.begin(),
                           (*system)->panels.end(), [](const FabricPanel& a, const FabricPanel& b) {
                               return a.corner == b.corner;
                           }));
        // torn links are left out, and the second ones come last in both
        std::vector<std::array<double, 4>> whole, again;
        for (std::size_t i = 0; i < split.springs.size(); ++i)
            if (const Spring& s = split.springs[i]; !state.springTorn[i])
                whole.push_back({double(s.a), double(s.b), s.stiffness, s.damping});
        for (const Spring& s : (*system)->springs)
            again.push_back({double(s.a), double(s.b), s.stiffness, s.damping});
        QVERIFY(whole == again);
    }
};

const RegisteredTest registered("test_final_scene", runPlain<TestFinalScene>);

} // namespace ripstop::test_final_scene
#include "test_final_scene.moc"
