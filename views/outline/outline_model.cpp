// An index keeps what its parent is: nothing for a section, the row of the section for an item, the
// id of the part for a table; node() makes of it what the row stands for.
//
// data(), setData() and toggleShown() read from and write to the document. reset() takes the items
// of a new scene. follow() compares the ids with the scene after an edit that adds or removes
// items, and inserts and removes single rows; what rows say is announced as changed at most every
// 100 ms, as it may depend on any other thing.
#include "outline/outline_model.h"

#include "document/document.h"
#include "document/plain_text.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/icon.h"
#include "icons/swatch.h"
#include "outline/detail.h"

#include <QApplication>
#include <QPalette>

#include <algorithm>

namespace ripstop {
namespace {

// The rows at the top. Settings stand for themselves, the others hold all items of a kind.
constexpr std::array sections{Kind::Settings, Kind::Part,     Kind::Material,
                              Kind::Group,    Kind::Collider, Kind::Wind,
                              Kind::Control,  Kind::Probe,    Kind::Plot};
constexpr std::array tables{Kind::Particle, Kind::Link, Kind::Panel};

// An index keeps what its parent is: nothing, a section, or a part (by id, which does not shift).
constexpr quintptr top = 0;
constexpr quintptr partMark = quintptr(1) << 32;

constexpr int refreshInterval = 100; // ms

int sectionRow(Kind kind)
{
    return int(std::find(sections.begin(), sections.end(), kind) - sections.begin());
}

quintptr inSection(int row) { return quintptr(row) + 1; }
quintptr inPart(Id part) { return partMark | quintptr(part); }

Kind kindOfItem(const Item& item)
{
    return std::visit([](const auto& i) { return kindOf(ConstRef(&i)); }, item);
}

bool isStructural(const Change& change)
{
    return std::holds_alternative<AddItem>(change) || std::holds_alternative<RemoveItem>(change);
}

} // namespace

OutlineModel::OutlineModel(Document& document, Selection& selection, QObject* parent)
    : QAbstractItemModel(parent)
    , m_document(document)
    , m_selection(selection)
{
    connect(&document, &Document::replaced, this, &OutlineModel::reset);
    connect(&document, &Document::changed, this, &OutlineModel::follow);
    m_saysAgain.setSingleShot(true);
    m_saysAgain.setInterval(refreshInterval);
    connect(&m_saysAgain, &QTimer::timeout, this, &OutlineModel::sayAgain);
    reset();
}

OutlineModel::Node OutlineModel::node(const QModelIndex& index) const
{
    const quintptr place = index.internalId();
    if (place == top) {
        const Kind kind = sections[std::size_t(index.row())];
        if (kind == Kind::Settings)
            return {Node::Sort::Thing, kind, settingsId};
        return {Node::Sort::Section, kind, noId};
    }
    if (place & partMark)
        return {Node::Sort::Table, tables[std::size_t(index.row())], Id{std::uint32_t(place)}};
    const Kind kind = sections[place - 1];
    return {Node::Sort::Thing, kind, m_items[std::size_t(kind)][std::size_t(index.row())]};
}

std::vector<Id> OutlineModel::ids(const QModelIndex& index) const
{
    const Node n = node(index);
    if (n.sort == Node::Sort::Thing)
        return {n.id};
    if (n.sort == Node::Sort::Section)
        return m_items[std::size_t(n.kind)];
    const Part* part = findItem<Part>(m_document.scene(), n.id);
    return part ? rowIds(*part, n.kind) : std::vector<Id>();
}

QModelIndex OutlineModel::section(Kind kind) const { return createIndex(sectionRow(kind), 0, top); }

QModelIndex OutlineModel::indexOf(Id item) const
{
    if (item == settingsId)
        return section(Kind::Settings);
    for (const Kind kind : sections) {
        const auto& items = m_items[std::size_t(kind)];
        const auto found = std::find(items.begin(), items.end(), item);
        if (found != items.end())
            return index(int(found - items.begin()), 0, section(kind));
    }
    return {};
}

QModelIndex OutlineModel::indexOfTable(Id part, Kind kind) const
{
    const auto table = std::find(tables.begin(), tables.end(), kind);
    const QModelIndex parent = indexOf(part);
    return parent.isValid() ? index(int(table - tables.begin()), 0, parent) : QModelIndex();
}

QModelIndex OutlineModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    if (!parent.isValid())
        return createIndex(row, column, top);
    const Node n = node(parent);
    return createIndex(row, column,
                       n.sort == Node::Sort::Section ? inSection(parent.row()) : inPart(n.id));
}

QModelIndex OutlineModel::parent(const QModelIndex& child) const
{
    const quintptr place = child.internalId();
    if (place == top)
        return {};
    if (place & partMark)
        return indexOf(Id{std::uint32_t(place)});
    return createIndex(int(place) - 1, 0, top);
}

int OutlineModel::rowCount(const QModelIndex& parent) const
{
    if (!parent.isValid())
        return int(sections.size());
    if (parent.column() != 0)
        return 0;
    const Node n = node(parent);
    if (n.sort == Node::Sort::Section)
        return int(m_items[std::size_t(n.kind)].size());
    return n.sort == Node::Sort::Thing && n.kind == Kind::Part ? int(tables.size()) : 0;
}

Qt::ItemFlags OutlineModel::flags(const QModelIndex& index) const
{
    if (!index.isValid()) // views ask for the root too
        return Qt::NoItemFlags;
    Qt::ItemFlags result = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    const Node n = node(index);
    if (index.column() == Name && n.sort == Node::Sort::Thing && n.kind != Kind::Settings)
        result |= Qt::ItemIsEditable;
    return result;
}

