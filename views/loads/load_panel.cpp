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
        edited();
    });
    connect(&document, &Document::changed, this, edited);
    connect(m_materials, &QPushButton::clicked, this, &LoadPanel::selectUnjudged);
    connect(m_unjudged, &QLabel::linkActivated, this, &LoadPanel::selectUnjudged);
    connect(m_untearable, &QLabel::linkActivated, this, &LoadPanel::letTear);
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
    m_now->hideColumn(LoadList::Time);
    lists->setChildrenCollapsible(false);
    lists->setStretchFactor(0, 5); // it has no times
    lists->setStretchFactor(1, 6);
    for (QLabel* note : {m_unjudged, m_untearable, m_launch}) {
        note->setWordWrap(true);
        note->setMargin(4);
        note->setTextFormat(Qt::RichText);
        note->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    }
    m_unjudged->setToolTip(helpOfMaterials());
    m_untearable->setObjectName(QStringLiteral("untearable"));
    m_untearable->setToolTip(
        tr("Lets these materials tear by strength: cloth, lines and spars then "
           "break where their margin is 1."));
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(lists, 1);
    layout->addWidget(m_unjudged);
    layout->addWidget(m_untearable);
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

void LoadPanel::choose(quint32 element)
{
    m_selection.set({Id{element}});
    emit chosen(element);
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
}

// Whether what is seen is the design, and not a run nor a moment of one.
bool LoadPanel::isBeforeRun() const
{
    const Frame* shown = m_player.frame().get();
    return shown && !shown->underWay && shown->run != m_run && !m_player.isLookingBack();
}

// Of the newest run, whether it is seen, looked back at or was reset: no recording keeps its own.
WorstPlaces LoadPanel::worstOfRun() const
{
    const Frame* shown = m_player.frame().get();
    return shown && (shown->run == m_run || isBeforeRun()) ? m_worst : WorstPlaces{};
}

void LoadPanel::refresh()
{
    const Frame* frame = m_player.frame().get();
    const WorstPlaces ofRun = worstOfRun();
    const bool isListed = frame && !(frame->worstNow.all().empty() && ofRun.all().empty());
    m_pages->setCurrentIndex(isListed ? 1 : 0);
    if (!isListed)
        return tellWhyNone(frame);
    if (!isVisible())
        return;
    m_now->showPlaces(m_document.scene(), frame->worstNow.all());
    m_ofRun->setTitle(isBeforeRun() ? tr("Of the last run") : tr("Worst of the run"));
    m_ofRun->showPlaces(m_document.scene(), ofRun.all());
    showLaunch(*frame, ofRun);
    if (std::exchange(m_isEdited, false)) {
        showUnjudged();
        showUntearable();
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
