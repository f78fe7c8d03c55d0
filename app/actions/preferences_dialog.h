// What holds for the whole program on this machine: theme, language, how much moves, memory of
// recordings.
//
// Each choice is that of the menu: the dialog triggers its actions, so that both say the same.
// Changes count at once and there is nothing to accept. Another language makes the window anew, and
// this dialog with it. Dialogs::showPreferences() opens it; it deletes itself when closed.
#pragma once

#include <QDialog>

class QAction;
class QCheckBox;
class QComboBox;

namespace ripstop {

class Actions;
class RunFiles;

class PreferencesDialog final : public QDialog
{
    Q_OBJECT

public:
    PreferencesDialog(const Actions& actions, RunFiles& runFiles, QWidget* parent);

private:
    QComboBox* choice(const QAction& one);
    QCheckBox* tick(QAction& action);
};

} // namespace ripstop
