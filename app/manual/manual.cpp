// Desktops open a file by its path and drop what comes after the #, so a page of one line is
// written that leads to the heading, and that is opened.
#include "manual/manual.h"

#include <QApplication>
#include <QCursor>
#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QSaveFile>
#include <QStandardPaths>
#include <QWidget>

namespace ripstop {
namespace {

QString firstFile(const QStringList& candidates)
{
    for (const QString& file : candidates)
        if (QFileInfo(file).isFile())
            return QFileInfo(file).canonicalFilePath();
    return {};
}

// A page that leads on to the address; empty where it cannot be written.
QUrl leadingTo(const QUrl& address)
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    QDir().mkpath(folder);
    QSaveFile file(folder + QStringLiteral("/manual.html"));
    const QString target = QString::fromUtf8(address.toEncoded()).toHtmlEscaped();
    const QString text = QStringLiteral("<!DOCTYPE html><meta charset=\"utf-8\">"
                                        "<meta http-equiv=\"refresh\" content=\"0; url=%1\">"
                                        "<a href=\"%1\">%1</a>\n")
                             .arg(target);
    if (!file.open(QIODevice::WriteOnly) || file.write(text.toUtf8()) < 0 || !file.commit())
        return {};
    return QUrl::fromLocalFile(file.fileName());
}

} // namespace

Manual::Manual(const QString& programs, Open open, QObject* parent)
    : QObject(parent)
    , m_programs(programs)
    , m_open(std::move(open))
{
    qApp->installEventFilter(this);
}

QUrl Manual::addressOf(const ManualPage& page) const
{
    const QString name =
        page.page == QStringLiteral("README") ? QStringLiteral("index") : page.page;
    const QString book = QStringLiteral("/manual/") + name + QStringLiteral(".html");
    const QString installed = m_programs + QStringLiteral("/../share/doc/ripstop");
    const QString built = m_programs + QStringLiteral("/..");
    const QString source = built + QStringLiteral("/../..");
    QString file = firstFile({installed + book, built + book});
    if (!file.isEmpty()) {
        QUrl address = QUrl::fromLocalFile(file);
        if (!page.anchor.isEmpty())
            address.setFragment(page.anchor);
        return address;
    }
    const QString text = '/' + page.page + QStringLiteral(".md");
    file = firstFile({installed + text, source + text});
    return file.isEmpty() ? QUrl() : QUrl::fromLocalFile(file);
}

void Manual::show(const ManualPage& page)
{
    const QUrl address = addressOf(page);
    if (address.isEmpty()) {
        emit said(tr("The manual is not installed here; the page is %1.md of Ripstop's source.")
                      .arg(page.page));
        return;
    }
    const QUrl detour = address.hasFragment() ? leadingTo(address) : address;
    if (!m_open(detour.isEmpty() ? address : detour))
        emit said(
            tr("Nothing here opens the manual; open %1 in a browser.").arg(address.toString()));
}

// A property or a bar under the mouse wins, as nobody clicks a label before asking about it; then
// whoever has the keys.
void Manual::showHere()
{
    const QWidget* under = QApplication::widgetAt(QCursor::pos());
    const QWidget* active = QApplication::activeWindow();
    if (under && active && under->window() != active)
        under = nullptr; // the mouse lies in another window
    const QWidget* focus = QApplication::focusWidget();
    show(manualPageFor(under ? under : focus ? focus : active));
}

// The action of the main window has the key there; its dialogs have no menu.
bool Manual::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress && watched->isWidgetType()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const auto* widget = static_cast<const QWidget*>(watched);
        if (key->key() == Qt::Key_F1 && key->modifiers() == Qt::NoModifier
            && widget->window()->windowFlags().testFlag(Qt::Dialog)) {
            showHere();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace ripstop
