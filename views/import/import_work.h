#pragma once

#include "author/mesh_import.h"
#include "document/worker.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <memory>

namespace ripstop {

// What is to be made of which file.
struct ImportWish
{
    QString file;
    MeshShape shape;
    MeshFabric fabric;
    std::string name; // of the part
    Surroundings surroundings;
};

// What came of it. A file that could be read is told of even if the rest is refused.
struct ImportOutcome
{
    int number = 0;
    QString refusal;                          // why there is no import; empty when there is one
    bool isRead = false;                      // the file is a mesh
    std::optional<double> unit;               // m, that the file says
    bool isUpright = false;                   // the file says which way is up
    std::size_t objects = 0;                  // with faces
    std::size_t materials = 0;                // that faces have
    std::shared_ptr<const PreparedMesh> mesh; // or null
    MeshImport made;
    Weave weave; // as chosen, or by default
};

// Reads, repairs and weaves on a thread of its own. A newer wish stops the work on the one before;
// what it does not change (the file, the repaired mesh) is kept.
class ImportWork final : public QObject
{
    Q_OBJECT

public:
    explicit ImportWork(QObject* parent = nullptr);
    ~ImportWork() override; // stops what is going on

    void post(ImportWish wish);
    void stop(); // nothing will come of the last wish
    bool isBusy() const { return m_done < m_number; }
    double share() const { return m_share; } // of the present wish that is done, 0 to 1

signals:
    void finished(std::shared_ptr<const ripstop::ImportOutcome> outcome); // of the newest wish

private:
    struct Job
    {
        ImportWish wish;
        int number;
    };

    // What stays between jobs; the worker's thread alone looks at it.
    struct Kept
    {
        QString file;
        std::optional<PolygonMesh> read;
        MeshShape shape;
        std::shared_ptr<const PreparedMesh> mesh;
    };

    ImportOutcome work(const Job& job);
    bool prepare(const Job& job, ImportOutcome& outcome, const Progress& progress);
    void collect();

    std::atomic<int> m_newest = 0; // number of the wish that is worth working on
    std::atomic<double> m_share = 0.0;
    int m_number = 0; // of the newest wish
    int m_done = 0;   // of the last outcome, or of what was stopped
    Kept m_kept;
    Worker<Job, ImportOutcome> m_worker;
};

} // namespace ripstop
