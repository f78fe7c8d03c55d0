// What of a scene the view shows, switch by switch.
#include "viewport/viewport.h"

#include "viewport/viewport_data.h"

namespace ripstop {

void Viewport::setPanelsShown(bool shown)
{
    d->pointing.pickable.drawn.panels = shown;
    d->stage.setPanelsShown(shown);
    d->screen.renderSoon();
}

void Viewport::setLinksShown(bool shown)
{
    d->pointing.pickable.drawn.links = shown;
    d->stage.links.setShown(shown);
    d->screen.renderSoon();
}

void Viewport::setParticlesShown(bool shown)
{
    d->pointing.pickable.drawn.particles = shown;
    d->stage.particles.setShown(shown);
    d->screen.renderSoon();
}

void Viewport::setPeopleShown(bool shown)
{
    d->draw([&] { d->stage.setPeopleShown(shown); });
}

void Viewport::setWindShown(bool shown) { d->compass.setWindShown(shown); }

void Viewport::setCentreShown(bool shown)
{
    d->draw([&] { d->centre.setMarked(shown); });
}

void Viewport::setDesignShown(bool shown)
{
    d->draw([&] { d->stage.setDesignShown(shown); });
}

void Viewport::setTrailsShown(bool shown)
{
    d->draw([&] { d->stage.trails.setShown(shown); });
}

void Viewport::setGrainShown(bool shown)
{
    d->draw([&] { d->stage.setGrainShown(shown); });
}

void Viewport::setMeshShown(bool shown)
{
    d->draw([&] { d->stage.setMeshShown(shown); });
}

void Viewport::setProbesShown(bool shown)
{
    d->draw([&] { d->labels.setWanted(shown); });
}

void Viewport::setRangeToPeak(bool toPeak)
{
    d->draw([&] { d->stage.setRangeToPeak(toPeak); });
}

void Viewport::setVectors(Vectors vectors)
{
    d->draw([&] { d->stage.setVectors(vectors); });
}

void Viewport::setWindFieldShown(bool shown)
{
    d->draw([&] { d->stage.setWindShown(shown); });
}

void Viewport::setStreaksShown(bool shown)
{
    d->draw([&] { d->stage.setStreaksShown(shown); });
}

void Viewport::setMotionReduced(bool reduced)
{
    d->draw([&] { d->stage.setMotionReduced(reduced); });
}

} // namespace ripstop
