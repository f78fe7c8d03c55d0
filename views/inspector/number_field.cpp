// Fields of numbers: what is typed, dragged, stepped and slid.
//
// numberEdit() makes the line of one number: typed text is judged and committed as a change of each
// thing's own number, so that "*1.1" works on many things at once; arrow keys and the dragging of
// the label are gestures (tuning.h). numberField() puts one such line over a slider, vectorField()
// three of them, in a row or below each other. A number that is absent shows what it falls back to.
#include "derived/link_stiffness.h"
#include "derived/tear_bounds.h"
#include "document/document.h"
#include "document/spoken.h"
#include "document/words.h"
#include "inspector/field.h"
#include "inspector/scrub_label.h"
#include "inspector/tuning.h"
#include "inspector/value_edit.h"

#include <QBoxLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QSlider>

#include <cmath>
#include <memory>

namespace ripstop {
namespace {

constexpr int rowWidth = 330; // px, from here on the axes of a vector stand in one row

// The unit of the first thing: a tear limit has the unit of its material's rule.
std::string_view unitNow(const FieldPlace& place)
{
    const std::vector<ConstRef> refs = place.subject.refs();
    return refs.empty() ? place.property.unit
                        : unitOf(place.subject.document().scene(), place.property, refs.front());
}

// Says why what was typed is refused, as a sentence; empty when it is fine.
QString complaintAbout(const FieldPlace& place, const QString& text, int axis)
{
    const Property& property = place.property;
    if (property.optional && text.trimmed().isEmpty())
        return {};
    const Typed typed = typedNumber(text.toStdString(), unitNow(place));
    if (!typed.number)
        return words("%1 %2; or change it by *1.1, +5 % or +0.2.")
            .arg(labelOf(property), translated(typed.complaint));
    const auto reason = place.subject.refusal(property, transformOf(*typed.number, axis));
    return reason ? QStringLiteral("%1 %2.").arg(labelOf(property), *reason) : QString();
}

void commitNumber(const FieldPlace& place, const QString& text, int axis)
{
    if (text.trimmed().isEmpty())
        place.subject.edit(place.property, setTo(std::monostate()));
    else if (const Typed typed = typedNumber(text.toStdString(), unitNow(place)); typed.number)
        place.subject.edit(place.property, transformOf(*typed.number, axis));
}

// A line for one number, with its arrow keys and a label to drag.
ValueEdit* numberEdit(const FieldPlace& place, int axis, ScrubLabel& label)
{
    auto* edit = new ValueEdit(
        [place, axis](const QString& text) { return complaintAbout(place, text, axis); });
    QObject::connect(edit, &ValueEdit::complained, edit, place.complain);
    QObject::connect(edit, &ValueEdit::committed, edit,
                     [place, axis](const QString& text) { commitNumber(place, text, axis); });

    const auto dragging = std::make_shared<Dragging>(place.subject, place.property);
    const auto total = std::make_shared<int>(0);
    edit->setSteps(true);
    QObject::connect(edit, &ValueEdit::stepped, edit, [=](int steps, bool isRepeat) {
        if (!isRepeat) {
            dragging->begin(); // a key that is held is one gesture
            *total = 0;
        }
        *total += steps;
        dragging->move(numberTransform(place.property, axis, [=](double before) {
            return stepped(place.property, before, *total);
        }));
    });

    label.setScrubbing(true);
    QObject::connect(&label, &ScrubLabel::began, edit, [=] {
        edit->leave();
        dragging->begin();
    });
    QObject::connect(&label, &ScrubLabel::dragged, edit, [=](double distance) {
        dragging->move(numberTransform(place.property, axis, [=](double before) {
            return scrubbed(place.property, before, distance);
        }));
    });
    QObject::connect(&label, &ScrubLabel::cancelled, edit, [=] { dragging->cancel(); });
    return edit;
}

// A slider for what is tuned while it flies; null for other properties.
QSlider* slider(const FieldPlace& place)
{
    const auto range = place.slides ? place.property.usual : std::nullopt;
    return range ? makeSlider(place.subject, place.property, [range] { return *range; }) : nullptr;
}

void refreshSlider(QSlider* bar, const FieldPlace& place)
{
    if (bar)
        showOn(*bar, *place.property.usual, place.subject, place.property);
}

QWidget* stacked(QWidget* above, QWidget* below)
{
    if (!below)
        return above;
    auto* both = new QWidget;
    auto* layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(above);
    layout->addWidget(below);
    return both;
}

// The axes of a vector: below each other in a narrow dock, and side by side in a wide one.
class AxesBox final : public QWidget
{
public:
    AxesBox()
        : m_layout(new QBoxLayout(QBoxLayout::TopToBottom, this))
    {
        m_layout->setContentsMargins(0, 0, 0, 0);
        m_layout->setSpacing(2);
    }
    void add(QWidget* label, QWidget* edit)
    {
        auto* row = new QHBoxLayout;
        row->setSpacing(4);
        row->addWidget(label);
        row->addWidget(edit, 1);
        m_layout->addLayout(row, 1);
    }

private:
    void resizeEvent(QResizeEvent* event) override
    {
        m_layout->setDirection(event->size().width() < rowWidth ? QBoxLayout::TopToBottom
                                                                : QBoxLayout::LeftToRight);
    }

