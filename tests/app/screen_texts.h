// The texts on a window and the texts of the catalogue, for tests that look what language stands
// there.
#pragma once

#include "document/words.h"
#include "io/scene_file.h"
#include "materials/presets.h"
#include "scene/units.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QGroupBox>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QSet>
#include <QTabBar>
#include <QXmlStreamReader>

#include <algorithm>

namespace ripstop {

// English -> French, as the file has it; the singular where there are plurals.
inline QHash<QString, QString> catalogue()
{
    QFile file(SOURCE_DIR "/resources/translations/ripstop_fr.ts");
    if (!file.open(QIODevice::ReadOnly))
        qFatal("there is no catalogue");
    QXmlStreamReader xml(&file);
    QHash<QString, QString> texts;
    QString english;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == QLatin1String("source"))
            english = xml.readElementText();
        else if (xml.name() == QLatin1String("translation"))
            texts.insert(english,
                         xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed());
    }
    return texts;
}

// Without the mark of its key and the dots behind it, and
// without what a menu shows in its second column: keys, and numbers of materials.
inline QString bare(const QString& text)
{
    return text.section('\t', 0, 0).remove('&').remove(QChar(0x2026)).trimmed();
}

// Texts of which the catalogue says that they are the same in French: Parachute, Tension.
inline QSet<QString> alike()
{
    QSet<QString> texts;
    const QHash<QString, QString> all = catalogue();
    for (auto text = all.begin(); text != all.end(); ++text)
        if (bare(text.key()) == bare(text.value()))
            texts << bare(text.key());
    return texts;
}

inline bool hasWords(const QString& text)
{
    static const QRegularExpression word("[^\\W\\d_]{2,}");
    return text.contains(word);
}

// Reads the texts of a widget and of all in it: what stands on it and what helps with it.
class ScreenReader
{
public:
    void read(QWidget& whole)
    {
        readOne(whole);
        for (QWidget* widget : whole.findChildren<QWidget*>())
            readOne(*widget);
        for (QAction* action : whole.findChildren<QAction*>()) {
            add(action->text());
            add(action->toolTip());
            add(action->statusTip());
        }
    }
    const QSet<QString>& texts() const { return m_texts; }

private:
    void add(const QString& text)
    {
        if (hasWords(text))
            m_texts << bare(text);
    }

    void readOne(const QWidget& widget)
    {
        add(widget.toolTip());
        add(widget.accessibleName());
        if (qobject_cast<const QDialog*>(&widget) || qobject_cast<const QDockWidget*>(&widget))
            add(widget.windowTitle());
        if (const auto* label = qobject_cast<const QLabel*>(&widget))
            add(label->text());
        if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
            add(button->text());
        if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
            add(group->title());
        if (const auto* menu = qobject_cast<const QMenu*>(&widget))
            add(menu->title());
        if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
            add(line->placeholderText());
        if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
            for (int i = 0; i < tabs->count(); ++i)
                add(tabs->tabText(i));
        if (const auto* box = qobject_cast<const QComboBox*>(&widget))
            for (int i = 0; i < box->count(); ++i)
                add(box->itemText(i));
        if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget))
            if (const QAbstractItemModel* model = view->model())
                for (int i = 0; i < model->columnCount(); ++i)
                    add(model->headerData(i, Qt::Horizontal).toString());
    }

    QSet<QString> m_texts;
};

// What the author of the sample has called things, and whom a preset quotes.
// Names of things in the scene, as they are, capitalised or with the sign of a key; what
// presets cite; units; files; and the languages, each in its own words.
inline bool isContent(const QString& text)
{
    static const QSet<QString> content = [] {
        QSet<QString> all{"english", "français"};
        const Result<Scene> scene = readScene(SCENES_DIR "/delta_kite.ripstop.json");
        for (const Entry& entry : scene->items) {
            const QString name = QString::fromStdString(nameOf(entry.item)).toLower();
            all << name << name + " +" << name + " " + QChar(0x2212);
        }
        for (int kind = 0; kind < kindCount; ++kind) // things are called so until they are renamed
            all << QString::fromUtf8(kindName(Kind(kind)).data());
        for (const Preset& preset : allPresets())
            all << "<qt>"
                       + QString::fromStdString(sourcesOf(preset))
                             .toHtmlEscaped()
                             .remove('&') // as bare() does
                             .toLower()
                             .replace('\n', "<br>")
                       + "</qt>"
                << QString::fromStdString(sourcesOf(preset)).toLower();
        return all;
    }();
    static const QRegularExpression coordinate("^Position [xyz] \\(m\\)$");
    const bool isFile = text.contains("ripstop.json") || text.contains("delta_kite");
    static const QRegularExpression betweenUnits("[ /·²³1]+");
    const QStringList units = text.split(betweenUnits, Qt::SkipEmptyParts);
    const bool isUnit = std::ranges::all_of(
        units, [](const QString& one) { return findUnit(one.toStdString()) != nullptr; });
    return isFile || isUnit || content.contains(text.toLower()) || text.contains(coordinate);
}

} // namespace ripstop
