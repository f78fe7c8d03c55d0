// The sliders that a person has at hand for the open scene.
//
// They are remembered with the settings of the program, by the scene's file, and not in the file:
// what is being tuned is a matter of the desk, and a design that is only looked at stays
// unmodified. The values are edits of the scene. Each change is written at once and announced by
// changed().
#pragma once

#include "base/result.h"
#include "inspector/last_directions.h"
#include "scene/slider.h"

#include <QObject>

#include <optional>
#include <vector>

namespace ripstop {

class Document;

class SliderShelf final : public QObject
{
    Q_OBJECT

public:
    explicit SliderShelf(Document& document, QObject* parent = nullptr);

    void takeOver(const SliderShelf& before);

    // All sliders over the scene share them, whether they stand on the shelf or in a form.
    LastDirections& directions() { return m_directions; }

    // The sliders whose things exist now.
    std::vector<Slider> sliders() const;
    bool has(const Property& property, const std::vector<Id>& ids) const;

    // Adds a slider, or takes it away when it is there. Too many things for one slider are refused.
    std::optional<Failure> toggle(const Property& property, const std::vector<Id>& ids);
    void setRange(const Property& property, const std::vector<Id>& ids, const SliderRange& range);

    // What is mostly tuned, as far as it has an effect: of the materials that the selected things
    // are of, or of the whole scene where they are of none.
    void addUsual(const std::vector<Id>& selected = {});

    // Somebody wants to know what other values of this would do: over the range of its slider where
    // it has one.
    void study(const Property& property, const std::vector<Id>& ids);

    void remember(bool on) { m_remembers = on; } // in the settings; not for pictures and tests

signals:
    void changed();
    void studyWanted(const ripstop::Property& property, const std::vector<ripstop::Id>& ids,
                     const std::optional<ripstop::SliderRange>& range);

private:
    void load();
    void take(std::vector<Slider> sliders);

    Document& m_document;
    std::vector<Slider> m_sliders;
    LastDirections m_directions;
    bool m_remembers = true;
};

} // namespace ripstop
