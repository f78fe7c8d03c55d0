// The constructor makes the buttons, layOut() puts them into a tool bar above the strip, and
// connectButtons() ties each to Recordings. The menus of bookmarks and comparisons are filled each
// time they open, because their entries change with every run. refresh() enables, labels and
// measures everything after any change; words beside icons go first where the window is narrow.
#include "timeline/timeline.h"

#include "document/plain_text.h"
#include "document/recordings.h"
#include "document/words.h"
#include "icons/icon.h"
#include "timeline/difference_dialog.h"
#include "timeline/timeline_strip.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace ripstop {
namespace {

QString sizeText(std::size_t bytes)
{
    return QLocale().formattedDataSize(qint64(bytes), 1, QLocale::DataSizeSIFormat);
}

QString nameOf(const Recording& recording)
{
    const QString name = QString::fromStdString(recording.name());
    const QString origin = QString::fromStdString(recording.origin());
    return origin.isEmpty() ? name : Timeline::tr("%1, from %2").arg(name, origin);
}

} // namespace

Timeline::Timeline(Recordings& recordings, QWidget* parent)
    : QWidget(parent)
    , m_recordings(recordings)
    , m_runs(new QComboBox)
    , m_more(button("runMenu", "settings", tr("This run"), tr("Rename or remove the run")))
    , m_eventBack(button("eventBack", "event-back", tr("Previous event"),
                         tr("Back to the event before: a tear, an edit, a hand, a control")))
    , m_back(button("frameBack", "step-back", tr("A frame back"),
                    tr("One frame back; Shift and the left key in the timeline go ten")))
    , m_forward(button("frameForward", "step", tr("A frame on"), tr("One frame on")))
    , m_eventForward(
          button("eventForward", "event-next", tr("Next event"), tr("On to the next event")))
    , m_loop(button("loop", "loop", tr("Loop"), tr("Play a range again and again")))
    , m_bookmark(button("bookmark", "bookmark", tr("Bookmark"),
                        tr("Bookmark this moment, or go to one that has a bookmark")))
    , m_compare(button("compareRuns", "compare", tr("Compare"),
                       tr("Show another run at the same time as a ghost")))
    , m_continue(button("continueHere", "branch", tr("Continue from here"),
                        tr("Begin a new run at this moment, from the exact state and with the "
                           "design as it is now. The run that is shown is kept.")))
    , m_live(button("backToLive", "live", tr("Live"), tr("Back to the run as it stands now")))
    , m_where(new QLabel)
    , m_strip(new TimelineStrip(recordings, this))
{
    layOut();
    connectButtons();
    connect(&recordings, &Recordings::listChanged, this, &Timeline::fillRuns);
    for (const auto signal : {&Recordings::listChanged, &Recordings::grew, &Recordings::moved,
                              &Recordings::stateChanged})
        connect(&recordings, signal, this, &Timeline::refresh);
    fillRuns();
    refresh();
}

QToolButton* Timeline::button(const char* name, const char* iconName, const QString& text,
                              const QString& toolTip)
{
    auto* made = new QToolButton(this);
    made->setObjectName(QLatin1String(name));
    made->setIcon(icon(QLatin1String(iconName)));
    made->setText(text);
    made->setAccessibleName(text);
    made->setToolTip(toolTip);
    made->setIconSize({18, 18});
    made->setAutoRaise(true);
    return made;
}

void Timeline::layOut()
{
    m_runs->setObjectName(QStringLiteral("runs"));
    m_runs->setAccessibleName(tr("Run"));
    m_runs->setToolTip(tr("The runs that are kept"));
    m_runs->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_runs->setMinimumContentsLength(13);
    for (QToolButton* repeats : {m_back, m_forward})
        repeats->setAutoRepeat(true);
    for (QToolButton* menu : {m_more, m_loop, m_bookmark, m_compare})
        menu->setPopupMode(QToolButton::InstantPopup);
    m_where->setObjectName(QStringLiteral("where"));
    m_where->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_where->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);

    auto* row = new QToolBar; // what has no room goes into a menu at its end
    row->addWidget(m_runs);
    row->addWidget(m_more);
    row->addSeparator();
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_eventBack, m_back, m_forward, m_eventForward})
        row->addWidget(widget);
    row->addSeparator();
    for (QToolButton* widget : {m_live, m_continue, m_loop, m_bookmark, m_compare})
        row->addWidget(widget);
    row->addWidget(m_where);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(row);
    layout->addWidget(m_strip, 1);
}

