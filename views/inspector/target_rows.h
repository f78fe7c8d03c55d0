// What a part or group comes to, what it is meant to come to, and the difference, in a row for each
// target that is set.
//
// A button spreads the missing or excess mass over the particles. The rows are made anew by show(),
// which the inspector calls after each edit; the widget is hidden where there is no target.
#pragma once

#include "author/targets.h"

#include <QWidget>

class QGridLayout;

namespace ripstop {

class Document;

class TargetRows final : public QWidget
{
    Q_OBJECT

public:
    explicit TargetRows(Document& document, QWidget* parent = nullptr);

    void show(Id id); // noId for nothing with targets
    using QWidget::show;

private:
    void addRow(const Target& target);
    void spread();

    Document& m_document;
    Id m_id = noId;
    QGridLayout* m_rows;
};

} // namespace ripstop
