#pragma once

#include <QDialog>

namespace ripstop {

class ResultPage;

// What `ripstop-cli verify` tells: the cases whose answer is known, expected beside got; and, on a
// second page, what designs do beside what was measured of real ones.
class VerificationDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit VerificationDialog(QWidget* parent);

    ResultPage& cases() { return *m_cases; }
    ResultPage& references() { return *m_references; }

private:
    ResultPage* m_cases;
    ResultPage* m_references;
};

} // namespace ripstop
