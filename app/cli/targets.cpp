#include "cli/targets.h"

#include "base/new_file.h"
#include "derived/named_files.h"
#include "terminal/terminal.h"

#include <filesystem>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

// Whether two names lead to one file, also where it does not exist yet. Devices may be written by
// many.
bool areOneFile(const std::string& a, const std::string& b)
{
    if (a.empty() || b.empty() || isDevice(a))
        return false;
    std::error_code error;
    if (fs::equivalent(a, b, error))
        return true;
    return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

} // namespace

bool isInput(const std::string& target, const FileNames& inputs)
{
    for (const std::string& input : inputs)
        if (areOneFile(target, input)) {
            fail(WrongUsage, target
                                 + " is read by this command and would be destroyed; write to "
                                   "another file.");
            return true;
        }
    return false;
}

bool takeStandardOutput(std::string& target)
{
    if (target != "-")
        return false;
    target = "/dev/stdout";
    return true;
}

int refuseTargets(const FileNames& targets, const FileNames& inputs)
{
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (targets[i].empty())
            continue;
        if (isInput(targets[i], inputs))
            return WrongUsage;
        for (std::size_t k = 0; k < i; ++k)
            if (areOneFile(targets[i], targets[k]))
                return fail(WrongUsage, targets[i] + " is to be written twice; name two files.");
        if (const auto failure = unwritable(targets[i]))
            return fail(BadInput, failure->message);
    }
    return Done;
}

FileNames inputsOf(const Scene& scene, const std::string& file, FileNames others)
{
    others.push_back(file);
    forEachFile(scene, [&](const std::string&, const std::string& name) {
        others.push_back(placeOfFile(scene.folder.path, name));
    });
    return others;
}

} // namespace ripstop
