// The sample scenes of the program, for tests that fly them: as a scene, as a simulation at its
// start, and a probe's value by its name.
//
// A sample that cannot be read or compiled, or a probe that is not there, ends the test program,
// since nothing after it would mean anything.
#pragma once

#include "compile/compile.h"
#include "io/scene_file.h"
#include "simulation/simulation.h"

#include <QDir>
#include <QString>
#include <QtGlobal>

#include <map>

namespace ripstop {

inline Scene sample(const QString& name)
{
    const Result<Scene> scene =
        readScene((QStringLiteral(SCENES_DIR) + "/" + name + ".ripstop.json").toStdString());
    if (!scene)
        qFatal("%s", scene.message().english().c_str());
    return *scene;
}

inline Simulation started(const QString& name)
{
    const auto system = compile(sample(name));
    if (!system)
        qFatal("%s", system.message().english().c_str());
    return Simulation(*system);
}

// Flights that the tests of a file share: each sample is started once and goes on from where the
// last test has left it. So who looks at early moments stands before who looks at late ones.
class SharedFlights
{
public:
    //   latest  s, no later than which the flight must be; 0 for who looks at its start
    Simulation& of(const QString& name, double latest)
    {
        auto found = m_flights.find(name);
        if (found == m_flights.end())
            found = m_flights.emplace(name, started(name)).first;
        if (found->second.state().time > latest + 0.5 * found->second.system().timeStep)
            qFatal("%s has flown on", qPrintable(name));
        return found->second;
    }

private:
    std::map<QString, Simulation> m_flights;
};

inline double probe(const Simulation& simulation, std::string_view name)
{
    const auto frame = simulation.frame();
    for (std::size_t i = 0; i < frame->probe.size(); ++i)
        if (frame->layout->probes[i].name == name)
            return frame->probe[i];
    qFatal("no such probe");
}

inline const Part& partOf(const Scene& scene)
{
    const Part* found = nullptr;
    forEachPart(scene, [&](Id, const Part& part) { found = &part; });
    return *found;
}

inline QStringList sampleNames()
{
    QStringList names;
    const QDir folder(QStringLiteral(SCENES_DIR));
    for (const QString& file : folder.entryList({"*.ripstop.json"}, QDir::Files, QDir::Name))
        names << file.chopped(int(sceneExtension.size()));
    return names;
}

} // namespace ripstop
