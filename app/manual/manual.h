// Opens the manual where it tells of what one looks at: F1 in the window and in its dialogs.
//
// The book (scripts/make_manual) lies beside the documentation of an installed program or in the
// folder of the build; without it the page itself is opened, and where there is none either a
// sentence says where the manual is. All belongs to the thread of the window.
#pragma once

#include "manual/manual_pages.h"

#include <QObject>
#include <QUrl>

#include <functional>

namespace ripstop {

class Manual final : public QObject
{
    Q_OBJECT

public:
    using Open = std::function<bool(const QUrl&)>;

    // `programs` is the folder of this program; the manual is looked for from there. Keys of
    // dialogs come here by the application.
    Manual(const QString& programs, Open open, QObject* parent);

    void showHere(); // for what is under the mouse, or has the keys
    void show(const ManualPage& page);
    void showStart() { show({QStringLiteral("README"), {}}); } // the contents

    // What opens: a page of the book with its heading, or the file of a page; empty for neither.
    QUrl addressOf(const ManualPage& page) const;

signals:
    void said(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QString m_programs;
    Open m_open;
};

} // namespace ripstop
