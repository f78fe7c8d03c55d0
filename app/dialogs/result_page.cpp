// Stages: fill() makes the tree, with a heading for each section. start() stops and joins a thread
// that still runs, makes the table anew if it has results already, and computes the rows that the
// filter shows. Each outcome goes to the thread of the window as a queued call with the number of
// its start, so that what a cancelled start sends late is dropped. take() writes a row and judges
// it, finish() ends the run; below stand the summary, the filter, and the table as text for the
// clipboard and for files.
#include "dialogs/result_page.h"

#include "document/ask_file.h"
#include "document/plain_text.h"
#include "io/csv.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSaveFile>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ripstop {
namespace {

constexpr int failedRole = Qt::UserRole; // bool; absent before the row was judged

// These colours can be read on light and on dark backgrounds.
QColor colorOf(bool holds) { return holds ? QColor(0x2e, 0x9e, 0x5b) : QColor(0xd6, 0x3b, 0x3b); }

QString quoted(const QString& text, char separator)
{
    return QString::fromStdString(csvCell(text.toStdString(), separator));
}

} // namespace

ResultPage::ResultPage(std::function<ResultTable()> make, QWidget* parent)
    : QWidget(parent)
    , m_make(std::move(make))
    , m_filter(new QLineEdit)
    , m_onlyFailed(new QCheckBox(tr("Only what &fails")))
    , m_tree(new QTreeWidget)
    , m_progress(new QProgressBar)
    , m_summary(new QLabel)
    , m_run(new QPushButton)
{
    m_filter->setPlaceholderText(tr("Filter by any word of a row, or by section"));
    m_filter->setAccessibleName(m_filter->placeholderText());
    m_filter->setClearButtonEnabled(true);
    m_tree->setAlternatingRowColors(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setAccessibleName(tr("Results"));
    fill();
    for (std::size_t i = 0; i < m_table.columns.size(); ++i)
        m_tree->setColumnWidth(int(i), m_table.columns[i].width);
    m_onlyFailed->setVisible(m_table.isJudged);

    auto* copy = new QPushButton(tr("&Copy"));
    auto* saving = new QPushButton(tr("&Save as CSV…"));
    copy->setToolTip(tr("Copy the table, for a spreadsheet."));
    connect(m_run, &QPushButton::clicked, this, [this] { m_running ? cancel() : start(); });
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(text('\t')); });
    connect(saving, &QPushButton::clicked, this, &ResultPage::save);
    connect(m_filter, &QLineEdit::textChanged, this, &ResultPage::showWhatIsWanted);
    connect(m_onlyFailed, &QCheckBox::toggled, this, &ResultPage::showWhatIsWanted);

    auto* choice = new QHBoxLayout;
    choice->addWidget(m_filter);
    choice->addWidget(m_onlyFailed);
    auto* state = new QHBoxLayout;
    state->addWidget(m_progress);
    state->addWidget(m_summary, 1);
    for (QPushButton* button : {m_run, copy, saving}) {
        button->setAutoDefault(false);
        state->addWidget(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(choice);
    layout->addWidget(m_tree);
    layout->addLayout(state);
    finish();
}

ResultPage::~ResultPage() = default;

void ResultPage::fill()
{
    m_table = m_make();
    m_items.clear();
    m_tree->clear();
    QStringList titles;
    for (const ResultTable::Column& column : m_table.columns)
        titles << column.title;
    m_tree->setColumnCount(int(titles.size()));
    m_tree->setHeaderLabels(titles);
    QTreeWidgetItem* section = nullptr;
    QFont bold = font();
    bold.setBold(true);
    for (const ResultTable::Row& row : m_table.rows) {
        if (!section || section->text(0) != row.section) {
            section = new QTreeWidgetItem(m_tree, {row.section});
            section->setFont(0, bold);
            section->setFirstColumnSpanned(true);
            section->setFlags(Qt::ItemIsEnabled);
            section->setExpanded(true);
        }
        auto* item = new QTreeWidgetItem(section, row.cells);
        for (int i = 0; i < int(m_table.columns.size()); ++i) {
            item->setToolTip(i, item->text(i));
            if (m_table.columns[std::size_t(i)].isNumber)
                item->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
        }
        m_items.push_back(item);
    }
}

void ResultPage::setFilter(const QString& text) { m_filter->setText(text); }

void ResultPage::cancel() { m_thread.request_stop(); }

void ResultPage::start()
{
    cancel();
    if (m_thread.joinable())
        m_thread.join();
    if (m_isUsed) // it holds results of the start before
        fill();
    m_isUsed = true;
    m_onlyFailed->setChecked(false);
    showWhatIsWanted();
    m_done = m_failed = 0;
    std::vector<int> wanted;
    for (std::size_t i = 0; i < m_items.size(); ++i)
        if (!m_items[i]->isHidden())
            wanted.push_back(int(i));
    m_wanted = int(wanted.size());
    m_progress->setRange(0, std::max(1, m_wanted));
    m_progress->setValue(0);
    m_running = true;
    m_run->setText(tr("&Cancel"));
    m_filter->setEnabled(false);
    showSummary();
    ++m_start;
    m_thread = std::jthread([this, start = m_start, wanted = std::move(wanted),
                             compute = m_table.compute](const std::stop_token& stop) {
        for (const int row : wanted) {
            if (stop.stop_requested())
                break;
            const ResultTable::Outcome outcome = compute(row);
            QMetaObject::invokeMethod(
                this, [this, start, row, outcome] { take(start, row, outcome); },
                Qt::QueuedConnection);
        }
        QMetaObject::invokeMethod(
            this,
            [this, start] {
                if (start == m_start)
                    finish();
            },
            Qt::QueuedConnection);
    });
}

void ResultPage::take(int start, int row, const ResultTable::Outcome& outcome)
{
    if (start != m_start) // it was sent before another start began
        return;
    QTreeWidgetItem* item = m_items[std::size_t(row)];
    for (int i = 0; i < int(outcome.cells.size()); ++i)
        if (!outcome.cells[i].isEmpty())
            item->setText(i, outcome.cells[i]);
    if (outcome.holds) {
        item->setText(0, *outcome.holds ? tr("✓ holds") : tr("✗ fails"));
        item->setForeground(0, colorOf(*outcome.holds));
        item->setData(0, failedRole, !*outcome.holds);
        m_failed += *outcome.holds ? 0 : 1;
        if (m_onlyFailed->isChecked())
            showWhatIsWanted();
    }
    ++m_done;
    m_progress->setValue(m_done);
    showSummary();
}

void ResultPage::finish()
{
    m_running = false;
    m_run->setText(tr("&Run", "the cases"));
    m_filter->setEnabled(true);
    showSummary();
    emit finished();
}

void ResultPage::showSummary()
{
    if (m_done == 0 && !m_running)
        m_summary->setText(tr("%1 rows, not yet run.").arg(m_items.size()));
    else if (m_failed > 0)
        m_summary->setText(
            tr("%1 of %2 do not hold; %3 run.").arg(m_failed).arg(m_wanted).arg(m_done));
    else if (m_table.isJudged)
        m_summary->setText(m_done == m_wanted
                               ? tr("All %1 hold.").arg(m_done)
                               : tr("%1 of %2 run; all hold.").arg(m_done).arg(m_wanted));
    else
        m_summary->setText(tr("%1 of %2 run.").arg(m_done).arg(m_wanted));
    QPalette palette = this->palette();
    if (m_done > 0 && m_table.isJudged)
        palette.setColor(QPalette::WindowText, colorOf(m_failed == 0));
    m_summary->setPalette(palette);
}

void ResultPage::showWhatIsWanted()
{
    const QString text = m_filter->text().trimmed();
    for (int s = 0; s < m_tree->topLevelItemCount(); ++s) {
        QTreeWidgetItem* section = m_tree->topLevelItem(s);
        const bool whole = section->text(0).contains(text, Qt::CaseInsensitive);
        int shown = 0;
        for (int i = 0; i < section->childCount(); ++i) {
            QTreeWidgetItem* item = section->child(i);
            bool wanted = whole;
            for (int column = 0; column < item->columnCount(); ++column)
                wanted = wanted || item->text(column).contains(text, Qt::CaseInsensitive);
            if (m_onlyFailed->isChecked())
                wanted = wanted && item->data(0, failedRole).toBool();
            item->setHidden(!wanted);
            shown += wanted ? 1 : 0;
        }
        section->setHidden(shown == 0);
    }
}

QString ResultPage::text(char separator) const
{
    QStringList cells{tr("Section")};
    for (const ResultTable::Column& column : m_table.columns)
        cells << column.title;
    QStringList lines{cells.join(QChar(separator))};
    for (std::size_t row = 0; row < m_items.size(); ++row) {
        cells = {quoted(m_table.rows[row].section, separator)};
        for (int i = 0; i < m_items[row]->columnCount(); ++i)
            cells << quoted(m_items[row]->text(i), separator);
        const QVariant failed = m_items[row]->data(0, failedRole);
        if (!failed.isNull()) // the verdict goes without its sign
            cells[1] = failed.toBool() ? tr("fails") : tr("holds");
        lines << cells.join(QChar(separator));
    }
    return lines.join('\n') + '\n';
}

void ResultPage::save()
{
    const QString path =
        askWhereToSave(this, tr("Save the table"), "verification.csv", tr("Table (*.csv)"), "csv");
    if (path.isEmpty())
        return;
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text(',').toUtf8()) < 0 || !file.commit())
        QMessageBox::warning(
            this, tr("Verification"),
            shownAsIs(tr("%1 cannot be written: %2").arg(path, file.errorString())));
}

} // namespace ripstop
