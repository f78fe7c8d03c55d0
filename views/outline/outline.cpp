// The constructor lays out search, add button and tree over model and filter. addCollider() and
// add() make items; removeSelected() asks first when more would go than what is selected.
//
// takeFromTree() and showSelection() carry the selection between tree and document; m_syncing keeps
// one from answering the other. Elements have no rows, so a table is shown as selected when all its
// rows are.
//
// search() passes the text to the filter; takeSearch() selects what it has found, or the thing with
// an id such as #17. eventFilter() gives the tree and the search box their keys.
#include "outline/outline.h"

#include "derived/collider_shape.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "document/selection.h"
#include "document/shape_file.h"
#include "document/words.h"
#include "icons/icon.h"
#include "outline/new_item.h"
#include "outline/outline_filter.h"
#include "outline/outline_model.h"
#include "select/element_counts.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QResizeEvent>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int detailWidth = 190; // pixels, of the longest details

using Sort = OutlineModel::Node::Sort;

QIcon iconOf(Kind kind) { return icon(QString::fromUtf8(kindName(kind).data())); }

// What the things point at: the materials of links and panels, the members of groups, the targets
// of controls and probes.
std::vector<Id> pointedAt(const Scene& scene, const std::vector<Id>& ids)
{
    std::vector<Id> result;
    for (const Id id : ids) {
        const auto ref = find(scene, id);
        if (!ref)
            continue;
        for (const Property& property : propertiesOf(kindOf(*ref))) {
            const Value value = property.get(*ref);
            if (const auto* list = std::get_if<std::vector<Id>>(&value))
                result.insert(result.end(), list->begin(), list->end());
            if (const Id* one = std::get_if<Id>(&value); one && *one != noId)
                result.push_back(*one);
        }
    }
    return result;
}

// Links and panels made of one of the materials.
//   without  ids, ascending: of parts and elements that are left out
std::vector<Id> madeOf(const Scene& scene, const std::vector<Id>& materials,
                       const std::vector<Id>& without = {})
{
    std::vector<Id> result;
    const auto isIn = [](const std::vector<Id>& ids, Id id) {
        return std::ranges::binary_search(ids, id);
    };
    const auto collect = [&](const auto& rows) {
        for (const auto& row : rows)
            if (isIn(materials, row.material) && !isIn(without, row.id))
                result.push_back(row.id);
    };
    forEachPart(scene, [&](Id id, const Part& part) {
        if (isIn(without, id))
            return;
        collect(part.links);
        collect(part.panels);
    });
    return result;
}

} // namespace

