// First the blocks with their checksums, then the writer, which puts each design before the first
// stretch that names it, then the reader, which goes block by block and keeps what came before any
// damage. Packed frames stay in the file until they are asked for.
#include "io/recording_file.h"
#include "base/program_version.h"

#include "base/bytes.h"
#include "io/recording_bounds.h"
#include "io/scene_file.h"
#include "io/whole_file.h"
#include "recording/packed.h"
#include "recording/run_fields.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <mutex>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

// The first line of a file of each version, the newest last. What came since a version is marked at
// its field (Since).
constexpr std::array<std::string_view, recordingVersion> firstLines{
    "RIPSTOP-RUN 1\n", "RIPSTOP-RUN 2\n", "RIPSTOP-RUN 3\n",
    "RIPSTOP-RUN 4\n", "RIPSTOP-RUN 5\n", "RIPSTOP-RUN 6\n"};
constexpr std::string_view firstLine = firstLines.back();
static_assert(std::all_of(firstLines.begin(), firstLines.end(),
                          [](std::string_view line) { return line.size() == firstLine.size(); }));

enum class BlockKind : std::uint32_t { About = 1, Design, Stretch, End, Certificate };

struct BlockHead
{
    BlockKind kind = BlockKind::End;
    std::uint64_t length = 0;
    std::uint64_t checksum = 0; // of kind and content
};

constexpr std::size_t headSize = sizeof(std::uint32_t) + 2 * sizeof(std::uint64_t);

struct About
{
    std::string program;
    std::string name;
    std::string origin;
    std::vector<Bookmark> bookmarks;
};

} // namespace

template <>
inline constexpr auto fieldsOf<BlockHead> =
    fields<BlockHead, &BlockHead::kind, &BlockHead::length, &BlockHead::checksum>;

template <>
inline constexpr auto fieldsOf<About> =
    fields<About, &About::program, &About::name, &About::origin, &About::bookmarks>;

namespace {

std::uint64_t checksumOf(BlockKind kind, std::string_view content)
{
    return checksum(content) ^ (std::uint64_t(kind) * 0x9e3779b97f4a7c15u);
}

template <typename T>
std::string written(const T& value)
{
    ByteWriter writer;
    writer(value);
    return writer.take();
}

template <typename T>
bool readWhole(std::string_view bytes, T& value, int version = newestVersion)
{
    ByteReader reader(bytes, version);
    reader(value);
    return reader.ok() && reader.atEnd();
}

// --- writing -------------------------------------------------------------------------------------

void write(std::ostream& out, BlockKind kind, std::string_view content)
{
    const std::string head = written(BlockHead{kind, content.size(), checksumOf(kind, content)});
    out.write(head.data(), std::streamsize(head.size()));
    out.write(content.data(), std::streamsize(content.size()));
}

class RecordingWriter
{
public:
    RecordingWriter(const Recording& recording, fs::path folder, std::ostream& out)
        : m_recording(recording)
        , m_folder(std::move(folder))
        , m_out(out)
    {}

    void writeStart()
    {
        m_out.write(firstLine.data(), std::streamsize(firstLine.size()));
        ripstop::write(m_out, BlockKind::About,
                       written(About{"ripstop " + programVersion(), m_recording.name(),
                                     m_recording.origin(), m_recording.bookmarks()}));
        if (const auto certificate = m_recording.certificate())
            ripstop::write(m_out, BlockKind::Certificate,
                           packed(written(*certificate), Packing::Small));
    }

    std::optional<Failure> writeStretch(std::size_t number)
    {
        const StoredChunk chunk = m_recording.chunk(number);
        writeDesigns(chunk);
        const Result<std::string> bytes = m_recording.chunkBytes(number);
        if (!bytes)
            return bytes.failure();
        const std::string head = packed(written(chunk), Packing::Small);
        std::string content = written(std::uint64_t(head.size()));
        content += head;
        content += *bytes;
        ripstop::write(m_out, BlockKind::Stretch, content);
        return std::nullopt;
    }

    void writeEnd() { ripstop::write(m_out, BlockKind::End, {}); }

