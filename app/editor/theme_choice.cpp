#include "editor/theme_choice.h"

#include <QApplication>
#include <QFile>
#include <QPalette>
#include <QStyleFactory>

namespace ripstop {
namespace {

struct Colors
{
    const char* window;
    const char* base;
    const char* alternate;
    const char* text;
    const char* note;  // secondary text, with a contrast of 4.5 : 1 on the window
    const char* faint; // what cannot be used now
    const char* button;
    const char* highlight;
    const char* link;
};

constexpr Colors light{"#f3f4f6", "#ffffff", "#f0f2f5", "#1d232b", "#636b76",
                       "#8a929c", "#e9ebee", "#2f6fb5", "#1f5fa6"};
constexpr Colors dark{"#2a2e34", "#212429", "#272b31", "#e4e7ea", "#a0a8b2",
                      "#868e98", "#363b42", "#3d7fc4", "#7fb4ea"};

QPalette paletteOf(const Colors& colors)
{
    QPalette palette;
    palette.setColor(QPalette::Window, colors.window);
    palette.setColor(QPalette::WindowText, colors.text);
    palette.setColor(QPalette::Base, colors.base);
    palette.setColor(QPalette::AlternateBase, colors.alternate);
    palette.setColor(QPalette::Text, colors.text);
    palette.setColor(QPalette::PlaceholderText, colors.note);
    palette.setColor(QPalette::Button, colors.button);
    palette.setColor(QPalette::ButtonText, colors.text);
    palette.setColor(QPalette::ToolTipBase, colors.base);
    palette.setColor(QPalette::ToolTipText, colors.text);
    palette.setColor(QPalette::Highlight, colors.highlight);
    palette.setColor(QPalette::HighlightedText, "#ffffff");
    palette.setColor(QPalette::Link, colors.link);
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, colors.faint);
    // embossed edge of disabled text
    palette.setColor(QPalette::Disabled, QPalette::Light, colors.base);
    return palette;
}

} // namespace

void applyThemeChoice(QApplication& application, ThemeChoice appearance)
{
    const bool desktopIsDark = QApplication::palette().color(QPalette::Window).lightness() < 128;
    const bool isDark =
        appearance == ThemeChoice::Dark || (appearance == ThemeChoice::Desktop && desktopIsDark);
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(paletteOf(isDark ? dark : light));
    QFile sheet(":/style/ripstop.qss");
    if (sheet.open(QIODevice::ReadOnly))
        application.setStyleSheet(QString::fromUtf8(sheet.readAll()));
}

} // namespace ripstop
