// Makes the design of what the run has come to, in one step of the history.
//
// The frame is that of the moment when the dialog opens; the dialog asks what becomes of rest
// lengths and velocities. The edit is made on a thread of its own, since a large design takes a
// while, and is pushed on the thread of the window, after the run has been reset. The Run menu
// opens it.
#pragma once

#include "document/worker.h"
#include "run/pose.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QLabel;

namespace ripstop {

class Document;
class Player;

class PoseDialog final : public QDialog
{
    Q_OBJECT

public:
    PoseDialog(Document& document, Player& player, QWidget* parent);

    void accept() override;
    void reject() override;

private:
    struct Job
    {
        Scene scene;
        std::shared_ptr<const Frame> frame;
        PoseOptions options;
    };

    void layOut();
    QString outcome() const; // what will change
    void explain();
    void take(); // pushes the edit that the worker has made

    Document& m_document;
    Player& m_player;
    const std::shared_ptr<const Frame> m_frame;
    QComboBox* m_lengths;
    QComboBox* m_motion;
    QLabel* m_choice;
    QDialogButtonBox* m_buttons;
    bool m_works = false;
    Worker<Job, Edit> m_worker; // last: it stops before the rest goes
};

} // namespace ripstop
