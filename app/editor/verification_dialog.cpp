#include "editor/verification_dialog.h"

#include "editor/ask_file.h"

#include <QCheckBox>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFile>
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

enum Column { Result, Id_, Title, Expected, Got, Unit, ToleranceText, Source, columns };

constexpr int failedRole = Qt::UserRole; // bool; absent before the case has run

QString words(const std::string& text) { return QString::fromStdString(text); }

QString digits(double number) { return QString::number(number, 'g', 9); }

// Readable on light and on dark.
QColor colorOf(bool holds) { return holds ? QColor(0x2e, 0x9e, 0x5b) : QColor(0xd6, 0x3b, 0x3b); }

QString quoted(QString text, QChar separator)
{
    if (!text.contains(separator) && !text.contains('"'))
        return text;
    return '"' + text.replace('"', "\"\"") + '"';
}

} // namespace

VerificationDialog::VerificationDialog(QWidget* parent)
    : QDialog(parent)
    , m_filter(new QLineEdit)
    , m_onlyFailed(new QCheckBox(tr("Only what &fails")))
    , m_tree(new QTreeWidget)
    , m_progress(new QProgressBar)
    , m_summary(new QLabel)
    , m_run(new QPushButton)
{
    setWindowTitle(tr("Verification"));
    auto* intro = new QLabel(
        tr("Cases whose answer is known from theory or a publication. The same engine that flies "
           "your scene must find it, within the tolerance that stands beside it."));
    intro->setWordWrap(true);
    m_filter->setPlaceholderText(tr("Filter by id, title, section or source"));
    m_filter->setClearButtonEnabled(true);
    m_tree->setColumnCount(columns);
    m_tree->setHeaderLabels({tr("Result"), tr("Id"), tr("Case"), tr("Expected"), tr("Got"),
                             tr("Unit"), tr("Tolerance"), tr("Source")});
    m_tree->setAlternatingRowColors(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setAccessibleName(tr("Cases"));
    fill();

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_run, QDialogButtonBox::ActionRole);
    auto* copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    auto* save = buttons->addButton(tr("&Save as CSV…"), QDialogButtonBox::ActionRole);
    copy->setToolTip(tr("Copy the table, for a spreadsheet."));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_run, &QPushButton::clicked, this, [this] { m_running ? cancel() : start(); });
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(table('\t')); });
    connect(save, &QPushButton::clicked, this, &VerificationDialog::saveTable);
    connect(m_filter, &QLineEdit::textChanged, this, &VerificationDialog::showWhatIsWanted);
    connect(m_onlyFailed, &QCheckBox::toggled, this, &VerificationDialog::showWhatIsWanted);

    auto* choice = new QHBoxLayout;
    choice->addWidget(m_filter);
    choice->addWidget(m_onlyFailed);
    auto* state = new QHBoxLayout;
    state->addWidget(m_progress);
    state->addWidget(m_summary, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addLayout(choice);
    layout->addWidget(m_tree);
    layout->addLayout(state);
    layout->addWidget(buttons);
    resize(1320, 720);
    finish();
}

VerificationDialog::~VerificationDialog() = default;

void VerificationDialog::fill()
{
    m_cases = allCases();
    m_rows.clear();
    m_tree->clear();
    QTreeWidgetItem* section = nullptr;
    QFont bold = font();
    bold.setBold(true);
    for (const Case& one : m_cases) {
        const QString title = words(one.section);
        if (!section || section->text(0) != title) {
            section = new QTreeWidgetItem(m_tree, {title});
            section->setFont(0, bold);
            section->setFirstColumnSpanned(true);
            section->setFlags(Qt::ItemIsEnabled);
            section->setExpanded(true);
        }
        auto* row = new QTreeWidgetItem(
            section, {QString(), words(one.id), words(one.title), digits(one.expected), QString(),
                      words(one.unit), words(textOf(one.tolerance, one.unit)), words(one.source)});
        for (const int column : {Expected, Got})
            row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        row->setToolTip(Title, row->text(Title));
        row->setToolTip(Source, row->text(Source));
        m_rows.push_back(row);
    }
    m_tree->setColumnWidth(Result, 120);
    m_tree->setColumnWidth(Id_, 60);
    m_tree->setColumnWidth(Title, 430);
    for (const int column : {Expected, Got})
        m_tree->setColumnWidth(column, 110);
    m_tree->setColumnWidth(Unit, 60);
    m_tree->setColumnWidth(ToleranceText, 150);
}

