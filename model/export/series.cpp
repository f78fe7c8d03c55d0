// There are three sinks. Sequence writes a file for each frame. Pvd makes the folder at the first
// frame, writes a VTP file for each frame into it and collects the rows of the index, which it
// writes last. Table opens its file with the first frame, since the header needs its probes, then
// adds a row for each frame and ends with the state of the last.
//
// All write as the frames come, so that no series is held in memory, and commit their OutputFiles
// in finish(). fileOfFrame() gives four digits at least: the first 10 000 names sort by frame.
#include "export/series.h"

#include "export/moment.h"
#include "export/output_files.h"
#include "export/xml_text.h"
#include "io/csv.h"
#include "io/json_text.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

class Sequence final : public FrameSink
{
public:
    Sequence(fs::path target, const MeshAppearance& appearance, MomentContent content)
        : m_target(std::move(target))
        , m_appearance(appearance)
        , m_content(content)
    {}

    std::optional<Failure> add(const Frame& frame) override
    {
        auto content = m_content(frame, m_appearance);
        if (!content)
            return content.failure();
        if (const auto materials = objMaterials(fileOfFrame(m_target, 0), m_appearance)) {
            *content = materials->line + *content;
            if (m_count == 0)
                if (auto failure = m_files.write(materials->file, materials->text))
                    return failure;
        }
        return m_files.write(fileOfFrame(m_target, m_count++), *content);
    }

    std::optional<Failure> finish(const Progress&) override { return m_files.commit(); }

private:
    OutputFiles m_files;
    fs::path m_target;
    MeshAppearance m_appearance;
    MomentContent m_content;
    std::size_t m_count = 0;
};

class Pvd final : public FrameSink
{
public:
    Pvd(fs::path target, const MeshAppearance& appearance)
        : m_target(std::move(target))
        , m_appearance(appearance)
    {}

    std::optional<Failure> add(const Frame& frame) override
    {
        const std::string stem = m_target.stem().string();
        if (m_count == 0)
            if (auto failure = m_files.makeFolder(m_target.parent_path() / stem))
                return failure;
        const fs::path name =
            fileOfFrame(stem + "_" + std::string(framePlaceholder) + ".vtp", m_count++);
        m_index += "<DataSet timestep=\"";
        appendNumber(m_index, frame.time);
        m_index += R"(" part="0" file=")" + xmlText(stem) + "/" + xmlText(name.string()) + "\"/>\n";
        const auto content = vtpMoment(frame, m_appearance);
        if (!content)
            return content.failure();
        return m_files.write(m_target.parent_path() / stem / name, *content);
    }

    std::optional<Failure> finish(const Progress&) override
    {
        if (auto failure =
                m_files.write(m_target, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
                                        "version=\"0.1\">\n<Collection>\n"
                                            + m_index + "</Collection>\n</VTKFile>\n"))
            return failure;
        return m_files.commit();
    }

private:
    OutputFiles m_files;
    fs::path m_target;
    MeshAppearance m_appearance;
    std::string m_index;
    std::size_t m_count = 0;
};

class Table final : public FrameSink
{
public:
    explicit Table(fs::path target)
        : m_target(std::move(target))
    {}

    void certify(std::shared_ptr<const Certificate> certificate) override
    {
        m_certificate = std::move(certificate);
    }

    std::optional<Failure> add(const Frame& frame) override
    {
        if (!m_out) {
            if (frame.layout->probes.empty())
                return Failure("The scene has no probes, so there is nothing to put into %1; add a "
                               "probe first.",
                               m_target.string());
            Result<std::ofstream> out = m_files.open(m_target);
            if (!out)
                return out.failure();
            m_out = std::move(*out);
            *m_out << csvHeader(frame, m_certificate.get());
        }
        *m_out << csvRow(frame, m_certificate.get());
        m_end = csvEnd(frame);
        return std::nullopt;
    }

    std::optional<Failure> finish(const Progress&) override
    {
        if (!m_out)
            return std::nullopt;
        *m_out << m_end;
        if (auto failure = close(*m_out, m_target))
            return failure;
        return m_files.commit();
    }

private:
    std::shared_ptr<const Certificate> m_certificate; // or null
    OutputFiles m_files;
    fs::path m_target;
    std::optional<std::ofstream> m_out;
    std::string m_end;
};

} // namespace

fs::path fileOfFrame(const fs::path& target, std::size_t number)
{
    std::string digits = std::to_string(number);
    digits.insert(0, std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0'));
    std::string name = target.filename().string();
    if (const auto place = name.find(framePlaceholder); place != std::string::npos)
        name.replace(place, framePlaceholder.size(), digits);
    return target.parent_path() / name;
}

Result<std::unique_ptr<FrameSink>>
sequenceSink(const fs::path& target, const MeshAppearance& appearance, MomentContent content)
{
    return std::unique_ptr<FrameSink>(std::make_unique<Sequence>(target, appearance, content));
}

Result<std::unique_ptr<FrameSink>> pvdSink(const fs::path& target, const MeshAppearance& appearance)
{
    return std::unique_ptr<FrameSink>(std::make_unique<Pvd>(target, appearance));
}

Result<std::unique_ptr<FrameSink>> tableSink(const fs::path& target, const MeshAppearance&)
{
    return std::unique_ptr<FrameSink>(std::make_unique<Table>(target));
}

} // namespace ripstop