Outline::Outline(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_model(new OutlineModel(document, selection, this))
    , m_filter(new OutlineFilter(*m_model, this))
    , m_search(new QLineEdit)
    , m_tree(new QTreeView)
    , m_addMenu(new QMenu(this))
{
    confirm = [this](const QString& question) {
        const auto answer =
            QMessageBox::question(this, tr("Delete"), shownAsIs(question),
                                  QMessageBox::Ok | QMessageBox::Cancel, QMessageBox::Ok);
        return answer == QMessageBox::Ok;
    };
    m_search->setPlaceholderText(tr("Search names, or #17"));
    m_search->setToolTip(tr("Shows only what has this in its name. #17 and Enter selects what has "
                            "the id 17; Enter alone selects all that is found."));
    m_search->setAccessibleName(tr("Search the outline"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    connect(m_search, &QLineEdit::textChanged, this, &Outline::search);
    connect(m_search, &QLineEdit::returnPressed, this, &Outline::takeSearch);
    m_search->installEventFilter(this);

    buildAddMenu();
    auto* addButton = new QToolButton;
    addButton->setIcon(icon(QStringLiteral("add")));
    addButton->setToolTip(tr("Add a material, collider, wind, control, probe or group."));
    addButton->setAccessibleName(tr("Add item"));
    addButton->setMenu(m_addMenu);
    addButton->setPopupMode(QToolButton::InstantPopup);
    addButton->setAutoRaise(true);

    auto* head = new QHBoxLayout;
    head->setContentsMargins(6, 6, 6, 2);
    head->addWidget(m_search);
    head->addWidget(addButton);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(head);
    layout->addWidget(m_tree);

    buildTree();
    connect(&m_selection, &Selection::changed, this, &Outline::showSelection);
    connect(&document, &Document::replaced, this, [this] { search(m_search->text()); });
    search({});
}

void Outline::buildTree()
{
    m_tree->setModel(m_filter);
    m_tree->setHeaderHidden(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    // A second click on what is selected must not take the next key for a name.
    m_tree->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_tree->setExpandsOnDoubleClick(false);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setUniformRowHeights(true);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setIndentation(14);
    m_tree->setTextElideMode(Qt::ElideRight);
    m_tree->setAccessibleName(tr("Outline"));
    m_tree->installEventFilter(this);

    QHeaderView* header = m_tree->header();
    header->setStretchLastSection(false);
    header->setMinimumSectionSize(20);
    header->setSectionResizeMode(OutlineModel::Name, QHeaderView::Stretch);
    header->setSectionResizeMode(OutlineModel::Detail, QHeaderView::Fixed);
    header->setSectionResizeMode(OutlineModel::Shown, QHeaderView::Fixed);
    header->resizeSection(OutlineModel::Shown, 26);

    connect(m_tree, &QTreeView::customContextMenuRequested, this, &Outline::showContextMenu);
    connect(m_tree, &QTreeView::clicked, this, [this](const QModelIndex& index) {
        if (index.column() == OutlineModel::Shown)
            m_model->toggleShown(m_filter->mapToSource(index));
    });
    connect(m_tree->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &Outline::takeFromTree);
    // A list that comes, as when its only item is deleted and that is undone, is open like others.
    connect(m_filter, &QAbstractItemModel::rowsInserted, m_tree,
            [this](const QModelIndex& parent, int first, int last) {
                for (int row = first; !parent.isValid() && row <= last; ++row)
                    m_tree->expand(m_filter->index(row, 0));
            });
}

void Outline::buildAddMenu()
{
    for (const Kind kind : addableKinds) {
        if (kind == Kind::Collider) {
            QMenu* shapes = m_addMenu->addMenu(iconOf(kind), kindLabel(kind));
            for (std::size_t i = 0; i < choiceNames<ColliderShape>.size(); ++i)
                shapes->addAction(choiceLabel(choiceNames<ColliderShape>[i]), this,
                                  [this, i] { addCollider(ColliderShape(i)); });
            continue;
        }
        m_addMenu->addAction(iconOf(kind), kindLabel(kind), this, [this, kind] { addNew(kind); });
    }
}

void Outline::addNew(Kind kind) { add(kind, newItem(m_document.scene(), kind, m_selection.ids())); }

// A mesh is nothing without its file, and would only be an error in the list of problems.
void Outline::addCollider(ColliderShape shape)
{
    QString file;
    const bool needsFile = rowOf(shape).madeOf == MadeOf::Triangles;
    if (needsFile)
        file = askShapeFile(this, m_document, shape);
    if (!needsFile || !file.isEmpty())
        add(Kind::Collider, newCollider(m_document.scene(), shape, file.toStdString()));
}

void Outline::add(Kind kind, Entry entry)
{
    const Scene& scene = m_document.scene();
    const Id id = entry.id;
    m_document.push({Message::verbatim(tr("Add %1").arg(kindLabel(kind).toLower()).toStdString()),
                     {AddItem{scene.items.size(), std::move(entry)}}});
    m_search->clear();
    m_selection.set({id});
    m_tree->setCurrentIndex(m_filter->mapFromSource(m_model->indexOf(id)));
}

void Outline::renameCurrent() { m_tree->edit(m_tree->currentIndex().siblingAtColumn(0)); }

void Outline::removeSelected()
{
    std::vector<Id> ids = m_selection.ids();
    std::erase(ids, settingsId);
    if (ids.empty())
        return;
    Edit edit = removal(m_document.scene(), ids);
    const QString named = describe(m_document.scene(), ids);
    if (const QString others = countsOf(alsoRemoved(ids, edit)); !others.isEmpty()) {
        if (!confirm(tr("Delete %1, and with it what hangs on it: %2?").arg(named, others)))
            return;
    } else if (std::vector<Id> made = madeOf(m_document.scene(), ids, ids); !made.empty()) {
        std::ranges::sort(made);
        if (!confirm(tr("Delete %1? What is made of it, %2, has then neither stiffness nor "
                        "strength of its own.")
                         .arg(named, describe(m_document.scene(), made))))
            return;
    }
    edit.label = Message::verbatim(tr("Remove %1").arg(named).toStdString());
    m_document.push(std::move(edit));
}

void Outline::focusSearch()
{
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

void Outline::showContextMenu(const QPoint& place)
{
    const QModelIndex current = m_tree->indexAt(place).siblingAtColumn(0);
    const Scene& scene = m_document.scene();
    const std::vector<Id>& ids = m_selection.ids();

    QMenu menu;
    const bool isBuilt = std::ranges::any_of(ids, [&](Id id) {
        const Part* part = findItem<Part>(scene, id);
        return part && !part->builder.empty();
    });
    if (isBuilt)
        for (QAction* action : m_partActions)
            menu.addAction(action);
    if (current.isValid() && (m_filter->flags(current) & Qt::ItemIsEditable))
        menu.addAction(tr("Rename"), QKeySequence(Qt::Key_F2), this,
                       [=, this] { m_tree->edit(current); });
    if (!ids.empty() && ids.front() != settingsId) {
        menu.addAction(icon(QStringLiteral("delete")), tr("Delete"), QKeySequence::Delete, this,
                       &Outline::removeSelected);
        if (auto members = pointedAt(scene, ids); !members.empty())
            menu.addAction(icon(QStringLiteral("select-all")), tr("Select what it refers to"), this,
                           [this, members] { m_selection.set(members); });
        if (auto users = madeOf(scene, ids); !users.empty())
            menu.addAction(icon(QStringLiteral("select-all")), tr("Select what is made of it"),
                           this, [this, users] { m_selection.set(users); });
        menu.addSeparator();
    }
    menu.addMenu(m_addMenu)->setText(tr("Add"));
    menu.exec(m_tree->viewport()->mapToGlobal(place));
}

void Outline::takeFromTree()
{
    if (m_syncing)
        return;
    const QScopedValueRollback syncing(m_syncing, true);
    std::vector<Id> ids;
    for (const QModelIndex& index : m_tree->selectionModel()->selectedRows()) {
        const std::vector<Id> some = m_model->ids(m_filter->mapToSource(index));
        ids.insert(ids.end(), some.begin(), some.end());
    }
    m_selection.set(std::move(ids));
    m_tree->viewport()->update(); // details such as "3 of 152" have changed
}

void Outline::showSelection()
{
    m_tree->viewport()->update(); // details such as "3 of 152" have changed
    if (m_syncing)
        return;
    const QScopedValueRollback syncing(m_syncing, true);

    QItemSelection rows;
    QModelIndex last;
    const auto show = [&](const QModelIndex& index) {
        const QModelIndex row = m_filter->mapFromSource(index);
        if (row.isValid()) {
            rows.select(row, row);
            last = row;
        }
    };
    const std::vector<Id>& ids = m_selection.ids();
    if (m_selection.contains(settingsId))
        show(m_model->indexOf(settingsId));
    for (const Entry& entry : m_document.scene().items) {
        if (m_selection.contains(entry.id))
            show(m_model->indexOf(entry.id));
        if (std::get_if<Part>(&entry.item))
            for (const Kind kind : {Kind::Particle, Kind::Link, Kind::Panel}) {
                const QModelIndex table = m_model->indexOfTable(entry.id, kind);
                const std::vector<Id> all = m_model->ids(table);
                if (!all.empty() && std::includes(ids.begin(), ids.end(), all.begin(), all.end()))
                    show(table);
            }
    }
    m_tree->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect
                                               | QItemSelectionModel::Rows);
    if (last.isValid())
        m_tree->scrollTo(last);
}

void Outline::search(const QString& text)
{
    m_filter->search(text);
    // Lists are open, parts are closed: their tables are many and say little.
    const bool isOfElement = OutlineFilter::idIn(text).has_value(); // its table is to be seen
    for (int row = 0; row < m_filter->rowCount(); ++row) {
        const QModelIndex list = m_filter->index(row, 0);
        m_tree->expand(list);
        for (int child = 0; isOfElement && child < m_filter->rowCount(list); ++child)
            m_tree->expand(m_filter->index(child, 0, list));
    }
    const QScopedValueRollback syncing(m_syncing, false);
    showSelection();
}

void Outline::takeSearch()
{
    const QString text = m_search->text().trimmed();
    bool isNumber = false;
    const uint number = QString(text).remove(QChar('#')).toUInt(&isNumber);
    if (isNumber && ripstop::find(m_document.scene(), Id{number})) {
        m_selection.set({Id{number}});
        return;
    }
    std::vector<Id> ids;
    for (int row = 0; row < m_filter->rowCount(); ++row) {
        const QModelIndex list = m_filter->index(row, 0);
        for (int child = 0; child < m_filter->rowCount(list); ++child)
            for (const Id id : m_model->ids(m_filter->mapToSource(m_filter->index(child, 0, list))))
                ids.push_back(id);
    }
    if (!text.isEmpty())
        m_selection.set(std::move(ids));
}

bool Outline::eventFilter(QObject* watched, QEvent* event)
{
    // Names come first: details get what they need, but no more than a third of the width.
    if (watched == m_tree && event->type() == QEvent::Resize)
        m_tree->header()->resizeSection(
            OutlineModel::Detail,
            std::min(detailWidth, static_cast<QResizeEvent*>(event)->size().width() / 3));
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (watched == m_tree && key == Qt::Key_Delete) {
            removeSelected();
            return true;
        }
        if (watched == m_search && key == Qt::Key_Escape && !m_search->text().isEmpty()) {
            m_search->clear();
            return true;
        }
        if (watched == m_search && key == Qt::Key_Down) {
            m_tree->setFocus();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace ripstop
