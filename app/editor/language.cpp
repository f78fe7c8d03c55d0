#include "editor/language.h"

#include "editor/actions.h"

#include <QAbstractSpinBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLibraryInfo>
#include <QLocale>
#include <QMainWindow>
#include <QSettings>
#include <QStatusBar>

#include <array>

namespace ripstop {
namespace {

constexpr const char* settingKey = "language";
constexpr const char* ownContext = "ripstop"; // of all texts in the file
constexpr const char* modelContext = "Model"; // in which spoken() asks

struct Tongue
{
    const char* code;
    const char* action;
    const char* name; // in the language itself; of System in that of the window
    const char* tip;
};

// In the order of Language.
constexpr std::array<Tongue, 3> tongues{{
    {"system", "languageSystem", QT_TRANSLATE_NOOP("Actions", "&System"),
     QT_TRANSLATE_NOOP("Actions", "The language of the desktop, from the next start on.")},
    {"en", "languageEnglish", "&English",
     QT_TRANSLATE_NOOP("Actions", "English, from the next start on.")},
    {"fr", "languageFrench", "&Fran\u00e7ais",
     QT_TRANSLATE_NOOP("Actions", "French, from the next start on.")},
}};

void choose(Language language, QMainWindow& window)
{
    QSettings().setValue(settingKey, QString::fromLatin1(tongues[std::size_t(language)].code));
    window.statusBar()->showMessage(
        Actions::tr("The language is kept, and heard when Ripstop starts the next time."), 8000);
}

} // namespace

std::optional<Language> languageFromCode(const QString& code)
{
    for (std::size_t i = 0; i < tongues.size(); ++i)
        if (code == QLatin1String(tongues[i].code))
            return Language(i);
    return std::nullopt;
}

Language keptLanguage()
{
    return languageFromCode(QSettings().value(settingKey).toString()).value_or(Language::System);
}

QString Speech::Catalogue::translate(const char* context, const char* source, const char* comment,
                                     int n) const
{
    if (context && *context == 'Q') // Qt's own, such as the names of keys
        return {};
    const QString text = QTranslator::translate(ownContext, source, comment, n);
    const bool isOfModel = context && QLatin1String(context) == QLatin1String(modelContext);
    return text.isEmpty() && isOfModel ? sentences.translated(QString::fromUtf8(source)) : text;
}

Speech::Speech(Language language)
{
    QCoreApplication::instance()->installEventFilter(this);
    speak(language);
}

Speech::~Speech()
{
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_qt);
    QLocale::setDefault(QLocale::system());
}

void Speech::speak(Language language)
{
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_qt);
    const QLocale system = QLocale::system();
    const bool isFrench = language == Language::French
                          || (language == Language::System && system.language() == QLocale::French);
    const bool fits = system.language() == (isFrench ? QLocale::French : QLocale::English);
    QLocale::setDefault(fits       ? system // with its own way of writing dates
                        : isFrench ? QLocale(QLocale::French, QLocale::France)
                                   : QLocale(QLocale::English, QLocale::UnitedStates));
    if (!isFrench)
        return;
    if (m_qt.load("qtbase_fr", QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    m_own.sentences.load(":/translations/sentences_fr.ts");
    if (m_own.load(":/translations/ripstop_fr.qm"))
        QCoreApplication::installTranslator(&m_own); // asked first, as the last one installed
}

bool Speech::eventFilter(QObject* target, QEvent* event)
{
    if (event->type() != QEvent::KeyPress || !qobject_cast<QAbstractSpinBox*>(target))
        return false;
    auto* key = static_cast<QKeyEvent*>(event);
    const QString point = QLocale().decimalPoint();
    if ((key->text() != QLatin1String(",") && key->text() != QLatin1String("."))
        || key->text() == point)
        return false;
    QKeyEvent other(QEvent::KeyPress, point == QLatin1String(",") ? Qt::Key_Comma : Qt::Key_Period,
                    key->modifiers(), point);
    QCoreApplication::sendEvent(target, &other);
    return true;
}

std::vector<MenuRow> languageRows(const Workbench& bench)
{
    std::vector<MenuRow> rows;
    const Language kept = keptLanguage();
    for (std::size_t i = 0; i < tongues.size(); ++i)
        rows.push_back({"&View/Lan&guage",
                        tongues[i].action,
                        Actions::tr(tongues[i].name),
                        nullptr,
                        {},
                        Actions::tr(tongues[i].tip),
                        [&window = bench.window, i] { choose(Language(i), window); },
                        Language(i) == kept ? Toggle::On : Toggle::Off,
                        "language"});
    return rows;
}

} // namespace ripstop
