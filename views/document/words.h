// Words for the things of a scene and the texts of the model, the same in every view: labels,
// counts, names, numbers, and the description of a selection. The model writes English, and these
// put it into the language of the window. They are called from the window's thread, except that
// texts of failures are made wherever work is done for it.
#pragma once

#include "scene/property.h"
#include "select/element_counts.h"

#include <QString>

namespace ripstop {

QString text(std::string_view utf8);

// A text of the window in its language, for sources without a class whose tr() would say it.
QString words(const char* english);

// What is called so, and what is said of it: "Picture: none", with a blank before the colon where
// the language has one.
QString labelled(const QString& name, const QString& said);

// A text of the model, which is written in English, in the language of the window.
QString translated(std::string_view english);
QString translated(const Message& message);

// The key of a control, "Left", as the language of the window calls it.
QString keyText(const std::string& key);

QString kindLabel(Kind kind);                  // "Particle"
QString kindPluralLabel(Kind kind);            // "Particles"
QString counted(Kind kind, qsizetype n);       // "1 particle", "20,000 particles"
QString countsOf(const ElementCounts& counts); // "5 particles, 10 links"; empty for nothing

QString labelOf(const Property& property);
QString helpOf(const Property& property);
QString choiceLabel(std::string_view choice);  // "Semi implicit Euler", translated
QString englishLabel(std::string_view choice); // "Semi implicit Euler", to be translated

// "kite", "particle 17", "Settings"; "#17" when there is no such thing.
QString nameOf(const Scene& scene, Id id);

// A number as short as it can be shown: six digits, or exact when that is shorter. With the comma
// where the language of the window has one; typedNumber() reads either.
QString compactNumber(double value);

// "kite", "particle 17 of kite", "3 particles of kite", "5 particles, 4 links". `ids` are in
// ascending order.
QString describe(const Scene& scene, const std::vector<Id>& ids);

} // namespace ripstop
