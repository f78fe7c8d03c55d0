// Stages: the constructor lays out field, table and chart. start() flies the three runs on other
// threads and keeps the certificate, or says why there is none; fill() writes the rows and draw()
// the chart of the row that is selected. The run can be saved as a table of values and errors or as
// a recording, which carries the certificate to what is exported from it.
#include "dialogs/certify_dialog.h"

#include "dialogs/work_dialog.h"
#include "document/ask_file.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "document/spoken.h"
#include "document/words.h"
#include "io/certificate_table.h"
#include "io/recording_file.h"
#include "io/whole_file.h"
#include "plots/band_chart.h"
#include "plots/chart_style.h"
#include "run/certify.h"
#include "start/parameter_field.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>
#include <optional>

namespace ripstop {
namespace {

const Parameter secondsParameter{"--seconds",
                                 "s",
                                 2.0,
                                 1e-3,
                                 1e6,
                                 false,
                                 "Simulated time; the longer, the less is left of the digits."};

// To the second digit of its error; what is less than that is nothing.
QString valueText(const CertifiedProbe& probe, bool isShare)
{
    const double value = probe.result.value[0];
    const double error = probe.result.error;
    int digits = 8;
    if (std::isfinite(error) && error > 0.0) {
        if (std::abs(value) < error)
            return readingText(isShare, 0.0, probe.unit);
        digits = std::min(digits, 2 + int(std::floor(std::log10(std::abs(value))))
                                      - int(std::floor(std::log10(error))));
    }
    return readingText(isShare, value, probe.unit, digits);
}

// An error is one however little it is, where a reading would be said to be nothing.
QString errorText(const CertifiedProbe& probe, bool isShare)
{
    const double error = probe.result.error;
    const std::string unit = isShare ? "%" : probe.unit;
    const double shown = isShare ? 100.0 * error : error;
    if (!(shown > 0.0) || !std::isfinite(shown)
        || spoken(shown, unit).number != QStringLiteral("0"))
        return readingText(isShare, error, probe.unit, 2);
    return Spoken{QLocale().toString(shown, 'g', 2), text(unit)}.text();
}

} // namespace

CertifyDialog::CertifyDialog(const Document& document, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_seconds(new ParameterField(secondsParameter))
    , m_start(new QPushButton(tr("&Certify")))
    , m_saveTable(new QPushButton(tr("&Save table…")))
    , m_saveRecording(new QPushButton(tr("Save &recording…")))
    , m_state(new QLabel)
    , m_table(new QTableWidget)
    , m_chart(new BandChart)
{
    setWindowTitle(tr("Certify"));
    setAttribute(Qt::WA_DeleteOnClose);
    layOut();
    connect(m_start, &QPushButton::clicked, this, &CertifyDialog::start);
    connect(m_saveTable, &QPushButton::clicked, this, &CertifyDialog::saveTable);
    connect(m_saveRecording, &QPushButton::clicked, this, &CertifyDialog::saveRecording);
    connect(m_seconds, &ParameterField::changed, this, [this] {
        const QString refusal = m_seconds->refusal();
        m_start->setEnabled(refusal.isEmpty());
        m_state->setText(refusal.isEmpty() ? timeItTakes() : refusal);
    });
    connect(m_table, &QTableWidget::currentCellChanged, this, &CertifyDialog::draw);
    fill();
    resize(QSize(860, 620).boundedTo(screen()->availableSize() * 0.94));
}

void CertifyDialog::layOut()
{
    auto* help = new QLabel(
        tr("Flies the design three times: as it is, with each substep cut in two, and in four. How "
           "the values of the probes come nearer to each other tells how far they are from where "
           "they go, and so which of their digits hold."));
    help->setWordWrap(true);
    help->setForegroundRole(QPalette::PlaceholderText);
    m_seconds->setObjectName(QStringLiteral("seconds"));
    m_start->setObjectName(QStringLiteral("start"));
    m_start->setDefault(true);
    auto* label = new QLabel(tr("S&imulated time"));
    label->setBuddy(m_seconds);
    auto* form = new QFormLayout;
    form->addRow(label, m_seconds);

    m_table->setObjectName(QStringLiteral("probes"));
    m_table->setColumnCount(6);
    m_table->setHorizontalHeaderLabels(
        {tr("Probe"), tr("Value"), tr("Error"), tr("Digits"), tr("Order"), tr("Judged by")});
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_table->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_state->setTextFormat(Qt::PlainText);
    m_state->setObjectName(QStringLiteral("state"));
    m_state->setWordWrap(true);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_start, QDialogButtonBox::ActionRole);
    buttons->addButton(m_saveTable, QDialogButtonBox::ActionRole);
    buttons->addButton(m_saveRecording, QDialogButtonBox::ActionRole);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    m_saveTable->setAutoDefault(false);
    m_saveRecording->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(help);
    layout->addLayout(form);
    layout->addWidget(m_state);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_chart, 1);
    layout->addWidget(buttons);
    m_state->setText(timeItTakes());
}

