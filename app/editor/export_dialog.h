#pragma once

#include "run/frame.h"
#include "scene/scene.h"

#include <QDialog>
#include <QTimer>

#include <atomic>
#include <future>
#include <memory>
#include <optional>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;

namespace ripstop {

// Writes meshes, series and tables for other programs. The moment on the screen is written as it
// is; anything else is simulated from the start, on a thread, with progress and cancel.
class ExportDialog final : public QDialog
{
    Q_OBJECT

public:
    // `stem` is the suggested file without its extension.
    ExportDialog(const Scene& scene, std::shared_ptr<const Frame> now, const QString& stem,
                 QWidget* parent);
    ~ExportDialog() override;

    QString target() const;

    void reject() override; // first cancels what runs

private:
    void chooseFormat();
    void browse();
    void start();
    bool mayWrite(); // asks before it replaces a file
    void watch();
    void end(const QString& failure);

    const Scene m_scene;
    const std::shared_ptr<const Frame> m_now;
    const QString m_stem;
    QString m_mayReplace; // a file that the user has agreed to lose

    QComboBox* m_format;
    QLineEdit* m_target;
    QDoubleSpinBox* m_from;
    QDoubleSpinBox* m_to;
    QDoubleSpinBox* m_fps;
    QLabel* m_message;
    QProgressBar* m_progress;
    QDialogButtonBox* m_buttons;
    QTimer m_watch;

    std::atomic<double> m_done = 0.0;
    std::atomic<bool> m_cancelled = false;
    std::future<QString> m_work; // the failure, or empty
};

} // namespace ripstop
