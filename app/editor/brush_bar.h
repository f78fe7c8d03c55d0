// The bar over the lower edge of the view while the brush is chosen: what it paints and with which
// number, how wide it is (radius, m), how it falls off, and whether it paints the other side as
// well.
//
// It edits the Brush of the view. While the brush is chosen the view has the colours of what is
// painted, and of a grain the strokes besides; then those that it had before. The main window makes
// it, over the view, which owns it, and calls refresh() when a wheel has changed the brush. It
// lives on the thread of the window.
#pragma once

#include "editor/view_bar.h"

#include "shaping/brush.h"

#include <vector>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;

namespace ripstop {

class Actions;
class Document;

class BrushBar final : public ViewBar
{
    Q_OBJECT

public:
    BrushBar(Document& document, Viewport& viewport, const Actions& actions);

    void refresh();

private:
    void layOut();
    void startOver();
    void choose(bool isOn);
    void showPainted();

    Document& m_document;
    Brush& m_brush;
    const Actions& m_actions;
    QAction* m_tool;
    QAction* m_before = nullptr; // the way of colouring before the brush was chosen
    bool m_grainBefore = false;  // whether strokes were shown
    QLabel* m_title;
    std::vector<QWidget*> m_values; // by what is painted
    ParameterField* m_radius = nullptr;
};

} // namespace ripstop
