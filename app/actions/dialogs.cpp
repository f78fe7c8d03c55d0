// Makes each dialog when it is first asked for. bringUp() shows it, or raises it where it is open.
#include "actions/dialogs.h"

#include "actions/keys_dialog.h"
#include "actions/menu_row.h"
#include "actions/palette.h"
#include "actions/preferences_dialog.h"
#include "dialogs/certify_dialog.h"
#include "dialogs/condition_dialog.h"
#include "dialogs/design_difference_dialog.h"
#include "dialogs/polar_dialog.h"
#include "dialogs/result_page.h"
#include "dialogs/rigidity_dialog.h"
#include "dialogs/settle_dialog.h"
#include "dialogs/verification_dialog.h"
#include "docks/docks.h"
#include "document/document.h"
#include "document/recordings.h"
#include "document/selection.h"
#include "inspector/inspector.h"
#include "inspector/material_test_dialog.h"
#include "plots/plot_panel.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include <memory>
#include <utility>

namespace ripstop {
namespace {

void bringUp(QWidget& dialog)
{
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

} // namespace

Dialogs::Dialogs(QMainWindow& window, Document& document, Selection& selection, Viewport& viewport)
    : m_window(window)
    , m_document(document)
    , m_selection(selection)
    , m_viewport(viewport)
{}

QStringList Dialogs::open() const
{
    const auto stands = [](const QWidget* dialog) { return dialog && dialog->isVisible(); };
    QStringList ids;
    for (const auto& [dialog, id] : {std::pair<const QWidget*, const char*>{m_polar, "polar"},
                                     {m_condition, "byProperty"},
                                     {m_rigidity, "floppy"},
                                     {m_settle, "settle"},
                                     {m_differences, "compareDesign"},
                                     {m_preferences, "preferences"}})
        if (stands(dialog))
            ids << QLatin1String(id);
    return ids;
}

void Dialogs::takeChecks(Dialogs& before)
{
    const auto take = [this](auto& ours, auto& theirs) {
        ours = std::exchange(theirs, nullptr);
        if (!ours)
            return;
        const bool stood = ours->isVisible();
        const QPoint place = ours->pos();
        ours->setParent(&m_window, ours->windowFlags());
        ours->move(place);
        ours->setVisible(stood);
    };
    take(m_verification, before.m_verification);
    take(m_certify, before.m_certify);
}

void Dialogs::showKeys(KeyMap& keys) { KeysDialog(keys, m_document.scene(), &m_window).exec(); }

// The action runs when the palette is gone, as if it had been chosen in its menu; but who looks for
// a panel wants to see it, also where it stands open behind others.
void Dialogs::showPalette(const Docks& docks)
{
    const std::shared_ptr<const QMenu> plots = docks.panel<PlotPanel>().contextMenu();
    Palette palette(
        *m_window.menuBar(),
        {{plots.get(), tr("Plots"), QStringLiteral("plots")},
         {docks.panel<Inspector>().presetMenu(), tr("Preset"), QStringLiteral("inspector")}},
        &m_window);
    if (palette.exec() != QDialog::Accepted || docks.showToggled(*palette.chosen()))
        return;
    if (!palette.dock().isEmpty())
        docks.show(palette.dock());
    // the menu of plots lives until its action has run
    QMetaObject::invokeMethod(
        palette.chosen(), [plots, action = palette.chosen()] { action->trigger(); },
        Qt::QueuedConnection);
}

void Dialogs::showPreferences(const Actions& actions, RunFiles& runFiles)
{
    if (!m_preferences) // deletes itself when closed
        m_preferences = new PreferencesDialog(actions, runFiles, &m_window);
    bringUp(*m_preferences);
}

void Dialogs::showVerification()
{
    if (!m_verification)
        m_verification = new VerificationDialog(&m_window); // deletes itself
    bringUp(*m_verification);
    ResultPage& cases = m_verification->cases();
    if (!cases.isRunning() && cases.done() == 0)
        cases.start();
}

void Dialogs::showPolar()
{
    const auto& ids = m_selection.ids();
    const bool one = ids.size() == 1 && findItem<Material>(m_document.scene(), ids.front());
    const Id material = one ? ids.front() : noId;
    if (m_polar)
        m_polar->show(material);
    else
        m_polar = new PolarDialog(m_document, material, &m_window); // deletes itself when closed
    bringUp(*m_polar);
}

void Dialogs::showMaterialTest()
{
    (new MaterialTestDialog(&m_window))->open(); // deletes itself when closed
}

void Dialogs::showCertify(Recordings& recordings)
{
    if (!m_certify) {
        m_certify = new CertifyDialog(m_document, &m_window); // deletes itself when closed
        QObject::connect(m_certify, &CertifyDialog::certified, &recordings,
                         &Recordings::takeCertificate);
    }
    bringUp(*m_certify);
}

void Dialogs::showCondition()
{
    if (!m_condition)
        m_condition = new ConditionDialog(
            m_document, m_selection, [this] { return m_viewport.frame(); }, &m_window);
    bringUp(*m_condition);
}

void Dialogs::showRigidity()
{
    if (!m_rigidity)
        m_rigidity = new RigidityDialog(m_document, m_selection, m_viewport, &m_window);
    bringUp(*m_rigidity);
}

void Dialogs::showDifferences()
{
    if (!m_differences)
        m_differences = new DesignDifferenceDialog(m_document, m_selection, m_viewport, &m_window);
    bringUp(*m_differences);
}

void Dialogs::showSettle(Player& player, std::function<void()> adoptPose)
{
    if (!m_settle) // deletes itself when closed
        m_settle = new SettleDialog(player, std::move(adoptPose), &m_window);
    bringUp(*m_settle);
}

} // namespace ripstop
