// Particles, links, lines, panels or materials as a spreadsheet.
//
// It is sorted by a click on a column, filtered by a condition, edited in place, copied to and
// pasted from other spreadsheets. The rows that are marked are selected in the design. While a run
// is shown it says that its numbers are those of the design. While it is hidden it does nothing but
// note that its rows are old.
#pragma once

#include "select/condition.h"
#include "table/sheet_model.h"

#include <QTimer>
#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace ripstop {

class Complaint;
class Document;
class Player;
class Selection;

class SheetPanel final : public QWidget
{
    Q_OBJECT

public:
    // `measurement` is asked for what conditions can measure now.
    SheetPanel(Document& document, Selection& selection, std::function<Measurement()> measurement,
               QWidget* parent = nullptr);

    void follow(const Player& player); // to say when what is shown is no design

    void showSheet(SheetOf sheet);
    SheetModel& model() { return m_model; }
    QTableView& table() { return *m_table; }
    QLineEdit& filterLine() { return *m_filter; }

    void copy();  // the marked cells, with tabs
    void paste(); // from the marked cell on

signals:
    void described(); // count and complaint are up to date

private:
    void reload();
    void describe();
    void complain(const QString& sentence);
    void selectMarked();
    void widenColumns();
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

    Document& m_document;
    Selection& m_selection;
    std::function<Measurement()> m_measurement;
    SheetModel m_model;
    QComboBox* m_sheets;
    QLineEdit* m_filter;
    QCheckBox* m_onlySelected;
    QLabel* m_count;
    QLabel* m_ofDesign; // while a run is shown
    Complaint* m_complaint;
    QTableView* m_table;
    QTimer m_soon;         // the filter is looked at when typing pauses
    bool m_isStale = true; // the rows are old, as the panel was hidden
    bool m_isMarking = false;
};

} // namespace ripstop
