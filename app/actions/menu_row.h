// A row of the table of actions, of which the menus are made.
//
// A row says all that is to be known of an action: where it stands, what it is called, which keys
// it has, what it does. The sources NAME_rows.cpp hold the rows of a menu each (menu_rows.h).
#pragma once

#include <QCoreApplication>
#include <QKeySequence>
#include <QString>

#include <functional>

namespace ripstop {

enum class Toggle { No, Off, On };
enum class Needs { Nothing, Selection };

struct MenuRow
{
    const char* menu; // "&Select/By &type" is a menu in another one
    const char* id;   // null for a line between actions
    QString text;
    const char* icon;
    QKeySequence keys;
    QString tip;
    std::function<void()> run;
    Toggle toggle = Toggle::No;
    const char* group = nullptr; // of toggles that exclude each other
    Needs needs = Needs::Nothing;
};

inline MenuRow lineIn(const char* menu) { return {menu, nullptr, {}, nullptr, {}, {}, {}}; }

// A text of the menus in the language of the window. The name is Qt's, so that lupdate finds what
// is said with it.
inline QString tr(const char* text) { return QCoreApplication::translate("Actions", text); }

} // namespace ripstop
