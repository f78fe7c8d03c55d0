// What every command of ripstop-cli shares: how it ends, what it prints, and how it is interrupted.
// Results go to standard output; messages and progress go to standard error, so that results can be
// piped. main() calls catchInterrupt(), and long work asks interrupted() between its
// steps.
#pragma once

#include "base/message.h"
#include "base/vec3.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <string>
#include <string_view>

namespace ripstop {

// How a command ends; scripts tell results apart by these.
enum ExitCode {
    Done = 0,
    BadInput = 1,
    WrongUsage = 2,
    Diverged = 3,
    Differs = 4,
    Inaccurate = 5,   // with run --strict, or certify --digits
    OutputLost = 6,   // standard output is full or closed
    Absurd = 7,       // the run ended in a state that no fabric can be in
    Interrupted = 128 // and the number of the signal: 130 for Ctrl-C, 143 for SIGTERM
};

// Keys in the order in which they were added.
using Json = nlohmann::ordered_json;

Json numbersOf(const Vec3& vector); // [x, y, z]

// Prints the message on standard error and returns the code; Interrupted with its signal.
int fail(ExitCode code, std::string_view message);
int fail(ExitCode code, const Message& message);

// Likewise, of what does not end the command.
void warn(std::string_view message);

// One object on standard output. Numbers that are not finite become null.
void print(const Json& object);

// "0.0123", "4.2e-05": six significant digits.
std::string shortNumber(double number);

// After this, Ctrl-C, SIGTERM and the end of the terminal ask to finish early. A second Ctrl-C, a
// moment later, ends the program.
void catchInterrupt();
bool interrupted();

// A line on standard error that says how far the work is and how long it will still take, when that
// is a terminal.
class ProgressLine
{
public:
    explicit ProgressLine(std::string label);
    ~ProgressLine(); // clears the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(double share); // 0 to 1; cheap to call often

private:
    std::string m_label;
    bool m_visible;
    std::chrono::steady_clock::time_point m_began;
    std::chrono::steady_clock::time_point m_next;
};

} // namespace ripstop
