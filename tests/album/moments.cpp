// Stages: the functions at the top make designs (a kite, one with faults) and the selections that
// actions are tried with. showEverything() walks the window through its moments, from the start
// page to a flown kite, and hands each to WindowWalk; comesByItself() makes the dialogs come that
// no action opens, by preparing files as a crash or another program would leave them. faultsOf()
// goes through the widgets of a window and lists in words what breaks a rule.
#include "album/moments.h"

#include "builders/builder.h"
#include "document/rescue.h"
#include "editor/tour.h"
#include "files/arrivals.h"
#include "files/kept_work.h"
#include "inspector/inspector.h"
#include "inspector/tuning_panel.h"
#include "io/scene_file.h"
#include "materials/presets.h"
#include "scene/property.h"
#include "select/select.h"
#include "study/narrow_box.h"
#include "study/study_panel.h"
#include "study/study_view.h"
#include "views/small_scenes.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QFileDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSlider>
#include <QStyleOptionComboBox>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QToolButton>

namespace ripstop {
namespace {

const QString samples = QStringLiteral(SCENES_DIR "/");

Scene kite() { return *build(*findBuilder("delta_kite"), {}); }

// A kite with a loose particle, a particle without mass, a link twice, and a step that is too long
// for its stiffness.
Scene faulty()
{
    Scene scene = kite();
    const auto entry = std::ranges::find_if(
        scene.items, [](const Entry& one) { return std::holds_alternative<Part>(one.item); });
    Part& part = std::get<Part>(entry->item);
    const Id from = part.particles[0].id, to = part.particles[1].id;
    part.particles.push_back({.id = scene.nextId, .position = Vec3(0, 30, 0), .mass = 0.1});
    scene.nextId = Id{std::uint32_t(scene.nextId) + 1};
    for (int i = 0; i < 2; ++i) {
        Link link = part.links.front();
        link.id = scene.nextId;
        link.from = from;
        link.to = to;
        part.links.push_back(link);
        scene.nextId = Id{std::uint32_t(scene.nextId) + 1};
    }
    part.particles[3].mass = 0.0;
    scene.settings.timeStep = 0.1;
    scene.settings.substeps = 1;
    return scene;
}

// Selections that let actions link, rope or fill: nothing, the first part, two particles, the edge
// of the fabric, a link, and a material.
std::vector<std::vector<Id>> selectionsOf(const Scene& scene)
{
    std::vector<std::vector<Id>> selections(1);
    const auto first = std::ranges::find_if(
        scene.items, [](const Entry& entry) { return std::holds_alternative<Part>(entry.item); });
    if (first == scene.items.end())
        return selections;
    const Part& part = std::get<Part>(first->item);
    selections.push_back({first->id});
    selections.push_back({part.particles.front().id, part.particles.back().id});
    selections.push_back(turnedInto(Kind::Particle, scene, boundary(scene, {})));
    selections.push_back({part.links.front().id});
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<Material>(entry.item)) {
            selections.push_back({entry.id});
            break;
        }
    return selections;
}

void open(WindowShop& shop, Scene scene)
{
    shop.window.show(); // after Quit
    for (Tour* tour : shop.window.findChildren<Tour*>())
        tour->close();
    shop.player.pause();
    shop.document.replace(std::move(scene));
    shop.window.showScene();
    shop.selection.set({});
    shop.player.reset();
    QTest::qWait(1);
}

// Shows one of each kind of thing in the inspector.
void inspector(WindowShop& shop, WindowWalk& walk)
{
    const Scene& scene = shop.document.scene();
    shop.window.docks().show("inspector");
    std::set<std::size_t> kinds;
    for (const Entry& entry : scene.items)
        if (kinds.insert(entry.item.index()).second) {
            shop.selection.set({entry.id});
            walk.window("inspector " + QString::fromStdString(nameOf(entry.item)));
        }
    forEachPart(scene, [&](Id, const Part& part) {
        if (part.particles.size() < 2 || part.panels.empty())
            return;
        const std::vector<std::pair<const char*, std::vector<Id>>> some{
            {"particle", {part.particles[0].id}},
            {"particles", {part.particles[0].id, part.particles[1].id}},
            {"link", {part.links[0].id}},
            {"panel", {part.panels[0].id}}};
        for (const auto& [name, ids] : some) {
            shop.selection.set(ids);
            walk.window(QStringLiteral("inspector one ") + name);
        }
    });
}

// Shows the usual sliders, and a part with targets beside what it weighs and measures.
void tuned(WindowShop& shop, WindowWalk& walk)
{
    shop.window.docks().show("tuning");
    shop.window.docks().panel<TuningPanel>().addUsual();
    QTest::qWait(1);
    walk.window("sliders");
    const Id part = selectionsOf(shop.document.scene())[1].front();
    for (const auto& [key, value] : {std::pair{"massTarget", 0.2}, {"areaTarget", 1.7}})
        shop.document.push(setValue(shop.document.scene(), part, key, value));
    shop.selection.set({part});
    shop.window.docks().show("inspector");
    walk.window("targets");
}

// A kite of real cloth: sliders with marks of the library, and a step to a lighter cloth. Then the
// paper's kite, whose sail is given a cloth that does nothing until its panels carry.
void ofTheTrade(WindowShop& shop, WindowWalk& walk)
{
    const auto selectMaterial = [&](std::string_view name) {
        for (const Entry& entry : shop.document.scene().items)
            if (const auto* material = std::get_if<Material>(&entry.item);
                material && material->name == name)
                shop.selection.set({entry.id});
    };
    open(shop, *build(*findBuilder("delta_kite"), {{"cloth", 1}, {"spars", 1}, {"cord", 1}}));
    shop.window.docks().show("tuning");
    shop.window.docks().panel<TuningPanel>().addUsual();
    QTest::qWait(1);
    walk.window("trade sliders");
    selectMaterial("sail");
    shop.window.docks().show("inspector");
    shop.window.actions()["lighter"]->trigger();
    QTest::qWait(1);
    walk.window("trade lighter");

    Scene paper = kite();
    for (Entry& entry : paper.items)
        if (auto* material = std::get_if<Material>(&entry.item);
            material && material->name == "sail")
            give(*material, **findPreset("ripstop_075"));
    open(shop, std::move(paper));
    selectMaterial("sail");
    QTest::qWait(1);
    walk.window("trade remedy");
    shop.window.docks().panel<Inspector>().sliders().toggle(
        propertyOf<&Material::membraneStiffness>(), shop.selection.ids());
    shop.window.docks().show("tuning");
    QTest::qWait(1);
    walk.window("trade remedy of a slider");
    shop.window.docks().show("inspector");
}

// A kite whose line tears or holds in gusts: the study when it is begun, its map with a flight that
// is chosen and watched, points that are drawn, and one variable alone.
void studied(WindowShop& shop, WindowWalk& walk)
{
    QTemporaryDir folder;
    const QString scene = folder.filePath("kite_in_gusts.ripstop.json");
    QFile::copy(samples + "kite_in_gusts.ripstop.json", scene);
    open(shop, Scene{});
    (void)shop.document.open(scene);
    shop.window.docks().show("study");
    auto& panel = shop.window.docks().panel<StudyPanel>();
    walk.window("study none");
    const auto fly = [&](const char* name, const char* variables, const char* plan) {
        QFile file(folder.filePath(QString("%1.ripstop-study.json").arg(name)));
        (void)file.open(QIODevice::WriteOnly);
        file.write(QString(R"({"format": "ripstop-study", "version": 1, "seconds": 2,
            "scene": "kite_in_gusts.ripstop.json", "untilTear": true, "variables": [%1],
            "plan": %2, "measures": [{"probe": "line tension", "reduction": "max"}]})")
                       .arg(variables, plan)
                       .toUtf8());
        file.close();
        panel.open(file.fileName());
        const auto rests = [&] { return panel.runner().task() == StudyRunner::Task::None; };
        (void)QTest::qWaitFor(rests, 20000);
        walk.window(QString("study %1 begun").arg(name));
        panel.run();
        (void)QTest::qWaitFor(
            [&] {
                return rests() && panel.runner().tally().flown == panel.runner().flights().size();
            },
            120'000);
        walk.window(QString("study %1").arg(name));
    };
    constexpr auto stiffness = R"({"name": "EA", "paths": ["line.axialStiffness"], "from": 1500,
        "to": 24000, "count": 4, "scale": "log"})";
    const QByteArray both = QByteArray(stiffness) + R"(, {"name": "strength",
        "paths": ["line.lineStrength"], "from": 40, "to": 120, "count": 5})";
    fly("one", stiffness, R"({"kind": "grid"})");
    fly("drawn", both, R"({"kind": "sobol", "count": 14})");
    fly("map", both, R"({"kind": "grid"})");
    panel.view().choose(9);
    walk.window("study chosen");
    emit panel.view().watchWanted(9);
    (void)QTest::qWaitFor([&] { return panel.runner().task() == StudyRunner::Task::None; }, 20000);
    walk.window("study watched");

    // several cells, and the pictures that share one selection
    const auto show = [&](const char* words) {
        for (QComboBox* box : panel.findChildren<QComboBox*>())
            if (const int place = box->findText(words); place >= 0) {
                box->setCurrentIndex(place);
                emit box->activated(place);
            }
    };
    panel.view().select({1, 7, 13, 19});
    walk.window("study several");
    emit panel.view().compareWanted(panel.view().selected());
    (void)QTest::qWaitFor([&] { return panel.view().curves().isVisible(); }, 20000);
    walk.window("study compared");
    show("ghosts side by side");
    walk.window("study beside");
    emit panel.view().curves().closed();
    for (const char* picture : {"Percentiles", "Parallel axes", "Scatter matrix", "Table"}) {
        show(picture);
        walk.window(QString("study picture %1").arg(picture));
    }
    show("Map");
}

} // namespace

