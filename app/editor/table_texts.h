// The texts that stand in tables of the model and in files of samples: what lupdate cannot see.
#pragma once

#include <QStringList>

namespace ripstop {

// In English, sorted, each once.
QStringList tableTexts();

} // namespace ripstop
