// The common part of sinks whose format knows one mesh for all frames, such as glTF and point
// caches.
#pragma once

#include "export/constant_mesh.h"
#include "export/frame_sink.h"
#include "export/output_files.h"

#include <filesystem>
#include <memory>

namespace ripstop {

// A series of one mesh: keeps the shapes until the last one has come, then has a format write them.
class SpooledSink : public FrameSink
{
public:
    SpooledSink(const std::filesystem::path& target, const MeshAppearance& appearance)
        : m_target(target)
        , m_appearance(appearance)
    {}

    std::optional<Failure> open()
    {
        Result<FrameSpool> spool = FrameSpool::open(m_files, m_target);
        if (!spool)
            return spool.failure();
        m_spool = std::move(*spool);
        return std::nullopt;
    }

    std::optional<Failure> add(const Frame& frame) override { return m_spool.add(frame); }

    std::optional<Failure> finish(const Progress& progress) override
    {
        Result<ConstantMesh> mesh = ConstantMesh::of(m_spool, m_appearance);
        if (!mesh)
            return mesh.failure();
        Result<std::ofstream> out = m_files.open(m_target);
        if (!out)
            return out.failure();
        if (auto failure = write(*mesh, *out, progress))
            return failure;
        if (auto failure = close(*out, m_target))
            return failure;
        return m_files.commit();
    }

protected:
    // What the target has in it; other files go through files().
    virtual std::optional<Failure> write(ConstantMesh& mesh, std::ostream& out,
                                         const Progress& progress) = 0;

    const std::filesystem::path& target() const { return m_target; }
    const MeshAppearance& appearance() const { return m_appearance; }
    OutputFiles& files() { return m_files; }
    FrameSpool& spool() { return m_spool; }

private:
    OutputFiles m_files;
    std::filesystem::path m_target;
    MeshAppearance m_appearance;
    FrameSpool m_spool;
};

inline Result<std::unique_ptr<FrameSink>> opened(std::unique_ptr<SpooledSink> sink)
{
    if (auto failure = sink->open())
        return *failure;
    return std::unique_ptr<FrameSink>(std::move(sink));
}

} // namespace ripstop
