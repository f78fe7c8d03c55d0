// The dialogs that actions open beside the main window.
//
// The workbench holds one of these, and actions call it. Each dialog is made when it is first
// asked for; those without a mode stay open while one works, and asking again raises them. The key
// table and the palette are modal and end before their function returns. All
// belongs to the thread of the window.
#pragma once

#include <QPointer>
#include <QStringList>

#include <functional>

class QMainWindow;

namespace ripstop {

class Actions;
class CertifyDialog;
class ConditionDialog;
class DesignDifferenceDialog;
class Docks;
class Document;
class KeyMap;
class Player;
class PolarDialog;
class PreferencesDialog;
class Recordings;
class RigidityDialog;
class RunFiles;
class Selection;
class SettleDialog;
class VerificationDialog;
class Viewport;

class Dialogs final
{
public:
    Dialogs(QMainWindow& window, Document& document, Selection& selection, Viewport& viewport);

    // The ids of the actions whose dialogs stand open and can be opened again as they are.
    QStringList open() const;
    // Checks that another window has begun go on here, in the language in which they began.
    void takeChecks(Dialogs& before);

    void showKeys(KeyMap& keys);
    void showPalette(const Docks& docks);
    void showPreferences(const Actions& actions, RunFiles& runFiles);
    void showVerification();                  // runs its cases when they have not been
    void showPolar();                         // of the selected material
    void showMaterialTest();                  // for an own material
    void showCertify(Recordings& recordings); // which get the certificate
    void showCondition();
    void showRigidity();
    void showDifferences(); // from the design as saved
    void showSettle(Player& player, std::function<void()> adoptPose);

private:
    QMainWindow& m_window;
    Document& m_document;
    Selection& m_selection;
    Viewport& m_viewport;
    QPointer<PreferencesDialog> m_preferences;       // while it is open
    QPointer<VerificationDialog> m_verification;     // while it is open
    QPointer<PolarDialog> m_polar;                   // while it is open
    QPointer<CertifyDialog> m_certify;               // while it is open
    QPointer<SettleDialog> m_settle;                 // while it is open
    ConditionDialog* m_condition = nullptr;          // once it has been asked for
    RigidityDialog* m_rigidity = nullptr;            // once it has been asked for
    DesignDifferenceDialog* m_differences = nullptr; // once it has been asked for
};

} // namespace ripstop
