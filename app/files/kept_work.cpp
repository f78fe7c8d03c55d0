#include "files/kept_work.h"

#include "dialogs/rescue_dialog.h"
#include "document/autosave.h"
#include "document/plain_text.h"
#include "document/player.h"
#include "document/words.h"
#include "files/files.h"

#include <QMessageBox>

#include <utility>

namespace ripstop {

KeptWork::KeptWork(Document& document, Player& player, Files& files, QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_player(player)
    , m_files(files)
    , m_window(window)
{}

void KeptWork::keepIn(const QString& folder)
{
    m_autosave = new Autosave(m_document, m_player.follower(), folder, Autosave::usualDelay, this);
    connect(m_autosave, &Autosave::failed, this, &KeptWork::failed);
    const QList<Rescue> found = leftBehind(folder);
    if (found.isEmpty())
        return;
    RescueDialog dialog(found, &m_window);
    if (dialog.exec() != QDialog::Accepted || !m_files.mayDiscard())
        return;
    if (const auto failure = m_autosave->recover(*dialog.chosen()))
        QMessageBox::warning(&m_window, tr("Cannot open what was left behind"),
                             shownAsIs(translated(failure->message)));
    else
        emit opened();
}

void KeptWork::takeOver(KeptWork& before)
{
    m_autosave = std::exchange(before.m_autosave, nullptr);
    if (!m_autosave)
        return;
    m_autosave->disconnect(&before);
    m_autosave->setParent(this);
    connect(m_autosave, &Autosave::failed, this, &KeptWork::failed);
}

void KeptWork::leave()
{
    if (m_autosave)
        m_autosave->leave();
}

} // namespace ripstop
