// A table whose rows have to be computed one by one, and the page that shows it: it computes the
// rows on a thread of its own while the window goes on, and can be filtered, cancelled, copied and
// saved as CSV.
//
// VerificationDialog has two of them. The page lives on the thread of the window; only
// ResultTable::compute runs on the other thread, one row after another, so it must not touch
// widgets. A row that is under way cannot be interrupted: the destructor waits for it.
#pragma once

#include <QStringList>
#include <QWidget>

#include <functional>
#include <optional>
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

// A table whose rows have to be computed before they are whole.
struct ResultTable
{
    struct Column
    {
        QString title;
        int width; // px
        bool isNumber = false;
    };
    struct Row
    {
        QString section;
        QStringList cells; // [columns] empty where a result will stand
    };
    struct Outcome
    {
        QStringList cells;         // [columns] what was empty; the others stay
        std::optional<bool> holds; // nothing when it is not judged
    };
    std::vector<Column> columns; // the first one is for the verdict
    std::vector<Row> rows;       // rows of one section are together
    bool isJudged = true;
    std::function<Outcome(int row)> compute; // called on another thread, row after row
};

class ResultPage final : public QWidget
{
    Q_OBJECT

public:
    // `make` is called for each start, so that nothing is kept from the start before.
    ResultPage(std::function<ResultTable()> make, QWidget* parent = nullptr);
    ~ResultPage() override;

    bool isRunning() const { return m_running; }
    int done() const { return m_done; }
    int failed() const { return m_failed; }

    void setFilter(const QString& text);
    void start();  // computes the rows that the filter shows, from the first on
    void cancel(); // stops after the row that is under way

    // One line per row, with a header. What was not computed is empty there.
    QString text(char separator) const;

signals:
    void finished(); // all wanted rows are computed, or the run was cancelled

private:
    void fill();
    void take(int start, int row, const ResultTable::Outcome& outcome);
    void finish();
    void showWhatIsWanted();
    void showSummary();
    void save();

    std::function<ResultTable()> m_make;
    ResultTable m_table;
    std::vector<QTreeWidgetItem*> m_items; // [rows]
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
    bool m_isUsed = false; // the table has results
    int m_start = 0;       // counts starts
    std::jthread m_thread; // last: stops and joins before the rest is destroyed
};

} // namespace ripstop
