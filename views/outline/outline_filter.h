// The outline without empty lists, and while something is searched for, without what differs.
//
// It stands between the model and the tree; lists stay while one of their items fits. #17 fits what
// has the id 17, and the table that an element of this id is in.
#pragma once

#include "scene/id.h"

#include <QSortFilterProxyModel>

#include <optional>

namespace ripstop {

class OutlineModel;

// The outline without empty lists, and while something is searched for, without what differs.
class OutlineFilter final : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    OutlineFilter(OutlineModel& model, QObject* parent);

    // Part of a name or of a detail, in any case of letters; or the number of a thing.
    void search(const QString& text);

    // The id that is searched for: 17 of "#17". Nothing of other texts.
    static std::optional<Id> idIn(const QString& text);

private:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

    OutlineModel& m_model;
    QString m_text;
    std::optional<Id> m_id; // of it, where it is a number
};

} // namespace ripstop
