// Cards in rows, as many to a row as fit into the width; the height follows from that. The arrow
// keys move the focus from card to card, and Enter clicks. Only the window's thread uses it.
#pragma once

#include <QWidget>

#include <vector>

namespace ripstop {

class Card;

class CardGrid final : public QWidget
{
    Q_OBJECT

public:
    explicit CardGrid(QWidget* parent = nullptr);

    void add(Card* card); // the grid becomes its parent
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    int columns(int width) const;
    void place();

    std::vector<Card*> m_cards;
};

} // namespace ripstop
