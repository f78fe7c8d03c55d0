// What holds for the whole program on this machine: theme, language, memory of recordings.
//
// Each choice is that of the menu: the dialog triggers its actions, so that both say the same.
// Changes count at once and there is nothing to accept, except that the language is that of the
// next start. Dialogs::showPreferences() opens it.
#pragma once

#include <QDialog>

class QAction;
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
};

} // namespace ripstop
