#include "language/sentences.h"

#include <QFile>
#include <QLocale>
#include <QXmlStreamReader>

#include <algorithm>

namespace ripstop {
namespace {

const QRegularExpression& gapSign()
{
    static const QRegularExpression sign(QStringLiteral("%(\\d)"));
    return sign;
}

// A single word with a gap, such as "Link %1", takes a single word.
QRegularExpression expressionOf(const QString& source)
{
    const bool isShort = source.count(QChar(' ')) < 2;
    QString text = QRegularExpression::escape(source);
    // escape() puts a backslash before the sign
    text.replace(QRegularExpression(QStringLiteral("\\\\%\\d")),
                 isShort ? QStringLiteral("(\\S+)") : QStringLiteral("(.+?)"));
    return QRegularExpression(QRegularExpression::anchoredPattern(text),
                              QRegularExpression::DotMatchesEverythingOption);
}

} // namespace

void Sentences::clear()
{
    m_whole.clear();
    m_patterns.clear();
}

void Sentences::load(const QString& file)
{
    clear();
    QFile input(file);
    if (!input.open(QIODevice::ReadOnly))
        return;
    QXmlStreamReader xml(&input);
    QString source;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == QLatin1String("source"))
            source = xml.readElementText();
        if (!xml.isStartElement() || xml.name() != QLatin1String("translation"))
            continue;
        const QString translation = xml.readElementText();
        if (!source.contains(gapSign()))
            m_whole.insert(source, translation);
        else
            m_patterns.push_back(
                {expressionOf(source), translation, QString(source).remove(gapSign()).size()});
    }
    std::ranges::stable_sort(m_patterns, std::ranges::greater(), &Pattern::letters);
}

QString Sentences::filled(const QString& gap) const
{
    bool isNumber = false;
    gap.toDouble(&isNumber);
    if (isNumber)
        return QString(gap).replace(QChar('.'), QLocale().decimalPoint());
    const QString known = translated(gap);
    return known.isEmpty() ? gap : known;
}

QString Sentences::translated(const QString& english) const
{
    if (const auto whole = m_whole.constFind(english); whole != m_whole.cend())
        return *whole;
    for (const Pattern& pattern : m_patterns) {
        const QRegularExpressionMatch match = pattern.english.match(english);
        if (!match.hasMatch())
            continue;
        // Gaps are numbered in the order of the English sentence.
        QString text;
        qsizetype end = 0;
        QRegularExpressionMatchIterator gaps = gapSign().globalMatch(pattern.translation);
        while (gaps.hasNext()) {
            const QRegularExpressionMatch gap = gaps.next();
            text += QStringView(pattern.translation).sliced(end, gap.capturedStart() - end);
            text += filled(match.captured(gap.capturedView(1).toInt()));
            end = gap.capturedEnd();
        }
        return text += QStringView(pattern.translation).sliced(end);
    }
    return {};
}

} // namespace ripstop