// In a narrow window the words beside the icons are left out first.
void Timeline::resizeEvent(QResizeEvent* event)
{
    const auto style = isWide() ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly;
    for (QToolButton* worded : {m_continue, m_live})
        worded->setToolButtonStyle(style);
    refresh();
    QWidget::resizeEvent(event);
}

bool Timeline::isWide() const { return width() >= 50 * fontMetrics().averageCharWidth() + 500; }

void Timeline::connectButtons()
{
    using Way = Recordings::Way;
    connect(m_runs, &QComboBox::activated, this, [this](int index) {
        m_recordings.setCurrent(m_recordings.list()[std::size_t(index)]);
    });
    connect(m_eventBack, &QToolButton::clicked, this, [this] { m_recordings.toEvent(Way::Back); });
    connect(m_eventForward, &QToolButton::clicked, this,
            [this] { m_recordings.toEvent(Way::Forward); });
    connect(m_back, &QToolButton::clicked, this, [this] { m_recordings.move(-1); });
    connect(m_forward, &QToolButton::clicked, this, [this] { m_recordings.move(1); });
    connect(m_continue, &QToolButton::clicked, this, [this] {
        m_recordings.isComputing() ? m_recordings.cancel() : m_recordings.continueHere();
    });
    connect(m_live, &QToolButton::clicked, &m_recordings, &Recordings::backToLive);

    auto* run = new QMenu(m_more);
    run->addAction(tr("&Rename\u2026"), this, &Timeline::rename);
    run->addAction(icon(QStringLiteral("delete")), tr("Re&move this run"), this,
                   [this] { m_recordings.remove(m_recordings.current()); });
    m_more->setMenu(run);

    auto* loop = new QMenu(m_loop);
    loop->addAction(tr("From &here on"), this, &Timeline::loopFromHere);
    loop->addAction(tr("Up &to here"), this, &Timeline::loopToHere);
    loop->addAction(tr("&No loop"), this, [this] { m_recordings.setLoop({}); });
    m_loop->setMenu(loop);

    for (QToolButton* filled : {m_bookmark, m_compare})
        filled->setMenu(new QMenu(filled));
    connect(m_bookmark->menu(), &QMenu::aboutToShow, this, &Timeline::fillBookmarks);
    connect(m_compare->menu(), &QMenu::aboutToShow, this, &Timeline::fillCompare);
}

void Timeline::fillRuns()
{
    const QSignalBlocker quiet(m_runs);
    m_runs->clear();
    const auto& list = m_recordings.list();
    for (const auto& recording : list) {
        m_runs->addItem(nameOf(*recording));
        m_runs->setItemData(m_runs->count() - 1, shownAsIs(nameOf(*recording)), Qt::ToolTipRole);
        if (recording == m_recordings.current())
            m_runs->setCurrentIndex(m_runs->count() - 1);
    }
    if (list.empty())
        m_runs->setPlaceholderText(tr("No run yet"));
}

void Timeline::fillBookmarks()
{
    QMenu* menu = m_bookmark->menu();
    menu->clear();
    menu->addAction(tr("Book&mark this moment\u2026"), this, &Timeline::askForBookmark);
    const auto& recording = m_recordings.current();
    if (!recording || recording->bookmarks().empty())
        return;
    menu->addSeparator();
    QMenu* removal = nullptr;
    const std::vector<Bookmark> bookmarks = recording->bookmarks();
    for (const Bookmark& bookmark : bookmarks)
        menu->addAction(tr("%1 s  %2")
                            .arg(QLocale().toString(bookmark.time, 'f', 3),
                                 inMenu(QString::fromStdString(bookmark.name))),
                        this, [this, time = bookmark.time] { m_recordings.seekTime(time); });
    menu->addSeparator();
    removal = menu->addMenu(tr("&Remove a bookmark"));
    for (std::size_t i = 0; i < bookmarks.size(); ++i)
        removal->addAction(inMenu(QString::fromStdString(bookmarks[i].name)), this,
                           [this, i] { m_recordings.removeBookmark(i); });
}

