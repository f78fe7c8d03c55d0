// What comes into the editor from builders and from meshes.
//
// It becomes a scene of its own, or goes into the one that is open. On the start page no scene is
// open, even if there is one behind it. The menus, the start page, what is dropped on the window
// and the command line all come here; files of ours are opened elsewhere (files.h).
#pragma once

#include <QObject>
#include <QString>

#include <functional>

class QWidget;

namespace ripstop {

class Document;
class Files;
class Selection;
class Viewport;

class Arrivals final : public QObject
{
    Q_OBJECT

public:
    // `isOpen` tells whether a scene is on the screen.
    Arrivals(Document& document, Selection& selection, Viewport& viewport, Files& files,
             std::function<bool()> isOpen, QWidget& window);

    // A new scene of a builder; with an empty name the dialog offers them all.
    void startFrom(const QString& builder);

    // A part of the open scene; where none is open, a new one.
    void insert(const QString& builder);

    // Asks how a mesh is to be brought in, and for the file when none is named. What comes of it
    // is one edit.
    void importMesh(const QString& file = {});

signals:
    void opened();                     // a new scene is there to be looked at
    void said(const QString& message); // for the status bar

private:
    Document& m_document;
    Selection& m_selection;
    Viewport& m_viewport;
    Files& m_files;
    std::function<bool()> m_isOpen;
    QWidget& m_window;
};

} // namespace ripstop
