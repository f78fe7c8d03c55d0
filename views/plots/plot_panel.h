#pragma once

#include "plots/chart.h"
#include "plots/xy_chart.h"
#include "scene/scene.h"

#include <QTimer>

class QIODevice;
class QLabel;
class QMenu;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace ripstop {

class Document;
class Player;

// Live curves of the probes of the scene, one strip for each unit over a common time axis. A list
// at the side says which probes are drawn and what they read: now, or at the time under the mouse.
// The same curves against another probe, or their spectra, take the place of the strips on request.
// Runs that are over stay as thin curves until they are cleared.
class PlotPanel final : public QWidget
{
    Q_OBJECT

public:
    PlotPanel(Document& document, Player& player, QWidget* parent = nullptr);

    Chart& chart() { return *m_chart; }
    const History& history() const { return m_history; }

    void clear(); // forgets the samples until now; the run goes on
    const std::vector<EarlierRun>& earlier() const { return m_earlier; }
    void forgetEarlier();

    struct Way // to look at the curves
    {
        enum class Of { OverTime, Against, Spectra } of = Of::OverTime;
        Id across{}; // the other probe

        friend bool operator==(const Way&, const Way&) = default;
    };
    void setWay(const Way& way);
    const Way& way() const { return m_way; }
    XyChart& xyChart() { return *m_xy; }

    // The curves that are drawn: a header with units, a row for each sample.
    void writeCsv(QIODevice& device, char separator = ',') const;

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void layOut();
    void refresh(); // which probes there are
    void rebuildList();
    void rebuildCurves();
    void take(const std::shared_ptr<const Frame>& frame);
    void showPast(const Frame& frame);
    void draw();
    void drawXy();
    void drawSoon();
    void showPage();
    void keepRun();
    void addWays(QMenu& menu);
    void copyTable() const;
    QCustomPlot& plotInSight();
    void showValues();
    void tick(QTreeWidgetItem* item); // draws a probe, or not
    void showMenu(const QPoint& place);
    void saveCsv();
    void savePicture();
    QString suggestedFile(const char* suffix) const;
    QString unitOf(Id probe) const; // as the newest frame has it

    Document& m_document;
    Player& m_player;
    std::vector<Entry> m_probes;            // as the list shows them
    std::shared_ptr<const Layout> m_layout; // of the newest frame
    History m_history;
    std::vector<EarlierRun> m_earlier;
    int m_runs = 0; // that have been kept, for their names
    Way m_way;
    std::optional<double> m_hovered; // s
    QTimer m_redraw;

    QStackedWidget* m_pages;
    QTreeWidget* m_list;
    QStackedWidget* m_chartPages;
    Chart* m_chart;
    XyChart* m_xy;
};

} // namespace ripstop
