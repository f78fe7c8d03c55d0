#include "editor/tool_bars.h"

#include "actions/actions.h"
#include "tools/tool_strip.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QToolBar>

#include <initializer_list>

namespace ripstop {
namespace {

using Buttons = std::initializer_list<const char*>; // ids of actions, with lines between groups

constexpr Buttons barGroups[]{
    {"open", "save"},
    {"undo", "redo"},
    {"move", "rotate", "scale"},
    {"fit", "home", "follow", "byStrain", "particles"},
};

constexpr Buttons stripGroups[]{
    {"toolPointer", "toolBox", "toolLasso"},
    {"drawParticles", "drawLinks", "drawPanels", "toolBrush"},
    {"toolGrab", "toolCut", "toolFan"},
    {"takeParticles", "takeLinks", "takePanels"},
    {"through"},
};

constexpr QPoint stripPlace(12, 12); // pixels, of the view

} // namespace

void fillToolBar(QToolBar& bar, const Actions& actions)
{
    for (const Buttons& group : barGroups) {
        for (const char* id : group)
            bar.addAction(actions[id]);
        bar.addSeparator();
    }
}

void addToolStrip(Viewport& viewport, const Actions& actions)
{
    auto* strip = new ToolStrip(&viewport);
    for (const Buttons& group : stripGroups) {
        QList<QAction*> buttons;
        for (const char* id : group)
            buttons << actions[id];
        strip->addGroup(buttons);
    }
    strip->move(stripPlace);
}

} // namespace ripstop
