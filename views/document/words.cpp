// In order: the table of words for the kinds of things; translations of texts and messages of the
// model, which writes English; labels of kinds, properties and choices; names of things by their
// ids; and the description of a selection, from its census. Choices have no labels of their own:
// they are made from the key in the file by a few rules of English and then translated.
#include "document/words.h"

#include "document/census.h"
#include "materials/presets.h"
#include "scene/said_number.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

struct KindWords
{
    const char* one;
    const char* many;
    const char* counted;
};

// clang-format off
constexpr std::array<KindWords, kindCount> kindWords{{
    {QT_TRANSLATE_NOOP("Kind", "Settings"),  QT_TRANSLATE_NOOP("Kind", "Settings"),  QT_TRANSLATE_N_NOOP("Kind", "%Ln setting(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Particle"),  QT_TRANSLATE_NOOP("Kind", "Particles"), QT_TRANSLATE_N_NOOP("Kind", "%Ln particle(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Link"),      QT_TRANSLATE_NOOP("Kind", "Links"),     QT_TRANSLATE_N_NOOP("Kind", "%Ln link(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Panel"),     QT_TRANSLATE_NOOP("Kind", "Panels"),    QT_TRANSLATE_N_NOOP("Kind", "%Ln panel(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Part"),      QT_TRANSLATE_NOOP("Kind", "Parts"),     QT_TRANSLATE_N_NOOP("Kind", "%Ln part(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Material"),  QT_TRANSLATE_NOOP("Kind", "Materials"), QT_TRANSLATE_N_NOOP("Kind", "%Ln material(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Group"),     QT_TRANSLATE_NOOP("Kind", "Groups"),    QT_TRANSLATE_N_NOOP("Kind", "%Ln group(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Collider"),  QT_TRANSLATE_NOOP("Kind", "Colliders"), QT_TRANSLATE_N_NOOP("Kind", "%Ln collider(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Wind"),      QT_TRANSLATE_NOOP("Kind", "Winds"),     QT_TRANSLATE_N_NOOP("Kind", "%Ln wind(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Control"),   QT_TRANSLATE_NOOP("Kind", "Controls"),  QT_TRANSLATE_N_NOOP("Kind", "%Ln control(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Probe"),     QT_TRANSLATE_NOOP("Kind", "Probes"),    QT_TRANSLATE_N_NOOP("Kind", "%Ln probe(s)")},
    {QT_TRANSLATE_NOOP("Kind", "Plot"),      QT_TRANSLATE_NOOP("Kind", "Plots"),     QT_TRANSLATE_N_NOOP("Kind", "%Ln plot(s)")},
}};
// clang-format on

const KindWords& wordsOf(Kind kind) { return kindWords[std::size_t(kind)]; }

// Words of the table are literals, and so end with a zero as QCoreApplication::translate() needs.
QString translated(const char* context, const char* text)
{
    return QCoreApplication::translate(context, text);
}

// As people write it: 1.2e-05 is 0.000012, and 1e+30 no row of digits.
QString withoutExponent(const QString& number)
{
    const qsizetype sign = number.indexOf(QChar('e'));
    bool isNumber = false;
    const double value = number.toDouble(&isNumber);
    if (sign < 0 || !isNumber || std::abs(value) >= mostDigits)
        return number;
    const int digits = int(number.left(sign).count(QRegularExpression(QStringLiteral("\\d"))));
    const int decimals = digits - 1 - number.mid(sign + 1).toInt();
    return QString::number(value, 'f', std::max(0, decimals));
}

} // namespace

QString text(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), qsizetype(utf8.size()));
}

QString words(const char* english) { return QCoreApplication::translate("Window", english); }

QString labelled(const QString& name, const QString& said)
{
    return words("%1: %2").arg(name, said);
}

QString translated(std::string_view english)
{
    return english.empty() ? QString()
                           : QCoreApplication::translate("Model", std::string(english).c_str());
}

QString translated(const Message& message)
{
    return QString::fromStdString(message.said([](Message::Kind kind, const std::string& english) {
        switch (kind) {
        case Message::Kind::Sentence:
            return translated(std::string_view(english)).toStdString();
        case Message::Kind::Verbatim:
            return english;
        case Message::Kind::Number:
            break;
        }
        return withoutExponent(QString::fromStdString(english))
            .replace(QChar('.'), QLocale().decimalPoint())
            .toStdString();
    }));
}

