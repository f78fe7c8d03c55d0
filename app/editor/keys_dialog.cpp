#include "editor/keys_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ripstop {

KeysDialog::KeysDialog(const std::vector<QAction*>& actions, const Scene& scene, QWidget* parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Keys"));
    auto* table = new QTreeWidget;
    table->setColumnCount(3);
    table->setHeaderLabels({tr("Key"), tr("Does"), tr("Help")});
    table->setRootIsDecorated(false);
    table->setAlternatingRowColors(true);
    table->setUniformRowHeights(true);

    const auto section = [&](const QString& title) {
        auto* row = new QTreeWidgetItem(table, {title});
        QFont bold = font();
        bold.setBold(true);
        row->setFont(0, bold);
        row->setFirstColumnSpanned(true);
        row->setFlags(Qt::ItemIsEnabled);
    };
    bool titled = false;
    for (const Entry& entry : scene.items) {
        const Control* control = std::get_if<Control>(&entry.item);
        if (!control || (control->keyLess.empty() && control->keyMore.empty()))
            continue;
        if (!titled)
            section(tr("Controls of this scene"));
        titled = true;
        const QString keys = QString("%1   %2").arg(QString::fromStdString(control->keyLess),
                                                    QString::fromStdString(control->keyMore));
        new QTreeWidgetItem(table, {keys, QString::fromStdString(control->name),
                                    tr("Less and more, %1 m each time.").arg(control->step)});
    }
    section(tr("Everywhere"));
    for (const QAction* action : actions)
        if (!action->shortcut().isEmpty()) {
            QString text = action->text();
            new QTreeWidgetItem(table, {action->shortcut().toString(QKeySequence::NativeText),
                                        text.remove('&'), action->statusTip()});
        }
    section(tr("In the 3D view"));
    new QTreeWidgetItem(table, {tr("Left drag"), tr("Turn"), tr("The horizon stays level.")});
    new QTreeWidgetItem(table, {tr("Middle or Shift + left drag"), tr("Move"), QString()});
    new QTreeWidgetItem(table, {tr("Ctrl + left drag"), tr("Steer"),
                                tr("Drags what controls move: corners, pilots, colliders.")});
    new QTreeWidgetItem(table, {tr("Wheel"), tr("Zoom"), tr("Towards the cursor.")});
    new QTreeWidgetItem(table, {tr("Click"), tr("Select"),
                                tr("With Shift, add to the selection; with Ctrl, take away.")});
    new QTreeWidgetItem(table, {tr("Left drag, with box or lasso"), tr("Select what lies inside"),
                                tr("With Shift, add; with Ctrl, take away; Escape gives up.")});
    new QTreeWidgetItem(table, {tr("Right drag, with box or lasso"), tr("Turn"), QString()});
    section(tr("While a handle is pulled"));
    new QTreeWidgetItem(
        table, {tr("X, Y, Z"), tr("Keep to an axis"), tr("The same key again lets it go.")});
    new QTreeWidgetItem(table, {tr("0 to 9, −, ."), tr("Type the amount"),
                                tr("Metres, degrees or a factor. Enter takes it.")});
    new QTreeWidgetItem(
        table, {tr("Ctrl"), tr("Snap"), tr("To a grid, to particles, to 15°, to tenths.")});
    new QTreeWidgetItem(table, {tr("Esc, right button"), tr("Take back"), QString()});
    table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(table);
    layout->addWidget(buttons);
    resize(720, 560);
}

} // namespace ripstop