QVariant OutlineModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Node n = node(index);
    const bool isThing = n.sort == Node::Sort::Thing;
    const Column column = Column(index.column());

    if (column == Name && (role == Qt::DisplayRole || role == Qt::EditRole))
        return isThing ? nameOf(m_document.scene(), n.id) : kindPluralLabel(n.kind);
    if (column == Detail && role == Qt::DisplayRole)
        return detail(n);
    if (column == Detail && role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (column == Detail && role == Qt::ForegroundRole)
        return QApplication::palette().brush(QPalette::PlaceholderText);
    if (column == Shown && role == Qt::DecorationRole && shownProperty(n))
        return icon(isShown(n) ? QStringLiteral("show") : QStringLiteral("hide"));
    if (column == Shown && role == Qt::ToolTipRole && shownProperty(n))
        return isShown(n) ? tr("Shown in the view; click to hide it.")
                          : tr("Hidden; click to show it in the view.");

    if (column == Name && role == Qt::DecorationRole) {
        if (const Material* material = findItem<Material>(m_document.scene(), n.id))
            return swatch(QColor(QString::fromStdString(material->color)));
        return icon(QString::fromUtf8(kindName(n.kind).data()));
    }
    if (column == Name && role == Qt::FontRole && n.sort == Node::Sort::Section) {
        QFont font = QApplication::font();
        font.setWeight(QFont::DemiBold);
        return font;
    }
    if (role == Qt::ToolTipRole && isThing && n.kind != Kind::Settings)
        return shownAsIs(tr("%1 %2, id %3")
                             .arg(kindLabel(n.kind), nameOf(m_document.scene(), n.id),
                                  QString::number(std::uint32_t(n.id))));
    return {};
}

bool OutlineModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!index.isValid())
        return false;
    const Node n = node(index);
    const QString name = value.toString().trimmed();
    const Property* property = findProperty(n.kind, Meaning::Name);
    if (role != Qt::EditRole || !property || name.isEmpty())
        return false;
    if (name != nameOf(m_document.scene(), n.id))
        m_document.push(
            {Message::verbatim(tr("Rename %1").arg(kindLabel(n.kind).toLower()).toStdString()),
             {SetValues{property, {n.id}, {name.toStdString()}}}});
    return true;
}

void OutlineModel::toggleShown(const QModelIndex& index)
{
    const Node n = node(index);
    if (const Property* property = shownProperty(n))
        m_document.push({Message::verbatim((isShown(n) ? tr("Hide %1") : tr("Show %1"))
                                               .arg(nameOf(m_document.scene(), n.id))
                                               .toStdString()),
                         {SetValues{property, {n.id}, {!isShown(n)}}}});
}

const Property* OutlineModel::shownProperty(const Node& node) const
{
    return node.sort == Node::Sort::Thing ? findProperty(node.kind, Meaning::Shown) : nullptr;
}

bool OutlineModel::isShown(const Node& node) const
{
    const auto ref = find(m_document.scene(), node.id);
    return ref && std::get<bool>(shownProperty(node)->get(*ref));
}

QString OutlineModel::detail(const Node& n) const
{
    if (n.sort == Node::Sort::Section) {
        const std::size_t count = m_items[std::size_t(n.kind)].size();
        return count == 0 ? QString() : QLocale().toString(qulonglong(count));
    }
    if (n.sort == Node::Sort::Table) {
        const Part* part = findItem<Part>(m_document.scene(), n.id);
        return part ? tableDetail(*part, n.kind, m_selection.ids()) : QString();
    }
    const Item* item = findItem(m_document.scene(), n.id);
    return item ? itemDetail(m_document.scene(), *item) : QString();
}

void OutlineModel::reset()
{
    beginResetModel();
    for (auto& items : m_items)
        items.clear();
    for (const Entry& entry : m_document.scene().items)
        m_items[std::size_t(kindOfItem(entry.item))].push_back(entry.id);
    endResetModel();
}

void OutlineModel::follow(const Edit& applied)
{
    if (std::any_of(applied.changes.begin(), applied.changes.end(), isStructural))
        for (const Kind kind : sections)
            followItems(kind);
    if (!m_saysAgain.isActive())
        m_saysAgain.start();
}

// Announces all rows as changed. What a row says may depend on any other thing (members, counts),
// and painting them all takes too long for each edit of a slider that is pulled.
void OutlineModel::sayAgain()
{
    const auto refresh = [this](const QModelIndex& parent) {
        if (const int rows = rowCount(parent); rows > 0)
            emit dataChanged(index(0, 0, parent), index(rows - 1, ColumnCount - 1, parent));
    };
    refresh({});
    for (const Kind kind : sections)
        refresh(section(kind));
    for (const Id part : m_items[std::size_t(Kind::Part)])
        refresh(indexOf(part));
}

// Removes the rows of items that are gone, then inserts those that have come, each at its place.
void OutlineModel::followItems(Kind kind)
{
    std::vector<Id> wanted;
    for (const Entry& entry : m_document.scene().items)
        if (kindOfItem(entry.item) == kind)
            wanted.push_back(entry.id);

    auto& items = m_items[std::size_t(kind)];
    const QModelIndex parent = section(kind);
    for (int row = int(items.size()) - 1; row >= 0; --row)
        if (std::find(wanted.begin(), wanted.end(), items[std::size_t(row)]) == wanted.end()) {
            beginRemoveRows(parent, row, row);
            items.erase(items.begin() + row);
            endRemoveRows();
        }
    for (int row = 0; row < int(wanted.size()); ++row)
        if (row >= int(items.size()) || items[std::size_t(row)] != wanted[std::size_t(row)]) {
            beginInsertRows(parent, row, row);
            items.insert(items.begin() + row, wanted[std::size_t(row)]);
            endInsertRows();
        }
}

} // namespace ripstop
