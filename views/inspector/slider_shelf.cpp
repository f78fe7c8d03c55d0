// load() reads the sliders of the file that is open; take() keeps a new list, writes it and
// announces it, and every change ends there. toggle(), setRange() and addUsual() make the new list
// from the sliders whose things still exist. addUsual() adds, up to fourteen in all, what is mostly
// tuned and has an effect, of all materials that are the same one of the library together.
#include "inspector/slider_shelf.h"

#include "document/document.h"
#include "inspector/tuning.h"
#include "materials/marks.h"
#include "materials/presets.h"
#include "scene/usage.h"
#include "select/made_of.h"

#include <QSettings>

#include <algorithm>
#include <set>

namespace ripstop {
namespace {

constexpr std::size_t enough = 14; // sliders to begin with

// A number by which the material is bought, where it has one and that decides something: strengths
// do for margins, but not beside another limit that tears it.
bool isUsualOf(const Material& material, const Property& property)
{
    const bool isStrength =
        isOneOf<&Material::warpStrength, &Material::weftStrength, &Material::lineStrength>(
            property);
    const bool otherLimit =
        material.tearRule != TearRule::Never && !isByStrength(material.tearRule);
    return magnitude(property.get(&material)) > 0.0 && !(isStrength && otherLimit);
}

QString settingOf(const Document& document)
{
    QString file = document.file();
    return QStringLiteral("sliders/") + file.replace(QChar('/'), QChar('|'));
}

Slider sliderFor(const Scene& scene, const Property& property, std::vector<Id> ids)
{
    const auto ref = find(scene, ids.front());
    const double value = ref ? magnitude(property.get(*ref)) : 0.0;
    if (isTradeNumber(property) && value > 0.0)
        return {&property, std::move(ids), rangeAmongMarks(value)};
    return {&property, std::move(ids),
            hasRange(property) ? rangeAround(property, value) : SliderRange()};
}

auto isAbout(const Property& property, const std::vector<Id>& ids)
{
    return [&](const Slider& slider) { return slider.property == &property && slider.ids == ids; };
}

} // namespace

SliderShelf::SliderShelf(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::replaced, this, &SliderShelf::load);
    connect(&document, &Document::fileChanged, this, [this] { // saved under a name
        if (!m_sliders.empty())
            take(m_sliders);
    });
    load();
}

void SliderShelf::takeOver(const SliderShelf& before)
{
    m_directions = before.m_directions;
    take(before.m_sliders);
}

std::vector<Slider> SliderShelf::sliders() const { return existing(m_document.scene(), m_sliders); }

bool SliderShelf::has(const Property& property, const std::vector<Id>& ids) const
{
    return std::ranges::any_of(sliders(), isAbout(property, ids));
}

std::optional<Failure> SliderShelf::toggle(const Property& property, const std::vector<Id>& ids)
{
    if (ids.size() > mostOfASlider)
        return Failure("A slider moves at most %1 things; tune the material that they share.",
                       mostOfASlider);
    std::vector<Slider> sliders = this->sliders();
    if (std::erase_if(sliders, isAbout(property, ids)) == 0)
        sliders.push_back(sliderFor(m_document.scene(), property, ids));
    take(std::move(sliders));
    return std::nullopt;
}

void SliderShelf::setRange(const Property& property, const std::vector<Id>& ids,
                           const SliderRange& range)
{
    std::vector<Slider> sliders = this->sliders();
    const auto found = std::ranges::find_if(sliders, isAbout(property, ids));
    if (found == sliders.end() || refusal(property, range))
        return;
    found->range = range;
    take(std::move(sliders));
}

// Adds the wind, the numbers by which the materials are bought, the settings of the solver and the
// numbers of materials that are not made of anything, in this order.
void SliderShelf::addUsual(const std::vector<Id>& selected)
{
    const Scene& scene = m_document.scene();
    const Usage usage = usageOf(scene);
    std::vector<Slider> sliders = this->sliders();
    const auto add = [&](const Property& property, std::vector<Id> ids) {
        std::erase_if(ids, [&](Id id) { return whyIdle(scene, usage, property, id).has_value(); });
        std::ranges::sort(ids);
        if (!ids.empty() && sliders.size() < enough
            && !std::ranges::any_of(sliders, isAbout(property, ids)))
            sliders.push_back(sliderFor(scene, property, std::move(ids)));
    };
    const std::vector<Id> chosen = materialsOf(scene, selected);
    const auto forEachMaterial = [&](auto visit) {
        for (const Entry& entry : scene.items)
            if (const Material* material = std::get_if<Material>(&entry.item);
                material && (chosen.empty() || std::ranges::count(chosen, entry.id) > 0))
                visit(entry.id, *material);
    };
    if (chosen.empty())
        for (const Entry& entry : scene.items)
            if (std::holds_alternative<Wind>(entry.item))
                add(propertyOf<&Wind::velocity>(), {entry.id});
    std::set<Id> joined;
    forEachMaterial([&](Id id, const Material& material) {
        if (!joined.insert(id).second)
            return;
        std::vector<Id> alike{id}; // of the same material of the library, for one slider together
        if (const Preset* preset = presetOf(material))
            forEachMaterial([&](Id other, const Material& candidate) {
                if (presetOf(candidate) == preset && joined.insert(other).second)
                    alike.push_back(other);
            });
        for (const Property* property : tradeNumbers())
            if (isUsualOf(material, *property))
                add(*property, alike);
    });
    if (chosen.empty())
        for (const Property* property :
             {&propertyOf<&Settings::substeps>(), &propertyOf<&Settings::sweeps>(),
              &propertyOf<&Settings::strainGoal>()})
            add(*property, {settingsId});
    forEachMaterial([&](Id id, const Material&) {
        for (const Property* property :
             {&propertyOf<&Material::stiffness>(), &propertyOf<&Material::damping>(),
              &propertyOf<&Material::compliance>(), &propertyOf<&Material::tearLimit>()})
            add(*property, {id});
    });
    take(std::move(sliders));
}

void SliderShelf::load()
{
    m_sliders.clear();
    m_directions.forget();
    if (m_remembers && !m_document.file().isEmpty()) {
        const QString text = QSettings().value(settingOf(m_document)).toString();
        if (const auto sliders = slidersFromText(text.toStdString()))
            m_sliders = *sliders;
    }
    emit changed();
}

void SliderShelf::study(const Property& property, const std::vector<Id>& ids)
{
    const auto same = std::ranges::find_if(m_sliders, [&](const Slider& slider) {
        return slider.property == &property && slider.ids == ids;
    });
    const bool isOnShelf = same != m_sliders.end() && hasRange(property);
    emit studyWanted(property, ids, isOnShelf ? std::optional(same->range) : std::nullopt);
}

void SliderShelf::take(std::vector<Slider> sliders)
{
    m_sliders = std::move(sliders);
    if (m_remembers && !m_document.file().isEmpty()) {
        if (m_sliders.empty())
            QSettings().remove(settingOf(m_document));
        else
            QSettings().setValue(settingOf(m_document), QString::fromStdString(textOf(m_sliders)));
    }
    emit changed();
}

} // namespace ripstop
