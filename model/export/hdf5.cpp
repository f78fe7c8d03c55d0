// Handles close themselves. A dataset grows by a frame at a time, in chunks that hold a frame or
// many small ones; its bytes are sorted by their place in a number and then compressed, which is
// half of what compression alone leaves. The file is written beside its target by the library.
#include "export/hdf5.h"

#ifdef RIPSTOP_HAS_HDF5

#include "base/program_version.h"
#include "export/output_files.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace ripstop {
namespace {

constexpr unsigned compression = 3;      // of zlib, 1 to 9
constexpr hsize_t numbersInChunk = 4096; // at least, of datasets with few numbers in a frame

class Handle
{
public:
    Handle(hid_t id, herr_t (*close)(hid_t))
        : m_id(id)
        , m_close(close)
    {}
    Handle(Handle&& other) noexcept
        : m_id(std::exchange(other.m_id, -1))
        , m_close(other.m_close)
    {}
    ~Handle()
    {
        if (m_id >= 0)
            m_close(m_id);
    }

    hid_t get() const { return m_id; }
    explicit operator bool() const { return m_id >= 0; }

private:
    hid_t m_id;
    herr_t (*m_close)(hid_t);
};

bool addText(hid_t object, const char* name, const std::string& text)
{
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), H5T_VARIABLE); // which Python reads as text
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(
        H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const char* const characters = text.c_str();
    return attribute && H5Awrite(attribute.get(), type.get(), &characters) >= 0;
}

