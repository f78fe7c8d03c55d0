#include "language/language.h"

#include <QAbstractSpinBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>

#include <array>

namespace ripstop {
namespace {

constexpr const char* settingKey = "language";
constexpr const char* ownContext = "ripstop"; // of all texts in the file

// In the order of Language.
constexpr std::array<const char*, 3> codes{"system", "en", "fr"};

} // namespace

std::optional<Language> languageFromCode(const QString& code)
{
    for (std::size_t i = 0; i < codes.size(); ++i)
        if (code == QLatin1String(codes[i]))
            return Language(i);
    return std::nullopt;
}

void keepLanguage(Language language)
{
    QSettings().setValue(settingKey, QString::fromLatin1(codes[std::size_t(language)]));
}

Language keptLanguage()
{
    return languageFromCode(QSettings().value(settingKey).toString()).value_or(Language::System);
}

QString Translation::Catalogue::translate(const char* context, const char* source,
                                          const char* comment, int n) const
{
    if (context && *context == 'Q') // contexts of Qt's own, such as the names of keys
        return {};
    return QTranslator::translate(ownContext, source, comment, n);
}

Translation::Translation(Language language)
{
    QCoreApplication::instance()->installEventFilter(this);
    install(language);
}

Translation::~Translation()
{
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_qt);
    QLocale::setDefault(QLocale::system());
}

void Translation::install(Language language)
{
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_qt);
    const QLocale system = QLocale::system();
    const bool isFrench = language == Language::French
                          || (language == Language::System && system.language() == QLocale::French);
    const bool fits = system.language() == (isFrench ? QLocale::French : QLocale::English);
    QLocale::setDefault(fits       ? system // which has its own way of writing dates
                        : isFrench ? QLocale(QLocale::French, QLocale::France)
                                   : QLocale(QLocale::English, QLocale::UnitedStates));
    if (!isFrench)
        return;
    if (m_qt.load("qtbase_fr", QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    if (m_own.load(":/translations/ripstop_fr.qm"))
        // Qt asks it first, because it was installed last
        QCoreApplication::installTranslator(&m_own);
}

bool Translation::eventFilter(QObject* target, QEvent* event)
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

} // namespace ripstop
