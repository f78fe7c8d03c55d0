// What the numbers of the open scene are for.
//
// The count behind it walks over the whole scene, so it is made when asked for, and again only
// after edits that may change it. Forms ask it for each row that they show.
#pragma once

#include "author/remedy.h"

#include <QObject>
#include <QString>

namespace ripstop {

class Document;

class UsageWatch final : public QObject
{
    Q_OBJECT

public:
    explicit UsageWatch(Document& document, QObject* parent = nullptr);

    // Why the property does nothing for any of these things, as half a sentence; empty where it has
    // an effect. Of more than 100 things only the first 100 are asked.
    QString whyIdle(const Property& property, const std::vector<Id>& ids);

    // What makes it count, of the first of these things; none where it has an effect.
    std::vector<const Remedy*> remedies(const Property& property, const std::vector<Id>& ids);

    const Usage& usage();

private:
    Document& m_document;
    std::optional<Usage> m_usage;
};

} // namespace ripstop
