// The window with a scene, whose actions open dialogs with a loop of their own: the test says what
// is done in them. It counts particles and knows parts by their order.
//
// Whoever makes one has to run by runWithWidgets().
#pragma once

#include "app/window_shop.h"

#include <QDialog>
#include <QTimer>
#include <QtTest>

#include <functional>
#include <utility>
#include <vector>

namespace ripstop {

struct InsertShop : WindowShop
{
    explicit InsertShop(Scene scene)
    {
        document.replace(std::move(scene));
        window.show();
        window.showScene();
    }

    // Triggers an action whose dialog runs a loop of its own, and does this in it.
    template <typename Dialog>
    void during(const char* id, const std::function<void(Dialog&)>& act)
    {
        bool found = false;
        QTimer::singleShot(0, &window, [&] {
            auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
            found = dialog;
            if (dialog)
                act(*dialog);
            if (dialog && dialog->isVisible())
                dialog->reject();
        });
        window.actions()[id]->trigger();
        QVERIFY2(found, id);
    }

    std::size_t count() const
    {
        std::size_t particles = 0;
        forEachPart(document.scene(),
                    [&](Id, const Part& part) { particles += part.particles.size(); });
        return particles;
    }
    Id part(std::size_t index) const
    {
        std::vector<Id> ids;
        forEachPart(document.scene(), [&](Id id, const Part&) { ids.push_back(id); });
        return ids.at(index);
    }
};

} // namespace ripstop
