// A frame starts a timer unless it runs; refresh() shows the newest when it runs out, or says why
// there is nothing to show.
#include "loads/load_panel.h"

#include "check/strength_gaps.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "document/spoken.h"
#include "loads/load_list.h"
#include "run/has_margins.h"
#include "scene/property.h"

#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStackedLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ripstop {
namespace {

constexpr int pause = 200; // ms, between two looks; more cannot be read

QString helpOfMaterials()
{
    return LoadPanel::tr("Select these materials, so that the inspector shows their strengths.");
}

} // namespace

LoadPanel::LoadPanel(Document& document, Selection& selection, Player& player, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_player(player)
    , m_pages(new QStackedLayout(this))
    , m_empty(new QLabel)
    , m_materials(new QPushButton(tr("Select the materials")))
    , m_now(new LoadList(tr("Worst now"), tr("Worst places now")))
    , m_ofRun(new LoadList(tr("Worst of the run"), tr("Worst places of the run")))
    , m_unjudged(new QLabel)
    , m_untearable(new QLabel)
    , m_opening(new QLabel)
    , m_more(new QLabel)
    , m_launch(new QLabel)
{
    m_pages->addWidget(emptyPage());
    m_pages->addWidget(listPage());
    m_delay.setSingleShot(true);
    m_delay.setInterval(pause);
    connect(&m_delay, &QTimer::timeout, this, &LoadPanel::refresh);
    const auto soon = [this] {
        if (!m_delay.isActive())
            m_delay.start();
    };
    connect(&player, &Player::frameReady, this, &LoadPanel::noteWorst);
    connect(&player, &Player::frameReady, this, soon);
    connect(&player, &Player::stateChanged, this, soon);
    const auto edited = [this, soon] {
        m_isEdited = true;
        soon();
    };
    connect(&document, &Document::replaced, this, [this, edited] {
        m_worst = {}; // its places are those of another design
        m_firstBreaks.forget();
        m_breaks = 0;
        edited();
    });
    connect(&document, &Document::changed, this, edited);
    connect(m_materials, &QPushButton::clicked, this, &LoadPanel::selectUnjudged);
    connect(m_unjudged, &QLabel::linkActivated, this, &LoadPanel::selectUnjudged);
    connect(m_untearable, &QLabel::linkActivated, this, &LoadPanel::letTear);
    connect(m_opening, &QLabel::linkActivated, this, &LoadPanel::takeSafetyFactor);
    for (LoadList* list : {m_now, m_ofRun})
        connect(list, &LoadList::chosen, this, &LoadPanel::choose);
    refresh();
}

QWidget* LoadPanel::emptyPage()
{
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setWordWrap(true);
    m_materials->setToolTip(helpOfMaterials());
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->addStretch();
    layout->addWidget(m_empty);
    layout->addWidget(m_materials, 0, Qt::AlignHCenter);
    layout->addStretch();
    return page;
}

QWidget* LoadPanel::listPage()
{
    const QString help = tr("Click a place to select it and bring it to the middle of the view.");
    auto* lists = new QSplitter;
    for (LoadList* list : {m_now, m_ofRun}) {
        list->setToolTip(help);
        lists->addWidget(list);
    }
    m_ofRun->setToolTip(
        tr("%1 What has broken stands first, in the order in which it did; a click on it goes to "
           "that moment where it is recorded.")
            .arg(help));
    m_now->hideColumn(LoadList::Time);
    lists->setChildrenCollapsible(false);
    lists->setStretchFactor(0, 5); // it has no times
    lists->setStretchFactor(1, 6);
    for (QLabel* note : {m_more, m_unjudged, m_untearable, m_opening, m_launch}) {
        note->setWordWrap(true);
        note->setMargin(4);
        note->setTextFormat(Qt::RichText);
        note->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
        note->hide(); // takes no room before it has something to say
    }
    m_unjudged->setToolTip(helpOfMaterials());
    m_untearable->setObjectName(QStringLiteral("untearable"));
    m_untearable->setToolTip(
        tr("Lets these materials tear by strength: cloth, lines and spars then "
           "break where their margin is 1."));
    m_opening->setObjectName(QStringLiteral("opening"));
    m_opening->setToolTip(
        tr("The air in a canopy lacks what makes the opening shock, so that a real one may tear "
           "where this one holds. Margins count every strength as so many times lower; flights and "
           "tears stay as they are."));
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(lists, 1);
    layout->addWidget(m_more);
    layout->addWidget(m_unjudged);
    layout->addWidget(m_untearable);
    layout->addWidget(m_opening);
    layout->addWidget(m_launch);
    return page;
}

QString LoadPanel::said() const
{
    return m_pages->currentIndex() == 0 ? m_empty->text() : QString();
}

void LoadPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

void LoadPanel::choose(const LoadedPlace& place)
{
    m_selection.set({Id{place.element}});
    if (place.torn)
        emit breakChosen(m_run, place.time, place.place);
    else
        emit chosen(place.element);
}

void LoadPanel::catchUp()
{
    if (!m_delay.isActive())
        return;
    m_delay.stop();
    refresh();
}

void LoadPanel::noteWorst()
{
    const Frame* newest = m_player.newest().get();
    if (!newest || !newest->underWay)
        return;
    m_worst = newest->worstOfRun;
    m_run = newest->run;
    m_breaks = newest->tears.size();
    m_firstBreaks = newest->firstBreaks;
}

// Whether what is seen is the design, and not a run nor a moment of one.
bool LoadPanel::isBeforeRun() const
{
    const Frame* shown = m_player.frame().get();
    return shown && !shown->underWay && shown->run != m_run && !m_player.isLookingBack();
}

// Whether what is known of the newest run is what is seen of it, looked back at or was reset: no
// recording keeps its own.
bool LoadPanel::isOfRun() const
{
    const Frame* shown = m_player.frame().get();
    return shown && (shown->run == m_run || isBeforeRun());
}

WorstPlaces LoadPanel::worstOfRun() const { return isOfRun() ? m_worst : WorstPlaces{}; }

// What broke first may not be among the worst: of one material these are three, and what breaks by
// another rule has no strength. What an edit has taken away can no longer be gone to.
std::vector<LoadedPlace> LoadPanel::brokenOfRun(const WorstPlaces& worst) const
{
    std::vector<LoadedPlace> broken;
    for (const LoadedPlace& place : worst.all())
        if (place.torn)
            broken.push_back(place);
    if (isOfRun())
        for (const LoadedPlace& place : m_firstBreaks.all())
            if (ripstop::find(m_document.scene(), Id{place.element})
                && std::ranges::find(broken, place.element, &LoadedPlace::element) == broken.end())
                broken.push_back(place);
    std::ranges::stable_sort(broken, {}, &LoadedPlace::time);
    return broken;
}

std::vector<LoadedPlace> LoadPanel::placesOfRun(const WorstPlaces& worst) const
{
    std::vector<LoadedPlace> places = brokenOfRun(worst);
    std::ranges::copy_if(worst.all(), std::back_inserter(places),
                         [](const LoadedPlace& place) { return !place.torn; });
    return places;
}

void LoadPanel::refresh()
{
    const Frame* frame = m_player.frame().get();
    const WorstPlaces ofRun = worstOfRun();
    const std::vector<LoadedPlace> places = placesOfRun(ofRun);
    const bool isListed = frame && !(frame->worstNow.all().empty() && places.empty());
    m_pages->setCurrentIndex(isListed ? 1 : 0);
    if (!isListed)
        return tellWhyNone(frame);
    if (!isVisible())
        return;
    m_now->showPlaces(m_document.scene(), frame->worstNow.all());
    m_ofRun->setTitle(isBeforeRun() ? tr("Of the last run") : tr("Worst of the run"));
    m_ofRun->showPlaces(m_document.scene(), places);
    showMore(places.empty() && m_player.isLookingBack());
    showLaunch(*frame, ofRun);
    if (std::exchange(m_isEdited, false)) {
        showUnjudged();
        showUntearable();
        showOpening();
    }
}

QString LoadPanel::namesOf(const std::vector<Id>& materials) const
{
    QStringList names;
    for (const Id id : materials)
        names << (id == noId ? tr("what has no material")
                             : QString::fromStdString(nameOf(*findItem(m_document.scene(), id))));
    return names.join(QStringLiteral(", ")).toHtmlEscaped();
}

// A list says nothing of what it does not judge, and must not seem to.
void LoadPanel::showUnjudged()
{
    const std::vector<Id> without = materialsWithoutStrength(m_document.scene());
    m_unjudged->setVisible(!without.empty());
    m_unjudged->setText(tr("Not judged, without a strength: %1")
                            .arg(QStringLiteral("<a href=\"#\">%1</a>").arg(namesOf(without))));
}

// A margin above 1 tears nothing by itself, which nobody expects who sees it.
void LoadPanel::showUntearable()
{
    const std::vector<Id> holding = materialsThatNeverTear(m_document.scene());
    m_untearable->setVisible(!holding.empty());
    m_untearable->setText(
        tr("Never tears: %1. %2")
            .arg(namesOf(holding), QStringLiteral("<a href=\"#\">%1</a>")
                                       .arg(tr("Let it tear by its strength").toHtmlEscaped())));
}

void LoadPanel::showOpening()
{
    m_opening->setVisible(understatesOpening(m_document.scene()));
    const QString remedy =
        tr("Take a safety factor of %1").arg(spokenText(openingSafetyFactor, {}));
    m_opening->setText(
        tr("Loads of a canopy that opens are a third to two fifths below measured ones. %1")
            .arg(QStringLiteral("<a href=\"#\">%1</a>").arg(remedy.toHtmlEscaped())));
}

void LoadPanel::showMore(bool isUnknown)
{
    const bool isMore = isOfRun() && m_breaks > FirstBreaks::most;
    m_more->setVisible(isUnknown || isMore);
    if (isUnknown)
        m_more->setText(tr("A recording keeps no list of the worst of its run: fly the design to "
                           "have one."));
    else if (isMore)
        m_more->setText(
            tr("%1 places have broken: the list has those that broke first, and the worst "
               "of the others.")
                .arg(m_breaks));
}

// A kite that is let go at rest in full wind is jerked by a multiple of what a gust does later, and
// who looks for gusts would make it stronger for nothing.
void LoadPanel::showLaunch(const Frame& frame, const WorstPlaces& ofRun)
{
    constexpr double launch = 1.0; // s
    const auto& worst = ofRun.all();
    const bool isLaunch = !worst.empty() && worst.front().time < launch && frame.time > 2.0 * launch
                          && !frame.worstNow.all().empty()
                          && frame.worstNow.all().front().margin() < 0.5 * worst.front().margin();
    m_launch->setVisible(isLaunch);
    if (isLaunch)
        m_launch->setText(tr("The worst of the run is the launch, %1 after the start: what is let "
                             "go at rest is jerked.")
                              .arg(spokenText(worst.front().time, "s")));
}

void LoadPanel::letTear()
{
    m_document.push(
        {Message("Let it tear"),
         {SetValues{&propertyOf<&Material::tearRule>(),
                    materialsThatNeverTear(m_document.scene()),
                    {std::string(choiceNames<TearRule>[std::size_t(TearRule::Strength)])}}}});
}

void LoadPanel::takeSafetyFactor()
{
    m_document.push(
        {Message("Take a safety factor"),
         {SetValues{&propertyOf<&Settings::safetyFactor>(), {settingsId}, {openingSafetyFactor}}}});
}

void LoadPanel::tellWhyNone(const Frame* frame)
{
    const bool hasMaterial = std::ranges::any_of(m_document.scene().items, [](const Entry& entry) {
        return std::holds_alternative<Material>(entry.item);
    });
    const bool isBare = frame && !hasMargins(*frame);
    m_materials->setVisible(isBare && hasMaterial);
    m_empty->setText(
        !isBare ? tr("Nothing bears a load yet: run the scene.")
        : hasMaterial
            ? tr("No material here has a strength for what it carries, so that nothing can be said "
                 "to be near to breaking. Take a material of the library, or type a line strength, "
                 "a warp and weft strength, or a breaking moment in the inspector.")
            : tr("There is no material here whose strength could be compared with a load. Insert a "
                 "material of the library and give it to lines, cloth or spars."));
}

void LoadPanel::selectUnjudged()
{
    std::vector<Id> materials = materialsWithoutStrength(m_document.scene());
    std::erase(materials, noId);
    m_selection.set(materials);
}

} // namespace ripstop
