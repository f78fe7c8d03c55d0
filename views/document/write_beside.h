// Files that Qt or a library writes by name, like pictures: whole or not at all all the same.
#pragma once

#include <QString>

#include <functional>

namespace ripstop {

// Has `write` make a file of another name beside the target, which it takes the place of
// (base/new_file.h). False when either fails; the target is as it was then.
bool writeBeside(const QString& target, const std::function<bool(const QString& file)>& write);

} // namespace ripstop
