// What the view of a study writes: pictures, and tables of curves.
#include "study/study_view.h"

#include "document/ask_file.h"
#include "document/document.h"
#include "document/words.h"
#include "io/whole_file.h"
#include "plots/chart_picture.h"
#include "study/columns_view.h"
#include "study/flight_curves.h"
#include "study/goal_chart.h"
#include "study/percentile_chart.h"
#include "study/study_chart.h"

#include <QFileInfo>
#include <QMessageBox>

namespace ripstop {

QCustomPlot* StudyView::shownPlot()
{
    switch (page()) {
    case Page::Map:
        return &m_chart->plot();
    case Page::Percentiles:
        return &m_bands->plot();
    case Page::Columns:
        return m_columns->plot();
    case Page::Goals:
        return &m_goals->plot();
    case Page::Designs:
        return nullptr;
    }
    return nullptr;
}

bool StudyView::writePicture(QCustomPlot& plot, const QString& file)
{
    const bool isWritten = savePicture(plot, file);
    if (isWritten)
        emit said(tr("Saved %1").arg(QFileInfo(file).fileName()));
    else
        QMessageBox::warning(this, tr("Cannot save the picture"),
                             tr("%1 cannot be written.").arg(file));
    return isWritten;
}

void StudyView::saveCurvesAs()
{
    const QString file =
        askWhereToSave(this, tr("Save the curves"), QStringLiteral("curves.svg"),
                       tr("Pictures (*.svg *.pdf *.png);;Tables (*.csv)"), QStringLiteral("svg"));
    if (file.isEmpty())
        return;
    if (!file.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        writePicture(m_curves->plot(), file);
        return;
    }
    if (const auto failure = replaceFile(pathOf(file), m_curves->table(), Flush::ToDisk))
        QMessageBox::warning(this, tr("Cannot save the table"), translated(failure->message));
    else
        emit said(tr("Saved %1").arg(QFileInfo(file).fileName()));
}

void StudyView::savePictureAs()
{
    const QString file = askWhereToSave(this, tr("Save the picture"), QStringLiteral("study.svg"),
                                        tr("Pictures (*.svg *.pdf *.png)"), QStringLiteral("svg"));
    if (file.isEmpty())
        return;
    writePicture(*shownPlot(), file);
}

} // namespace ripstop
