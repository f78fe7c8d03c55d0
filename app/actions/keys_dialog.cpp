// Stages: the constructor fills a table of four sections and lays out the row in which the key of
// the chosen action is changed. showKeys() writes the keys of all actions, in bold where they are
// not the usual ones; filter() hides rows and sections that the search does not meet.
// showConflict() names the action that would lose a key before it is set.
#include "actions/keys_dialog.h"

#include "actions/key_map.h"
#include "document/words.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ripstop {
namespace {

constexpr int actionRole = Qt::UserRole;

enum Column { keyColumn, nameColumn, helpColumn };

QString nameOf(const QAction& action) { return action.text().remove('&'); }

} // namespace

KeysDialog::KeysDialog(KeyMap& keys, const Scene& scene, QWidget* parent)
    : QDialog(parent)
    , m_keys(keys)
    , m_search(new QLineEdit)
    , m_table(new QTreeWidget)
    , m_name(new QLabel)
    , m_edit(new QKeySequenceEdit)
    , m_set(new QPushButton(tr("&Set")))
    , m_usual(new QPushButton(tr("&Usual")))
    , m_conflict(new QLabel)
{
    setWindowTitle(tr("Keys"));
    m_search->setPlaceholderText(tr("Search a key or what it does"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_search->setClearButtonEnabled(true);
    m_table->setHeaderLabels({tr("Key"), tr("Does"), tr("Help")});
    m_table->setRootIsDecorated(false);
    m_table->setIndentation(0);
    m_table->setAlternatingRowColors(true);
    m_table->setUniformRowHeights(true);
    addControls(scene);
    addActions();
    addPointing();
    m_table->expandAll();
    m_table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);

    m_edit->setAccessibleName(tr("Key"));
    m_edit->setClearButtonEnabled(true);
    m_usual->setToolTip(tr("The key that it had at first."));
    auto* resetAll = new QPushButton(tr("All &usual"));
    resetAll->setToolTip(tr("Every action gets the key that it had at first."));
    auto* change = new QHBoxLayout;
    change->addWidget(m_name);
    change->addWidget(m_edit, 1);
    change->addWidget(m_set);
    change->addWidget(m_usual);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(resetAll, QDialogButtonBox::ResetRole);
    for (QPushButton* button : {m_set, m_usual, resetAll})
        button->setAutoDefault(false); // Enter belongs to the field

    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(resetAll, &QPushButton::clicked, &m_keys, &KeyMap::resetAll);
    connect(m_search, &QLineEdit::textChanged, this, &KeysDialog::filter);
    connect(m_table, &QTreeWidget::itemSelectionChanged, this, &KeysDialog::showChosen);
    connect(m_table, &QTreeWidget::itemActivated, this, [this] { m_edit->setFocus(); });
    connect(m_edit, &QKeySequenceEdit::keySequenceChanged, this, &KeysDialog::showConflict);
    connect(m_set, &QPushButton::clicked, this, &KeysDialog::setKeys);
    connect(m_usual, &QPushButton::clicked, this, [this] {
        m_edit->setKeySequence(m_keys.usual(*chosen()));
        setKeys();
    });
    connect(&m_keys, &KeyMap::changed, this, &KeysDialog::showKeys);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_search);
    layout->addWidget(m_table);
    layout->addLayout(change);
    layout->addWidget(m_conflict);
    layout->addWidget(buttons);
    resize(760, 600);
    showKeys();
    showChosen();
    m_search->setFocus();
}

QTreeWidgetItem* KeysDialog::section(const QString& title)
{
    auto* row = new QTreeWidgetItem(m_table, {title});
    QFont bold = font();
    bold.setBold(true);
    row->setFont(0, bold);
    row->setFirstColumnSpanned(true);
    row->setFlags(Qt::ItemIsEnabled);
    return row;
}

void KeysDialog::addControls(const Scene& scene)
{
    QTreeWidgetItem* title = nullptr;
    int stick = 0;
    for (const Entry& entry : scene.items) {
        const Control* control = std::get_if<Control>(&entry.item);
        if (!control)
            continue;
        if (!title)
            title = section(tr("Controls of this scene"));
        const QString name = QString::fromStdString(control->name);
        const QString keys =
            QString("%1   %2").arg(keyText(control->keyLess), keyText(control->keyMore));
        if (!keys.trimmed().isEmpty())
            new QTreeWidgetItem(
                title, {keys, name,
                        tr("Less and more, %1 m each time.").arg(compactNumber(control->step))});
        new QTreeWidgetItem(title,
                            {tr("Gamepad, axis %1").arg(++stick), name,
                             tr("Up to %1 m either way.").arg(compactNumber(control->limit))});
    }
}

