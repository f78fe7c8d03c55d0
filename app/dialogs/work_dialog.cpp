#include "dialogs/work_dialog.h"

#include "document/plain_text.h"
#include "document/time_left.h"
#include "document/words.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QProgressDialog>
#include <QTimer>

#include <atomic>
#include <thread>

namespace ripstop {
namespace {

constexpr int showDelay = 400;  // ms, before the bar shows
constexpr int lookEvery = 30;   // ms
constexpr int full = 1000;      // of the bar
constexpr int tellEvery = 1000; // ms, how long it goes on

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

    QElapsedTimer since, told;
    since.start();
    // two lines from the beginning, so that the bar does not jump when there is a second one
    const auto label = [&](const QString& left) {
        return QStringLiteral("<qt>%1<br>%2</qt>")
            .arg(asHtml(title), left.isEmpty() ? QStringLiteral("&nbsp;") : asHtml(left));
    };
    QProgressDialog bar(label({}), words("Cancel"), 0, full, parent);
    bar.setWindowModality(Qt::WindowModal);
    bar.setMinimumDuration(showDelay);
    bar.setAutoClose(false);
    bar.setAutoReset(false);
    QObject::connect(&bar, &QProgressDialog::canceled, &bar, [&] { cancelled = true; });
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &bar, [&] {
        bar.setValue(int(share * (full - 1)));
        if (!told.isValid() || told.hasExpired(tellEvery)) {
            bar.setLabelText(
                label(timeLeftText(secondsLeft(1e-3 * double(since.elapsed()), share))));
            told.start();
        }
        if (done)
            loop.quit();
    });
    look.start(lookEvery);
    loop.exec();
    thread.join();
    // Window managers give the keys to the window below both. Who cancels has seen the bar, too.
    if (parent && (bar.isVisible() || cancelled)) {
        bar.hide();
        parent->activateWindow();
    }
}

} // namespace ripstop
