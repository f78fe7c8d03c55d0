// What the export dialog offers, and what it says about each choice before anything is written:
// which files come, how many frames, how large they are and which of them are there already.
//
// The table of choices is that of mesh formats and film formats, with the tables of a run and the
// bundle after them. Functions here write nothing; they look at the disk for files that would be
// replaced, and are called on the thread of the window.
#pragma once

#include "export/export_run.h"
#include "export/format.h"
#include "files/film.h"

#include <QSize>
#include <QString>

#include <variant>
#include <vector>

namespace ripstop {

enum class RunTable { Tears, Controls }; // of the run on the screen
struct WholeRun                          // a bundle (bundle/bundle.h)
{};

struct ExportChoice
{
    std::variant<const ExportFormat*, const FilmFormat*, RunTable, WholeRun> what;
    QString ending; // after the name of the scene
    QString label;
    QString note;

    const ExportFormat* mesh() const; // null when it is something else
    const FilmFormat* film() const;   // null when it is something else
    bool isSeries() const;            // whether it has frames
    bool isBundle() const;
    bool isFlown() const { return isSeries() || isBundle(); } // needs a whole run
};

std::vector<ExportChoice> exportChoices();

// "Writes kite.pc2 and kite.obj. 251 frames, about 3.4 MB. kite.obj is there and will be replaced."
//   frames  of a series; 1 of a moment
QString previewOf(const ExportChoice& choice, const QString& target, std::size_t frames,
                  const MeshAppearance& appearance, const Scene& scene, const Frame* now,
                  QSize picture);

// The files of a choice that are there already.
QStringList replacedBy(const ExportChoice& choice, const QString& target, std::size_t frames,
                       const MeshAppearance& appearance);

} // namespace ripstop
