// The constructor lays out the choice of sheet, filter, count, complaint and table. reload() finds
// the rows that condition and selection leave, later while the panel is hidden; an edit calls it
// only when it may add or remove rows.
//
// selectMarked() carries marks into the selection. copy() writes the block around the marked cells
// with tabs; paste() reads one value for all marked cells, or a block, and makes one edit of it or
// complains. eventFilter() keeps the keys of copy, paste and select all for the cells.
#include "table/sheet_panel.h"

#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/complaint.h"
#include "table/cell_editor.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QTableView>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int typingPause = 200;           // ms
constexpr int rowPadding = 6;              // px
constexpr qsizetype mostCells = 2'000'000; // to copy; more is a file, and there is an export for it

bool changesRows(const Edit& edit)
{
    return std::ranges::any_of(edit.changes, [](const Change& change) {
        const auto* values = std::get_if<SetValues>(&change);
        return !values || isOneOf<&Link::role>(*values->property);
    });
}

} // namespace

SheetPanel::SheetPanel(Document& document, Selection& selection,
                       std::function<Measurement()> measurement, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_measurement(std::move(measurement))
    , m_model(document)
    , m_sheets(new QComboBox)
    , m_filter(new QLineEdit)
    , m_onlySelected(new QCheckBox(tr("Only s&elected")))
    , m_count(new QLabel)
    , m_ofDesign(new QLabel(tr("The design at its start, not the run.")))
    , m_complaint(new Complaint)
    , m_table(new QTableView)
{
    for (const auto& [sheet, name] : {std::pair(SheetOf::Particles, tr("Particles")),
                                      {SheetOf::Links, tr("Links")},
                                      {SheetOf::Lines, tr("Lines")},
                                      {SheetOf::Panels, tr("Panels")},
                                      {SheetOf::Materials, tr("Materials")}})
        m_sheets->addItem(name, int(sheet));
    m_sheets->setAccessibleName(tr("What the rows are"));
    m_sheets->setToolTip(tr("What the rows are. Lines are the links with the role line."));
    m_filter->setPlaceholderText(tr("Filter: mass < 1 g and not pinned"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setAccessibleName(tr("Filter"));
    m_filter->setToolTip(tr("Only the rows that meet a condition, as in Select by property: mass < "
                            "1 g, strain > 5 %, material = ripstop."));
    m_onlySelected->setToolTip(tr("Only the rows of what is selected in the design."));
    m_count->setForegroundRole(QPalette::PlaceholderText);

    m_table->setModel(&m_model);
    m_table->setItemDelegate(new CellEditor(m_model, m_table));
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setAlternatingRowColors(true);
    m_table->setWordWrap(false);
    m_table->setAccessibleName(tr("Table"));
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed); // no row is measured
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + rowPadding);
    m_table->horizontalHeader()->setSortIndicator(0, Qt::AscendingOrder);
    m_table->setSortingEnabled(true);
    m_table->installEventFilter(this);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    const auto act = [this](const QString& name, auto run) {
        auto* action = new QAction(name, m_table);
        connect(action, &QAction::triggered, this, run);
        m_table->addAction(action);
    };
    act(tr("Copy\tCtrl+C"), &SheetPanel::copy);
    act(tr("Paste\tCtrl+V"), &SheetPanel::paste);

    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(6, 4, 6, 4);
    bar->addWidget(m_sheets);
    bar->addWidget(m_filter, 1);
    bar->addWidget(m_onlySelected);
    bar->addWidget(m_count);
    auto* warning = new QHBoxLayout;
    warning->setContentsMargins(6, 0, 6, 2);
    warning->addWidget(m_complaint);
    m_ofDesign->setObjectName(QStringLiteral("ofDesign"));
    m_ofDesign->setForegroundRole(QPalette::PlaceholderText);
    m_ofDesign->setContentsMargins(6, 0, 6, 2);
    m_ofDesign->setToolTip(tr("The run is read by probes, by the colours of the view, and in the "
                              "status bar with the mouse on a thing."));
    m_ofDesign->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(m_ofDesign);
    layout->addLayout(warning);
    layout->addWidget(m_table, 1);

    m_soon.setSingleShot(true);
    m_soon.setInterval(typingPause);
    connect(&m_soon, &QTimer::timeout, this, &SheetPanel::reload);
    connect(m_filter, &QLineEdit::textChanged, &m_soon, qOverload<>(&QTimer::start));
    connect(m_onlySelected, &QCheckBox::toggled, this, &SheetPanel::reload);
    connect(m_sheets, &QComboBox::currentIndexChanged, this,
            [this] { showSheet(SheetOf(m_sheets->currentData().toInt())); });
    connect(&m_model, &SheetModel::refused, this, &SheetPanel::complain);
    connect(&m_model, &SheetModel::sorted, this, &SheetPanel::describe);
    connect(&m_model, &QAbstractItemModel::modelReset, this, &SheetPanel::describe);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &SheetPanel::selectMarked);
    connect(&document, &Document::replaced, this, &SheetPanel::reload);
    connect(&document, &Document::changed, this, [this](const Edit& applied) {
        if (changesRows(applied))
            reload();
        m_table->viewport()->update();
    });
    connect(&selection, &Selection::changed, this, [this] {
        if (m_onlySelected->isChecked() && !m_isMarking)
            m_soon.start();
    });
}

void SheetPanel::follow(const Player& player)
{
    const auto tell = [this, &player] {
        const Frame* shown = player.frame().get();
        m_ofDesign->setVisible(shown && (player.isPlaying() || shown->underWay));
    };
    connect(&player, &Player::frameReady, this, tell);
    connect(&player, &Player::stateChanged, this, tell);
    tell();
}

