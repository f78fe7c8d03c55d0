// showFindings() makes a row of each finding: sign, sentence, and a button below it where there is
// a repair. fitRows() gives rows the height of both, again whenever their column changes. outdate()
// disables the buttons after an edit; repair() pushes a copy of the edit, as the list is made anew
// by that.
#include "problems/stability_list.h"

#include "document/document.h"
#include "document/plain_text.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/tinted.h"

#include <QHeaderView>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

enum Column { Subject, Told };

constexpr int padding = 6; // px

// Signs and words begin at the top of a row, as buttons stand at the bottom.
class TopDelegate final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

private:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->displayAlignment = Qt::AlignLeft | Qt::AlignTop;
        option->decorationAlignment = Qt::AlignHCenter | Qt::AlignTop;
    }
};

// How high these words are in a cell of this width (px), which the style breaks otherwise than the
// metrics of a font do.
int heightOf(QStyleOptionViewItem cell, const QString& words, int width)
{
    cell.features |= QStyleOptionViewItem::HasDisplay;
    cell.text = words;
    cell.rect = QRect(0, 0, width, QWIDGETSIZE_MAX);
    return cell.widget->style()
        ->sizeFromContents(QStyle::CT_ItemViewItem, &cell, QSize(), cell.widget)
        .height();
}

// Stands below the sentence, which would have no room beside it: the words of a repair are as many.
QWidget* placed(QPushButton* button)
{
    auto* place = new QWidget;
    auto* inside = new QVBoxLayout(place);
    inside->setContentsMargins(padding / 2, 0, padding / 2, padding / 2);
    inside->addStretch(1);
    inside->addWidget(button, 0, Qt::AlignLeft);
    return place;
}

} // namespace

StabilityList::StabilityList(Document& document, Selection& selection, QWidget* parent)
    : QTreeWidget(parent)
    , m_document(document)
    , m_selection(selection)
{
    setColumnCount(2);
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setFrameShape(NoFrame);
    setWordWrap(true);
    setItemDelegate(new TopDelegate(this));
    setSelectionMode(SingleSelection);
    setAccessibleName(tr("Stability"));
    setToolTip(tr("How near the design is to what its solver can follow. Click a row to select "
                  "what it is about."));
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(Subject, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(Told, QHeaderView::Stretch);
    const auto select = [this](QTreeWidgetItem* item) {
        const Finding& finding = m_findings[std::size_t(indexOfTopLevelItem(item))];
        if (!finding.culprits.empty())
            m_selection.set(finding.culprits);
    };
    connect(this, &QTreeWidget::itemClicked, this, select);
    connect(this, &QTreeWidget::itemActivated, this, select);
    connect(&document, &Document::changed, this, &StabilityList::outdate);
    connect(&document, &Document::replaced, this, &StabilityList::outdate);
}

void StabilityList::showFindings(const std::vector<Finding>& findings)
{
    m_findings = findings;
    clear();
    for (std::size_t row = 0; row < findings.size(); ++row) {
        const Finding& finding = findings[row];
        const bool isPoor = finding.severity == Severity::Warning;
        auto* item =
            new QTreeWidgetItem(this, {translated(finding.subject), translated(finding.message)});
        item->setIcon(Subject, isPoor ? tinted(QStringLiteral("warning"), QColor(0xd9, 0x8e, 0x1f))
                                      : tinted(QStringLiteral("ok"), QColor(0x3c, 0x9a, 0x5f)));
        item->setData(Subject, Qt::AccessibleTextRole,
                      (isPoor ? tr("Poor: %1") : tr("Good: %1")).arg(item->text(Subject)));
        item->setToolTip(Told, shownAsIs(item->text(Told)));
        if (!finding.repair)
            continue;
        auto* button = new QPushButton(inMenu(translated(finding.repair->label)));
        button->setToolTip(tr("Repairs it as one step that can be undone."));
        connect(button, &QPushButton::clicked, this, [this, row] { repair(row); });
        setItemWidget(item, Told, placed(button));
    }
    fitRows();
}

int StabilityList::poor() const
{
    return int(std::ranges::count(m_findings, Severity::Warning, &Finding::severity));
}

bool StabilityList::tellsPoor(std::string_view sort) const
{
    return !sort.empty() && std::ranges::any_of(m_findings, [sort](const Finding& finding) {
        return finding.severity == Severity::Warning && finding.sort == sort;
    });
}

// Comes after each change of the widget and its scroll bars, which a resize of the widget alone
// does not tell of.
void StabilityList::updateGeometries()
{
    QTreeWidget::updateGeometries();
    fitRows();
}

// Rows are as high as their sentences need in the width that there is; a tree does not see to it.
void StabilityList::fitRows()
{
    QStyleOptionViewItem cell;
    initViewItemOption(&cell);
    for (int row = 0; row < topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = topLevelItem(row);
        const int words = heightOf(cell, item->text(Told), columnWidth(Told));
        const QWidget* place = itemWidget(item, Told);
        const int below = place ? place->sizeHint().height() : 0;
        item->setSizeHint(Told, QSize(0, words + padding + below));
    }
}

void StabilityList::outdate()
{
    for (int row = 0; row < topLevelItemCount(); ++row)
        if (QWidget* place = itemWidget(topLevelItem(row), Told))
            place->setEnabled(false);
}

void StabilityList::repair(std::size_t row)
{
    const Edit edit = *m_findings[row].repair; // the list is about to be made anew
    m_document.push(edit);
}

} // namespace ripstop
