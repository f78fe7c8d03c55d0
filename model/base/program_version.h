// Which Ripstop this is, as it says of itself on the command line, in tables and in files.
#pragma once

#include <string>
#include <string_view>

namespace ripstop {

// The commit that the program was built from, "1cad645", with a "+" behind it where something was
// changed since; empty where it was not built in a repository. The build makes it
// (scripts/embed_commit.cmake).
std::string_view buildCommit();

// "0.1.0 (1cad645)", or "0.1.0".
inline std::string programVersion()
{
    const std::string commit(buildCommit());
    return commit.empty() ? RIPSTOP_VERSION : RIPSTOP_VERSION " (" + commit + ")";
}

} // namespace ripstop