void SheetPanel::showSheet(SheetOf sheet)
{
    m_sheets->setCurrentIndex(m_sheets->findData(int(sheet)));
    if (m_model.sheet() == sheet)
        return reload();
    m_model.show(sheet);
    m_table->horizontalHeader()->setSortIndicator(0, Qt::AscendingOrder);
    widenColumns();
    reload();
}

// Shows the rows that the filter and the selection leave; later, while nobody sees them.
void SheetPanel::reload()
{
    m_isStale = !isVisible();
    if (m_isStale)
        return;
    complain({});
    std::optional<std::vector<Id>> limit;
    const std::string condition = m_filter->text().trimmed().toStdString();
    if (!condition.empty()) {
        auto found = matching(m_document.scene(), m_measurement(), condition);
        if (!found)
            return complain(translated(found.message()));
        limit = std::move(*found);
    }
    if (m_onlySelected->isChecked()) {
        const std::vector<Id>& selected = m_selection.ids();
        std::vector<Id> both;
        if (limit)
            std::ranges::set_intersection(*limit, selected, std::back_inserter(both));
        limit = limit ? std::move(both) : selected;
    }
    m_model.limitTo(std::move(limit));
    describe();
}

void SheetPanel::describe()
{
    const QLocale locale;
    const auto shown = locale.toString(qulonglong(m_model.ids().size()));
    const auto all = locale.toString(qulonglong(m_model.total()));
    m_count->setText(m_model.ids().size() == m_model.total() ? tr("%1 rows").arg(all)
                                                             : tr("%1 of %2 rows").arg(shown, all));
    emit described();
}

void SheetPanel::complain(const QString& sentence) { m_complaint->tell(sentence); }

// Makes columns as wide as the header and what stands in the first rows.
void SheetPanel::widenColumns()
{
    constexpr int looked = 30;
    m_table->horizontalHeader()->setResizeContentsPrecision(looked);
    m_table->resizeColumnsToContents();
}

void SheetPanel::selectMarked()
{
    if (!m_table->hasFocus())
        return; // rows that went away take their marks along, which says nothing
    std::vector<Id> ids;
    for (const QItemSelectionRange& range : m_table->selectionModel()->selection())
        for (int row = range.top(); row <= range.bottom(); ++row)
            ids.push_back(m_model.ids()[std::size_t(row)]);
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    m_isMarking = true; // the rows stay as they are
    m_selection.set(std::move(ids));
    m_isMarking = false;
}

void SheetPanel::copy()
{
    const QItemSelection marked = m_table->selectionModel()->selection();
    if (marked.isEmpty())
        return;
    int top = marked.first().top(), bottom = top, left = marked.first().left(), right = left;
    for (const QItemSelectionRange& range : marked) {
        top = std::min(top, range.top());
        bottom = std::max(bottom, range.bottom());
        left = std::min(left, range.left());
        right = std::max(right, range.right());
    }
    if (qsizetype(bottom - top + 1) * (right - left + 1) > mostCells)
        return complain(tr("That is too much for the clipboard; mark fewer cells."));
    QString block;
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column) {
            const QModelIndex index = m_model.index(row, column);
            const QVariant check = m_model.data(index, Qt::CheckStateRole);
            block +=
                check.isValid()
                    ? (check.toInt() == Qt::Checked ? QStringLiteral("yes") : QStringLiteral("no"))
                    : m_model.data(index, column == 0 ? Qt::DisplayRole : Qt::EditRole).toString();
            block += column == right ? QChar('\n') : QChar('\t');
        }
    QApplication::clipboard()->setText(block);
}

// Pastes one value into all marked cells, or a block into as many cells as it has.
void SheetPanel::paste()
{
    const QItemSelection marked = m_table->selectionModel()->selection();
    QString block = QApplication::clipboard()->text();
    while (block.endsWith(QChar('\n')) || block.endsWith(QChar('\r')))
        block.chop(1);
    if (marked.isEmpty() || block.isEmpty())
        return complain(block.isEmpty() ? tr("The clipboard holds no text to paste.")
                                        : tr("Mark the cell where the text is to begin."));
    const bool isOne = !block.contains(QChar('\n')) && !block.contains(QChar('\t'));
    int top = m_model.rowCount(), left = m_model.columnCount(), bottom = 0, right = 0;
    for (const QItemSelectionRange& range : marked) {
        top = std::min(top, range.top());
        left = std::min(left, range.left());
        bottom = std::max(bottom, range.bottom());
        right = std::max(right, range.right());
    }
    const auto firstId = m_model.ids().begin() + top;
    const auto firstColumn = m_model.columns().begin() + left;
    const std::vector<Id> ids(firstId,
                              isOne ? m_model.ids().begin() + bottom + 1 : m_model.ids().end());
    const std::vector<SheetColumn> columns(
        firstColumn, isOne ? m_model.columns().begin() + right + 1 : m_model.columns().end());
    auto edit = pasted(m_document.scene(), ids, columns, block.toStdString());
    complain(edit ? QString() : translated(edit.message()));
    if (edit)
        m_document.push(std::move(*edit));
}

bool SheetPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_table
        || (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride))
        return QWidget::eventFilter(watched, event);
    auto* key = static_cast<QKeyEvent*>(event);
    const bool isCopy = key->matches(QKeySequence::Copy);
    const bool isAll = key->matches(QKeySequence::SelectAll);
    if (!isCopy && !isAll && !key->matches(QKeySequence::Paste))
        return false;
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept(); // here these keys are about cells, not about the design
        return true;
    }
    if (isAll)
        m_table->selectAll();
    else if (isCopy)
        copy();
    else
        paste();
    return true;
}

void SheetPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!m_isStale)
        return;
    reload();
    widenColumns();
}

} // namespace ripstop
