// The constructor puts a banner above two columns: at the side what can be begun (new, open,
// import, the tour, recent files, builders), and beside it the cards of the samples. Samples and
// builders are read once, when the page is made; setRecent() fills the list of files anew each
// time. Builders of obstacles are left out, because nothing of theirs moves.
#include "start/start_page.h"

#include "builders/builder.h"
#include "document/plain_text.h"
#include "document/words.h"
#include "icons/icon.h"
#include "start/card.h"
#include "start/card_grid.h"
#include "start/samples.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace ripstop {
namespace {

constexpr int sideWidth = 240; // px
constexpr int mostRecent = 8;

QLabel* heading(const QString& text)
{
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setWeight(QFont::DemiBold);
    font.setPointSizeF(1.15 * font.pointSizeF());
    label->setFont(font);
    return label;
}

// A line of text that can be clicked.
QToolButton* entry(const QString& text, const QString& iconName, const QString& toolTip)
{
    auto* button = new QToolButton;
    button->setText(text);
    button->setIcon(icon(iconName));
    button->setIconSize({18, 18});
    button->setToolTip(toolTip);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent)
{
    auto* page = new QWidget;
    auto* columns = new QHBoxLayout;
    columns->setSpacing(28);
    columns->addWidget(side());
    columns->addWidget(samples(), 1);
    auto* content = new QVBoxLayout(page);
    content->setContentsMargins(28, 22, 28, 22);
    content->setSpacing(18);
    content->addWidget(banner());
    content->addLayout(columns, 1);

    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(page);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(area);
    setRecent({});
}

QWidget* StartPage::banner()
{
    auto* picture = new QLabel;
    picture->setPixmap(applicationIcon().pixmap(QSize(48, 48), devicePixelRatioF()));
    auto* name = new QLabel(tr("Ripstop"));
    QFont large = name->font();
    large.setPointSizeF(2.0 * large.pointSizeF());
    large.setWeight(QFont::DemiBold);
    name->setFont(large);
    auto* line = new QLabel(tr("Fabric that flies: kites, hang gliders, parachutes, cloth."));
    line->setForegroundRole(QPalette::PlaceholderText);

    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(name);
    words->addWidget(line);
    auto* whole = new QWidget;
    auto* layout = new QHBoxLayout(whole);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(14);
    layout->addWidget(picture);
    layout->addLayout(words);
    layout->addStretch(1);
    return whole;
}

QWidget* StartPage::side()
{
    auto* newScene = new QPushButton(icon(QStringLiteral("new")), tr("New scene"));
    newScene->setObjectName(QStringLiteral("new"));
    newScene->setToolTip(tr("An empty scene, to draw or import into"));
    auto* open = new QPushButton(icon(QStringLiteral("open")), tr("Open\u2026"));
    open->setObjectName(QStringLiteral("open"));
    open->setToolTip(tr("A scene from a file"));
    auto* import = new QPushButton(icon(QStringLiteral("import")), tr("Import\u2026"));
    import->setObjectName(QStringLiteral("import"));
    import->setToolTip(tr("Fabric from a mesh: OBJ, STL, PLY, OFF, glTF, Collada, VTP or VTU"));
    QToolButton* tour = entry(tr("New here? Take the tour"), QStringLiteral("manual"),
                              tr("What the parts of the window are for, in a minute"));
    tour->setObjectName(QStringLiteral("tour"));
    connect(tour, &QToolButton::clicked, this, &StartPage::tourRequested);
    connect(import, &QPushButton::clicked, this, &StartPage::importRequested);
    connect(newScene, &QPushButton::clicked, this, &StartPage::newRequested);
    connect(open, &QPushButton::clicked, this, &StartPage::browseRequested);

    m_noRecent = new QLabel(tr("Files that you open will be listed here."));
    m_noRecent->setForegroundRole(QPalette::PlaceholderText);
    m_noRecent->setWordWrap(true);
    m_recent = new QVBoxLayout;
    m_recent->setSpacing(1);

    auto* whole = new QWidget;
    whole->setFixedWidth(sideWidth);
    auto* layout = new QVBoxLayout(whole);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(newScene);
    layout->addWidget(open);
    layout->addWidget(import);
    layout->addWidget(tour);
    layout->addSpacing(14);
    layout->addWidget(heading(tr("Recent")));
    layout->addWidget(m_noRecent);
    layout->addLayout(m_recent);
    layout->addSpacing(14);
    layout->addWidget(heading(tr("Build")));
    layout->addWidget(builders());
    layout->addStretch(1);
    return whole;
}

QWidget* StartPage::builders()
{
    auto* whole = new QWidget;
    auto* layout = new QVBoxLayout(whole);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    for (const Builder& builder : allBuilders()) {
        if (builder.family == Family::Obstacles)
            continue; // a scene of obstacles alone has nothing that moves
        const QString name = QString::fromUtf8(builder.name.data(), qsizetype(builder.name.size()));
        QToolButton* button = entry(translated(builder.label) + QStringLiteral("\u2026"),
                                    QStringLiteral("builder"), translated(builder.help));
        button->setObjectName(QStringLiteral("build ") + name);
        connect(button, &QToolButton::clicked, this, [this, name] { emit builderRequested(name); });
        layout->addWidget(button);
    }
    return whole;
}

Card* StartPage::card(const QString& file, const QString& sentence)
{
    const Sample sample = readSample(file);
    auto* card = new Card(translated(sample.title.toStdString()),
                          sentence.isEmpty() ? translated(sample.note.toStdString()) : sentence,
                          pictureOf(sample), QStringLiteral("part"));
    card->setObjectName(QStringLiteral("sample ") + sample.name);
    connect(card, &Card::clicked, this, [this, file] { emit openRequested(file); });
    return card;
}

// What shows best what the program is for comes first, each with what one will see and may tune.
QWidget* StartPage::samples()
{
    const std::pair<const char*, QString> impressive[]{
        {"kite_in_gusts", tr("A ripstop kite rides gusts. Tune the strength of its line until it "
                             "snaps.")},
        {"last_gust", tr("A gust tears a big delta. Tune the joint efficiency of its border until "
                         "it holds.")},
        {"nylon_parachute", tr("Folded nylon fills with air. Tune the strength of the cords that "
                               "brake it.")},
        {"dacron_glider", tr("Dacron on aluminium, and you steer. Tune how stiff its tubes are.")},
        {"tearing_sheet", tr("A slit runs across ripstop. Tune the strength of the cloth, and when "
                             "it runs.")},
        {"flag", tr("Cloth flutters in 8 m/s of wind. Tune the wind, and how much the cloth "
                    "weighs.")}};
    const QStringList files = sampleFiles();
    auto* first = new CardGrid;
    QStringList others = files;
    for (const auto& [name, sentence] : impressive)
        for (const QString& file : files)
            if (QFileInfo(file).baseName() == QLatin1String(name)) {
                first->add(card(file, sentence));
                others.removeOne(file);
            }
    auto* more = new CardGrid;
    for (const QString& file : std::as_const(others))
        more->add(card(file));

    auto* whole = new QWidget;
    auto* layout = new QVBoxLayout(whole);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(heading(tr("Begin with")));
    layout->addWidget(first);
    layout->addSpacing(14);
    layout->addWidget(heading(tr("More samples")));
    layout->addWidget(more);
    if (files.isEmpty()) {
        auto* none = new QLabel(tr("The folder \"scenes\" with the samples is not beside the "
                                   "program. The designs can still be built, at the left."));
        none->setForegroundRole(QPalette::PlaceholderText);
        none->setWordWrap(true);
        layout->addWidget(none);
    }
    layout->addStretch(1);
    return whole;
}

void StartPage::setRecent(const QStringList& files)
{
    while (QLayoutItem* old = m_recent->takeAt(0)) {
        delete old->widget();
        delete old;
    }
    for (const QString& file : files.mid(0, mostRecent)) {
        QToolButton* button =
            entry(inMenu(QFileInfo(file).fileName().remove(QStringLiteral(".ripstop.json"))),
                  QStringLiteral("recent"), shownAsIs(QDir::toNativeSeparators(file)));
        button->setObjectName(QStringLiteral("recent ") + file);
        button->setEnabled(QFileInfo::exists(file));
        if (!button->isEnabled())
            button->setToolTip(shownAsIs(tr("%1 is gone.").arg(QDir::toNativeSeparators(file))));
        connect(button, &QToolButton::clicked, this, [this, file] { emit openRequested(file); });
        m_recent->addWidget(button);
    }
    m_noRecent->setVisible(files.isEmpty());
}

} // namespace ripstop
