// Sentences of the engine in another language.
//
// The engine knows English only and puts names and numbers into its sentences. A sentence is
// recognised by a pattern with gaps: "%1 free particles have no mass." What stood in the gaps is
// put into the translation, and is itself translated where it is a sentence or a word of the list;
// numbers get the decimal comma.
#pragma once

#include <QHash>
#include <QRegularExpression>
#include <QString>

#include <vector>

namespace ripstop {

class Sentences
{
public:
    void load(const QString& file); // a .ts file; empties the list where there is none
    void clear();

    // Empty for what matches no pattern.
    QString translated(const QString& english) const;

private:
    struct Pattern
    {
        QRegularExpression english;
        QString translation;
        qsizetype letters; // outside the gaps
    };

    QString filled(const QString& gap) const;

    QHash<QString, QString> m_whole;
    std::vector<Pattern> m_patterns; // those that say most first
};

} // namespace ripstop
