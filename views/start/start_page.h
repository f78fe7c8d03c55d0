// The page that is shown before a scene is open: the samples with their pictures, the files that
// were open lately, and the ways to something new. It does nothing itself: each signal asks the
// main window. Only the window's thread uses it.
#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace ripstop {

class Card;

class StartPage final : public QWidget
{
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);

    void setRecent(const QStringList& files); // the newest first

signals:
    void openRequested(const QString& file);
    void newRequested();
    void browseRequested();
    void importRequested();
    void tourRequested();
    void builderRequested(const QString& builder); // its name in the table of builders

private:
    QWidget* banner();
    QWidget* side();
    QWidget* samples();
    Card* card(const QString& file, const QString& sentence = {}); // its own note without one
    QWidget* builders();

    QLabel* m_noRecent = nullptr;
    QVBoxLayout* m_recent = nullptr;
};

} // namespace ripstop