bool addNumber(hid_t object, const char* name, std::int64_t number)
{
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(
        H5Acreate2(object, name, H5T_NATIVE_INT64, space.get(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    return attribute && H5Awrite(attribute.get(), H5T_NATIVE_INT64, &number) >= 0;
}

template <typename T>
hid_t typeOf()
{
    if constexpr (std::is_same_v<T, double>)
        return H5T_NATIVE_DOUBLE;
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return H5T_NATIVE_INT64;
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return H5T_NATIVE_UINT32;
    else if constexpr (std::is_same_v<T, int>)
        return H5T_NATIVE_INT;
    else
        return H5T_NATIVE_UINT8;
}

using Shape = std::vector<hsize_t>; // of what a frame has

// What is the same in all frames.
template <typename T>
bool addArray(hid_t group, const char* name, const std::vector<T>& values, const Shape& shape)
{
    const Handle space(H5Screate_simple(int(shape.size()), shape.data(), nullptr), H5Sclose);
    const Handle set(
        H5Dcreate2(group, name, typeOf<T>(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
    return set
           && (values.empty()
               || H5Dwrite(set.get(), typeOf<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data())
                      >= 0);
}

// Grows by a frame with each call of add().
class GrowingSet
{
public:
    GrowingSet(hid_t group, const std::string& name, hid_t type, const Shape& shape,
               const std::string& unit)
        : m_type(type)
        , m_shape(shape)
        , m_set(made(group, name, type, shape), H5Dclose)
    {
        m_isSound = bool(m_set) && (unit.empty() || addText(m_set.get(), "unit", unit));
    }

    bool add(const void* values)
    {
        if (!m_isSound)
            return false;
        Shape size{m_count + 1}, from{m_count}, count{1};
        for (const hsize_t n : m_shape) {
            size.push_back(n);
            from.push_back(0);
            count.push_back(n);
        }
        m_isSound = H5Dset_extent(m_set.get(), size.data()) >= 0;
        ++m_count;
        if (!m_isSound || std::ranges::find(count, hsize_t(0)) != count.end())
            return m_isSound;
        const Handle file(H5Dget_space(m_set.get()), H5Sclose);
        H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, from.data(), nullptr, count.data(),
                            nullptr);
        const Handle memory(H5Screate_simple(int(count.size()), count.data(), nullptr), H5Sclose);
        m_isSound =
            H5Dwrite(m_set.get(), m_type, memory.get(), file.get(), H5P_DEFAULT, values) >= 0;
        return m_isSound;
    }

private:
    static hid_t made(hid_t group, const std::string& name, hid_t type, const Shape& shape)
    {
        Shape none{0}, endless{H5S_UNLIMITED}, chunk{1};
        hsize_t numbers = 1;
        for (const hsize_t n : shape) {
            none.push_back(n);
            endless.push_back(n);
            chunk.push_back(std::max<hsize_t>(n, 1));
            numbers *= chunk.back();
        }
        chunk.front() = std::max<hsize_t>(1, numbersInChunk / numbers);
        const Handle space(H5Screate_simple(int(none.size()), none.data(), endless.data()),
                           H5Sclose);
        const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_chunk(how.get(), int(chunk.size()), chunk.data());
        H5Pset_shuffle(how.get());
        H5Pset_deflate(how.get(), compression);
        return H5Dcreate2(group, name.c_str(), type, space.get(), H5P_DEFAULT, how.get(),
                          H5P_DEFAULT);
    }

    hid_t m_type;
    Shape m_shape;
    Handle m_set;
    hsize_t m_count = 0; // frames
    bool m_isSound = false;
};

Handle groupIn(hid_t parent, const char* name)
{
    return {H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
}

// The frames of one layout.
class MeshGroup
{
public:
    MeshGroup(hid_t file, int number, std::int64_t firstFrame, const Frame& frame)
        : m_layout(frame.layout)
        , m_group(groupIn(file, ("mesh" + std::to_string(number)).c_str()))
        , m_particles(groupIn(m_group.get(), "particles"))
        , m_links(groupIn(m_group.get(), "links"))
        , m_panels(groupIn(m_group.get(), "panels"))
        , m_carries(!frame.panelPull.empty())
    {
        m_isSound = m_panels && addNumber(m_group.get(), "first_frame", firstFrame) && addLayout();
        const Layout& layout = *m_layout;
        const hsize_t particles = layout.particleId.size(), links = layout.links.size(),
                      panels = layout.panelId.size();
        grow(m_group, "time", H5T_NATIVE_DOUBLE, {}, "s");
        grow(m_particles, "position", H5T_NATIVE_DOUBLE, {particles, 3}, "m");
        grow(m_particles, "velocity", H5T_NATIVE_DOUBLE, {particles, 3}, "m/s");
        grow(m_links, "strain", H5T_NATIVE_DOUBLE, {links}, "1");
        grow(m_links, "tension", H5T_NATIVE_DOUBLE, {links}, "N");
        grow(m_links, "torn", H5T_NATIVE_UINT8, {links}, "");
        grow(m_panels, "load", H5T_NATIVE_DOUBLE, {panels, 3}, "N");
        grow(m_panels, "gone", H5T_NATIVE_UINT8, {panels}, "");
        if (m_carries) {
            grow(m_panels, "strain", H5T_NATIVE_DOUBLE, {panels}, "1");
            grow(m_panels, "tension", H5T_NATIVE_DOUBLE, {panels}, "N/m");
            grow(m_panels, "state", H5T_NATIVE_INT, {panels}, "");
        }
    }

    bool isOf(const Frame& frame) const
    {
        return m_carries == !frame.panelPull.empty()
               && (frame.layout == m_layout || *frame.layout == *m_layout);
    }

    bool add(const Frame& frame)
    {
        std::vector<const void*> values{&frame.time,
                                        frame.position.data(),
                                        frame.velocity.data(),
                                        frame.strain.data(),
                                        frame.tension.data(),
                                        frame.torn.data(),
                                        frame.panelLoad.data(),
                                        frame.gone.data()};
        std::vector<double> strain, tension;
        std::vector<int> state; // 0 slack, 1 wrinkled, 2 taut, -1 of panels that carry no pull
        if (m_carries) {
            for (const PanelPull& pull : frame.panelPull) {
                strain.push_back(pull.strain);
                tension.push_back(pull.tension);
                state.push_back(pull.carries ? int(pull.state) : -1);
            }
            values.insert(values.end(), {strain.data(), tension.data(), state.data()});
        }
        for (std::size_t i = 0; i < m_sets.size(); ++i)
            m_isSound = m_sets[i].add(values[i]) && m_isSound;
        return m_isSound;
    }

private:
    void grow(const Handle& group, const char* name, hid_t type, const Shape& shape,
              const char* unit)
    {
        m_sets.emplace_back(group.get(), name, type, shape, unit);
    }

    bool addLayout()
    {
        std::vector<std::uint32_t> linkId;
        std::vector<int> ends, corners;
        for (const Layout::Link& link : m_layout->links) {
            linkId.push_back(link.id);
            ends.insert(ends.end(), {link.a, link.b});
        }
        for (const auto& corner : m_layout->panelCorners)
            corners.insert(corners.end(), corner.begin(), corner.end());
        return addArray(m_particles.get(), "id", m_layout->particleId,
                        {m_layout->particleId.size()})
               && addArray(m_links.get(), "id", linkId, {linkId.size()})
               && addArray(m_links.get(), "ends", ends, {linkId.size(), 2})
               && addArray(m_panels.get(), "id", m_layout->panelId, {m_layout->panelId.size()})
               && addArray(m_panels.get(), "corners", corners, {m_layout->panelId.size(), 3});
    }

    std::shared_ptr<const Layout> m_layout;
    Handle m_group;
    Handle m_particles;
    Handle m_links;
    Handle m_panels;
    bool m_carries; // panels do, the pull of the fabric
    bool m_isSound = false;
    std::vector<GrowingSet> m_sets; // in the order of add()
};

class Hdf5 final : public FrameSink
{
public:
    explicit Hdf5(std::filesystem::path target)
        : m_target(std::move(target))
    {
        H5dont_atexit(); // which would close again, and crash, what a full disk did not let it
                         // close
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it prints what it returns as well
    }
    ~Hdf5() override { closeAll(); }

    std::optional<Failure> add(const Frame& frame) override
    {
        errno = 0;
        if (m_count == 0 && !begin(frame))
            return notWritten(m_target);
        if (!m_mesh || !m_mesh->isOf(frame)) {
            m_mesh.reset();
            m_mesh.emplace(m_file->get(), m_meshes++, m_count, frame);
        }
        bool isSound =
            m_mesh->add(frame) && m_series[0].add(&frame.time) && m_series[1].add(&frame.step);
        for (std::size_t i = 0; i < m_probes; ++i) {
            const double value = i < frame.probe.size() ? frame.probe[i] : NAN;
            isSound = m_series[2 + i].add(&value) && isSound;
        }
        ++m_count;
        if (!isSound)
            return notWritten(m_target);
        return std::nullopt;
    }

    std::optional<Failure> finish(const Progress&) override
    {
        errno = 0;
        if (m_count > 0 && !closeAll())
            return notWritten(m_target);
        return m_files.commit();
    }

private:
    bool begin(const Frame& frame)
    {
        const std::string written = m_files.reserve(m_target).string();
        m_file.emplace(H5Fcreate(written.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                       H5Fclose);
        if (!*m_file)
            return false;
        const hid_t file = m_file->get();
        m_series.emplace_back(file, "time", H5T_NATIVE_DOUBLE, Shape{}, "s");
        m_series.emplace_back(file, "step", H5T_NATIVE_INT64, Shape{}, "");
        const Handle probes = groupIn(file, "probes");
        std::map<std::string, int> times;
        for (const Layout::Probe& probe : frame.layout->probes) {
            std::string name = probe.name.empty() ? "probe" : probe.name;
            std::ranges::replace(name, '/', '_'); // which stands between groups
            if (const int before = times[name]++; before > 0 || name == ".")
                name += " " + std::to_string(before + 1);
            m_series.emplace_back(probes.get(), name, H5T_NATIVE_DOUBLE, Shape{}, probe.unit);
        }
        m_probes = frame.layout->probes.size();
        return bool(probes) && addText(file, "format", "ripstop-series")
               && addNumber(file, "version", 1) && addText(file, "program", programVersion());
    }

    bool closeAll()
    {
        m_mesh.reset();
        m_series.clear();
        const bool isWhole = !m_file || !*m_file || H5Fflush(m_file->get(), H5F_SCOPE_GLOBAL) >= 0;
        m_file.reset();
        return isWhole;
    }

    OutputFiles m_files;
    std::filesystem::path m_target;
    std::optional<Handle> m_file;
    std::optional<MeshGroup> m_mesh;
    std::vector<GrowingSet> m_series; // time, step and the probes
    std::size_t m_probes = 0;
    std::int64_t m_count = 0; // frames
    int m_meshes = 0;
};

} // namespace

Result<std::unique_ptr<FrameSink>> hdf5Sink(const std::filesystem::path& target,
                                            const MeshAppearance&)
{
    return std::unique_ptr<FrameSink>(std::make_unique<Hdf5>(target));
}

#else

namespace ripstop {

Result<std::unique_ptr<FrameSink>> hdf5Sink(const std::filesystem::path& target,
                                            const MeshAppearance&)
{
    return Failure("%1 is an HDF5 file, which this program was built without; export .pvd or .csv, "
                   "or build it with libhdf5-dev.",
                   target.string());
}

#endif

} // namespace ripstop
