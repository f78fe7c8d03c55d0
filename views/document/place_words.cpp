#include "document/place_words.h"

#include "document/words.h"

namespace ripstop {
namespace {

Id materialOf(const Scene& scene, Id element)
{
    const std::optional<ConstRef> thing = find(scene, element);
    if (!thing)
        return noId;
    if (const auto* link = std::get_if<const Link*>(&*thing))
        return (*link)->material;
    const auto* panel = std::get_if<const Panel*>(&*thing);
    return panel ? (*panel)->material : noId;
}

} // namespace

QString placeWords(const Scene& scene, Id element)
{
    const Id material = materialOf(scene, element);
    return material == noId
               ? describe(scene, {element})
               : QStringLiteral("%1, %2").arg(nameOf(scene, material), nameOf(scene, element));
}

} // namespace ripstop
