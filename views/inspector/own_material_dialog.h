// Asks what a material is to be called among the user's own, what it is and who says its numbers,
// and writes it into their file. A name that is there already has to be confirmed; what cannot be
// written is said and the dialog stays.
#pragma once

#include "materials/preset.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ripstop {

class OwnMaterialDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit OwnMaterialDialog(Preset preset, QWidget* parent = nullptr);

private:
    void layOut();
    void refresh();
    void save();

    Preset m_preset;
    QLineEdit* m_label;
    QComboBox* m_kind;
    QLineEdit* m_source;
    QLabel* m_name; // as commands take it, or what is wrong
    QPushButton* m_save;
    bool m_replaces = false; // an own material of that name
};

} // namespace ripstop
