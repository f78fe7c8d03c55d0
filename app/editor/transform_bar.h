// The bar over the lower edge of the view while a tool that moves, turns or scales is chosen: the
// numbers of the drag (metres, degrees or factors), which can also be typed, and the choices of
// pivot, axes, rest lengths and snapping.
//
// It edits the TransformTool of the view, which does the work; while a run is shown it only says
// how to get back to the design. The main window makes it, and the view owns it.
#pragma once

#include "editor/view_bar.h"

#include "tools/transform_tool.h"

#include <array>

class QComboBox;
class QLabel;
class QLineEdit;

namespace ripstop {

class Viewport;

class TransformBar final : public ViewBar
{
    Q_OBJECT

public:
    explicit TransformBar(Viewport& viewport);

private:
    void layOut();
    void refresh();
    void showNumbers();
    void complain(const QString& wrong);
    void take(); // applies what is typed
    QString refusal() const override { return m_wrong; }

    TransformTool& m_tool;
    QLabel* m_title;
    std::array<QLineEdit*, 3> m_numbers;
    QLabel* m_unit;
    QWidget* m_row;
    QString m_wrong; // with what was typed last
    Shaping m_shown = Shaping::None;
    bool m_wasDragging = false;
};

} // namespace ripstop
