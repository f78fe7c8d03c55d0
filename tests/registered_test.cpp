// The main() of every program of tests: it runs the one that is named.
#include "registered_test.h"

#include <cstdio>
#include <map>
#include <string_view>

namespace ripstop {

namespace {

using Tests = std::map<std::string_view, TestMain>;

// Those of this program. Whichever registers first makes the table.
Tests& tests()
{
    static Tests all;
    return all;
}

void printTests(std::FILE* out)
{
    for (const auto& [name, main] : tests())
        std::fprintf(out, "    %s\n", name.data());
}

int runNamedTest(int argc, char** argv)
{
    const std::string_view program = argv[0];
    const auto linked = tests().find(program.substr(program.rfind('/') + 1));
    if (linked != tests().end())
        return linked->second(argc, argv);
    if (argc < 2) {
        std::printf("Run one of these tests by its name, with arguments of QtTest behind it:\n");
        printTests(stdout);
        return 0;
    }
    const auto named = tests().find(argv[1]);
    if (named != tests().end())
        return named->second(argc - 1, argv + 1);
    std::fprintf(stderr, "No test in this program is registered as \"%s\"; these are:\n", argv[1]);
    printTests(stderr);
    return 2;
}

} // namespace

RegisteredTest::RegisteredTest(const char* name, TestMain main) { tests().emplace(name, main); }

} // namespace ripstop

int main(int argc, char** argv) { return ripstop::runNamedTest(argc, argv); }