    QBoxLayout* m_layout;
};

// What a link has of its material: stiffness and compliance follow from its length and its role
// where the material has physical numbers, and what it tears at from the rule. No number where it
// never does.
double ofItsMaterial(const Property& property, const Property& source, const Link& link,
                     const Material& material)
{
    if (isOneOf<&Link::stiffness>(property))
        return springStiffness(material, link);
    if (isOneOf<&Link::compliance>(property))
        return rodCompliance(material, link);
    if (isOneOf<&Link::tearLimit>(property)) {
        const TearLimit tear =
            linkTearOf(material, link.role, link.width, std::nullopt, link.strengthFactor);
        return tear.rule == TearRule::Never ? std::nan("") : tear.limit;
    }
    return std::get<double>(source.get(&material));
}

// What an absent value falls back to: "from material (100 N/m)"; without the number where the links
// have several.
QString inherited(const FieldPlace& place)
{
    const Property* source = ofMaterial(place.property);
    if (!source)
        return words("none");
    const Scene& scene = place.subject.document().scene();
    std::optional<double> common;
    for (const ConstRef& ref : place.subject.refs()) {
        const Link& link = *std::get<const Link*>(ref);
        const auto* material = findItem<Material>(scene, link.material);
        const double value =
            material ? ofItsMaterial(place.property, *source, link, *material) : std::nan("");
        if (!std::isfinite(value) || (common && !readAlike(*common, value)))
            return words("from material");
        if (!common)
            common = value;
    }
    return common ? words("from material (%1)").arg(spokenText(*common, unitNow(place)))
                  : words("from material");
}

} // namespace

Field numberField(const FieldPlace& place)
{
    ValueEdit* edit = numberEdit(place, 0, place.label);
    QSlider* bar = slider(place);
    return {stacked(edit, bar), {edit}, [=](const Common& common) {
                const bool isAbsent = std::holds_alternative<std::monostate>(common.value);
                const bool isShown = !isAbsent && !common.mixed[0];
                const Spoken said =
                    isShown ? spokenInField(magnitude(common.value), unitNow(place)) : Spoken();
                edit->setUnit(said.unit);
                if (common.mixed[0])
                    edit->show({}, mixedText());
                else if (isAbsent)
                    edit->show({}, inherited(place));
                else
                    edit->show(said.number);
                refreshSlider(bar, place);
            }};
}

Field vectorField(const FieldPlace& place)
{
    static const std::array<QColor, 3> colors{QColor(0xd1, 0x4b, 0x4b), QColor(0x4a, 0x9c, 0x4a),
                                              QColor(0x46, 0x7f, 0xd0)};
    auto* axes = new AxesBox;
    std::array<ValueEdit*, 3> edits{};
    Field field;
    for (int axis = 0; axis < 3; ++axis) {
        auto* label = new ScrubLabel(QStringLiteral("xyz").mid(axis, 1));
        QPalette palette = label->palette();
        palette.setColor(QPalette::WindowText, colors[std::size_t(axis)]);
        label->setPalette(palette);
        label->setToolTip(words("Drag sideways to change the value."));
        ValueEdit* edit = numberEdit(place, axis, *label);
        edit->setAccessibleName(labelOf(place.property) + QChar(' ') + label->text());
        axes->add(label, edit);
        edits[std::size_t(axis)] = edit;
        field.focus[std::size_t(axis)] = edit;
    }
    QSlider* bar = slider(place);
    field.widget = stacked(axes, bar);
    field.refresh = [=](const Common& common) {
        const Vec3* vector = std::get_if<Vec3>(&common.value);
        for (int axis = 0; axis < 3; ++axis) {
            const bool isMixed = common.mixed[std::size_t(axis)] || !vector;
            ValueEdit* edit = edits[std::size_t(axis)];
            const Spoken said =
                isMixed ? Spoken() : spokenInField((*vector)[axis], place.property.unit);
            edit->setUnit(said.unit);
            edit->show(said.number, isMixed ? mixedText() : QString());
        }
        refreshSlider(bar, place);
    };
    return field;
}

} // namespace ripstop
