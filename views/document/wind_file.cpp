#include "document/wind_file.h"

#include "document/document.h"
#include "document/words.h"
#include "io/wind_record.h"

#include <QFileDialog>

namespace ripstop {

std::optional<Result<NumberRows>> askWindRecord(QWidget* parent, const Document& document)
{
    const QString file = QFileDialog::getOpenFileName(
        parent, words("Read a measured wind"), QString::fromStdString(document.scene().folder.path),
        words("Tables (*.csv *.tsv *.txt);;All files (*)"));
    if (file.isEmpty())
        return std::nullopt;
    return windRecordOf(file.toStdString());
}

} // namespace ripstop
