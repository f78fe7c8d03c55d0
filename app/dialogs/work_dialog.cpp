#include "dialogs/work_dialog.h"

#include "document/plain_text.h"

#include <QEventLoop>
#include <QProgressDialog>
#include <QTimer>

#include <atomic>
#include <thread>

namespace ripstop {
namespace {

constexpr int showDelay = 400; // ms, before the bar shows
constexpr int lookEvery = 30;  // ms
constexpr int full = 1000;     // of the bar

} // namespace

void workWithProgress(QWidget* parent, const QString& title,
                      const std::function<void(const Progress&)>& work)
{
    std::atomic<double> share = 0.0;
    std::atomic<bool> cancelled = false;
    std::atomic<bool> done = false;
    std::thread thread([&] {
        work([&](double now) {
            share = now;
            return !cancelled;
        });
        done = true;
    });

    QProgressDialog bar(shownAsIs(title), QObject::tr("Cancel"), 0, full, parent);
    bar.setWindowModality(Qt::WindowModal);
    bar.setMinimumDuration(showDelay);
    bar.setAutoClose(false);
    bar.setAutoReset(false);
    QObject::connect(&bar, &QProgressDialog::canceled, &bar, [&] { cancelled = true; });
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &bar, [&] {
        bar.setValue(int(share * (full - 1)));
        if (done)
            loop.quit();
    });
    look.start(lookEvery);
    loop.exec();
    thread.join();
}

} // namespace ripstop
