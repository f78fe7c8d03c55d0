// The texts that stand in tables of the model and in files of samples: what lupdate cannot see,
// since no call of tr() names them.
//
// main() prints them for --table-texts, and scripts/translations adds them to the catalogue.
// Neither a window nor a translation is needed.
#pragma once

#include <QStringList>

namespace ripstop {

// The texts in English, sorted, each once.
QStringList tableTexts();

} // namespace ripstop
