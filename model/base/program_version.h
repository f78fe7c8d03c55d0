// Which Ripstop this is, as it says of itself on the command line, in tables and in files.
#pragma once

#include <string>
#include <string_view>

namespace ripstop {

// "0.2.0", as CMakeLists.txt has it. The build makes it (scripts/embed_commit.cmake), and the next.
std::string_view releaseVersion();

// The commit that the program was built from, "1cad645", with a "+" behind it where something was
// changed since; empty where it was not built in a repository.
std::string_view buildCommit();

// "0.2.0 (1cad645)", or "0.2.0".
inline std::string programVersion()
{
    const std::string version(releaseVersion()), commit(buildCommit());
    return commit.empty() ? version : version + " (" + commit + ")";
}

} // namespace ripstop
