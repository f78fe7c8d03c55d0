// The language of the window: English, which is written in the source, or another one that has a
// file under resources/translations.
//
// One English text has one French text, wherever it stands: contexts, which Qt looks up first, do
// not count, so that labels in tables of the model and in rows of actions need none. Numbers are
// shown with the comma where the language has one; all that is typed is read with either, and
// files and the command line know the point only.
#pragma once

#include <QObject>
#include <QTranslator>

#include <optional>

namespace ripstop {

enum class Language { System, English, French };

std::optional<Language> languageFromCode(const QString& code); // "system", "en", "fr"
Language keptLanguage();                                       // System until one was chosen
void keepLanguage(Language language);

// Translates what the program says from here on. Texts that are on the screen already stay, so the
// window is made anew (editor/window_host.h).
class Translation : public QObject
{
public:
    explicit Translation(Language language);
    ~Translation() override;

    void install(Language language);

protected:
    // Spin boxes take the comma for the point and the other way round.
    bool eventFilter(QObject* target, QEvent* event) override;

private:
    // Looks up a text without its context.
    class Catalogue : public QTranslator
    {
    public:
        QString translate(const char* context, const char* source, const char* comment,
                          int n) const override;
    };

    Catalogue m_own;
    QTranslator m_qt; // "Cancel", "Look in:"
};

} // namespace ripstop
