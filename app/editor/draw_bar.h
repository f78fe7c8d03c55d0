// The bar over the lower edge of the view while one of the tools that draw particles, links or
// panels is chosen: it says what a click does, and edits the DrawSettings that the tools read
// (part, material, kind, segments, mass in kg, plane, grid in m).
//
// The main window makes it once, over the view, which owns it. It shows and hides itself as the
// actions of the tools are switched, and refreshes when the document changes or another scene
// replaces it. It lives on the thread of the window.
#pragma once

#include "editor/view_bar.h"

#include "tools/draw_tool.h"

#include <functional>
#include <vector>

class QAction;
class QComboBox;
class QLabel;

namespace ripstop {

class Actions;
class Document;

class DrawBar final : public ViewBar
{
    Q_OBJECT

public:
    DrawBar(Document& document, Viewport& viewport, DrawSettings& settings, const Actions& actions);

    void refresh();

private:
    struct Hint
    {
        QAction* tool;
        QString title;
        QString words;
    };

    void startOver();
    void layOut();
    QWidget* field(const Parameter& parameter, double value,
                   const std::function<void(double)>& take);
    template <typename T>
    void fillItems(QComboBox& box, Id chosen, const QString& fresh);

    Document& m_document;
    DrawSettings& m_settings;
    std::vector<Hint> m_hints;
    QLabel* m_title;
    QComboBox* m_part;
    QComboBox* m_material;
    QWidget* m_mass;
    std::vector<QWidget*> m_onLinks; // fields that only links have
};

} // namespace ripstop
