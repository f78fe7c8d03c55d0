// The figures that a simulation stands or falls with, before it is started.
//
// A click selects what a row is about; a button repairs it, where that can be done without asking,
// as one step of undo. Repairs are edits of the scene as it was checked, so an edit disables the
// buttons until the next findings come.
#pragma once

#include "author/stability.h"

#include <QTreeWidget>

namespace ripstop {

class Document;
class Selection;

class StabilityList final : public QTreeWidget
{
    Q_OBJECT

public:
    StabilityList(Document& document, Selection& selection, QWidget* parent = nullptr);

    void showFindings(const std::vector<Finding>& findings); // of the document as it is now
    int poor() const;                                        // how many findings are poor
    bool tellsPoor(std::string_view sort) const;             // a poor finding is of this sort

private:
    void updateGeometries() override;
    void fitRows();
    void repair(std::size_t row);
    void outdate(); // the repairs may not fit any more

    Document& m_document;
    Selection& m_selection;
    std::vector<Finding> m_findings;
};

} // namespace ripstop
