#include "actions/mnemonics.h"

#include <QKeySequence>
#include <QMenu>
#include <QSet>

namespace ripstop {
namespace {

// Where the letter stands that the text asks for, behind an "&"; "&&" is the character itself.
qsizetype markIn(const QString& text)
{
    for (qsizetype at = text.indexOf('&'); at >= 0 && at + 1 < text.size();
         at = text.indexOf('&', at + 2))
        if (text[at + 1] != '&')
            return at;
    return -1;
}

// Places of letters, those that begin a word first.
QList<qsizetype> lettersOf(const QString& text)
{
    QList<qsizetype> first, others;
    for (qsizetype at = 0; at < text.size() && text[at] != '\t'; ++at)
        if (text[at].isLetterOrNumber())
            (at == 0 || text[at - 1].isSpace() ? first : others) << at;
    return first + others;
}

QString withMark(QString text, QSet<QChar>& taken)
{
    for (const qsizetype at : lettersOf(text)) {
        const QChar letter = text[at].toLower();
        if (taken.contains(letter))
            continue;
        taken << letter;
        return text.insert(at, '&');
    }
    return text;
}

} // namespace

void giveMnemonics(const QList<QAction*>& entries)
{
    QSet<QChar> taken;
    QList<QAction*> without;
    for (QAction* entry : entries) {
        const QString text = entry->text();
        const qsizetype mark = markIn(text);
        if (entry->isSeparator() || !entry->isVisible())
            continue;
        if (mark >= 0 && !taken.contains(text[mark + 1].toLower()))
            taken << text[mark + 1].toLower();
        else
            without << entry;
    }
    for (QAction* entry : without) {
        QString text = entry->text();
        if (const qsizetype mark = markIn(text); mark >= 0)
            text.remove(mark, 1);
        entry->setText(withMark(text, taken));
    }
}

void keepMnemonics(const QList<QAction*>& entries)
{
    for (const QAction* entry : entries)
        if (QMenu* menu = entry->menu()) {
            QObject::connect(menu, &QMenu::aboutToShow, menu,
                             [menu] { giveMnemonics(menu->actions()); });
            keepMnemonics(menu->actions());
        }
}

} // namespace ripstop