    std::optional<Failure> write(const Progress& progress)
    {
        writeStart();
        const std::size_t count = m_recording.chunkCount();
        for (std::size_t i = 0; i < count && m_out; ++i) {
            if (auto failure = writeStretch(i))
                return failure;
            if (!goesOn(progress, double(i + 1) / double(count)))
                return Failure{"Cancelled."};
        }
        writeEnd();
        return std::nullopt;
    }

private:
    // Each before the first stretch that names it.
    void writeDesigns(const StoredChunk& chunk)
    {
        int last = chunk.design;
        for (const RunInput& input : chunk.inputs)
            if (const auto* change = std::get_if<DesignChange>(&input.what))
                last = std::max(last, change->number);
        for (; m_designs <= last; ++m_designs) {
            std::string text = sceneText(m_recording.design(m_designs).scene(), m_folder);
            ripstop::write(m_out, BlockKind::Design,
                           m_designs == 0 ? packed(text, Packing::Small)
                                          : packedAfter(m_text, text));
            m_text = std::move(text);
        }
    }

    const Recording& m_recording;
    fs::path m_folder; // of the file; what scenes name is seen from there
    std::ostream& m_out;
    int m_designs = 0;  // that are written
    std::string m_text; // of the last
};

// --- reading -------------------------------------------------------------------------------------

// Of one open file, also when it is replaced or removed.
class RunFile
{
public:
    explicit RunFile(const fs::path& file)
        : m_in(file, std::ios::binary)
    {}
    bool isOpen() const { return bool(m_in); }

    std::string read(std::uint64_t place, std::size_t size) // shorter where the file ends
    {
        const std::lock_guard lock(m_mutex);
        std::string bytes(size, '\0');
        m_in.clear();
        m_in.seekg(std::streamoff(place));
        m_in.read(bytes.data(), std::streamsize(size));
        bytes.resize(m_in.bad() || m_in.gcount() < 0 ? 0 : std::size_t(m_in.gcount()));
        return bytes;
    }

private:
    std::mutex m_mutex;
    std::ifstream m_in;
};

class RecordingReader
{
public:
    RecordingReader(std::shared_ptr<RunFile> file, int version, std::uint64_t size,
                    const fs::path& path)
        : m_file(std::move(file))
        , m_version(version)
        , m_size(size)
        , m_name(path.string())
        , m_folder(path.parent_path().string())
    {}

    // What is wrong with the next block, or nothing.
    std::optional<Message> next()
    {
        const std::string bytes = m_file->read(m_place, headSize);
        BlockHead head;
        if (bytes.size() < headSize || !readWhole(bytes, head))
            return Message("is cut off");
        if (head.length > m_size - m_place - headSize)
            return Message("is cut off");
        if (head.length > RecordingBudget::largestBlock)
            return Message("is damaged");
        const std::string content = m_file->read(m_place + headSize, std::size_t(head.length));
        if (content.size() < head.length || checksumOf(head.kind, content) != head.checksum)
            return Message("is damaged");
        const std::uint64_t begin = m_place + headSize;
        m_place = begin + head.length;
        m_budget.hasRead(headSize + head.length);
        if (head.kind == BlockKind::End)
            m_atEnd = true;
        else if (head.kind == BlockKind::About)
            return readAbout(content);
        else if (head.kind == BlockKind::Certificate)
            return readCertificate(content);
        else if (head.kind == BlockKind::Design)
            return readDesign(content);
        else if (head.kind == BlockKind::Stretch)
            return readStretch(content, begin);
        return std::nullopt; // of a later version, and no matter
    }

    std::uint64_t place() const { return m_place; }
    bool atEnd() const { return m_atEnd; }
    std::shared_ptr<Recording> take() { return std::move(m_recording); }

private:
    std::optional<Message> readAbout(const std::string& content)
    {
        About about;
        if (!readWhole(content, about))
            return Message("is damaged");
        m_recording->setName(about.name);
        m_recording->setOrigin(about.origin);
        m_recording->setBookmarks(about.bookmarks);
        return std::nullopt;
    }

