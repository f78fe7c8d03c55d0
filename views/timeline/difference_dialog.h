#pragma once

#include "document/worker.h"
#include "run/compare_runs.h"

#include <QDialog>

#include <atomic>
#include <memory>
#include <optional>

class QLabel;
class QProgressBar;

namespace ripstop {

// How far the particles of two runs are apart, over time: root mean square and the farthest. It is
// worked out by a thread; click to look at that time.
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
    std::atomic<double> m_share = 0.0;
    std::atomic<bool> m_cancelled = false;
    Worker<int, Outcome> m_worker; // last: it ends before what it uses
};

} // namespace ripstop
