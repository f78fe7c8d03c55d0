// Two sets of colours, the palette that is made of one, and Fusion with edges that are seen on
// both. applyThemeChoice() asks the desktop for its palette again each time.
#include "theme/theme_choice.h"

#include <QApplication>
#include <QFile>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QSettings>
#include <QStyleFactory>
#include <QStyleOption>

namespace ripstop {
namespace {

constexpr auto settingKey = "theme"; // 0, 1, 2, in the order of ThemeChoice

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

// Part of a colour, from 0 (none of it) to 1.
QColor faint(QColor color, float part)
{
    color.setAlphaF(part);
    return color;
}

// The ground of a tool button: in the accent of the palette while it is chosen, grey under the
// mouse.
void drawToolGround(const QStyleOption& option, QPainter& painter)
{
    const bool isOn = option.state & QStyle::State_On;
    const bool isUnder = option.state & QStyle::State_Enabled
                         && option.state & (QStyle::State_MouseOver | QStyle::State_Sunken);
    if (!isOn && !isUnder)
        return;
    const QColor accent = option.palette.color(QPalette::Highlight);
    const QColor text = option.palette.color(QPalette::ButtonText);
    const bool isDown = option.state & QStyle::State_Sunken;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(isOn ? QPen(accent) : QPen(Qt::NoPen));
    painter.setBrush(isOn ? faint(accent, isUnder ? 0.45F : 0.3F)
                          : faint(text, isDown ? 0.2F : 0.1F));
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 2.5, 2.5);
    painter.restore();
}

// Fusion takes the edges of menus and of boxes to be ticked from the colour of the window,
// darkened, which cannot be seen on a dark one: a box without its tick would not be there, and
// entries of a menu would lie among the words below. It also makes a tool button under the mouse
// brighter than one that is chosen, which takes the one for the other.
class EdgedFusion final : public QProxyStyle
{
public:
    EdgedFusion()
        : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion")))
    {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override
    {
        const bool isFlat = option->state & (State_On | State_AutoRaise);
        if (element == PE_PanelButtonTool && isFlat)
            return drawToolGround(*option, *painter);
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const QPalette& colors = option->palette;
        const bool isMenu = element == PE_PanelMenu || element == PE_FrameMenu;
        if (!(isMenu || element == PE_IndicatorCheckBox)
            || colors.color(QPalette::Window).lightness() >= 128)
            return;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing, false);
        painter->setBrush(Qt::NoBrush);
        const QColor edge = colors.color(QPalette::PlaceholderText);
        painter->setPen(isMenu ? faint(edge, 0.5F) : edge);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
    }
};

} // namespace

void applyThemeChoice(QApplication& application, ThemeChoice appearance)
{
    QApplication::setPalette(QPalette()); // what was chosen before must not pass for the desktop's
    const bool desktopIsDark = QApplication::palette().color(QPalette::Window).lightness() < 128;
    const bool isDark =
        appearance == ThemeChoice::Dark || (appearance == ThemeChoice::Desktop && desktopIsDark);
    QApplication::setStyle(new EdgedFusion); // the application's
    QApplication::setPalette(paletteOf(isDark ? dark : light));
    QFile sheet(":/style/ripstop.qss");
    if (sheet.open(QIODevice::ReadOnly))
        application.setStyleSheet(QString::fromUtf8(sheet.readAll()));
}

ThemeChoice keptThemeChoice()
{
    const int kept = QSettings().value(settingKey, int(ThemeChoice::Desktop)).toInt();
    const bool isOne = kept >= int(ThemeChoice::Desktop) && kept <= int(ThemeChoice::Dark);
    return isOne ? ThemeChoice(kept) : ThemeChoice::Desktop;
}

void keepThemeChoice(ThemeChoice appearance) { QSettings().setValue(settingKey, int(appearance)); }

} // namespace ripstop
