// The inspector over one of everything, for tests that type into it and read what it says.
#pragma once

#include "document/document.h"
#include "document/selection.h"
#include "inspector/inspector.h"
#include "small_scenes.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QtTest>

#include <algorithm>
#include <vector>

namespace ripstop {

// In a window that has the focus.
struct InspectorForm
{
    Document document;
    Selection selection{document};
    Inspector inspector{document, selection};

    InspectorForm()
    {
        document.replace(oneOfEverything());
        inspector.resize(300, 700);
        inspector.show();
        QApplication::setActiveWindow(&inspector); // Xvfb has no window manager to do it
    }

    QLineEdit* line(std::string_view key, int axis = 0)
    {
        return qobject_cast<QLineEdit*>(inspector.field(key, axis));
    }
    void type(QLineEdit* edit, const QString& text)
    {
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    bool says(const QString& words) const
    {
        const auto labels = inspector.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }
    Value value(Id id, std::string_view key) const
    {
        const ConstRef ref = *find(document.scene(), id);
        return findProperty(kindOf(ref), key)->get(ref);
    }
};

inline const std::vector<Id> oneOfEachKind{settingsId, Id{3},  Id{5},  Id{8},  Id{1},  Id{9},
                                           Id{11},     Id{12}, Id{13}, Id{14}, Id{15}, Id{16}};

inline Id idOfKind(Kind kind)
{
    const Scene scene = oneOfEverything();
    return *std::find_if(oneOfEachKind.begin(), oneOfEachKind.end(),
                         [&](Id id) { return kindOf(*find(scene, id)) == kind; });
}

} // namespace ripstop
