// What the command line of the editor asks for, and how it is read.
//
// Only main() reads it; Screenshot gets a copy. readOptions() knows no scene: names of items,
// docks and actions are checked by main() once there is something to look them up in. An
// application object has to exist, since the parser uses it; --help and --version print and end
// the program.
#pragma once

#include "language/language.h"
#include "look/backdrop.h"
#include "look/quantity_values.h"
#include "theme/theme_choice.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace ripstop {

struct Options
{
    QString scene;      // or a recording or a study; empty for the start page
    QString mesh;       // file of a mesh that is imported in place of a scene
    bool play = false;  // whether the run starts at once
    QString screenshot; // file of the picture; when it is empty the window stays open
    double after = 0.0; // s, simulated time at which the picture is taken
    int frames = 1;     // pictures, at equal steps up to `after`
    bool viewOnly = false;
    int pictureWidth = 0;                  // pixels, of a picture of the view; 0 as it is shown
    Backdrop backdrop = Backdrop::Scenery; // of a picture of the view
    bool legend = false;                   // and compass, in a picture of the view
    bool pins = false;                     // marked in a picture of the view
    std::optional<QSize> size;
    std::optional<ThemeChoice> appearance; // without one the kept theme is used
    std::optional<Language> language;      // without one the kept language is used
    ColorBy colorBy = ColorBy::Material;
    QString select;    // name of an item, or a condition that elements meet
    QString fit;       // name of the item that fills the picture
    QString action;    // id of the action to trigger
    QStringList docks; // ids of the docks to bring to the front
};

// Returns nothing, and a sentence in `error`, when the arguments make no sense.
std::optional<Options> readOptions(const QStringList& arguments, QString& error);

} // namespace ripstop
