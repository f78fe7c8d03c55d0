// What the user has selected: items or elements, in ascending order of id. Ids that an edit removes
// leave the selection by themselves. Belongs to the window's thread.
#pragma once

#include "scene/id.h"

#include <QObject>

#include <vector>

namespace ripstop {

class Document;

class Selection final : public QObject
{
    Q_OBJECT

public:
    explicit Selection(Document& document, QObject* parent = nullptr);

    const std::vector<Id>& ids() const { return m_ids; }
    bool contains(Id id) const;

    void set(std::vector<Id> ids);
    void add(const std::vector<Id>& ids);
    void remove(const std::vector<Id>& ids);
    void clear() { set({}); }

signals:
    void changed();

private:
    Document& m_document;
    std::vector<Id> m_ids;
};

} // namespace ripstop
