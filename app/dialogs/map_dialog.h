// Maps on the selected elements: a number of theirs as a formula of where they lie, or of a picture
// (select/element_map.h).
//
// What the formula gives is counted while it is typed; the map is one step of undo. It lives on the
// thread of the window.
#pragma once

#include "select/element_map.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ripstop {

class Document;
class Selection;

class MapDialog final : public QDialog
{
    Q_OBJECT

public:
    MapDialog(Document& document, Selection& selection, QWidget* parent);

    void setFormula(const QString& formula);
    void setNumber(const Property& property);
    QString verdict() const; // what the formula gives, or what is wrong

    void accept() override;

private:
    void fillNumbers();
    void offerFormula();
    void choosePicture();
    void look();
    Result<MappedNumbers> map() const;

    Document& m_document;
    Selection& m_selection;
    QComboBox* m_number;
    std::vector<const Property*> m_numbers; // [rows of m_number]
    QLineEdit* m_formula;
    QString m_offered; // the formula that the dialog wrote
    QLineEdit* m_picture;
    QLabel* m_verdict;
    QPushButton* m_ok = nullptr;
};

} // namespace ripstop
