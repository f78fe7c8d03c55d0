// The work behind the import dialog, on a thread of its own: it reads the mesh, repairs it and
// weaves fabric of it.
//
// The window's thread posts wishes and gets finished() for the newest one; a newer wish stops the
// work on the one before. What a wish does not change (the file that was read, the repaired mesh)
// is kept between jobs. A file that cannot be read or used, and too little memory, end in the
// refusal of the outcome, a sentence in the language of the window.
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

// What came of a wish. What is known of a file that could be read is given even if the rest is
// refused.
struct ImportOutcome
{
    int number = 0;
    QString refusal;                          // why there is no import; empty when there is one
    bool isRead = false;                      // the file is a mesh
    std::optional<double> unit;               // m, that the file says
    bool isUpright = false;                   // the file says which way is up
    std::size_t objects = 0;                  // with faces
    std::size_t materials = 0;                // that faces have; none where the file tells of none
    std::shared_ptr<const PreparedMesh> mesh; // or null
    MeshImport made;
    FabricKind carrier = FabricKind::Panels; // as chosen, or by default, as is the weave
    Weave weave;
};

class ImportWork final : public QObject
{
    Q_OBJECT

public:
    explicit ImportWork(QObject* parent = nullptr);
    ~ImportWork() override; // stops what is going on

    void post(ImportWish wish);
    void stop(); // the last wish is dropped: finished() will not be emitted for it
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

    // What stays between jobs. Only the thread of the worker reads and writes it.
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
