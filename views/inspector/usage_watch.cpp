#include "inspector/usage_watch.h"

#include "document/document.h"
#include "document/words.h"

namespace ripstop {
namespace {

constexpr std::size_t mostAsked = 100;

} // namespace

UsageWatch::UsageWatch(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::replaced, this, [this] { m_usage.reset(); });
    connect(&document, &Document::changed, this, [this](const Edit& applied) {
        if (changesUsage(applied))
            m_usage.reset();
    });
}

const Usage& UsageWatch::usage()
{
    if (!m_usage)
        m_usage = usageOf(m_document.scene());
    return *m_usage;
}

std::vector<const Remedy*> UsageWatch::remedies(const Property& property,
                                                const std::vector<Id>& ids)
{
    if (ids.empty() || whyIdle(property, ids).isEmpty())
        return {};
    return remediesOf(m_document.scene(), usage(), property, ids.front());
}

QString UsageWatch::whyIdle(const Property& property, const std::vector<Id>& ids)
{
    QString first;
    for (std::size_t i = 0; i < ids.size() && i < mostAsked; ++i) {
        const auto reason = ripstop::whyIdle(m_document.scene(), usage(), property, ids[i]);
        if (!reason)
            return {};
        if (i == 0)
            first = translated(*reason);
    }
    return first;
}

} // namespace ripstop
