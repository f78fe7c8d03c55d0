// All keys on one page: those of the controls of a scene, those of the actions, which can be
// changed here, and what the mouse does.
//
// Changes go to the KeyMap at once, which keeps them; there is nothing to accept. The controls are
// those of the scene at the moment when the dialog was made. Dialogs::showKeys() opens it.
#pragma once

#include "scene/scene.h"

#include <QDialog>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace ripstop {

class KeyMap;

class KeysDialog final : public QDialog
{
    Q_OBJECT

public:
    KeysDialog(KeyMap& keys, const Scene& scene, QWidget* parent);

private:
    QTreeWidgetItem* section(const QString& title);
    void addControls(const Scene& scene);
    void addActions();
    void addPointing();
    void showKeys();
    void filter();
    QAction* chosen() const;
    void showChosen();
    void showConflict();
    void setKeys();

    KeyMap& m_keys;
    QLineEdit* m_search;
    QTreeWidget* m_table;
    QLabel* m_name;
    QKeySequenceEdit* m_edit;
    QPushButton* m_set;
    QPushButton* m_usual;
    QLabel* m_conflict;
};

} // namespace ripstop
