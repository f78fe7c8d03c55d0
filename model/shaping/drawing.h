// Draws a network by hand: grows one edit of particles, links and panels.
//
// Ends and corners are particles that are there or that were drawn before. A link belongs to the
// part of its first end, a panel to that of its first corner. What is drawn of a material of the
// scene whose density is known gives particles the mass that it says (scene/weigh.h): half of a
// link to each end, a third of a panel to each corner.
#pragma once

#include "scene/edit.h"

#include <map>
#include <set>
#include <span>

namespace ripstop {

// What a new link is.
struct LinkStroke
{
    Id material{};
    LinkKind kind = LinkKind::Rod;
    Resists resists = Resists::Both;
};

// Of known density: none, as no particle is given a mass for what is drawn of them. Who says later
// what it weighs has it weighed (scene/weigh.h).
Material plainCord(std::string name);
Material plainCloth(std::string name);

class Drawing
{
public:
    explicit Drawing(const Scene& scene); // has to outlive this

    Id material(Material material);
    Id part(const std::string& name); // an empty one
    Id group(const std::string& name, std::vector<Id> members);

    Id particle(Id part, const Vec3& position, double mass = 0.0); // m, kg

    // At rest as long as it is drawn. noId when both ends are one, lie in one place or are linked
    // already: a second link there would only double the first.
    Id link(Id from, Id to, const LinkStroke& stroke);

    // `count` links between particles at equal steps. Where the material does not say its density,
    // they weigh `mass` kg together, half a segment's of which goes to each end. Answers the
    // particles, with both ends; a rest length longer than the chord by `slack` (1) is shared out
    // evenly.
    std::vector<Id> rope(Id from, Id to, int count, double mass, double slack,
                         const LinkStroke& stroke);

    // noId when two corners are one or there is a panel on them.
    Id panel(Id a, Id b, Id c, Id material);

    void addMass(Id particle, double mass); // kg

    Vec3 position(Id particle) const;                      // m
    Id partOf(Id element) const;                           // noId when there is none
    const std::vector<Id>& made() const { return m_made; } // elements, ascending

    Edit finish(Message label); // empty when nothing was drawn

private:
    Id fresh();
    Id tie(Id from, Id to, double length, const LinkStroke& stroke);               // m
    double densityOf(Id material, std::optional<double> Material::*density) const; // 0: unknown
    Particle* drawn(Id particle);
    const Particle* row(Id particle) const;
    AddRows& rowsOf(Id part);
    std::set<Id>& linkedTo(Id particle);
    std::set<std::array<Id, 2>>& coveredBy(Id lowest);

    const Scene& m_scene;
    Id m_next;
    std::vector<AddItem> m_items;
    std::map<Id, AddRows> m_rows;          // by part
    std::map<Id, Id> m_partOf;             // of drawn elements
    std::map<Id, double> m_mass;           // kg, new, of particles that were there
    std::map<Id, std::set<Id>> m_linkedTo; // of first ends, as they are asked for
    std::map<Id, std::set<std::array<Id, 2>>>
        m_coveredBy; // of lowest corners, as they are asked for
    std::vector<Id> m_made;
};

// What most links, or panels, are made of that touch these particles (ascending); noId where there
// are none.
Id linkMaterialAt(const Scene& scene, const std::vector<Id>& particles);
Id panelMaterialAt(const Scene& scene, const std::vector<Id>& particles);

// The particles in the order in which one would draw through them: along links, or along the sides
// of panels, where these form a line or a ring, else along their greatest extent.
std::vector<Id> inLine(const Scene& scene, const std::vector<Id>& particles);

// The particles around the hole that they bound: along links or the sides of panels where these
// form one ring, else by their angle about the middle in the plane that fits best.
std::vector<Id> inRing(const Scene& scene, const std::vector<Id>& particles);

} // namespace ripstop
