// How the window asks for the file of a collider's shape, and how a scene names it: from its own
// folder where the file lies there, so that both can be moved together.
#pragma once

#include "base/contact_laws.h"

#include <QString>

class QWidget;

namespace ripstop {

class Document;

// Asks for the mesh or the picture of a collider, and says how the scene names it: from its own
// folder where the file lies there, so that both can be moved together. Empty when the user thinks
// better of it.
QString askShapeFile(QWidget* parent, const Document& document, ColliderShape shape);

// How a scene in `folder` (none: not saved yet) names a file.
QString namedFrom(const QString& folder, const QString& file);

} // namespace ripstop
