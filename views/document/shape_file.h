// How the window asks for the files that a scene names, and how the scene does so: from its own
// folder where the file lies there, so that both can be moved together.
#pragma once

#include "laws/contact_laws.h"

#include <QString>

class QWidget;

namespace ripstop {

class Document;

// Asks the user for the mesh or the picture of heights of a collider, and returns its name as the
// scene is to have it; empty when the question is cancelled.
QString askShapeFile(QWidget* parent, const Document& document, ColliderShape shape);

// The same for the picture on a fabric.
QString askPictureFile(QWidget* parent, const Document& document);

// How a scene in `folder` names a file. Without a folder the scene is not saved yet, and the name
// stays as it is.
QString namedFrom(const QString& folder, const QString& file);

} // namespace ripstop
