// What the command line of the editor asks for, and how it is read.
//
// Only main() reads it; Screenshot gets a copy. readOptions() knows no scene: names of items,
// docks and actions are checked by main() once there is something to look them up in. An
// application object has to exist, since the parser uses it; --help and --version print and end
// the program.
#pragma once

#include "editor/theme_choice.h"
#include "language/language.h"
#include "look/quantity_values.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace ripstop {

struct Options
{
    QString scene;      // empty: the start page
    QString mesh;       // to be imported, in place of a scene
    bool play = false;  // at once
    QString screenshot; // empty: stay open
    double after = 0.0; // s, simulated time at which the picture is taken
    int frames = 1;     // pictures, at equal steps up to `after`
    bool viewOnly = false;
    std::optional<QSize> size;
    ThemeChoice appearance = ThemeChoice::Desktop;
    std::optional<Language> language; // none: as it was kept
    ColorBy colorBy = ColorBy::Material;
    QString select;    // name of an item
    QString fit;       // name of an item
    QString action;    // of a menu, by its id
    QStringList docks; // in front
};

// Returns nothing, and a sentence in `error`, when the arguments make no sense.
std::optional<Options> readOptions(const QStringList& arguments, QString& error);

} // namespace ripstop
