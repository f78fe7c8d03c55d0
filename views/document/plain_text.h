// Texts with names that people gave, where Qt would make something else of them.
//
// Tips, message boxes and labels that were told nothing take what looks like HTML for HTML, so that
// a probe "top <i>of</i> pole" loses its tags; menus and buttons take an ampersand for the sign of
// a key. A label that shows names is set to Qt::PlainText instead.
#pragma once

#include <QString>
#include <QTextDocument>

namespace ripstop {

// As HTML that shows the characters of the text, to stand in more of it.
inline QString asHtml(const QString& text)
{
    return text.toHtmlEscaped().replace(QChar('\n'), QStringLiteral("<br>"));
}

// For a tip or a message: what is shown has the characters of the text.
inline QString shownAsIs(const QString& text)
{
    return Qt::mightBeRichText(text) ? QStringLiteral("<qt>%1</qt>").arg(asHtml(text)) : text;
}

// For an entry of a menu, or a button.
inline QString inMenu(QString text) { return text.replace(QChar('&'), QStringLiteral("&&")); }

} // namespace ripstop
