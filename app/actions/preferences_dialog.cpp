#include "actions/preferences_dialog.h"

#include "actions/actions.h"
#include "files/run_files.h"

#include <QAction>
#include <QActionGroup>
#include <QCheckBox>
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
    setAttribute(Qt::WA_DeleteOnClose);
    auto* memory = new QSpinBox;
    memory->setRange(0, RunFiles::mostMemory);
    memory->setSingleStep(64);
    memory->setSuffix(tr(" MB"));
    memory->setSpecialValueText(tr("nothing is recorded"));
    memory->setValue(RunFiles::memory());
    memory->setToolTip(tr("Each run keeps up to this much of itself in memory; older moments go to "
                          "a temporary file."));
    connect(memory, &QSpinBox::valueChanged, &runFiles, &RunFiles::setMemory);

    auto* note = new QLabel(tr("Memory counts from the next run on."));
    note->setWordWrap(true);
    note->setForegroundRole(QPalette::PlaceholderText);
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Theme:"), choice(*actions["themeSystem"]));
    form->addRow(tr("&Language:"), choice(*actions["languageSystem"]));
    form->addRow(QString(), tick(*actions["reduceMotion"]));
    form->addRow(tr("&Memory for recordings:"), memory);
    form->addRow(note);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
}

QCheckBox* PreferencesDialog::tick(QAction& action)
{
    auto* box = new QCheckBox(action.text().remove('&'));
    box->setToolTip(action.statusTip());
    box->setChecked(action.isChecked());
    connect(box, &QCheckBox::clicked, &action, &QAction::trigger);
    return box;
}

// A list of the actions that exclude this one, and of itself, the checked one chosen.
QComboBox* PreferencesDialog::choice(const QAction& one)
{
    auto* list = new QComboBox;
    for (QAction* action : one.actionGroup()->actions()) {
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
