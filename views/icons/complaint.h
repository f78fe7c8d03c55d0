#pragma once

#include <QLabel>

namespace ripstop {

// Words that say what is wrong, read as easily (4.5 : 1 at least) on a light ground as on a dark
// one.
QColor wrongColor(const QPalette& ground);

// A sentence in that colour; hidden while there is none.
class Complaint : public QLabel
{
    Q_OBJECT

public:
    explicit Complaint(QWidget* parent = nullptr);

    void tell(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void takeColor();
};

} // namespace ripstop
