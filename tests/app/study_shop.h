// A window with the study panel, as tests of studies share it.
#pragma once

#include "app/window_shop.h"

#include "inspector/inspector.h"
#include "study/study_form.h"
#include "study/study_panel.h"
#include "study/study_view.h"

#include <QComboBox>
#include <QFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace ripstop {

inline constexpr int patience = 60'000; // ms; other work may be on the machine

// A window with a copy of a sample in a folder of its own.
struct StudyShop : WindowShop
{
    QTemporaryDir folder;
    StudyPanel& panel = window.docks().panel<StudyPanel>();
    QSignalSpy said{&panel, &StudyPanel::said};

    explicit StudyShop(const char* sample = "pendulum")
    {
        const QString file = folder.filePath("a.ripstop.json");
        QFile::copy(QString(SCENES_DIR "/%1.ripstop.json").arg(sample), file);
        if (document.open(file))
            qFatal("the sample cannot be opened");
        window.resize(1280, 900);
        window.show();
    }

    SliderShelf& shelf() { return window.docks().panel<Inspector>().sliders(); }
    const Property& property(Kind kind, const char* key) { return *findProperty(kind, key); }
    QPushButton& button(const QString& words)
    {
        for (QPushButton* one : panel.findChildren<QPushButton*>())
            if (one->text().remove('&') == words)
                return *one;
        qFatal("there is no such button");
    }
    void setSeconds(double seconds)
    {
        Study study = panel.form().study();
        study.seconds = seconds;
        show(study);
    }
    std::string firstProbe() const // its name
    {
        for (const Entry& entry : document.scene().items)
            if (const auto* probe = std::get_if<Probe>(&entry.item))
                return probe->name;
        qFatal("there is no probe");
    }
    // In the form, as a person would have made it.
    void show(const Study& study)
    {
        QStringList probes;
        for (const Entry& entry : document.scene().items)
            if (const auto* probe = std::get_if<Probe>(&entry.item))
                probes << QString::fromStdString(probe->name);
        panel.form().setStudy(
            study, [](const StudyVariable&) { return QString(); }, probes);
        emit panel.form().edited();
    }
    bool chooseIn(const QString& name, int place)
    {
        for (QComboBox* box : panel.findChildren<QComboBox*>())
            if (box->accessibleName() == name && place >= 0 && place < box->count()) {
                box->setCurrentIndex(place);
                emit box->activated(place);
                return true;
            }
        return false;
    }
    void choosePlan(StudyPlan::Kind kind)
    {
        for (QComboBox* box : panel.findChildren<QComboBox*>())
            if (box->accessibleName() == "Points" && !chooseIn("Points", box->findData(int(kind))))
                qFatal("there is no such plan");
    }
    bool choosePicture(const QString& words)
    {
        for (QComboBox* box : panel.findChildren<QComboBox*>())
            if (box->accessibleName() == "Picture")
                return box->isVisible() && chooseIn("Picture", box->findText(words));
        return false;
    }
    // With the button held, which QTest::mouseMove() does not tell.
    static void drag(QWidget& widget, const QPoint& from, const QPoint& to)
    {
        const auto send = [&](QEvent::Type type, const QPoint& place, Qt::MouseButton button,
                              Qt::MouseButtons held) {
            QMouseEvent event(type, place, widget.mapToGlobal(place), button, held, {});
            QApplication::sendEvent(&widget, &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }
    bool isDone() const { return panel.runner().task() == StudyRunner::Task::None; }
    QString lastSaid() const { return said.isEmpty() ? QString() : said.last().first().toString(); }
};

} // namespace ripstop
