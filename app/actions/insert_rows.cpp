// Stages: a row for each builder comes from the table of builders, with a line between families,
// so that a new builder needs nothing here; then rows for what else a design is made of, as the
// outline adds it. Shop holds the two actions on a part that a builder made: building it again with
// other parameters, and detaching it, for which it first says what is lost.
#include "actions/menu_rows.h"

#include "actions/workbench.h"
#include "author/rebuild.h"
#include "builders/builder.h"
#include "dialogs/builder_dialog.h"
#include "docks/docks.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "document/selection.h"
#include "document/words.h"
#include "files/arrivals.h"
#include "outline/outline.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"

#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>

namespace ripstop {
namespace {

// "insert delta_kite", which lives as long as the program.
const char* idOf(std::size_t builder)
{
    static const std::vector<std::string> ids = [] {
        std::vector<std::string> all;
        for (const Builder& one : allBuilders())
            all.push_back("insert " + std::string(one.name));
        return all;
    }();
    return ids[builder].c_str();
}

// What is done to parts that a builder made.
class Shop
{
public:
    explicit Shop(const Workbench& bench)
        : m_document(bench.document)
        , m_selection(bench.selection)
        , m_viewport(bench.viewport)
        , m_window(bench.window)
    {}

    void changeParameters() const
    {
        const std::vector<Id> parts = builtParts(m_document.scene(), m_selection.ids());
        if (parts.size() != 1)
            return say(parts.empty() ? tr("Nothing of a builder is selected: parts that "
                                          "were drawn, imported or detached have no "
                                          "parameters.")
                                     : tr("Select one part only."));
        const Part& part = *findItem<Part>(m_document.scene(), parts.front());
        TransformTool& shaping = m_viewport.transformTool();
        BuilderDialog dialog(QString::fromStdString(part.builder),
                             {.document = m_document,
                              .selection = m_selection,
                              .focus = m_viewport.camera().focus,
                              .part = parts.front(),
                              .showsRun = !shaping.isAtDesign()},
                             &m_window);
        // a part with another mesh has no place in a run, whose particles it shares only in part
        QObject::connect(&dialog, &BuilderDialog::agreed, &dialog,
                         [&shaping] { shaping.goToDesign(); });
        dialog.exec();
    }

    void detach() const
    {
        const std::vector<Id> parts = builtParts(m_document.scene(), m_selection.ids());
        if (parts.empty())
            return say(tr("Nothing of a builder is selected."));
        QMessageBox box(QMessageBox::Question, tr("Detach from builder"), shownAsIs(lossOf(parts)),
                        QMessageBox::Ok | QMessageBox::Cancel, &m_window);
        box.button(QMessageBox::Ok)->setText(tr("Detach"));
        if (box.exec() == QMessageBox::Ok)
            m_document.push(detached(m_document.scene(), parts));
    }

private:
    void say(const QString& words) const { m_window.statusBar()->showMessage(words, 8000); }

    // "kite keeps its 75 particles ... It loses its 28 parameters: segments, height, ..."
    QString lossOf(const std::vector<Id>& parts) const
    {
        QStringList lines;
        for (const Id id : parts) {
            const Part& part = *findItem<Part>(m_document.scene(), id);
            QStringList labels;
            for (const Parameter& parameter : builderOf(part)->parameters)
                labels << choiceLabel(parameter.key).toLower();
            const int shown = 6;
            const QString some = labels.mid(0, shown).join(QStringLiteral(", "));
            lines << tr("%1 keeps its %2 and %3 as they are, with all that was changed by "
                        "hand.")
                         .arg(QString::fromStdString(part.name),
                              counted(Kind::Particle, qsizetype(part.particles.size())),
                              counted(Kind::Link, qsizetype(part.links.size())));
            lines << tr("It loses its %1 parameters (%2\u2026): they can no longer be "
                        "changed, and the mesh no finer or coarser.")
                         .arg(labels.size())
                         .arg(some);
        }
        lines << tr("Undo attaches it again.");
        return lines.join(QStringLiteral("\n\n"));
    }

    Document& m_document;
    Selection& m_selection;
    Viewport& m_viewport;
    QMainWindow& m_window;
};

} // namespace

MenuRows insertRows(const Workbench& bench)
{
    MenuRows rows;
    Arrivals& arrivals = bench.arrivals;
    for (std::size_t i = 0; i < allBuilders().size(); ++i) {
        const Builder& builder = allBuilders()[i];
        if (i > 0 && builder.family != allBuilders()[i - 1].family)
            rows.push_back(lineIn("&Insert"));
        const bool isObstacle = builder.family == Family::Obstacles;
        rows.push_back({"&Insert",
                        idOf(i),
                        translated(builder.label) + QChar(0x2026),
                        isObstacle ? "collider" : "builder",
                        {},
                        translated(builder.help),
                        [&arrivals, name = text(builder.name)] { arrivals.insert(name); }});
    }
    rows.push_back(lineIn("&Insert"));
    auto& outline = bench.docks.panel<Outline>();
    const auto add = [&outline](Kind kind) { return [&outline, kind] { outline.addNew(kind); }; };
    // clang-format off
    const MenuRows items{
        {"&Insert", "addWind",     tr("Wind"),     "wind",     {}, tr("Add a wind: the same everywhere, growing with the height, in gusts or as a jet."), add(Kind::Wind)},
        {"&Insert", "addControl",  tr("Control"),  "control",  {}, tr("Add a control, with which keys or a track move what is selected."), add(Kind::Control)},
        {"&Insert", "addProbe",    tr("Probe"),    "probe",    {}, tr("Add a probe, which measures what is selected while it flies."), add(Kind::Probe)},
        {"&Insert", "addPlot",     tr("Plot"),     "plot",     {}, tr("Add a plot of probes over time."), add(Kind::Plot)},
        {"&Insert", "addMaterial", tr("Material"), "material", {}, tr("Add a material, for panels and links."), add(Kind::Material)},
    };
    // clang-format on
    rows.insert(rows.end(), items.begin(), items.end());
    const Shop shop(bench);
    rows.push_back(lineIn("&Insert"));
    rows.push_back({"&Insert", "parameters", tr("Change &parameters\u2026"), "settings",
                    QKeySequence("Shift+B"),
                    tr("Build the selected part again with other parameters; it keeps its "
                       "place and what was tuned."),
                    [shop] { shop.changeParameters(); }, Toggle::No, nullptr, Needs::Selection});
    rows.push_back({"&Insert",
                    "detach",
                    tr("&Detach from builder\u2026"),
                    nullptr,
                    {},
                    tr("Keep the selected part as it is, to be shaped by hand only; says "
                       "what is lost."),
                    [shop] { shop.detach(); },
                    Toggle::No,
                    nullptr,
                    Needs::Selection});
    return rows;
}

} // namespace ripstop