QString CertifyDialog::timeItTakes()
{
    return tr("It takes about seven times as long as the run.");
}

void CertifyDialog::start()
{
    const Scene scene = m_document.scene();
    const double seconds = m_seconds->value();
    std::optional<Result<Certification>> made;
    workWithProgress(this, tr("Certifying…"), [&](const Progress& progress) {
        made.emplace(certify(scene, seconds, {}, progress));
    });
    if (!*made) {
        if (made->message() != Message("Cancelled."))
            m_state->setText(translated(made->message()));
        return;
    }
    if (!(**made).stopped.empty())
        return m_state->setText(translated((**made).stopped));
    m_certificate = std::make_shared<const Certificate>(std::move((**made).certificate));
    m_recording = (**made).flown;
    m_shares.clear();
    for (const Entry& entry : scene.items)
        if (const auto* probe = std::get_if<Probe>(&entry.item);
            probe && isSaidInPercent(probe->quantity))
            m_shares.insert(probe->name);
    m_state->setText(tr("After %1 s. Select a probe to see how far it may be off over time. The "
                        "plots show it, too, when the design runs as it is now.")
                         .arg(spokenNumber(seconds)));
    fill();
    emit certified(m_certificate);
}

void CertifyDialog::fill()
{
    const bool some = m_certificate != nullptr;
    m_chart->setVisible(some);
    m_saveTable->setEnabled(some);
    m_saveRecording->setEnabled(m_recording != nullptr);
    m_table->setRowCount(some ? int(m_certificate->probes.size()) : 0);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const CertifiedProbe& probe = m_certificate->probes[std::size_t(row)];
        const Convergence& result = probe.result;
        const bool isShare = m_shares.contains(probe.name);
        const QStringList cells{QString::fromStdString(probe.name),
                                valueText(probe, isShare),
                                errorText(probe, isShare),
                                QLocale().toString(result.digits),
                                result.converges() ? QLocale().toString(result.order, 'f', 1)
                                                   : QStringLiteral("–"),
                                probe.ofMean ? tr("mean of the second half") : tr("last value")};
        for (int column = 0; column < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            if (column > 0 && column < 5)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_table->setItem(row, column, item);
        }
    }
    if (m_table->rowCount() > 0)
        m_table->setCurrentCell(0, 0);
    draw();
}

void CertifyDialog::draw()
{
    const int row = m_table->currentRow();
    if (!m_certificate || row < 0)
        return m_chart->clear();
    const CertifiedProbe& probe = m_certificate->probes[std::size_t(row)];
    m_chart->show({QString::fromStdString(probe.name), QString::fromStdString(probe.unit),
                   m_shares.contains(probe.name)},
                  m_certificate->time, probe.value, probe.error);
}

void CertifyDialog::saveTable()
{
    const QString file = askWhereToSave(this, tr("Save the values and their errors"),
                                        QStringLiteral("certificate.csv"), tr("Tables (*.csv)"),
                                        QStringLiteral("csv"));
    if (file.isEmpty())
        return;
    if (const auto failure =
            replaceFile(pathOf(file), certificateTable(*m_certificate), Flush::ToDisk))
        QMessageBox::warning(this, tr("Cannot save the table"),
                             shownAsIs(translated(failure->message)));
}

void CertifyDialog::saveRecording()
{
    const QString file = askWhereToSave(
        this, tr("Save the run with its certificate"), QStringLiteral("certified.ripstop-run"),
        tr("Recordings (*.ripstop-run)"), QStringLiteral("ripstop-run"));
    if (file.isEmpty())
        return;
    std::optional<Failure> failure;
    workWithProgress(this, tr("Saving…"), [&](const Progress& progress) {
        failure = ripstop::saveRecording(*m_recording, pathOf(file), progress);
    });
    if (failure && failure->message != Message("Cancelled."))
        QMessageBox::warning(this, tr("Cannot save the recording"),
                             shownAsIs(translated(failure->message)));
}

} // namespace ripstop
