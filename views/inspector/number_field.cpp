// Fields of numbers: what is typed, dragged, stepped and slid.
#include "document/document.h"
#include "document/words.h"
#include "inspector/field.h"
#include "inspector/scrub_label.h"
#include "inspector/tuning.h"
#include "inspector/typed_number.h"
#include "inspector/value_edit.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QLabel>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QSlider>

#include <memory>

namespace ripstop {
namespace {

constexpr int sliderSteps = 400;
constexpr int rowWidth = 330; // px, from here on the axes of a vector stand in one row

QString words(const char* text) { return QCoreApplication::translate("Field", text); }

// Why what was typed is refused, as a sentence; empty when it is fine.
QString complaintAbout(const FieldPlace& place, const QString& text, int axis)
{
    const Property& property = place.property;
    if (property.optional && text.trimmed().isEmpty())
        return {};
    const QString unit = QString::fromUtf8(property.unit.data());
    const auto typed = typedNumber(text, unit);
    if (!typed)
        return words("%1 must be a number, or a change such as *1.1, +5% or +0.2.")
            .arg(labelOf(property));
    const auto reason = place.subject.refusal(property, transformOf(*typed, axis));
    return reason ? QStringLiteral("%1 %2.").arg(labelOf(property), *reason) : QString();
}

void commitNumber(const FieldPlace& place, const QString& text, int axis)
{
    if (text.trimmed().isEmpty())
        place.subject.edit(place.property, setTo(std::monostate()));
    else if (const auto typed = typedNumber(text, QString::fromUtf8(place.property.unit.data())))
        place.subject.edit(place.property, transformOf(*typed, axis));
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

double magnitude(const Value& value)
{
    if (const Vec3* vector = std::get_if<Vec3>(&value))
        return vector->norm();
    if (const int* whole = std::get_if<int>(&value))
        return *whole;
    const double* real = std::get_if<double>(&value);
    return real ? *real : 0.0;
}

Transform toMagnitude(const Property& property, double size)
{
    return [&property, size](const Value& before) -> Value {
        if (const Vec3* vector = std::get_if<Vec3>(&before)) {
            const double length = vector->norm();
            return Vec3(length > 0.0 ? Vec3(*vector * (size / length)) : Vec3(size, 0.0, 0.0));
        }
        return numberTransform(property, 0, [size](double) { return size; })(before);
    };
}

// A slider for what is tuned while it flies; null for other properties.
QSlider* slider(const FieldPlace& place)
{
    const Tuning* tuning = tuningOf(place.property);
    if (!tuning)
        return nullptr;
    auto* bar = new QSlider(Qt::Horizontal);
    bar->setRange(0, sliderSteps);
    bar->setPageStep(sliderSteps / 20);
    bar->setSingleStep(sliderSteps / 100);
    bar->setFocusPolicy(Qt::TabFocus);
    bar->setAccessibleName(words("%1 slider").arg(labelOf(place.property)));
    bar->setToolTip(
        words("Drag to tune %1 while it flies.").arg(labelOf(place.property).toLower()));

    const auto dragging = std::make_shared<Dragging>(place.subject, place.property);
    QObject::connect(bar, &QSlider::sliderPressed, bar, [=] { dragging->begin(); });
    QObject::connect(bar, &QSlider::valueChanged, bar, [=](int position) {
        if (!bar->isSliderDown())
            dragging->begin(); // a key or a click beside the handle
        const double value = valueAt(*tuning, double(position) / sliderSteps);
        dragging->move(toMagnitude(place.property, value));
    });
    return bar;
}

void refreshSlider(QSlider* bar, const Property& property, const Common& common)
{
    if (!bar || bar->isSliderDown())
        return;
    const QSignalBlocker quiet(bar);
    const Tuning& tuning = *tuningOf(property);
    bar->setValue(int(std::lround(placeOf(tuning, magnitude(common.value)) * sliderSteps)));
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

// The axes of a vector: below each other in a narrow dock, else in a row.
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

// What an absent value falls back to: "from material (100 N/m)".
QString inherited(const FieldPlace& place)
{
    const Property* source = findProperty(Kind::Material, place.property.key);
    const Property* material = findProperty(place.property.kind, "material");
    if (!source || !material)
        return words("none");
    const Value id = Subject::common(*material, place.subject.refs()).value;
    const Scene& scene = place.subject.document().scene();
    const auto ref = std::holds_alternative<Id>(id) ? find(scene, std::get<Id>(id)) : std::nullopt;
    if (!ref)
        return words("from material");
    const QString value = compactNumber(std::get<double>(source->get(*ref)));
    const QString unit = QString::fromUtf8(source->unit.data());
    return words("from material (%1)").arg(unit.isEmpty() ? value : value + QChar(' ') + unit);
}

// The tear limit of a material has the unit of its rule.
QString unitNow(const FieldPlace& place)
{
    const Property* rule = findProperty(place.property.kind, "tearRule");
    if (place.property.key != "tearLimit" || !rule)
        return QString::fromUtf8(place.property.unit.data());
    const Common common = Subject::common(*rule, place.subject.refs());
    const std::string* name = std::get_if<std::string>(&common.value);
    if (!name || common.mixed[0])
        return {};
    return *name == "length"  ? QStringLiteral("m")
           : *name == "force" ? QStringLiteral("N")
                              : QString();
}

} // namespace

Field numberField(const FieldPlace& place)
{
    ValueEdit* edit = numberEdit(place, 0, place.label);
    QSlider* bar = slider(place);
    return {stacked(edit, bar), {edit}, [=](const Common& common) {
                const bool isAbsent = std::holds_alternative<std::monostate>(common.value);
                edit->setUnit(isAbsent || common.mixed[0] ? QString() : unitNow(place));
                if (common.mixed[0])
                    edit->show({}, mixedText());
                else if (isAbsent)
                    edit->show({}, inherited(place));
                else
                    edit->show(compactNumber(magnitude(common.value)));
                refreshSlider(bar, place.property, common);
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
        edit->setUnit(QString::fromUtf8(place.property.unit.data()));
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
            edits[std::size_t(axis)]->show(isMixed ? QString() : compactNumber((*vector)[axis]),
                                           isMixed ? mixedText() : QString());
        }
        refreshSlider(bar, place.property, common);
    };
    return field;
}

} // namespace ripstop
