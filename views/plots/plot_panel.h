#pragma once

#include "plots/chart.h"
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
class PlotPanel final : public QWidget
{
    Q_OBJECT

public:
    PlotPanel(Document& document, Player& player, QWidget* parent = nullptr);

    Chart& chart() { return *m_chart; }
    const History& history() const { return m_history; }

    void clear(); // forgets the samples until now; the run goes on

    // The curves that are drawn: a header with units, a row for each sample.
    void writeCsv(QIODevice& device) const;

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
    void drawSoon();
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
    std::optional<double> m_hovered; // s
    QTimer m_redraw;

    QStackedWidget* m_pages;
    QTreeWidget* m_list;
    QStackedWidget* m_chartPages;
    Chart* m_chart;
};

} // namespace ripstop
