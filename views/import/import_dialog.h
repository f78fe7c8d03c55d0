// The dialog in which a mesh becomes fabric: how it looks and how large it is, what is wrong with
// it and what was repaired, and what will be made of it.
//
// Everything is worked out on another thread (import_work.h) shortly after each change of the form,
// and the dialog can be accepted only while the outcome belongs to what is chosen. It changes no
// scene: the caller adds result(). What is accepted has its pictures: those that lie within the
// mesh's file are written beside it (shapes/packed_pictures.h). Only the window's thread uses it.
#pragma once

#include "import/import_work.h"

#include <QDialog>
#include <QTimer>

class QDialogButtonBox;
class QLabel;
class QListWidget;
class QProgressBar;

namespace ripstop {

class ImportForm;
class MeshPreview;

class ImportDialog final : public QDialog
{
    Q_OBJECT

public:
    // What is imported is for this scene, which must not change while the dialog is open.
    ImportDialog(const Scene& scene, const QString& file, QWidget* parent = nullptr);

    // Asks the user for the file of a mesh; empty when the question is cancelled.
    static QString askFile(QWidget* parent, const QString& folder);
    static bool isMesh(const QString& file); // by its ending

    // What is to be added to the scene. It may be asked for once the dialog has been accepted, or
    // while isReady().
    const MeshImport& result() const { return m_outcome->made; }
    QString file() const { return m_file; }
    bool isReady() const { return m_outcome && m_outcome->refusal.isEmpty(); }
    bool isSettled() const { return m_outcome && !m_delay.isActive(); }

    void accept() override;

signals:
    void settled(); // the outcome that is shown is that of what is chosen

private:
    void layOut();
    QWidget* filePlace();
    void chooseFile();
    void openFile(const QString& file);
    void workSoon();
    void post();
    void watch(); // shows progress
    void take(std::shared_ptr<const ImportOutcome> outcome);
    void showReport();
    void setReady(bool isReady);

    const Scene& m_scene;
    QString m_file;
    QLabel* m_fileName;
    MeshPreview* m_preview;
    ImportForm* m_form;
    QLabel* m_size;
    QLabel* m_counts;
    QListWidget* m_report;
    QProgressBar* m_progress;
    QDialogButtonBox* m_buttons;
    std::shared_ptr<const ImportOutcome> m_outcome; // null while work goes on
    std::shared_ptr<const PreparedMesh> m_shown;    // stays until there is another mesh
    QTimer m_delay;
    QTimer m_watch;
    ImportWork m_work;
};

} // namespace ripstop
