// Shows what `ripstop-cli verify` tells: on one page the cases whose answer is known, expected
// beside got (verify/case.h); on the other what designs do beside what was measured of real ones
// (verify/reference.h).
//
// Each page computes on a thread of its own (result_page.h). When it is closed it deletes itself
// as soon as the case that is under way has ended, and it can be opened again until then.
#pragma once

#include <QDialog>

namespace ripstop {

class ResultPage;

class VerificationDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit VerificationDialog(QWidget* parent);

    ResultPage& cases() { return *m_cases; }
    ResultPage& references() { return *m_references; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void goWhenIdle();

    ResultPage* m_cases;
    ResultPage* m_references;
    bool m_isClosed = false;
};

} // namespace ripstop
