#include "document/clipboard.h"

#include "io/scene_file.h"

#include <QClipboard>
#include <QGuiApplication>

namespace ripstop {

void copyToClipboard(const Scene& scene, const std::vector<Id>& ids)
{
    const Scene some = excerpt(scene, ids);
    if (!some.items.empty())
        QGuiApplication::clipboard()->setText(QString::fromStdString(sceneText(some)));
}

Result<Copies> pasteFromClipboard(const Scene& scene)
{
    const std::string text = QGuiApplication::clipboard()->text().toStdString();
    if (text.find("ripstop-scene") == std::string::npos)
        return Failure{"There is nothing to paste: the clipboard holds no design. Copy something "
                       "that is selected first."};
    const Result<Scene> fragment = parseScene(text, "the clipboard");
    if (!fragment)
        return fragment.failure();
    return pasted(scene, *fragment);
}

} // namespace ripstop
