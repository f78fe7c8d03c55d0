# Makes a C++ source that tells the version and the commit which are built, and leaves it alone where
# they are the same:
#
#     cmake -DFOLDER=REPOSITORY -DSOURCE=FILE -DVERSION=0.2.0 -P embed_commit.cmake
#
# It defines `ripstop::releaseVersion()` and `ripstop::buildCommit()`.
set(commit "")
find_package(Git QUIET)
if(GIT_FOUND AND EXISTS "${FOLDER}/.git")
    execute_process(COMMAND ${GIT_EXECUTABLE} -C "${FOLDER}" describe --always --abbrev=7 --exclude=* --dirty=+
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(CONFIGURE OUTPUT "${SOURCE}" @ONLY CONTENT [[
#include "base/program_version.h"

std::string_view ripstop::releaseVersion() { return "@VERSION@"; }

std::string_view ripstop::buildCommit() { return "@commit@"; }
]])
