#pragma once

#include "editor/view_bar.h"

#include "tools/transform_tool.h"

#include <array>

class QComboBox;
class QLabel;
class QLineEdit;

namespace ripstop {

class Viewport;

// Over the lower edge of the view while a tool is chosen: the numbers of the drag, which can also
// be typed (Enter applies them), and what it turns about, what becomes of rest lengths, what Ctrl
// snaps to.
class TransformBar final : public ViewBar
{
    Q_OBJECT

public:
    explicit TransformBar(Viewport& viewport);

private:
    void layOut();
    void refresh();
    void take(); // what is typed

    TransformTool& m_tool;
    QLabel* m_title;
    std::array<QLineEdit*, 3> m_numbers;
    QLabel* m_unit;
    QLabel* m_hint;
    QWidget* m_row;
    Shaping m_shown = Shaping::None;
    bool m_wasDragging = false;
};

} // namespace ripstop
