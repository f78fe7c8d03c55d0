// A menu of fabrics, lines and spars above the form of a material, and where the numbers of the
// chosen one come from.
//
// A preset is chosen for all materials of the subject. What cannot be done is said in the place of
// the source, once; nothing is changed then.
#pragma once

#include "inspector/subject.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace ripstop {

struct Preset;

class PresetChooser final : public QWidget
{
    Q_OBJECT

public:
    explicit PresetChooser(Subject& subject, QWidget* parent = nullptr);

    void refresh(); // names the preset that the materials have

    // Gives the preset to all materials of the subject, as one edit.
    void apply(const Preset& preset);

private:
    void fillMenu();

    Subject& m_subject;
    QToolButton* m_button;
    QLabel* m_note;    // the source of the numbers, or why the preset cannot be taken
    QString m_warning; // to be shown once
};

} // namespace ripstop