QString keyText(const std::string& key)
{
    return QKeySequence(QString::fromStdString(key)).toString(QKeySequence::NativeText);
}

QString kindLabel(Kind kind) { return translated("Kind", wordsOf(kind).one); }

QString kindPluralLabel(Kind kind) { return translated("Kind", wordsOf(kind).many); }

QString counted(Kind kind, qsizetype n)
{
    // Without a translation file the plural is made here: English adds an s.
    QString text = QCoreApplication::translate("Kind", wordsOf(kind).counted, nullptr, int(n));
    return text.replace(QStringLiteral("(s)"), n == 1 ? QString() : QStringLiteral("s"));
}

QString countsOf(const ElementCounts& elements)
{
    QStringList texts;
    for (const auto& [kind, count] :
         {std::pair{Kind::Particle, elements.particles}, std::pair{Kind::Link, elements.links},
          std::pair{Kind::Panel, elements.panels}})
        if (count > 0)
            texts << counted(kind, qsizetype(count));
    return texts.join(QStringLiteral(", "));
}

QString labelOf(const Property& property) { return translated(property.label); }

QString helpOf(const Property& property) { return translated(property.help); }

QString englishLabel(std::string_view choice)
{
    QString text = QString::fromUtf8(choice.data(), qsizetype(choice.size())).replace('_', ' ');
    for (const char* name : {"euler", "verlet", "gauss", "seidel", "jacobi"}) {
        const QString proper = QString(QLatin1String(name));
        text.replace(proper, proper.at(0).toUpper() + proper.mid(1));
    }
    for (const char* axis : {"pressure x", "pressure y", "pressure z"})
        if (text == QLatin1String(axis))
            text.prepend(QLatin1String("centre of "));
    for (const char* name : {"bdf2", "rk4"})
        text.replace(QLatin1String(name), QString(QLatin1String(name)).toUpper());
    if (!text.isEmpty())
        text[0] = text.at(0).toUpper();
    return text;
}

QString choiceLabel(std::string_view choice)
{
    if (const Result<const Preset*> preset = findPreset(choice)) // what is for sale has one name
        return translated((*preset)->label);
    return translated(englishLabel(choice).toStdString());
}

QString nameOf(const Scene& scene, Id id)
{
    if (id == settingsId)
        return kindLabel(Kind::Settings);
    if (const Item* item = findItem(scene, id))
        return QString::fromStdString(nameOf(*item));
    const QString number = QString::number(std::uint32_t(id));
    if (const auto ref = find(scene, id))
        return kindLabel(kindOf(*ref)).toLower() + QChar(' ') + number;
    return QChar('#') + number;
}

QString compactNumber(double value)
{
    const double size = std::abs(value);
    const bool isPlain = size == 0.0 || (size >= 1e-6 && size < 1e9); // 0.0005, not 5e-04
    const auto shortest = [&](double number) {
        return QString::number(number, isPlain ? 'f' : 'g', QLocale::FloatingPointShortest);
    };
    const QString exact = shortest(value);
    const QString rounded = shortest(QString::number(value, 'g', 6).toDouble());
    QString number = exact.size() <= rounded.size() ? exact : rounded;
    return number.replace(QChar('.'), QLocale().decimalPoint());
}

QString describe(const Scene& scene, const std::vector<Id>& ids)
{
    const Census all = census(scene, ids);
    QStringList kinds;
    Id part = noId;
    bool elementsOfOnePart = true;
    for (int k = 0; k < kindCount; ++k) {
        const auto& found = all[Kind(k)];
        if (found.empty())
            continue;
        kinds << counted(Kind(k), qsizetype(found.size()));
        for (const Census::Found& one : found) {
            elementsOfOnePart =
                elementsOfOnePart && one.part != noId && (part == noId || part == one.part);
            part = one.part;
        }
    }
    QString text = kinds.join(QStringLiteral(", "));
    if (ids.size() == 1)
        text = nameOf(scene, ids.front());
    if (kinds.isEmpty() || !elementsOfOnePart)
        return text;
    //: "3 particles of kite"
    return QCoreApplication::translate("Kind", "%1 of %2").arg(text, nameOf(scene, part));
}

} // namespace ripstop
