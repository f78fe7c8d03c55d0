// Numbers and words of a row first, then the columns, then the rows as they are filled.
#include "loads/load_list.h"

#include "document/place_words.h"
#include "document/plain_text.h"
#include "document/spoken.h"
#include "document/words.h"
#include "icons/tinted.h"
#include "scene/property.h"
#include "scene/scene.h"

#include <QHeaderView>

#include <algorithm>

namespace ripstop {
namespace {

constexpr double nearBreaking = 0.8; // 1, from where on a margin has a sign

constexpr double rounding = 1e-6; // 1, of a margin: what lies at rest bears no more

constexpr int digits = 3; // which is more than is known of what breaks

// Far from breaking, digits tell nothing, and would take the room of names.
QString marginText(double margin)
{
    constexpr double least = 0.001;
    return margin < least ? QStringLiteral("< ") + spokenText(least, {}, digits)
                          : spokenText(margin, {}, digits);
}

QString amount(double value, LoadKind kind) { return spokenText(value, unitOf(kind), digits); }

QString loadWords(LoadKind kind)
{
    switch (kind) {
    case LoadKind::Line:
        return LoadList::tr("Pull along it");
    case LoadKind::Thread:
        return LoadList::tr("Pull of the thread over the width of cloth that it stands for");
    case LoadKind::Cloth:
        return LoadList::tr("Pull per width of the threads, warp or weft, that are nearer to their "
                            "strength");
    case LoadKind::Spar:
        return LoadList::tr("Bending moment of the spar beside this link");
    }
    return {};
}

QString helpOfLoad(const LoadedPlace& place)
{
    const QString words = loadWords(place.kind);
    if (!(place.strength > 0.0))
        return words;
    const QString help =
        LoadList::tr("%1. It can bear %2.").arg(words, amount(place.strength, place.kind));
    return place.isAtLeast()
               ? LoadList::tr("%1 It came in a blow, of which the time steps took much: without "
                              "that it would be about %2 higher.")
                     .arg(help, spokenText(100.0 * place.shortfall, "%", digits))
               : help;
}

QIcon signOf(double margin)
{
    if (margin >= 1.0)
        return tinted(QStringLiteral("error"), QColor(0xd6, 0x3b, 0x3b));
    if (margin >= nearBreaking)
        return tinted(QStringLiteral("warning"), QColor(0xd9, 0x8e, 0x1f));
    return tinted(QStringLiteral("ok"), QColor(0x3c, 0x9a, 0x5f));
}

} // namespace

LoadList::LoadList(const QString& title, const QString& name, QWidget* parent)
    : QTreeWidget(parent)
{
    setColumnCount(5);
    setHeaderLabels({tr("Margin"), title, tr("Load"), tr("Can bear"), tr("Time")});
    headerItem()->setToolTip(Margin, tr("Load over strength: 1 breaks."));
    headerItem()->setToolTip(Strength,
                             tr("What it tears at, or else the strength of the material times its "
                                "joint efficiency; over the safety factor of the scene."));
    setAccessibleName(name);
    setRootIsDecorated(false);
    setFrameShape(NoFrame);
    setSelectionMode(SingleSelection);
    setUniformRowHeights(true);
    setTextElideMode(Qt::ElideMiddle); // the number in the end tells one from the other
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(Place, QHeaderView::Stretch);
    const auto choose = [this](QTreeWidgetItem* item) {
        emit chosen(m_places[std::size_t(indexOfTopLevelItem(item))]);
    };
    connect(this, &QTreeWidget::itemClicked, this, choose);
    connect(this, &QTreeWidget::itemActivated, this, choose);
}

void LoadList::setTitle(const QString& title) { headerItem()->setText(Place, title); }

void LoadList::showPlaces(const Scene& scene, std::span<const LoadedPlace> places)
{
    const QList<QTreeWidgetItem*> marked = selectedItems();
    const quint32 held = marked.isEmpty() ? 0 : marked[0]->data(Place, Qt::UserRole).toUInt();
    const auto end = std::ranges::find_if( // the worst come first
        places, [](const LoadedPlace& place) { return !place.torn && place.margin() < rounding; });
    places = places.first(std::size_t(end - places.begin()));
    m_places.assign(places.begin(), places.end());
    int torn = 0; // so far
    while (topLevelItemCount() > int(places.size()))
        delete takeTopLevelItem(topLevelItemCount() - 1);
    while (topLevelItemCount() < int(places.size()))
        new QTreeWidgetItem(this);
    for (int row = 0; row < int(places.size()); ++row) {
        const LoadedPlace& place = places[std::size_t(row)];
        QTreeWidgetItem& item = *topLevelItem(row);
        const bool isJudged = place.strength > 0.0;
        item.setText(Margin, isJudged ? marginText(place.margin()) : QString());
        item.setIcon(Margin, signOf(isJudged && !place.torn ? place.margin() : 1.0));
        const QString words = placeWords(scene, Id{place.element});
        item.setText(Place, place.torn ? tr("%1. %2: torn").arg(++torn).arg(words) : words);
        item.setData(Place, Qt::UserRole, place.element);
        item.setSelected(held != 0 && place.element == held);
        const QString whole = describe(scene, {Id{place.element}});
        item.setToolTip(Place, shownAsIs(item.text(Place) + QChar('\n') + whole));
        item.setText(Load, (place.isAtLeast() ? QStringLiteral("\u2265 ") : QString())
                               + amount(place.load, place.kind));
        item.setToolTip(Load, helpOfLoad(place));
        item.setText(Strength, isJudged ? amount(place.strength, place.kind) : QString());
        item.setText(Time, spokenText(place.time, "s"));
        for (const Column column : {Margin, Load, Strength, Time})
            item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    makeRoomForPlaces();
    scheduleDelayedItemsLayout(); // columns follow longer numbers only when rows are laid out
}

// By the widest of all, so that a column does not come and go with the places of a run, nor with
// the run.
void LoadList::makeRoomForPlaces()
{
    if (topLevelItemCount() == 0)
        return;
    const auto width = [this](Column column) {
        return isColumnHidden(column)
                   ? 0
                   : std::max(sizeHintForColumn(column), header()->sectionSizeHint(column));
    };
    m_widestPlace = std::max(m_widestPlace, width(Place));
    m_widestStrength = std::max(m_widestStrength, width(Strength));
    const int all = width(Margin) + m_widestPlace + width(Load) + m_widestStrength + width(Time);
    setColumnHidden(Strength, all > viewport()->width());
}

void LoadList::resizeEvent(QResizeEvent* event)
{
    QTreeWidget::resizeEvent(event);
    makeRoomForPlaces();
}

} // namespace ripstop