void showStudies(WindowShop& shop, const WindowWalk::Look& look)
{
    WindowWalk walk(shop, look);
    studied(shop, walk);
}

namespace {

void comesByItself(WindowShop& shop, WindowWalk& walk)
{
    QTemporaryDir folder;
    const auto copyTo = [&](const char* name) {
        const RescuePlace place{folder.path(), name};
        (void)saveScene(kite(), std::filesystem::path(place.scene().toStdU16String()));
        QFile about(place.about());
        (void)about.open(QIODevice::WriteOnly);
        about.write(QString("{\"title\": \"%1\", \"file\": \"/home/me/kites/%1.ripstop.json\"}")
                        .arg(name)
                        .toUtf8());
    };
    copyTo("delta, second try");
    copyTo("untitled");
    walk.during("left behind", [&] { shop.window.keptWork().keepIn(folder.path()); });

    const QString file = folder.filePath("my kite.ripstop.json");
    open(shop, kite());
    (void)shop.document.save(file);
    shop.document.push(setValue(shop.document.scene(), settingsId, "title", std::string("Mine")));
    QFile other(file);
    (void)other.open(QIODevice::Append);
    other.write("\n");
    other.close();
    (void)other.open(QIODevice::ReadWrite);
    other.setFileTime(QDateTime::currentDateTime().addSecs(60), QFile::FileModificationTime);
    other.close();
    walk.during("changed on the disk", [&] { shop.window.files().lookAtDisk(); });
    walk.during("save over another", [&] { shop.window.files().save(); });
    walk.during("unsaved changes", [&] { shop.window.files().startNew(); });

    QFile broken(folder.filePath("broken.ripstop.json"));
    (void)broken.open(QIODevice::WriteOnly);
    broken.write("{\"format\": \"ripstop-scene\", ");
    broken.close();
    open(shop, kite());
    walk.during("broken file", [&] { shop.window.files().open(broken.fileName()); });

    QFile mesh(folder.filePath("sail.obj"));
    (void)mesh.open(QIODevice::WriteOnly);
    mesh.write("o sail\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 2\nf 1 2 3 4\nf 1 2 3\n");
    mesh.close();
    walk.during("import a mesh", [&] { shop.window.arrivals().importMesh(mesh.fileName()); });
}

bool isCutOff(const QWidget& widget, int needed)
{
    return widget.isVisible() && needed > widget.width() + 1;
}

// What is chosen can be read whole, unless the box itself shortens it and tells the rest.
bool isCutOff(const QComboBox& box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.editable = box.isEditable();
    const QRect room = box.style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                   QStyle::SC_ComboBoxEditField, &box);
    const int icon = box.itemIcon(box.currentIndex()).isNull() ? 0 : box.iconSize().width() + 4;
    return !qobject_cast<const NarrowBox*>(&box) && !box.isEditable()
           && box.fontMetrics().horizontalAdvance(box.currentText()) + icon > room.width();
}

