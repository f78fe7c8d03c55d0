// Stages: the constructor collects the entries of all menus with their paths; fill() ranks those
// that answer what is typed and lists them, those that cannot be run now last and grey. fit() is
// the ranking: each typed word has to be found, in the name first, then in the menu, then in the
// tip. Keys that move through the list work while the field has the focus.
#include "actions/palette.h"

#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int commandRole = Qt::UserRole;
constexpr int dockRole = Qt::UserRole + 1;

// Without what stands in the column of keys.
QString plain(const QString& text) { return text.section('\t', 0, 0).remove('&'); }

// Actions of panels have theirs where the mouse shows it.
QString tipOf(const QAction& action)
{
    return action.statusTip().isEmpty() ? action.toolTip() : action.statusTip();
}

bool beginsAWord(const QString& text, const QString& word)
{
    return text.startsWith(word, Qt::CaseInsensitive)
           || text.contains(' ' + word, Qt::CaseInsensitive);
}

bool isAWord(const QString& text, const QString& word)
{
    return (' ' + text + ' ').contains(' ' + word + ' ', Qt::CaseInsensitive);
}

} // namespace

Palette::Palette(const QMenuBar& menus, const QList<PanelMenu>& others, QWidget* parent)
    : QDialog(parent)
    , m_typed(new QLineEdit)
    , m_list(new QTreeWidget)
    , m_none(
          new QLabel(tr("No action has all of these words in its name, its menu or its help. Try "
                        "fewer words, or others. Presets of materials are found while a material "
                        "is selected.")))
{
    setWindowTitle(tr("Find an action"));
    for (const QAction* title : menus.actions())
        if (title->menu())
            collect(*title->menu(), plain(title->text()));
    for (const PanelMenu& other : others)
        if (other.menu)
            collect(*other.menu, other.title, other.dock);

    m_typed->setPlaceholderText(tr("Type what you want to do: mirror, pin, wind…"));
    m_typed->setAccessibleName(m_typed->placeholderText());
    m_typed->setClearButtonEnabled(true);
    m_typed->installEventFilter(this);
    m_list->setHeaderHidden(true);
    m_list->setColumnCount(3);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_none->setWordWrap(true);
    connect(m_typed, &QLineEdit::textChanged, this, &Palette::fill);
    connect(m_typed, &QLineEdit::returnPressed, this, [this] {
        if (chosen())
            accept();
    });
    connect(m_list, &QTreeWidget::itemClicked, this, [this] {
        if (chosen())
            accept();
    });

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_typed);
    layout->addWidget(m_none);
    layout->addWidget(m_list);
    resize(620, 420);
    fill();
}

QAction* Palette::chosen() const
{
    const QTreeWidgetItem* row = m_list->currentItem();
    auto* action = row ? row->data(0, commandRole).value<QAction*>() : nullptr;
    return action && action->isEnabled() ? action : nullptr;
}

QString Palette::dock() const
{
    const QTreeWidgetItem* row = m_list->currentItem();
    return row ? row->data(0, dockRole).toString() : QString();
}

int Palette::fit(const QString& typed, const QString& name, const QString& menu, const QString& tip)
{
    int sum = 1;
    for (const QString& word : typed.split(' ', Qt::SkipEmptyParts)) {
        if (name.startsWith(word, Qt::CaseInsensitive))
            sum += isAWord(name, word) ? 50 : 40;
        else if (beginsAWord(name, word))
            sum += isAWord(name, word) ? 45 : 30;
        else if (name.contains(word, Qt::CaseInsensitive))
            sum += 15;
        else if (beginsAWord(menu, word))
            sum += 8;
        else if (beginsAWord(tip, word))
            sum += 4;
        else
            return 0;
    }
    return sum;
}

void Palette::collect(const QMenu& menu, const QString& path, const QString& dock)
{
    for (QAction* action : menu.actions()) {
        if (action->menu())
            collect(*action->menu(), QStringLiteral("%1 › %2").arg(path, plain(action->text())),
                    dock);
        else if (!action->isSeparator() && action->isVisible())
            m_entries << Entry{action, plain(action->text()), path, dock};
    }
}

void Palette::fill()
{
    QList<std::pair<int, const Entry*>> fitting;
    for (const Entry& entry : m_entries)
        if (const int fits = fit(m_typed->text(), entry.name, entry.menu, tipOf(*entry.action)))
            fitting << std::pair{fits, &entry};
    std::ranges::stable_sort(fitting, [](const auto& a, const auto& b) {
        const bool aRuns = a.second->action->isEnabled();
        const bool bRuns = b.second->action->isEnabled();
        return aRuns != bRuns ? aRuns : a.first > b.first;
    });

    m_none->setVisible(fitting.isEmpty());
    m_list->clear();
    for (const auto& [fits, entry] : fitting) {
        const QAction& action = *entry->action;
        auto* row =
            new QTreeWidgetItem(m_list, {entry->name, entry->menu,
                                         action.shortcut().toString(QKeySequence::NativeText)});
        row->setIcon(0, action.icon());
        row->setToolTip(0, action.isEnabled() || action.whatsThis().isEmpty() ? tipOf(action)
                                                                              : action.whatsThis());
        row->setData(0, commandRole, QVariant::fromValue(entry->action));
        row->setData(0, dockRole, entry->dock);
        row->setForeground(1, palette().placeholderText());
        if (!action.isEnabled())
            row->setForeground(0, palette().brush(QPalette::Disabled, QPalette::Text));
        if (action.isCheckable() && action.isChecked())
            row->setText(0, tr("%1 (on)").arg(entry->name));
    }
    m_list->setCurrentItem(m_list->topLevelItem(0));
}

// The arrow and page keys move through the list while the field keeps the focus.
bool Palette::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_typed && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp
            || key == Qt::Key_PageDown) {
            QApplication::sendEvent(m_list, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace ripstop
