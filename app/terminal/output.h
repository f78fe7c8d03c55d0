// Standard output as a file that can fail: the disk behind it may be full, and who reads a pipe may
// be gone. A StandardOutput stands in main() for as long as the command runs.
#pragma once

#include <memory>
#include <ostream>

namespace ripstop {

// Takes over std::cout and std::cerr. What cannot be written is remembered for finish(), which
// gives the command an exit code for it; a closed pipe and a limit of the size of files no longer
// end the program in the middle of a file. Control characters, which names and titles of a scene
// may carry to a terminal, are printed as \x1b and the like.
class StandardOutput
{
public:
    StandardOutput();
    ~StandardOutput();
    StandardOutput(const StandardOutput&) = delete;
    StandardOutput& operator=(const StandardOutput&) = delete;

    // Writes what is left. Returns the exit code, or OutputLost where the command would be Done and
    // its output did not arrive.
    int finish(int exitCode);

private:
    class Buffer;
    std::unique_ptr<Buffer> m_out;
    std::unique_ptr<Buffer> m_error;
    std::streambuf* m_outBefore;
    std::streambuf* m_errorBefore;
};

// Has what is printed as a result go to the standard error while it stands, where something else
// has the standard output for itself.
class OutputOnError
{
public:
    explicit OutputOnError(bool isActive);
    ~OutputOnError();
    OutputOnError(const OutputOnError&) = delete;
    OutputOnError& operator=(const OutputOnError&) = delete;

private:
    std::streambuf* m_before; // null where it goes where it always goes
};

} // namespace ripstop
