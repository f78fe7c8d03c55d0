// The scene as a tree:
//
//     Settings
//     Parts          kite             Particles, Links, Panels
//     Materials      dacron
//     Groups ... Plots
//
// The model keeps only ids; all else is read from the document when it is shown. After an edit the
// ids are compared with the scene, so that rows come and go one by one and nothing collapses. Names
// and visibility are written as edits of the document. It belongs to the thread of the window.
#pragma once

#include "scene/edit.h"

#include <QAbstractItemModel>
#include <QTimer>

#include <array>

namespace ripstop {

class Document;
class Selection;

class OutlineModel final : public QAbstractItemModel
{
    Q_OBJECT

public:
    enum Column { Name, Detail, Shown, ColumnCount };

    OutlineModel(Document& document, Selection& selection, QObject* parent);

    // What a row stands for: a list of all items of a kind, a table of a part, or one thing.
    struct Node
    {
        enum class Sort { Section, Table, Thing };
        Sort sort;
        Kind kind;
        Id id; // of the thing, or of the part of a table
    };
    Node node(const QModelIndex& index) const;

    std::vector<Id> ids(const QModelIndex& index) const; // all that the row stands for
    QModelIndex indexOf(Id item) const;                  // invalid for an element
    QModelIndex indexOfTable(Id part, Kind kind) const;
    void toggleShown(const QModelIndex& index);

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    void reset();
    void follow(const Edit& applied);
    void sayAgain();
    void followItems(Kind kind);
    QModelIndex section(Kind kind) const;
    QString detail(const Node& node) const;
    const Property* shownProperty(const Node& node) const;
    bool isShown(const Node& node) const;

    Document& m_document;
    Selection& m_selection;
    std::array<std::vector<Id>, kindCount> m_items; // by kind, in the author's order
    QTimer m_saysAgain;
};

} // namespace ripstop
