// The window with a scene, of which it counts particles and knows parts by their order.
//
// Beside it stands what the dialogs of builders are asked and told.
//
// Whoever makes one has to run by runWithWidgets().
#pragma once

#include "app/window_shop.h"

#include <QAbstractButton>
#include <QDialogButtonBox>
#include <QLineEdit>

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

inline QAbstractButton* okOf(QDialog& dialog)
{
    return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
}

inline QLineEdit* numberOf(QDialog& dialog, const char* key)
{
    return dialog.findChild<QWidget*>(key)->findChild<QLineEdit*>();
}

inline void typeInto(QLineEdit* field, const char* words)
{
    field->selectAll();
    QTest::keyClicks(field, words);
}

} // namespace ripstop
