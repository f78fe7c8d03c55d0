// Stages: the constructor collects the entries of all menus with their paths; fill() ranks those
// that answer what is typed and lists them, those that cannot be run now last and grey, unless it
// is their name that was typed. fit() is the ranking: each typed word has to be found, in the name
// first, then among what others call it, then in the menu, then in the tip. Keys that move through
// the list work while the field has the focus.
#include "actions/palette.h"

#include "actions/other_words.h"

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
#include <functional>
#include <tuple>

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

enum class Found { No, Within, AtBeginning, Whole };

// The best place of `word` in a text: a word of it, the beginning of one, or a part.
Found bestPlace(const QString& text, const QString& word)
{
    Found best = Found::No;
    for (qsizetype at = text.indexOf(word, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(word, at + 1, Qt::CaseInsensitive)) {
        const qsizetype end = at + word.size();
        const bool begins = at == 0 || !text[at - 1].isLetterOrNumber();
        const bool ends = end == text.size() || !text[end].isLetterOrNumber();
        best = std::max(best, !begins ? Found::Within : ends ? Found::Whole : Found::AtBeginning);
    }
    return best;
}

constexpr int isItsName = 10000;      // more than all words of what is typed can sum up to
constexpr int beginsWithWords = 1000; // likewise

int nameFit(const QString& name, const QString& word)
{
    const bool isFirst = name.startsWith(word, Qt::CaseInsensitive);
    switch (bestPlace(name, word)) {
    case Found::Whole:
        return isFirst ? 50 : 45;
    case Found::AtBeginning:
        return isFirst ? 40 : 30;
    case Found::Within:
        return 15;
    case Found::No:
        break;
    }
    return 0;
}

// A sentence has so many words that beginnings of them say nothing: each tip of the languages has
// a window in it, which is no wind.
bool isInSentence(const QString& sentence, const QString& word)
{
    return bestPlace(sentence, word) == Found::Whole
           || bestPlace(sentence, word + 's') == Found::Whole;
}

int wordFit(const QString& word, const QString& name, const QString& menu, const QString& tip,
            const QString& others)
{
    int best = nameFit(name, word);
    if (const Found other = bestPlace(others, word); other >= Found::AtBeginning)
        best = std::max(best, other == Found::Whole ? 25 : 20);
    if (best == 0 && bestPlace(menu, word) >= Found::AtBeginning)
        return 8;
    return best == 0 && isInSentence(tip, word) ? 4 : best;
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

int Palette::fit(const QString& typed, const QString& name, const QString& menu, const QString& tip,
                 const QString& others)
{
    const QString asked = typed.simplified();
    const QString bare = QString(name).remove(QStringLiteral("…"));
    if (!asked.isEmpty() && bare.compare(asked, Qt::CaseInsensitive) == 0)
        return isItsName;
    int sum = (bare + ' ').startsWith(asked + ' ', Qt::CaseInsensitive) ? beginsWithWords : 1;
    for (const QString& word : asked.split(' ', Qt::SkipEmptyParts)) {
        const int fits = wordFit(word, name, menu, tip, others);
        if (fits == 0)
            return 0;
        sum += fits;
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
        if (const int fits = fit(m_typed->text(), entry.name, entry.menu, tipOf(*entry.action),
                                 otherWords(entry.action->objectName())))
            fitting << std::pair{fits, &entry};
    // a grey one stays first where it was named, so that Enter runs no other
    std::ranges::stable_sort(fitting, std::greater{}, [](const auto& one) {
        return std::tuple(one.first == isItsName, one.second->action->isEnabled(), one.first);
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
