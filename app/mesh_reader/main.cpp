// ripstop-mesh-reader FILE: reads a mesh by assimp, or by VTK where it is of that, and writes it to
// standard output, in the form of shapes/mesh_answer.h. Ripstop starts it for each file that it has
// no reader of its own for, so that what a broken file does to the library ends this process and no
// other.
#include "mesh_reader/assimp_reader.h"
#include "mesh_reader/process_limits.h"
#include "mesh_reader/vtk_reader.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include <unistd.h>

using namespace ripstop;

namespace {

void say(std::string_view record)
{
    while (!record.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, record.data(), record.size());
        if (written < 0 && errno != EINTR)
            _exit(EXIT_FAILURE); // nobody listens any more
        record.remove_prefix(written > 0 ? std::size_t(written) : 0);
    }
}

// Made beforehand, as it is said when there is no memory left.
const std::string& noMemory()
{
    static const std::string record = troubleRecord(ReadTrouble::TooMuchMemory);
    return record;
}

void giveUp()
{
    say(noMemory());
    _exit(EXIT_FAILURE);
}

} // namespace

int main(int count, char** arguments)
{
    if (count != 2) {
        std::fputs("ripstop-mesh-reader FILE reads a mesh for the other programs of Ripstop.\n",
                   stderr);
        return EXIT_FAILURE;
    }
    limitProcess();
    (void)noMemory();
    std::set_new_handler(giveUp);
    try {
        const auto tell = [](double share) { say(progressRecord(share)); };
        const std::string file = arguments[1];
        say(isVtkFile(file) ? answerOfVtk(file, tell) : answerOfAssimp(file, tell));
    } catch (const std::exception& error) {
        say(troubleRecord(ReadTrouble::Unreadable, error.what()));
    }
    _exit(EXIT_SUCCESS); // what the library keeps need not be tidied up
}
