#pragma once

#include "editor/view_bar.h"

#include "tools/hand_settings.h"

#include <functional>
#include <vector>

class QAction;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ripstop {

class Actions;
class Document;
class Player;
class Viewport;

// Over the lower edge of the view while a hand, a knife or a fan is in use: how strong it is, what
// the mouse does, and what hands have left behind.
class HandBar final : public ViewBar
{
    Q_OBJECT

public:
    HandBar(Document& document, Player& player, Viewport& viewport, const Actions& actions);

    void refresh();

private:
    // A number of the settings. One that may be left to the program is empty then and shows what
    // it is.
    struct Field
    {
        QAction* tool;
        QWidget* row;
        QLineEdit* edit;
        QString unit;
        double low, high;
        std::function<double()> value;
        std::function<bool()> isOwn;
        std::function<void(std::optional<double>)> set;
    };
    struct Hint
    {
        QAction* tool;
        QString title;
        QString words;
    };

    void layOut(QAction* through);
    void addField(const QString& name, Field field, const QString& help);
    void addFields();
    void take(const Field& field);
    const Hint* shown() const;

    Document& m_document;
    Player& m_player;
    HandSettings& m_settings;
    std::vector<Hint> m_hints;
    std::vector<Field> m_fields;
    QLabel* m_title;
    QLabel* m_hint;
    QWidget* m_through;
    QPushButton* m_unpin;
};

} // namespace ripstop
