// The panels of the window, each found by what it is.
//
// The docks own a list of them and hand it to rows of the table that need a panel of a row above;
// actions reach a panel through the docks.
#pragma once

#include <QWidget>

#include <typeinfo>
#include <vector>

namespace ripstop {

class Panels final
{
public:
    void add(QWidget& panel) { m_panels.push_back(&panel); }

    // There has to be one: a panel that no row of the table makes is a mistake of ours, seen as
    // soon as the window is built.
    template <typename Panel>
    Panel& the() const
    {
        for (QWidget* panel : m_panels)
            if (auto* found = dynamic_cast<Panel*>(panel))
                return *found;
        qFatal("no dock has the panel %s", typeid(Panel).name());
    }

private:
    std::vector<QWidget*> m_panels;
};

} // namespace ripstop
