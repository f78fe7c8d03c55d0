#include "actions/preferences_dialog.h"

#include "actions/actions.h"
#include "files/run_files.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>

namespace ripstop {

PreferencesDialog::PreferencesDialog(const Actions& actions, RunFiles& runFiles, QWidget* parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Preferences"));
    auto* memory = new QSpinBox;
    memory->setRange(0, RunFiles::mostMemory);
    memory->setSingleStep(64);
    memory->setSuffix(QStringLiteral(" MB"));
    memory->setSpecialValueText(tr("nothing is recorded"));
    memory->setValue(RunFiles::memory());
    memory->setToolTip(tr("Each run keeps up to this much of itself in memory; older moments go to "
                          "a temporary file."));
    connect(memory, &QSpinBox::valueChanged, &runFiles, &RunFiles::setMemory);

    auto* language = choice(actions, {"languageSystem", "languageEnglish", "languageFrench"});
    auto* note = new QLabel(tr("The language changes when Ripstop starts the next time; memory "
                               "counts from the next run on."));
    note->setWordWrap(true);
    note->setForegroundRole(QPalette::PlaceholderText);
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Theme:"), choice(actions, {"themeSystem", "themeLight", "themeDark"}));
    form->addRow(tr("&Language:"), language);
    form->addRow(tr("&Memory for recordings:"), memory);
    form->addRow(note);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
}

// A list of actions that exclude each other, the checked one chosen.
QComboBox* PreferencesDialog::choice(const Actions& actions, std::initializer_list<const char*> ids)
{
    auto* list = new QComboBox;
    for (const char* id : ids) {
        QAction* action = actions[id];
        list->addItem(action->text().remove('&'));
        list->setItemData(list->count() - 1, action->statusTip(), Qt::ToolTipRole);
        if (action->isChecked())
            list->setCurrentIndex(list->count() - 1);
        connect(list, &QComboBox::activated, action, [action, row = list->count() - 1](int chosen) {
            if (chosen == row)
                action->trigger();
        });
    }
    return list;
}

} // namespace ripstop