    std::optional<Message> readCertificate(const std::string& content)
    {
        if (!m_budget.takesToKeep(content))
            return tooMuch();
        const Result<std::string> bytes = unpacked(content);
        Certificate certificate;
        const auto isWhole = [&](const CertifiedProbe& probe) {
            return probe.value.size() == certificate.time.size()
                   && probe.error.size() == certificate.time.size();
        };
        if (!bytes || !readWhole(*bytes, certificate)
            || !std::ranges::all_of(certificate.probes, isWhole))
            return Message("is damaged");
        m_recording->setCertificate(std::make_shared<const Certificate>(std::move(certificate)));
        return std::nullopt;
    }

    std::optional<Message> readDesign(const std::string& content)
    {
        if (!m_budget.takesDesign(content))
            return tooMuch();
        Result<std::string> text = unpacked(content, m_text);
        if (!text)
            return Message("is damaged");
        Result<Scene> scene = parseScene(*text, m_name);
        if (!scene)
            return Message("has a scene that cannot be read (%1)", scene.message());
        scene->folder.path = m_folder;
        m_time.addDesign(scene->settings.timeStep);
        m_recording->addDesign({std::make_shared<const Scene>(std::move(*scene)), {}});
        m_text = std::move(*text);
        return std::nullopt;
    }

    static Message tooMuch() { return Message("asks for more memory than its bytes may need"); }

    bool isSound(const StoredChunk& chunk)
    {
        const int designs = int(m_recording->designCount());
        const auto isKnown = [&](const RunInput& input) {
            const auto* change = std::get_if<DesignChange>(&input.what);
            return !change || (change->number >= 0 && change->number < designs);
        };
        return chunk.design >= 0 && chunk.design < designs && m_time.takes(chunk)
               && std::all_of(chunk.inputs.begin(), chunk.inputs.end(), isKnown);
    }

    std::optional<Message> readStretch(const std::string& content, std::uint64_t begin)
    {
        std::uint64_t length = 0;
        constexpr std::size_t prefix = sizeof length;
        if (content.size() < prefix
            || !readWhole(std::string_view(content).substr(0, prefix), length)
            || length > content.size() - prefix)
            return Message("is damaged");
        const auto packedHead = std::string_view(content).substr(prefix, std::size_t(length));
        if (!m_budget.takesToKeep(packedHead)
            || !m_budget.takes(std::string_view(content).substr(prefix + std::size_t(length))))
            return tooMuch();
        const Result<std::string> head = unpacked(packedHead);
        StoredChunk chunk;
        if (!head || !readWhole(*head, chunk, m_version) || !isSound(chunk))
            return Message("is damaged");
        std::erase_if(chunk.events, [](const RunEvent& event) { // of a later version
            return std::size_t(event.kind) >= runEventNames.size();
        });
        const std::uint64_t place = begin + prefix + length;
        const std::size_t size = content.size() - prefix - std::size_t(length);
        const auto fetch = [file = m_file, place, size, name = m_name]() -> Result<std::string> {
            std::string bytes = file->read(place, size);
            if (bytes.size() < size)
                return Failure("%1 can no longer be read; open it again.", name);
            return bytes;
        };
        m_recording->addChunk(std::move(chunk), fetch, size);
        return std::nullopt;
    }

    std::shared_ptr<RunFile> m_file;
    int m_version; // of the file
    std::uint64_t m_size;
    std::string m_name;
    std::string m_folder; // what scenes name is seen from there
    std::uint64_t m_place = firstLine.size();
    bool m_atEnd = false;
    RecordingBudget m_budget;
    RecordedTime m_time;
    std::string m_text; // of the last design
    std::shared_ptr<Recording> m_recording = std::make_shared<Recording>(0);
};

} // namespace

std::optional<Failure> saveRecording(const Recording& recording, const fs::path& file,
                                     const Progress& progress)
{
    return replaceFile(
        file, WriteInto([&](std::ostream& out) {
            return RecordingWriter(recording, file.parent_path(), out).write(progress);
        }));
}

// --- growing -------------------------------------------------------------------------------------