void KeysDialog::addActions()
{
    auto* title = section(tr("Everywhere"));
    for (QAction* action : m_keys.actions()) {
        auto* row = new QTreeWidgetItem(title, {{}, nameOf(*action), action->statusTip()});
        row->setIcon(nameColumn, action->icon());
        row->setData(keyColumn, actionRole, QVariant::fromValue(action));
    }
}

void KeysDialog::addPointing()
{
    auto* view = section(tr("In the 3D view"));
    const auto row = [](QTreeWidgetItem* under, const QString& key, const QString& does,
                        const QString& help) {
        new QTreeWidgetItem(under, {key, does, help});
    };
    row(view, tr("Left drag"), tr("Turn", "the view"), tr("The horizon stays level."));
    row(view, tr("Middle or Shift + left drag"), tr("Move"), {});
    row(view, tr("Ctrl + left drag"), tr("Grab"),
        tr("Pulls at fabric and lines, carries colliders, moves what controls move."));
    row(view, tr("Wheel"), tr("Zoom"), tr("Towards the cursor."));
    row(view, tr("Click"), tr("Select"),
        tr("With Shift, add to the selection; with Ctrl, take away."));
    row(view, tr("Left drag, with box or lasso"), tr("Select what lies inside"),
        tr("With Shift, add; with Ctrl, take away; Escape gives up."));
    row(view, tr("Right drag, with box or lasso"), tr("Turn", "the view"), {});
    auto* handle = section(tr("While a handle is pulled"));
    row(handle, tr("X, Y, Z"), tr("Keep to an axis"), tr("The same key again lets it go."));
    row(handle, tr("0 to 9, −, ."), tr("Type the amount"),
        tr("Metres, degrees or a factor. Enter takes it."));
    row(handle, tr("Ctrl"), tr("Snap"), tr("To a grid, to particles, to 15°, to tenths."));
    row(handle, tr("Esc, right button"), tr("Take back"), {});
}

void KeysDialog::showKeys()
{
    for (QTreeWidgetItemIterator row(m_table); *row; ++row) {
        const auto* action = (*row)->data(keyColumn, actionRole).value<QAction*>();
        if (!action)
            continue;
        QFont font = this->font();
        font.setBold(action->shortcut() != m_keys.usual(*action));
        (*row)->setFont(keyColumn, font);
        (*row)->setText(keyColumn, action->shortcut().toString(QKeySequence::NativeText));
    }
    filter();
    showChosen();
}

void KeysDialog::filter()
{
    const QString searched = m_search->text();
    for (int t = 0; t < m_table->topLevelItemCount(); ++t) {
        QTreeWidgetItem* title = m_table->topLevelItem(t);
        bool isShown = false;
        for (int r = 0; r < title->childCount(); ++r) {
            QTreeWidgetItem* row = title->child(r);
            bool fits = searched.isEmpty();
            for (const Column column : {keyColumn, nameColumn, helpColumn})
                fits |= row->text(column).contains(searched, Qt::CaseInsensitive);
            row->setHidden(!fits);
            isShown |= fits;
        }
        title->setHidden(!isShown);
    }
}

QAction* KeysDialog::chosen() const
{
    const auto rows = m_table->selectedItems();
    return rows.isEmpty() ? nullptr : rows.first()->data(keyColumn, actionRole).value<QAction*>();
}

void KeysDialog::showChosen()
{
    const QAction* action = chosen();
    m_name->setText(action ? tr("Key for \"%1\":").arg(nameOf(*action))
                           : tr("Choose an action to change its key:"));
    m_edit->setKeySequence(action ? action->shortcut() : QKeySequence());
    m_edit->setEnabled(action);
    m_usual->setEnabled(action && action->shortcut() != m_keys.usual(*action));
    showConflict();
}

void KeysDialog::showConflict()
{
    const QAction* action = chosen();
    const QAction* holder = m_keys.holder(m_edit->keySequence());
    const bool isTaken = action && holder && holder != action;
    m_conflict->setText(isTaken ? tr("\"%1\" has this key, and would lose it.").arg(nameOf(*holder))
                        : action ? tr("Press the keys, then Set.")
                                 : QString());
    m_set->setEnabled(action && m_edit->keySequence() != action->shortcut());
}

void KeysDialog::setKeys()
{
    if (QAction* action = chosen())
        m_keys.set(*action, m_edit->keySequence());
}

} // namespace ripstop
