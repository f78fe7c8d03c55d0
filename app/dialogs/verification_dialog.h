#pragma once

#include <QDialog>

namespace ripstop {

class ResultPage;

// What `ripstop-cli verify` tells: the cases whose answer is known, expected beside got; and, on a
// second page, what designs do beside what was measured of real ones. Closed, it deletes itself as
// soon as what it computes has stopped.
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
