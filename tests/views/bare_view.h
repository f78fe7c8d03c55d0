// A view of a scene without a window around it.
#pragma once

#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "viewport/viewport.h"

#include <QSize>

#include <utility>

namespace ripstop {

struct BareView
{
    Document document;
    Selection selection{document};
    Player player{document};
    Viewport viewport{document, selection, player};

    BareView(Scene scene, QSize size)
    {
        viewport.resize(size);
        document.replace(std::move(scene));
        static_cast<QWidget&>(viewport).show();
    }
};

} // namespace ripstop
