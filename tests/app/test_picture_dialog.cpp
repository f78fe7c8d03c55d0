// The dialog that asks how a picture of the view is to be, and the pictures that come of it: their
// sizes, what is behind things in them, and letters that stay letters.
#include "files/picture_dialog.h"
#include "views/bare_view.h"
#include "views/run_with_widgets.h"

#include "builders/builder.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>

namespace ripstop::test_picture_dialog {

namespace {

Scene deltaKite()
{
    const Builder& builder = *findBuilder("delta_kite");
    return *build(builder, unsaid(builder));
}

struct View : BareView
{
    View()
        : BareView(deltaKite(), {400, 300})
    {
        QSettings().remove("picture");
    }
    QByteArray written(const PictureLook& look, const QString& name)
    {
        const QString file = folder.filePath(name);
        if (!writePicture(viewport, look, file))
            return {};
        QFile made(file);
        return made.open(QIODevice::ReadOnly) ? made.readAll() : QByteArray();
    }

    QTemporaryDir folder;
};

template <typename Field>
Field& field(const PictureDialog& dialog, const char* name)
{
    return *dialog.findChild<Field*>(name);
}

} // namespace

class TestPictureDialog : public QObject
{
    Q_OBJECT

private slots:
    // At first 3000 pixels wide, as a page asks; whatever is typed, the shape stays that of the
    // view.
    void theShapeIsThatOfTheView()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        PictureDialog dialog(view.viewport, nullptr);
        QCOMPARE(dialog.look().size, QSize(3000, 2250));
        field<QComboBox>(dialog, "sizes").setCurrentIndex(2);
        QCOMPARE(dialog.look().size, view.viewport.size() * view.viewport.devicePixelRatioF() * 4);
        field<QSpinBox>(dialog, "height").setValue(600);
        QCOMPARE(dialog.look().size, QSize(800, 600));
        field<QSpinBox>(dialog, "width").setValue(1000);
        QCOMPARE(dialog.look().size, QSize(1000, 750));
    }

    void theLastChoiceIsOffered()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        {
            PictureDialog dialog(view.viewport, nullptr);
            field<QComboBox>(dialog, "format").setCurrentIndex(2);
            field<QComboBox>(dialog, "backdrop").setCurrentIndex(1);
            field<QCheckBox>(dialog, "overlays").setChecked(false);
            QVERIFY(!dialog.look().pins); // marks are for who edits
            field<QCheckBox>(dialog, "pins").setChecked(true);
            field<QPushButton>(dialog, "go").click();
        }
        PictureDialog cancelled(view.viewport, nullptr);
        QCOMPARE(cancelled.ending(), QString("svg"));
        QCOMPARE(int(cancelled.look().backdrop), int(Backdrop::White));
        QVERIFY(!cancelled.look().overlays);
        QVERIFY(cancelled.look().pins);
    }

    // The mark of the hand that holds the line.
    void pinsAreInItWhereTheyAreWanted()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        view.viewport.fit({}); // the hand, too
        PictureLook look{QSize(400, 300), Backdrop::White, false};
        const auto pinned = [&view, &look](bool pins) {
            look.pins = pins;
            return QImage::fromData(view.written(look, "pins.png"));
        };
        const QImage with = pinned(true);
        QVERIFY(with != pinned(false));
        QCOMPARE(pinned(true), with);
    }

    void pixelsHaveTheSizeThatWasAskedFor()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        const QByteArray file =
            view.written({QSize(1200, 900), Backdrop::Transparent, false}, "a.png");
        const QImage picture = QImage::fromData(file);
        QCOMPARE(picture.size(), QSize(1200, 900));
        QCOMPARE(picture.pixelColor(1190, 10).alpha(), 0);
        int opaque = 0; // the kite
        for (int x = 0; x < 1200; x += 4)
            for (int y = 0; y < 900; y += 4)
                opaque += picture.pixelColor(x, y).alpha() == 255;
        QVERIFY(opaque > 50);
    }

    void jpegHasWhiteForNothing()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        const QImage picture = QImage::fromData(
            view.written({QSize(400, 300), Backdrop::Transparent, false}, "a.jpg"));
        const QColor corner = picture.pixelColor(395, 5);
        QVERIFY(corner.red() > 250 && corner.green() > 250 && corner.blue() > 250);
    }

    // The legend is text in a drawing, above one picture of the view.
    void drawingsHoldTextAboveOnePicture()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        view.viewport.setColorBy(ColorBy::Tension);
        view.viewport.image();
        const QByteArray svg = view.written({QSize(1200, 900), Backdrop::White, true}, "a.svg");
        QCOMPARE(svg.count("<image"), 1);
        QVERIFY(svg.contains("<text"));
        QVERIFY(svg.contains("Tension"));
        const QByteArray pdf = view.written({QSize(1200, 900), Backdrop::White, true}, "a.pdf");
        QVERIFY(pdf.startsWith("%PDF"));
        QVERIFY(pdf.contains("/Font"));
    }

    void whatCannotBeWrittenIsSaid()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        for (const char* name : {"/nowhere/a.png", "/nowhere/a.svg", "/nowhere/a.pdf"})
            QVERIFY(!writePicture(view.viewport, {QSize(40, 30)}, name));
    }
};

const RegisteredTest registered("test_picture_dialog", runWithView<TestPictureDialog>);

} // namespace ripstop::test_picture_dialog

#include "test_picture_dialog.moc"
