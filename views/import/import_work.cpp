// post() numbers each wish, and a job stops at its next report of progress when its number is no
// longer the newest. On the thread of the worker, prepare() reads and repairs what the kept state
// does not have yet, and work() weaves the fabric from that; reading counts for 40 % of the
// progress, the repair for 30 % and the fabric for the rest. collect() runs in the window's thread
// and drops outcomes of wishes that have changed since.
#include "import/import_work.h"

#include "document/words.h"
#include "shapes/mesh_file.h"

#include <set>

namespace ripstop {

ImportWork::ImportWork(QObject* parent)
    : QObject(parent)
    , m_worker(
          [this](const Job& job) { return work(job); },
          [this] { QMetaObject::invokeMethod(this, &ImportWork::collect, Qt::QueuedConnection); })
{}

ImportWork::~ImportWork() { m_newest = -1; }

void ImportWork::post(ImportWish wish)
{
    m_newest = ++m_number;
    m_share = 0.0;
    m_worker.post({std::move(wish), m_number});
}

void ImportWork::stop()
{
    m_newest = ++m_number;
    m_done = m_number;
}

void ImportWork::collect()
{
    const auto outcome = m_worker.take();
    if (!outcome || outcome->number != m_number || !isBusy())
        return; // it belongs to a wish that has changed since
    m_done = outcome->number;
    emit finished(outcome);
}

// Reads and repairs, where that is not done yet. It returns false with the refusal in `outcome`.
bool ImportWork::prepare(const Job& job, ImportOutcome& outcome, const Progress& progress)
{
    const ImportWish& wish = job.wish;
    if (!m_kept.read || m_kept.file != wish.file) {
        m_kept = {};
        Result<PolygonMesh> read =
            readPolygonFile(wish.file.toStdString(), stageOf(progress, 0.0, 0.4));
        if (!read) {
            outcome.refusal = translated(read.message());
            return false;
        }
        m_kept.file = wish.file;
        m_kept.read = std::move(*read);
    }
    const PolygonMesh& read = *m_kept.read;
    outcome.isRead = true;
    outcome.unit = read.unit;
    outcome.isUpright = read.isUpright;
    outcome.objects = std::set(read.object.begin(), read.object.end()).size();
    const std::set used(read.material.begin(), read.material.end());
    const bool tells = used.size() > 1 || std::ranges::any_of(used, [&](int one) {
                           const PolygonMesh::Material& material = read.materials[std::size_t(one)];
                           return !material.name.empty() || !material.color.empty();
                       });
    outcome.materials = tells ? used.size() : 0;
    if (!m_kept.mesh || !(m_kept.shape == wish.shape)) {
        m_kept.mesh = nullptr;
        Result<PreparedMesh> mesh = prepared(read, wish.shape, stageOf(progress, 0.4, 0.7));
        if (!mesh) {
            outcome.refusal = translated(mesh.message());
            return false;
        }
        m_kept.shape = wish.shape;
        m_kept.mesh = std::make_shared<const PreparedMesh>(std::move(*mesh));
    }
    outcome.mesh = m_kept.mesh;
    return true;
}

ImportOutcome ImportWork::work(const Job& job)
{
    ImportOutcome outcome;
    outcome.number = job.number;
    const Progress progress = [this, number = job.number](double share) {
        m_share = share;
        return m_newest == number;
    };
    try {
        if (!prepare(job, outcome, progress))
            return outcome;
        const ImportWish& wish = job.wish;
        outcome.carrier = carrierOf(wish.fabric);
        outcome.weave = weaveOf(*outcome.mesh, wish.fabric);
        Result<MeshImport> made = fabricOf(*outcome.mesh, wish.fabric, wish.name, wish.surroundings,
                                           stageOf(progress, 0.7, 1.0));
        if (made)
            outcome.made = std::move(*made);
        else
            outcome.refusal = translated(made.message());
    } catch (const std::bad_alloc&) {
        outcome.refusal = tr("There is not enough memory for this mesh.");
    }
    return outcome;
}

} // namespace ripstop