QString wordsOn(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        return label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return button->text().isEmpty() ? button->toolTip() : button->text();
    return widget.objectName();
}

bool takesInput(const QWidget& widget)
{
    return qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QComboBox*>(&widget)
           || qobject_cast<const QAbstractSpinBox*>(&widget)
           || qobject_cast<const QKeySequenceEdit*>(&widget)
           || qobject_cast<const QSlider*>(&widget) || qobject_cast<const QPlainTextEdit*>(&widget);
}

// A part of another input, as the line in a spin box, is named with it.
bool isNamed(const QWidget& widget, const QWidget& window)
{
    if (!widget.accessibleName().isEmpty())
        return true;
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->buddy() == &widget)
            return true;
    const QWidget* parent = widget.parentWidget();
    return parent && parent != &window && (takesInput(*parent) || widget.focusProxy())
           && isNamed(*parent, window);
}

} // namespace

void prepareViews()
{
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
}

void showEverything(WindowShop& shop, const WindowWalk::Look& look)
{
    QApplication::setQuitOnLastWindowClosed(false); // Quit is one of the actions
    WindowWalk walk(shop, look);
    walk.window("start page");
    open(shop, Scene{});
    walk.panels("empty");
    walk.tools("empty");
    open(shop, faulty());
    walk.panels("faulty");
    open(shop, kite());
    walk.panels("kite");
    inspector(shop, walk);
    walk.menus();
    walk.contextMenus();
    shop.selection.set(selectionsOf(shop.document.scene())[1]);
    walk.tools("kite");
    QTemporaryDir folder; // a file, as a scene without one asks to be saved
    const QString file = folder.filePath("delta_kite.ripstop.json");
    QFile::copy(samples + "delta_kite.ripstop.json", file);
    const auto reopen = [&] {
        open(shop, Scene{});
        (void)shop.document.open(file);
        QTest::qWait(1);
    };
    reopen();
    const auto selections = selectionsOf(shop.document.scene());
    walk.actions(selections, reopen);
    shop.run("tour");
    walk.window("tour");
    open(shop, kite());
    shop.player.playUntil(1.0);
    (void)QTest::qWaitFor(
        [&] { return !shop.player.isPlaying() && shop.player.frame()->time >= 1.0; }, 20000);
    walk.panels("flown");
    walk.during("adopt pose", [&] { shop.run("adoptPose"); });
    tuned(shop, walk);
    walk.tools("flown");
    ofTheTrade(shop, walk);
    studied(shop, walk);
    comesByItself(shop, walk);
}

