#pragma once

#include "verify/case.h"

#include <QDialog>

#include <thread>
#include <vector>

class QCheckBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace ripstop {

// The cases whose answer is known, as `ripstop-cli verify` has them: expected beside got. They run
// on a thread of their own while the window goes on; what has come out can be copied and saved.
class VerificationDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit VerificationDialog(QWidget* parent);
    ~VerificationDialog() override;

    bool isRunning() const { return m_running; }
    int done() const { return m_done; }
    int failed() const { return m_failed; }

    void setFilter(const QString& text);

    // One line per case, with a header; what has not run has no result.
    QString table(QChar separator) const;

public slots:
    void start();  // from the beginning; with the cases that the filter shows
    void cancel(); // after the case that is under way

signals:
    void finished(); // all asked for, or cancelled

private:
    void fill();
    void take(int row, const CaseResult& result);
    void finish();
    void showWhatIsWanted();
    void showSummary();
    void saveTable();

    std::vector<Case> m_cases;
    std::vector<QTreeWidgetItem*> m_rows; // [cases]
    QLineEdit* m_filter;
    QCheckBox* m_onlyFailed;
    QTreeWidget* m_tree;
    QProgressBar* m_progress;
    QLabel* m_summary;
    QPushButton* m_run;
    int m_wanted = 0;
    int m_done = 0;
    int m_failed = 0;
    bool m_running = false;
    std::jthread m_thread; // last: stops and joins before the rest is destroyed
};

} // namespace ripstop