void Timeline::fillCompare()
{
    QMenu* menu = m_compare->menu();
    menu->clear();
    for (const auto& recording : m_recordings.list()) {
        if (recording == m_recordings.current())
            continue;
        QAction* action = menu->addAction(inMenu(nameOf(*recording)), this,
                                          [this, recording] { m_recordings.setGhost(recording); });
        action->setCheckable(true);
        action->setChecked(recording == m_recordings.ghost());
    }
    if (menu->isEmpty())
        menu->addAction(tr("There is no other run yet: reset and play again, continue from here, "
                           "or open a recording"))
            ->setEnabled(false);
    menu->addSeparator();
    QAction* difference =
        menu->addAction(tr("&Plot the difference"), this, &Timeline::plotDifference);
    QAction* none =
        menu->addAction(tr("&No ghost"), this, [this] { m_recordings.setGhost(nullptr); });
    for (QAction* ofGhost : {difference, none})
        ofGhost->setEnabled(m_recordings.ghost() != nullptr);
}

void Timeline::askWhatToCompare() { m_compare->showMenu(); }

void Timeline::plotDifference()
{
    // the dialog deletes itself when it is closed
    auto* dialog = new DifferenceDialog(m_recordings.current(), m_recordings.ghost(), window());
    connect(dialog, &DifferenceDialog::picked, &m_recordings, &Recordings::seekTime);
    dialog->show();
}

void Timeline::askForBookmark()
{
    bool given = false;
    const QString name =
        QInputDialog::getText(
            this, tr("Bookmark this moment"), tr("Name of the bookmark:"), QLineEdit::Normal,
            tr("%1 s").arg(QLocale().toString(m_recordings.time(), 'f', 2)), &given)
            .trimmed();
    if (given && !name.isEmpty())
        m_recordings.addBookmark(name);
}

void Timeline::rename()
{
    const auto recording = m_recordings.current();
    if (!recording)
        return;
    bool given = false;
    const QString name =
        QInputDialog::getText(this, tr("Rename the run"), tr("Name of the run:"), QLineEdit::Normal,
                              QString::fromStdString(recording->name()), &given)
            .trimmed();
    if (given && !name.isEmpty())
        m_recordings.rename(recording, name);
}

void Timeline::loopFromHere()
{
    const auto& recording = m_recordings.current();
    if (!recording || recording->frameCount() == 0)
        return;
    const double end = recording->timeOf(recording->frameCount() - 1);
    const double to = m_recordings.loop() ? m_recordings.loop()->to : end;
    const double here = m_recordings.time();
    m_recordings.setLoop(Recordings::Range{here, to > here ? to : end});
}

void Timeline::loopToHere()
{
    const auto& recording = m_recordings.current();
    if (!recording || recording->frameCount() == 0)
        return;
    const double start = recording->timeOf(0);
    const double from = m_recordings.loop() ? m_recordings.loop()->from : start;
    const double here = m_recordings.time();
    m_recordings.setLoop(Recordings::Range{from < here ? from : start, here});
}

void Timeline::refresh()
{
    const auto& recording = m_recordings.current();
    const std::size_t count = recording ? recording->frameCount() : 0;
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_eventBack, m_back, m_forward, m_eventForward, m_loop,
                                         m_bookmark, m_compare, m_more, m_continue})
        widget->setEnabled(count > 0);
    m_runs->setEnabled(recording != nullptr);
    m_live->setEnabled(m_recordings.isLookingBack());
    const bool computing = m_recordings.isComputing();
    m_continue->setText(computing ? tr("Cancel") : tr("Continue from here"));
    if (count == 0)
        return m_where->setText({});
    const auto size = recording->size();
    const QString trouble = translated(recording->trouble());
    const QString time = tr("%1 s").arg(QLocale().toString(m_recordings.time(), 'f', 3));
    const QString where = tr("%1 \u00b7 frame %2 of %3")
                              .arg(time, QLocale().toString(qulonglong(m_recordings.frame() + 1)),
                                   QLocale().toString(qulonglong(count)));
    m_where->setText((isWide() ? where : time)
                     + (trouble.isEmpty() ? QString() : tr(" \u00b7 full")));
    const QString kept =
        tr("In memory: %1, on disk: %2").arg(sizeText(size.memory), sizeText(size.disk));
    m_where->setToolTip(shownAsIs(where + '\n' + (trouble.isEmpty() ? kept : trouble)));
}

} // namespace ripstop
