// Tells which digits of the probes hold (recording/certificate.h): a table of them, and a chart of
// the one that is selected, in a band of what it may be off by.
//
// It certifies the design as it is when the button is pressed, on threads of its own with a bar
// that can be cancelled; what was found stays until then. It lives on the thread of the window and
// deletes itself when it is closed. Dialogs::showCertify() opens it.
#pragma once

#include "recording/certificate.h"

#include <QDialog>

#include <memory>
#include <set>
#include <string>

class QLabel;
class QPushButton;
class QTableWidget;

namespace ripstop {

class BandChart;
class Document;
class ParameterField;
class Recording;

class CertifyDialog final : public QDialog
{
    Q_OBJECT

public:
    CertifyDialog(const Document& document, QWidget* parent);

    void start();

signals:
    void certified(const std::shared_ptr<const ripstop::Certificate>& certificate);

private:
    static QString timeItTakes();
    void layOut();
    void fill();
    void draw();
    void saveTable();
    void saveRecording();

    const Document& m_document;
    ParameterField* m_seconds;
    QPushButton* m_start;
    QPushButton* m_saveTable;
    QPushButton* m_saveRecording;
    QLabel* m_state;
    QTableWidget* m_table;
    BandChart* m_chart;
    std::shared_ptr<const Certificate> m_certificate; // or null
    std::shared_ptr<const Recording> m_recording;     // of the run as it is, with the certificate
    std::set<std::string> m_shares;                   // probes that are said in percent
};

} // namespace ripstop
