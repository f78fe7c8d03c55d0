// A document that flies, with the panel of plots that follows it, for tests of plots.
#pragma once

#include "document/document.h"
#include "document/player.h"
#include "document/recordings.h"
#include "plots/plot_panel.h"

#include <QtTest>

#include <cmath>

namespace ripstop {

struct PlotDesk
{
    Document document;
    Player player{document};
    Recordings recordings{player};
    PlotPanel plots{document, player};

    explicit PlotDesk(Scene scene)
    {
        document.replace(std::move(scene));
        plots.follow(recordings);
        plots.resize(900, 300);
        plots.show();
    }
    void fly(double time) // s
    {
        player.playUntil(time);
        QTRY_VERIFY(player.frame() && std::abs(player.frame()->time - time) < 1e-6
                    && !player.isPlaying());
    }
};

} // namespace ripstop
