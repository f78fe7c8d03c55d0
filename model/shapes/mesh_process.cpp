// The program is found, started with the file as its argument and its standard output as a pipe,
// listened to until it ends, and what it said or how it ended becomes a mesh or a sentence.
//
// posix_spawn() rather than fork(): other threads run, and what they hold would be copied.
#include "shapes/mesh_process.h"

#include "shapes/mesh_answer.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

constexpr const char* readerName = "ripstop-mesh-reader";
constexpr int listenFor = 50; // ms, between two questions whether to go on

class OwnHandle
{
public:
    explicit OwnHandle(int handle = -1)
        : m_handle(handle)
    {}
    OwnHandle(OwnHandle&& other) noexcept
        : m_handle(std::exchange(other.m_handle, -1))
    {}
    ~OwnHandle() { close(); }

    int get() const { return m_handle; }
    void close()
    {
        if (m_handle >= 0)
            ::close(std::exchange(m_handle, -1));
    }

private:
    int m_handle;
};

// --- the process -------------------------------------------------------------------------------

std::optional<fs::path> readerProgram()
{
    std::error_code error;
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& place : {folder / readerName, folder.parent_path() / "bin" / readerName})
        if (fs::is_regular_file(place, error))
            return place;
    return std::nullopt;
}

// A process that is ended and waited for at the latest when this is destroyed.
class ReaderProcess
{
public:
    // 0, or the number of what went wrong.
    int start(const fs::path& program, const fs::path& file, int output)
    {
        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        // Ctrl-C in a terminal is for the program that started it, which ends it when it is done.
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK
                                                  | POSIX_SPAWN_SETSIGDEF);
        sigset_t signals;
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes, &signals);
        sigfillset(&signals);
        posix_spawnattr_setsigdefault(&attributes, &signals);

        std::string name = program.string();
        std::string argument = file.string();
        const std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
        const int error =
            posix_spawn(&m_process, name.c_str(), &files, &attributes, arguments.data(), environ);
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
        m_isRunning = error == 0;
        return error;
    }
    ~ReaderProcess()
    {
        if (m_isRunning) {
            ::kill(m_process, SIGKILL);
            wait();
        }
    }

    // How it ended, as waitpid() has it.
    int wait()
    {
        int status = 0;
        while (::waitpid(m_process, &status, 0) < 0 && errno == EINTR) {
        }
        m_isRunning = false;
        return status;
    }

private:
    pid_t m_process = 0;
    bool m_isRunning = false;
};

// --- what it says ------------------------------------------------------------------------------

enum class Heard { All, Nonsense, Cancelled };

// Listens until the pipe is closed at the other end.
Heard listen(int pipe, MeshAnswer& answer, const Progress& progress)
{
    std::array<char, 1 << 16> bytes;
    for (;;) {
        if (!goesOn(progress, answer.share()))
            return Heard::Cancelled;
        pollfd awaited{.fd = pipe, .events = POLLIN, .revents = 0};
        if (::poll(&awaited, 1, progress ? listenFor : -1) <= 0)
            continue; // nothing yet, or a signal
        const ssize_t size = ::read(pipe, bytes.data(), bytes.size());
        if (size < 0 && errno == EINTR)
            continue;
        if (size <= 0)
            return Heard::All;
        if (!answer.take({bytes.data(), std::size_t(size)}))
            return Heard::Nonsense;
        if (answer.isOver())
            return Heard::All;
    }
}

Failure sentenceOf(const fs::path& file, ReadTrouble trouble, const std::string& why)
{
    switch (trouble) {
    case ReadTrouble::UnknownFormat:
        return Failure("The mesh %1 has no known format; choose an OBJ, STL, PLY, OFF, glTF, GLB, "
                       "Collada (.dae), VTP or VTU file.",
                       file.string());
    case ReadTrouble::TooManyBytes:
        return Failure("The mesh %1 and the files that it names are larger than 1 GiB; make it "
                       "coarser in a mesh program first.",
                       file.string());
    case ReadTrouble::TooMuchMemory:
        return Failure("The mesh %1 asks for more memory than a file of its size may need; it is "
                       "damaged, or has to be saved in another format.",
                       file.string());
    case ReadTrouble::Unreadable:
        break;
    }
    return Failure("The mesh %1 cannot be read (%2). The file may be cut off or of another "
                   "format; save it again, or choose another file.",
                   file.string(), why);
}

// It ended without an answer.
Failure sentenceOf(const fs::path& file, int status)
{
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGXCPU || signal == SIGALRM)
        return Failure("The mesh %1 takes longer to read than a file of its size may; it is "
                       "damaged, or has to be saved in another format.",
                       file.string());
    return Failure("The mesh %1 is damaged: the library that reads its format crashed on it. Save "
                   "it again in a mesh program, as OBJ or PLY for example.",
                   file.string());
}

} // namespace

Result<PolygonMesh> readInOwnProcess(const fs::path& file, const Progress& progress)
{
    const std::optional<fs::path> program = readerProgram();
    if (!program)
        return Failure("The mesh %1 cannot be read, as the program %2 is not beside this one; "
                       "install it there, or save the mesh as OBJ, PLY or OFF.",
                       file.string(), readerName);
    const auto notStarted = [&](int error) {
        return Failure("The mesh %1 cannot be read, as the program %2 could not be started (%3).",
                       file.string(), program->string(), std::strerror(error));
    };
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return notStarted(errno);
    const OwnHandle listening(ends[0]);
    OwnHandle speaking(ends[1]);
    ReaderProcess reader;
    if (const int error = reader.start(*program, fs::absolute(file), speaking.get()))
        return notStarted(error);
    speaking.close();

    MeshAnswer answer;
    const Heard heard = listen(listening.get(), answer, progress);
    if (heard == Heard::Cancelled)
        return Failure{"The import was cancelled."};
    if (answer.mesh())
        return std::move(*answer.mesh());
    if (answer.trouble())
        return sentenceOf(file, *answer.trouble(), answer.why());
    return sentenceOf(file, heard == Heard::All ? reader.wait() : 0);
}

} // namespace ripstop
