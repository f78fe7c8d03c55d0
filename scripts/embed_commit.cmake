# Makes a C++ source that tells the commit which is built, and leaves it alone where it is the same:
#
#     cmake -DFOLDER=REPOSITORY -DSOURCE=FILE -P embed_commit.cmake
#
# It defines `std::string_view ripstop::buildCommit()`.
set(commit "")
find_package(Git QUIET)
if(GIT_FOUND AND EXISTS "${FOLDER}/.git")
    execute_process(COMMAND ${GIT_EXECUTABLE} -C "${FOLDER}" describe --always --abbrev=7 --exclude=* --dirty=+
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(CONFIGURE OUTPUT "${SOURCE}" @ONLY CONTENT [[
#include "base/program_version.h"

std::string_view ripstop::buildCommit() { return "@commit@"; }
]])
