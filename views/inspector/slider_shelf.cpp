// load() reads the sliders of the file that is open; take() keeps a new list, writes it and
// announces it, and every change ends there. toggle(), setRange() and addUsual() make the new list
// from the sliders whose things still exist. addUsual() adds, up to eight in all, what is mostly
// tuned and has an effect.
#include "inspector/slider_shelf.h"

#include "document/document.h"
#include "inspector/tuning.h"
#include "scene/usage.h"

#include <QSettings>

#include <algorithm>

namespace ripstop {
namespace {

constexpr std::size_t enough = 8; // sliders to begin with

QString settingOf(const Document& document)
{
    QString file = document.file();
    return QStringLiteral("sliders/") + file.replace(QChar('/'), QChar('|'));
}

Slider sliderFor(const Scene& scene, const Property& property, std::vector<Id> ids)
{
    const auto ref = find(scene, ids.front());
    const double value = ref ? magnitude(property.get(*ref)) : 0.0;
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

// Adds the wind, the settings of the solver and the first materials, in this order.
void SliderShelf::addUsual()
{
    const Scene& scene = m_document.scene();
    const Usage usage = usageOf(scene);
    std::vector<Slider> sliders = this->sliders();
    const auto add = [&](const Property& property, Id id) {
        if (sliders.size() < enough && !has(property, {id}) && !whyIdle(scene, usage, property, id))
            sliders.push_back(sliderFor(scene, property, {id}));
    };
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<Wind>(entry.item))
            add(propertyOf<&Wind::velocity>(), entry.id);
    for (const Property* property :
         {&propertyOf<&Settings::substeps>(), &propertyOf<&Settings::sweeps>(),
          &propertyOf<&Settings::strainGoal>()})
        add(*property, settingsId);
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<Material>(entry.item))
            for (const Property* property :
                 {&propertyOf<&Material::stiffness>(), &propertyOf<&Material::damping>(),
                  &propertyOf<&Material::compliance>(), &propertyOf<&Material::tearLimit>()})
                add(*property, entry.id);
    take(std::move(sliders));
}

void SliderShelf::load()
{
    m_sliders.clear();
    if (m_remembers && !m_document.file().isEmpty()) {
        const QString text = QSettings().value(settingOf(m_document)).toString();
        if (const auto sliders = slidersFromText(text.toStdString()))
            m_sliders = *sliders;
    }
    emit changed();
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
