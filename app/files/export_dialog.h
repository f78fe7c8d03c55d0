// Writes meshes, series, films, tables and bundles for other programs.
//
// The moment on the screen is written as it is, on the thread of the window. Anything else is
// taken from the recording or simulated from the start, on a thread of its own, with progress and
// cancel; that thread gets a copy of all fields (Job) and has pictures drawn by calling back to
// the thread of the window. The dialog keeps its own copy of the scene. A failure is a sentence in
// the dialog, which stays open. Files::exportRun() opens it, modal.
#pragma once

#include "files/export_choice.h"
#include "files/film_look.h"
#include "recording/recording.h"
#include "scene/scene.h"

#include <QDialog>
#include <QTimer>

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <utility>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace ripstop {

class ExportDialog final : public QDialog
{
    Q_OBJECT

public:
    using Draw = std::function<QImage(const std::shared_ptr<const Frame>&, const FilmLook&)>;

    // What is there to be exported.
    struct Matter
    {
        const Scene& scene;
        std::shared_ptr<const Frame> now; // on the screen
        // The run that is in the timeline, or null; and the part of it that is played again and
        // again.
        std::shared_ptr<const Recording> recording = nullptr;
        std::optional<std::pair<double, double>> range = std::nullopt; // s
    };

    // `stem` is the suggested file without its extension. `draw` makes pictures of frames, in the
    // size `view` unless asked for another.
    ExportDialog(const Matter& matter, const QString& stem, Draw draw, QSize view, QWidget* parent);
    ~ExportDialog() override;

    QString target() const;

    void reject() override; // first cancels what runs

    // Chooses a format by its ending. An ending that no choice has changes nothing.
    void choose(const QString& ending);
    QString ending() const;

signals:
    void ended(); // the thread has ended: it has written, failed or been cancelled

private:
    // What a thread needs to know of the fields.
    struct Job
    {
        ExportChoice choice;
        QString target;
        ExportRange range;
        bool recorded; // the run is taken as it was; otherwise it is simulated anew
        ControlTrack controls;
        double picturesPerSecond; // of the film
        FilmLook look;
    };

    void layOut();
    void followEnding(const QString& typed);
    void chooseFormat();
    void chooseSource();
    void showPreview();
    QString whyNot() const;
    void browse();
    void start();
    bool mayWrite();          // asks before it replaces a file
    QString writeNow() const; // returns the failure, or an empty text
    // runs on the other thread; returns the failure, or an empty text
    QString write(const Job& job);
    QString writeBundle(const Job& job);
    Result<std::unique_ptr<FrameSink>> sinkFor(const Job& job);
    void watch();
    void setBusy(bool busy);
    void end(const QString& failure);

    const ExportChoice& choice() const;
    std::pair<double, double> recorded() const; // s, from and to
    bool isFlight() const;                      // the recording is more than one moment
    bool isRecorded() const;
    ExportRange range() const;
    std::size_t frames() const; // that will be written
    Job job() const;

    const Scene m_scene;
    const MeshAppearance m_appearance; // of it
    const std::shared_ptr<const Frame> m_now;
    const std::shared_ptr<const Recording> m_recording;
    QString m_stem; // without an ending, as given or as typed
    const Draw m_draw;
    const QSize m_view;
    const std::vector<ExportChoice> m_choices;
    QString m_mayReplace; // a file that the user has agreed to lose

    QWidget* m_fields;
    QFormLayout* m_form;
    QComboBox* m_format;
    QLineEdit* m_target;
    QComboBox* m_source; // the recording, or a new simulation
    QDoubleSpinBox* m_from;
    QDoubleSpinBox* m_to;
    QDoubleSpinBox* m_fps;
    QDoubleSpinBox* m_speed;
    QCheckBox* m_again;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QWidget* m_size;
    QCheckBox* m_overlays;
    QCheckBox* m_time;
    QCheckBox* m_probes;
    QCheckBox* m_pins;
    QWidget* m_shown; // the row of the four boxes above
    QCheckBox* m_transparent;
    QLabel* m_note;
    QLabel* m_message;
    QProgressBar* m_progress;
    QDialogButtonBox* m_buttons;
    QPushButton* m_go = nullptr;
    QTimer m_watch;

    std::atomic<double> m_done = 0.0;
    std::atomic<bool> m_cancelled = false;
    std::future<QString> m_work; // the failure, or empty
};

} // namespace ripstop
