#include "inspector/remedies.h"

#include "document/document.h"
#include "document/words.h"
#include "inspector/subject.h"

#include <QCoreApplication>

namespace ripstop {
namespace {

QString joinedLinks(const QStringList& words)
{
    //: between two things that one may do: "Do this or do that"
    return words.join(QCoreApplication::translate("Remedies", " or "));
}

} // namespace

QString remedyLinks(const Remedies& remedies)
{
    QStringList links;
    for (std::size_t i = 0; i < remedies.size(); ++i)
        links << QStringLiteral("<a href='%1'>%2</a>")
                     .arg(i)
                     .arg(translated(remedies[i]->label).toHtmlEscaped());
    return joinedLinks(links);
}

QString remedyWords(const Remedies& remedies)
{
    QStringList words;
    for (const Remedy* remedy : remedies)
        words << translated(remedy->label);
    return joinedLinks(words);
}

QString performRemedy(const Remedy& remedy, const Property& property, Subject& subject)
{
    Result<Edit> edit = remedy.edit(subject.document().scene(), property, subject.ids());
    if (!edit)
        return translated(edit.message());
    subject.document().push(std::move(*edit));
    return {};
}

} // namespace ripstop