QStringList faultsOf(const QWidget& window)
{
    QStringList faults;
    const QSize screen = QSize(1280, 800);
    if (window.isWindow() && qobject_cast<const QDialog*>(&window)
        && (window.width() > screen.width() || window.height() > screen.height()))
        faults << QString("is %1 x %2 pixels").arg(window.width()).arg(window.height());
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible())
            continue;
        const auto* label = qobject_cast<const QLabel*>(widget);
        const bool isPlain = label && !label->wordWrap() && label->pixmap().isNull();
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const auto* tool = qobject_cast<const QToolButton*>(widget);
        const bool isIcon = tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly;
        const bool hasText = (isPlain && !label->text().isEmpty())
                             || (button && !button->text().isEmpty() && !isIcon);
        if (hasText && isCutOff(*widget, widget->minimumSizeHint().width()))
            faults << QString("\"%1\" is cut off").arg(wordsOn(*widget));
        if (label && label->wordWrap()
            && label->heightForWidth(label->width()) > label->height() + 1)
            faults << QString("\"%1\" is cut off below").arg(wordsOn(*widget));
        if (const auto* box = qobject_cast<const QComboBox*>(widget); box && isCutOff(*box))
            faults << QString("the choice \"%1\" is cut off").arg(box->currentText());
        const bool isQts = qobject_cast<const QFileDialog*>(&window);
        if (!isQts && takesInput(*widget) && !isNamed(*widget, window))
            faults << QString("the input %1 %2 in %3 has no name")
                          .arg(widget->metaObject()->className(), widget->objectName(),
                               widget->parentWidget()->metaObject()->className());
        if (button && wordsOn(*widget).isEmpty() && widget->accessibleName().isEmpty()
            && widget->focusPolicy() != Qt::NoFocus)
            faults << QString("a button of %1 says nothing")
                          .arg(widget->parentWidget()->metaObject()->className());
    }
    return faults;
}

} // namespace ripstop
