// What a command is asked to write, looked at before its work begins. A target that cannot be
// written, one that is given twice and one that the command reads are refused.
#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace ripstop {

// Files that a command reads or writes; empty names stand for options that were not given.
using FileNames = std::vector<std::string>;

// "-" is the standard output: its device takes the place of the name. Whether it was that.
bool takeStandardOutput(std::string& target);

// Returns Done, or the exit code after a message has been printed.
int refuseTargets(const FileNames& targets, const FileNames& inputs);

// Only whether it is one that the command reads, after a message: for folders, which stand for many
// files.
bool isInput(const std::string& target, const FileNames& inputs);

// A scene and the files that its colliders name, with what else the command reads.
FileNames inputsOf(const Scene& scene, const std::string& file, FileNames others = {});

} // namespace ripstop