void VerificationDialog::start()
{
    cancel();
    if (m_thread.joinable())
        m_thread.join();
    fill(); // what cases have kept for each other is measured anew, too
    m_onlyFailed->setChecked(false);
    showWhatIsWanted();
    m_done = m_failed = m_wanted = 0;
    std::vector<int> wanted;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        if (!m_rows[i]->isHidden())
            wanted.push_back(int(i));
    m_wanted = int(wanted.size());
    m_progress->setRange(0, std::max(1, m_wanted));
    m_progress->setValue(0);
    m_running = true;
    m_run->setText(tr("&Cancel"));
    m_filter->setEnabled(false);
    showSummary();
    // the destructor joins before it lets go of what the thread reads
    m_thread = std::jthread([this, wanted = std::move(wanted)](const std::stop_token& stop) {
        for (const int row : wanted) {
            if (stop.stop_requested())
                break;
            const CaseResult result = run(m_cases[std::size_t(row)]);
            QMetaObject::invokeMethod(
                this, [this, row, result] { take(row, result); }, Qt::QueuedConnection);
        }
        QMetaObject::invokeMethod(
            this, [this] { finish(); }, Qt::QueuedConnection);
    });
}

void VerificationDialog::setFilter(const QString& text) { m_filter->setText(text); }

void VerificationDialog::cancel() { m_thread.request_stop(); }

void VerificationDialog::take(int row, const CaseResult& result)
{
    QTreeWidgetItem* item = m_rows[std::size_t(row)];
    item->setText(Result, result.holds ? tr("✓ holds") : tr("✗ fails"));
    item->setForeground(Result, colorOf(result.holds));
    item->setText(Got, digits(result.got));
    item->setData(Result, failedRole, !result.holds);
    ++m_done;
    m_failed += result.holds ? 0 : 1;
    m_progress->setValue(m_done);
    showSummary();
}

void VerificationDialog::finish()
{
    m_running = false;
    m_run->setText(tr("&Run"));
    m_filter->setEnabled(true);
    showSummary();
    emit finished();
}

void VerificationDialog::showSummary()
{
    if (m_done == 0 && !m_running)
        m_summary->setText(tr("%1 cases, not yet run.").arg(m_cases.size()));
    else if (m_failed > 0)
        m_summary->setText(
            tr("%1 of %2 cases do not hold; %3 run.").arg(m_failed).arg(m_wanted).arg(m_done));
    else if (m_done == m_wanted)
        m_summary->setText(tr("All %1 cases hold.").arg(m_done));
    else
        m_summary->setText(tr("%1 of %2 cases run; all hold.").arg(m_done).arg(m_wanted));
    QPalette palette = this->palette();
    if (m_done > 0)
        palette.setColor(QPalette::WindowText, colorOf(m_failed == 0));
    m_summary->setPalette(palette);
}

void VerificationDialog::showWhatIsWanted()
{
    const QString text = m_filter->text().trimmed();
    for (int s = 0; s < m_tree->topLevelItemCount(); ++s) {
        QTreeWidgetItem* section = m_tree->topLevelItem(s);
        const bool whole = section->text(0).contains(text, Qt::CaseInsensitive);
        int shown = 0;
        for (int i = 0; i < section->childCount(); ++i) {
            QTreeWidgetItem* row = section->child(i);
            bool wanted = whole;
            for (const int column : {Id_, Title, Source})
                wanted = wanted || row->text(column).contains(text, Qt::CaseInsensitive);
            if (m_onlyFailed->isChecked())
                wanted = wanted && row->data(Result, failedRole).toBool();
            row->setHidden(!wanted);
            shown += wanted ? 1 : 0;
        }
        section->setHidden(shown == 0);
    }
}

QString VerificationDialog::table(QChar separator) const
{
    QStringList lines;
    QStringList cells;
    for (int column = 0; column < columns; ++column)
        cells << m_tree->headerItem()->text(column);
    cells << tr("Section");
    lines << cells.join(separator);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const QVariant failed = m_rows[i]->data(Result, failedRole);
        cells = {failed.isNull() ? QString() : failed.toBool() ? tr("fails") : tr("holds")};
        for (int column = Id_; column < columns; ++column)
            cells << quoted(m_rows[i]->text(column), separator);
        cells << quoted(words(m_cases[i].section), separator);
        lines << cells.join(separator);
    }
    return lines.join('\n') + '\n';
}

void VerificationDialog::saveTable()
{
    const QString path =
        askWhereToSave(this, tr("Save the table"), "verification.csv", tr("Table (*.csv)"), "csv");
    if (path.isEmpty())
        return;
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(table(',').toUtf8()) < 0 || !file.commit())
        QMessageBox::warning(this, windowTitle(),
                             tr("%1 cannot be written: %2").arg(path, file.errorString()));
}

} // namespace ripstop
