// Fields of what points at other things: typed, chosen from a menu, or picked in the view.
//
// readIds() makes ids of a text of names and numbers, or says which of them is no such thing.
// shownIds() and hintOf() make a text of ids again; long lists are only counted. fillMenu() offers
// the items that fit, which a list takes in and lets go, picking where elements fit, and none.
// idField() puts line and menu side by side.
#include "document/document.h"
#include "document/plain_text.h"
#include "document/words.h"
#include "icons/icon.h"
#include "inspector/field.h"
#include "inspector/value_edit.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace ripstop {
namespace {

constexpr std::size_t mostShown = 40; // ids of a list; a longer one is only counted

bool isList(const Property& property)
{
    return std::holds_alternative<std::vector<Id>>(property.initial);
}

Kind kindOfItem(const Item& item)
{
    return std::visit([](const auto& i) { return kindOf(ConstRef(&i)); }, item);
}

// The thing that a person means: "17", "#17", "particle 17" or the name of an item.
std::optional<Id> idFromText(const Scene& scene, const Property& property, const QString& text)
{
    for (const Entry& entry : scene.items)
        if (property.pointsAt.contains(kindOfItem(entry.item))
            && QString::fromStdString(nameOf(entry.item)) == text)
            return entry.id;
    bool isNumber = false;
    const QString number = text.section(QChar(' '), -1).remove(QChar('#'));
    const Id id{number.toUInt(&isNumber)};
    const auto ref = isNumber ? find(scene, id) : std::nullopt;
    if (!ref || !property.pointsAt.contains(kindOf(*ref)))
        return std::nullopt;
    return id;
}

QString wanted(const Property& property)
{
    QStringList kinds;
    for (int k = 0; k < kindCount; ++k)
        if (property.pointsAt.contains(Kind(k)))
            kinds << kindLabel(Kind(k)).toLower();
    return kinds.join(QStringLiteral(", "));
}

// The value that a text means, or what is wrong with the text.
struct Read
{
    Value value;
    QString complaint;
};

Read readIds(const FieldPlace& place, const QString& text)
{
    const Scene& scene = place.subject.document().scene();
    const QStringList names = text.split(QChar(','), Qt::SkipEmptyParts);
    std::vector<Id> ids;
    for (const QString& name : names) {
        if (name.trimmed().isEmpty())
            continue;
        const auto id = idFromText(scene, place.property, name.trimmed());
        if (!id)
            return {{},
                    words("%1 must be a %2; there is none called \"%3\".")
                        .arg(labelOf(place.property), wanted(place.property), name.trimmed())};
        ids.push_back(*id);
    }
    if (isList(place.property))
        return {ids, {}};
    if (ids.size() > 1)
        return {{}, words("%1 is one thing, not several.").arg(labelOf(place.property))};
    return {ids.empty() ? noId : ids.front(), {}};
}

// In a list: the name of an item, where that means it when it is typed, else the number.
QString nameInList(const Scene& scene, const Property& property, Id id)
{
    const Item* item = findItem(scene, id);
    const QString name = item ? QString::fromStdString(nameOf(*item)) : QString();
    const bool meansIt = !name.contains(QChar(',')) && name == name.trimmed()
                         && idFromText(scene, property, name) == id;
    return meansIt ? name : QString::number(std::uint32_t(id));
}

QString shownIds(const Scene& scene, const Property& property, const Value& value)
{
    if (const Id* id = std::get_if<Id>(&value))
        return *id == noId ? QString() : nameOf(scene, *id);
    const auto* ids = std::get_if<std::vector<Id>>(&value);
    if (!ids || ids->size() > mostShown)
        return {};
    QStringList names;
    for (const Id id : *ids)
        names << nameInList(scene, property, id);
    return names.join(QStringLiteral(", "));
}

QString hintOf(const FieldPlace& place, const Common& common)
{
    if (common.mixed[0])
        return mixedText();
    const auto* ids = std::get_if<std::vector<Id>>(&common.value);
    if (ids && ids->size() > mostShown) {
        std::vector<Id> sorted = *ids;
        std::sort(sorted.begin(), sorted.end());
        return describe(place.subject.document().scene(), sorted);
    }
    if (isOneOf<&Plot::probes>(place.property))
        return words("all that are plotted");
    return isOneOf<&Probe::target>(place.property) ? words("whole scene") : words("none");
}

// A list that has an item in it, or has it no more where it had.
std::vector<Id> toggled(std::vector<Id> ids, Id id)
{
    if (std::erase(ids, id) == 0)
        ids.push_back(id);
    return ids;
}

void fillMenu(QMenu& menu, const FieldPlace& place)
{
    menu.clear();
    Subject& subject = place.subject;
    const Property& property = place.property;
    const auto choose = [&](const QIcon& picture, const QString& text, const Value& value) {
        return menu.addAction(picture, text, &subject, [&subject, &property, value] {
            subject.edit(property, setTo(value));
        });
    };

    const Value now = Subject::common(property, subject.refs()).value;
    for (const Entry& entry : subject.document().scene().items)
        if (const Kind kind = kindOfItem(entry.item); property.pointsAt.contains(kind)) {
            const auto* list = std::get_if<std::vector<Id>>(&now);
            const QString picture = QString::fromUtf8(kindName(kind).data());
            QAction* action = choose(list ? QIcon() : icon(picture), // a list has ticks there
                                     inMenu(QString::fromStdString(nameOf(entry.item))),
                                     list ? Value(toggled(*list, entry.id)) : Value(entry.id));
            action->setCheckable(list);
            action->setChecked(list && std::ranges::count(*list, entry.id) > 0);
        }
    menu.addSeparator();
    const Kinds picked = property.pointsAt;
    if (picked.contains(Kind::Particle) || picked.contains(Kind::Link))
        menu.addAction(icon(QStringLiteral("grab")), words("Pick in the view or the outline"),
                       &subject, [&subject, &property] { subject.pick(property); });
    choose(icon(QStringLiteral("remove")), words("None"),
           isList(property) ? Value(std::vector<Id>()) : Value(noId));
}

} // namespace

Field idField(const FieldPlace& place)
{
    auto* edit =
        new ValueEdit([place](const QString& text) { return readIds(place, text).complaint; });
    QObject::connect(edit, &ValueEdit::complained, edit, place.complain);
    QObject::connect(edit, &ValueEdit::committed, edit, [place](const QString& text) {
        const Read read = readIds(place, text);
        if (read.complaint.isEmpty())
            place.subject.edit(place.property, setTo(read.value));
    });

    auto* button = new QToolButton;
    auto* menu = new QMenu(button);
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, place] { fillMenu(*menu, place); });
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setArrowType(Qt::DownArrow);
    button->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    button->setAutoRaise(true);
    button->setToolTip(words("Choose or pick %1.").arg(labelOf(place.property).toLower()));
    button->setAccessibleName(button->toolTip());

    auto* both = new QWidget;
    auto* layout = new QHBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(edit);
    layout->addWidget(button);
    return {both, {edit}, [place, edit](const Common& common) {
                const Scene& scene = place.subject.document().scene();
                edit->show(common.mixed[0] ? QString()
                                           : shownIds(scene, place.property, common.value),
                           hintOf(place, common));
            }};
}

} // namespace ripstop
