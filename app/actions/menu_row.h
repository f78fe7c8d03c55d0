// A row of the table of actions.
#pragma once

#include <QKeySequence>
#include <QString>

#include <functional>

namespace ripstop {

enum class Toggle { No, Off, On };
enum class Needs { Nothing, Selection };

struct MenuRow
{
    const char* menu; // "&Select/By &type" is a menu in another one
    const char* id;   // null: a line between actions
    QString text;
    const char* icon;
    QKeySequence keys;
    QString tip;
    std::function<void()> run;
    Toggle toggle = Toggle::No;
    const char* group = nullptr; // of toggles that exclude each other
    Needs needs = Needs::Nothing;
};

} // namespace ripstop
