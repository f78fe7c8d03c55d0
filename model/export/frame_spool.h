// A file on the way for series whose mesh must not change: shapes go in as they come and are read
// again when the last is known. Places are in metres, in single precision.
#pragma once

#include "export/output_files.h"
#include "simulation/frame.h"

#include <memory>
#include <vector>

namespace ripstop {

// The shapes of a series, kept in a file beside its target until the last one is there: formats
// whose mesh must not change have to know what will have torn in the end.
class FrameSpool
{
public:
    struct Shape
    {
        std::vector<Eigen::Vector3f> position; // [particles] m
        std::vector<std::uint8_t> gone;        // [panels]
        std::vector<std::uint8_t> torn;        // [links]
    };

    static Result<FrameSpool> open(OutputFiles& files, const std::filesystem::path& besides);

    std::optional<Failure> add(const Frame& frame);

    std::size_t count() const { return m_frames.size(); }
    double time(std::size_t i) const { return m_frames[i].time; } // s
    const Layout& layout(std::size_t i) const { return *m_frames[i].layout; }
    const std::vector<std::uint8_t>& everGone() const { return m_everGone; } // [panels]
    const std::vector<std::uint8_t>& everTorn() const { return m_everTorn; } // [links of the last]

    Result<Shape> read(std::size_t i);

private:
    struct Entry
    {
        double time; // s
        std::shared_ptr<const Layout> layout;
        std::streamoff begin;
    };

    std::filesystem::path m_besides;
    std::fstream m_file;
    std::vector<Entry> m_frames;
    std::vector<std::uint8_t> m_everGone;
    std::vector<std::uint8_t> m_everTorn;
};

} // namespace ripstop
