// Small pictures of the designs of a study, drawn in the background: a design is built with its
// values, which may be those of builders, and drawn without a display (export/design_picture.h).
//
// Pictures are kept by the keys of their flights, so that a design that stays among the best is
// drawn once. Belongs to the window's thread, as its signal does.
#pragma once

#include "scene/scene.h"

#include <QHash>
#include <QImage>
#include <QObject>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ripstop {

struct OpenedStudy; // study/opened_study.h

class DesignPictures final : public QObject
{
    Q_OBJECT

public:
    explicit DesignPictures(QObject* parent = nullptr);
    ~DesignPictures() override;

    // Those that are not there are drawn, in this order, instead of what else was wanted.
    //   size  pixels, of each side
    void want(const OpenedStudy& study, const std::vector<std::size_t>& points, int size);
    QImage picture(const std::string& key) const; // null: not drawn yet, or it cannot be built

signals:
    void drawn(const QString& key);

private:
    struct Wanted
    {
        std::string key;
        std::vector<std::string> assignments;
    };

    void draw(const std::stop_token& stops);

    QHash<QString, QImage> m_pictures; // by the key, of the size that was wanted last
    std::string m_design;              // hash of that of which they are
    int m_size = 0;
    std::mutex m_mutex; // of what follows
    std::condition_variable_any m_hasWork;
    std::shared_ptr<const Scene> m_scene;
    int m_drawnSize = 0;
    std::vector<Wanted> m_wanted;
    std::jthread m_thread; // last: it ends before what it uses; begun with the first wish
};

} // namespace ripstop
