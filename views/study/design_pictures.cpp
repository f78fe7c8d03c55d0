// want() replaces the list of wishes; the thread takes them one by one and posts each picture with
// its size. A picture of a design of before has another key, and harms nobody.
#include "study/design_pictures.h"

#include "export/design_picture.h"
#include "study/opened_study.h"
#include "study/point_scene.h"

namespace ripstop {
namespace {

constexpr qsizetype mostPictures = 400; // a search comes by many that are best for a while

QImage imageOf(const RasterPicture& picture)
{
    return QImage(picture.pixels.data(), picture.size, picture.size, QImage::Format_RGBA8888)
        .copy();
}

} // namespace

DesignPictures::DesignPictures(QObject* parent)
    : QObject(parent)
{}

DesignPictures::~DesignPictures() = default;

void DesignPictures::want(const OpenedStudy& study, const std::vector<std::size_t>& points,
                          int size)
{
    const bool isOther = study.keys.design() != m_design || size != m_size;
    if (isOther || m_pictures.size() > mostPictures)
        m_pictures.clear();
    m_design = study.keys.design();
    m_size = size;
    std::vector<Wanted> wanted;
    for (const std::size_t point : points)
        if (std::string key = study.key(point); !m_pictures.contains(QString::fromStdString(key)))
            wanted.push_back({std::move(key), study.assignments(point)});
    {
        const std::lock_guard lock(m_mutex);
        if (isOther)
            m_scene = std::make_shared<const Scene>(study.scene);
        m_drawnSize = size;
        m_wanted = std::move(wanted);
    }
    if (!m_thread.joinable())
        m_thread = std::jthread([this](const std::stop_token& stops) { draw(stops); });
    m_hasWork.notify_one();
}

QImage DesignPictures::picture(const std::string& key) const
{
    return m_pictures.value(QString::fromStdString(key));
}

void DesignPictures::draw(const std::stop_token& stops)
{
    std::unique_lock lock(m_mutex);
    while (m_hasWork.wait(lock, stops, [this] { return !m_wanted.empty(); })) {
        const Wanted wanted = std::move(m_wanted.front());
        m_wanted.erase(m_wanted.begin());
        const std::shared_ptr<const Scene> scene = m_scene;
        const int size = m_drawnSize;
        lock.unlock();
        const auto design = sceneWith(*scene, wanted.assignments);
        const QImage image = design ? imageOf(pictureOf(*design, size)) : QImage();
        QMetaObject::invokeMethod(
            this,
            [this, key = QString::fromStdString(wanted.key), image, size] {
                if (image.isNull() || size != m_size)
                    return;
                m_pictures.insert(key, image);
                emit drawn(key);
            },
            Qt::QueuedConnection);
        lock.lock();
    }
}

} // namespace ripstop
