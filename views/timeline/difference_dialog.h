// How far the particles of two runs are apart, m, over time: the root mean square of all and the
// farthest one (recording/compare_runs.h). The distances are worked out on a thread of its own
// while the dialog shows progress; a click asks to look at that time. The dialog deletes itself
// when it is closed, which also ends the work. Only the window's thread uses it.
#pragma once

#include "document/worker.h"
#include "recording/compare_runs.h"

#include <QDialog>

#include <atomic>
#include <memory>
#include <optional>

class QLabel;
class QProgressBar;

namespace ripstop {

class DifferenceDialog final : public QDialog
{
    Q_OBJECT

public:
    DifferenceDialog(std::shared_ptr<Recording> a, std::shared_ptr<Recording> b,
                     QWidget* parent = nullptr);
    ~DifferenceDialog() override;

    bool isDone() const { return m_done; }
    const std::vector<RunDistance>& distances() const { return m_list; }

signals:
    void picked(double time); // s

private:
    class Plot;
    struct Outcome
    {
        std::vector<RunDistance> list;
        Message failure;
    };
    void take();
    void showProgress();
    void describe(std::optional<std::size_t> row);

    std::shared_ptr<Recording> m_a;
    std::shared_ptr<Recording> m_b;
    std::vector<RunDistance> m_list;
    bool m_done = false;
    QLabel* m_text;
    QProgressBar* m_bar;
    Plot* m_plot;
    std::atomic<double> m_share = 0.0; // of the work that is done, 0 to 1; written by the worker
    std::atomic<bool> m_cancelled = false;
    Worker<int, Outcome> m_worker; // last: it ends before what it uses
};

} // namespace ripstop
