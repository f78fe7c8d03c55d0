// The tuning panel beside the inspector, for tests that drag sliders and read what follows.
#pragma once

#include "document/document.h"
#include "document/selection.h"
#include "inspector/inspector.h"
#include "inspector/tuning_panel.h"
#include "inspector/tuning_row.h"
#include "small_scenes.h"

#include <QApplication>
#include <QLabel>

#include <algorithm>
#include <utility>
#include <vector>

namespace ripstop {

// Over one of everything, remembering nothing.
struct TuningDesk
{
    Document document;
    Selection selection{document};
    Inspector inspector{document, selection};
    TuningPanel panel{document, selection, inspector.sliders()};

    TuningDesk()
    {
        inspector.sliders().remember(false);
        document.replace(oneOfEverything());
        panel.resize(300, 600);
        panel.show();
        QApplication::setActiveWindow(&panel); // Xvfb has no window manager to do it
    }

    TuningRow* add(const Property& property, std::vector<Id> ids)
    {
        if (inspector.sliders().toggle(property, ids))
            return nullptr;
        QApplication::processEvents(); // it is shown
        for (TuningRow* row : panel.findChildren<TuningRow*>())
            if (row->slider().property == &property && row->slider().ids == ids)
                return row;
        return nullptr;
    }
    Value value(Id id, const Property& property) const
    {
        return property.get(*find(document.scene(), id));
    }
    void set(Id id, std::string_view key, Value to)
    {
        document.push(setValue(document.scene(), id, key, std::move(to)));
    }
    Id firstWind() const
    {
        const auto found = std::ranges::find_if(document.scene().items, [](const Entry& entry) {
            return std::holds_alternative<Wind>(entry.item);
        });
        return found->id;
    }
    bool says(const QString& words) const
    {
        QApplication::processEvents(); // rows that are new are shown
        const auto labels = panel.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }
};

} // namespace ripstop
