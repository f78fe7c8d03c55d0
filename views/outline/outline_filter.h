// The outline without empty lists, and while something is searched for, without what differs.
//
// It stands between the model and the tree; lists stay while one of their items fits.
#pragma once

#include <QSortFilterProxyModel>

namespace ripstop {

class OutlineModel;

// The outline without empty lists, and while something is searched for, without what differs.
class OutlineFilter final : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    OutlineFilter(OutlineModel& model, QObject* parent);

    void search(const QString& text); // part of a name or of a detail, in any case of letters

private:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

    OutlineModel& m_model;
    QString m_text;
};

} // namespace ripstop
