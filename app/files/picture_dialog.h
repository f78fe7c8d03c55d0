// Asks how a picture of the view is to be: its kind, how large, and what lies behind things.
//
// It shows a small one at once. What was chosen is kept for the next picture, but for the size
// where that follows the view. The dialog is modal and for the thread of the window; it writes
// nothing.
#pragma once

#include "files/view_picture.h"

#include <QDialog>
#include <QTimer>

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace ripstop {

class PictureDialog final : public QDialog
{
    Q_OBJECT

public:
    PictureDialog(Viewport& viewport, QWidget* parent);

    PictureLook look() const;
    QString ending() const; // "png"

private:
    void layOut();
    void takeKept();
    void chooseSize();
    void keepShape(QSpinBox& changed, QSpinBox& other);
    void preview();
    void keep() const;

    Viewport& m_viewport;
    QSize m_view; // pixels of the screen
    QComboBox* m_format;
    QComboBox* m_sizes;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QComboBox* m_backdrop;
    QCheckBox* m_overlays;
    QCheckBox* m_pins;
    QLabel* m_note;
    QLabel* m_preview;
    QTimer m_soon;
};

} // namespace ripstop