class GrowingRecording::Private
{
public:
    Private(fs::path asked, NewFile made)
        : target(std::move(asked))
        , file(std::move(made))
    {}
    ~Private() { stop(); }

    void stop()
    {
        if (recording)
            recording->tellOfStretches({});
    }

    void add(std::size_t number)
    {
        if (!failure)
            failure = writer->writeStretch(number);
        file.out().flush(); // what is killed keeps what it has given to the system
        next = number + 1;
    }

    fs::path target;
    NewFile file;
    std::shared_ptr<Recording> recording;
    std::optional<RecordingWriter> writer;
    std::size_t next = 0; // stretch
    std::optional<Failure> failure;
};

GrowingRecording::GrowingRecording(std::unique_ptr<Private> made)
    : d(std::move(made))
{}
GrowingRecording::GrowingRecording(GrowingRecording&&) noexcept = default;
GrowingRecording::~GrowingRecording() = default;

Result<GrowingRecording> GrowingRecording::open(const fs::path& file)
{
    Result<NewFile> made = NewFile::openToKeep(file);
    if (!made)
        return made.failure();
    return GrowingRecording(std::make_unique<Private>(file, std::move(*made)));
}

void GrowingRecording::follow(std::shared_ptr<Recording> recording)
{
    d->recording = std::move(recording);
    d->recording->setName(d->target.stem().string());
    d->writer.emplace(*d->recording, d->target.parent_path(), d->file.out());
    d->writer->writeStart();
    d->recording->tellOfStretches([inside = d.get()](std::size_t number) { inside->add(number); });
}

std::optional<Failure> GrowingRecording::finish()
{
    if (!d->recording)
        return Failure("%1 was not written: no step was made.", d->target.string());
    d->stop();
    for (std::size_t count = d->recording->chunkCount(); d->next < count && !d->failure;)
        d->add(d->next);
    if (d->failure)
        return d->failure;
    d->writer->writeEnd();
    if (auto failure = d->file.commit())
        return failure;
    if (!d->recording->trouble().empty())
        return Failure("%1: %2", d->target.string(), d->recording->trouble());
    return std::nullopt;
}

Result<OpenedRecording> openRecording(const fs::path& file, const Progress& progress)
{
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status))
        return Failure("%1 does not exist; check the path.", file.string());
    if (!fs::is_regular_file(status))
        return Failure("%1 is no file; name a recording (*.ripstop-run).", file.string());
    const auto size = fs::file_size(file, error);
    const auto open = std::make_shared<RunFile>(file);
    if (error || !open->isOpen())
        return Failure("%1 cannot be opened; check that you may read it.", file.string());
    const std::string start = open->read(0, firstLine.size());
    const auto line = std::find(firstLines.begin(), firstLines.end(), start);
    if (line == firstLines.end()) {
        const bool newer = start.starts_with(firstLine.substr(0, firstLine.find(' ') + 1));
        return newer ? Failure("%1 was written by a later version of Ripstop; open it with that.",
                               file.string())
                     : Failure("%1 is not a recording of Ripstop (*.ripstop-run).", file.string());
    }

    const int version = int(line - firstLines.begin()) + 1;
    RecordingReader reader(open, version, size, file);
    OpenedRecording opened;
    std::optional<Message> wrong;
    while (!reader.atEnd() && !wrong) {
        wrong = reader.next();
        if (!goesOn(progress, double(reader.place()) / double(std::max<std::uintmax_t>(1, size))))
            return Failure{"Cancelled."};
    }
    opened.recording = reader.take();
    const std::size_t frames = opened.recording->frameCount();
    if (frames == 0)
        return wrong ? Failure("%1 %2 before its first frame; there is nothing to show.",
                               file.string(), *wrong)
                     : Failure("%1 holds no frame.", file.string());
    opened.recording->finish();
    if (wrong)
        opened.damage = Message("%1 %2 after %3 s of simulated time; what comes before is shown.",
                                file.string(), *wrong,
                                Message::number("%.3f", opened.recording->timeOf(frames - 1)));
    return opened;
}

} // namespace ripstop
