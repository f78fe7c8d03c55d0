// objText() writes positions, texture points and normals, then the faces, with a group where the
// fabric changes, the lines as the last group, and what nothing holds. One number serves as the
// index of position, texture point and normal, since a vertex has one of each; OBJ counts from 1.
// The places in pictures follow as further texture points, as many for each fabric that has one.
//
// plyMoment() must declare its counts before the rows, so it first finds which panels and links
// still stand. Then come particles with velocities, panels, and links with strain and tension.
#include "export/moment.h"

#include "base/program_version.h"
#include "derived/named_files.h"
#include "export/standing.h"
#include "io/json_text.h"

#include <algorithm>
#include <optional>

namespace ripstop {
namespace {

void appendWhole(std::string& text, std::size_t number) { text += std::to_string(number); }

void appendVector(std::string& text, const Vec3& vector)
{
    for (Eigen::Index i = 0; i < 3; ++i) {
        text += i == 0 ? "" : " ";
        appendNumber(text, vector[i]);
    }
}

void appendRow(std::string& text, const char* start, const Vec3& vector)
{
    text += start;
    appendVector(text, vector);
    text += '\n';
}

// A name for a line of words.
std::string oneWord(std::string name)
{
    std::ranges::replace_if(
        name, [](unsigned char c) { return c <= ' '; }, '_');
    return name;
}

void appendTexture(std::string& text, const std::vector<MeshAppearance::TexturePoint>& points)
{
    for (const auto& [u, v] : points) {
        text += "vt ";
        appendNumber(text, u);
        text += ' ';
        appendNumber(text, v);
        text += '\n';
    }
}

// Blender leaves out the vertices of an OBJ that no face and no line has, and a point cache would
// not fit the others: each of them is a line of no length.
std::string objLoose(const Surface& surface)
{
    std::vector<char> isHeld(surface.position.size(), 0);
    for (const auto& corners : surface.panels)
        for (const int corner : corners)
            isHeld[std::size_t(corner)] = 1;
    for (const auto& ends : surface.lines)
        for (const int end : ends)
            isHeld[std::size_t(end)] = 1;
    std::string text;
    for (std::size_t i = 0; i < isHeld.size(); ++i)
        if (const std::string number = std::to_string(i + 1); !isHeld[i])
            text += "l " + number + ' ' + number + '\n';
    return text.empty() ? text : "g loose\n" + text;
}

std::string title(const Frame& frame)
{
    std::string text = "Ripstop " + std::string(releaseVersion()) + ", t = ";
    appendNumber(text, frame.time);
    return text + " s; metres, y up";
}

} // namespace

std::string objText(const Surface& surface)
{
    std::string text = "# Ripstop " + std::string(releaseVersion()) + "; metres, y up\n";
    for (const Vec3& position : surface.position)
        appendRow(text, "v ", position);
    appendTexture(text, surface.texture);
    std::size_t points = surface.texture.size();
    std::vector<std::size_t> before; // [fabrics] texture points before those of its picture
    for (const auto& print : surface.prints) {
        appendTexture(text, print);
        before.push_back(points);
        points += print.size();
    }
    if (!surface.panels.empty())
        for (const Vec3& normal : normalsOf(surface))
            appendRow(text, "vn ", normal);

    // vertices count from 1
    std::optional<std::size_t> fabric;
    for (std::size_t i = 0; i < surface.panels.size(); ++i) {
        if (surface.fabric[i] != fabric) {
            fabric = surface.fabric[i];
            const std::string name = oneWord(surface.fabrics[*fabric].name);
            text += "g " + name + '\n' + "usemtl " + name + '\n';
        }
        text += 'f';
        for (const int corner : surface.panels[i]) {
            const std::string number = std::to_string(corner + 1);
            text += ' ' + number + '/';
            if (surface.isPrinted(*fabric))
                text += std::to_string(before[*fabric] + std::size_t(corner) + 1);
            else if (!surface.texture.empty())
                text += number;
            text += '/' + number;
        }
        text += '\n';
    }
    text += surface.lines.empty() ? "" : "g lines\n";
    for (const auto& [a, b] : surface.lines)
        text += "l " + std::to_string(a + 1) + ' ' + std::to_string(b + 1) + '\n';
    text += objLoose(surface);
    return text;
}

Result<std::string> objMoment(const Frame& frame, const MeshAppearance& appearance)
{
    return objText(surfaceOf(frame, appearance));
}

std::optional<ObjMaterials> objMaterials(const std::filesystem::path& obj,
                                         const MeshAppearance& appearance)
{
    const auto& fabrics = appearance.fabrics();
    if (obj.extension() != ".obj" || fabrics.empty())
        return std::nullopt;
    ObjMaterials materials{std::filesystem::path(obj).replace_extension(".mtl"), {}, {}};
    materials.line = "mtllib " + materials.file.filename().string() + '\n';
    for (const MeshAppearance::Fabric& fabric : fabrics) {
        materials.text += "newmtl " + oneWord(fabric.name) + "\nKd";
        for (const double part : fabric.color) {
            materials.text += ' ';
            appendNumber(materials.text, fabric.picture.empty() ? part : 1.0);
        }
        materials.text += '\n';
        if (fabric.picture.empty())
            continue;
        const std::filesystem::path folder = std::filesystem::absolute(obj).parent_path();
        materials.text += "map_Kd " + nameSeenFrom(folder, fabric.picture) + '\n';
    }
    return materials;
}

Result<std::string> plyMoment(const Frame& frame, const MeshAppearance&)
{
    const Layout& layout = *frame.layout;
    const Standing whole = standing(frame);
    std::string text = "ply\nformat ascii 1.0\ncomment " + title(frame)
                       + "; velocity vx vy vz in m/s, tension in N\nelement vertex ";
    appendWhole(text, frame.position.size());
    for (const char* name : {"x", "y", "z", "vx", "vy", "vz"})
        text.append("\nproperty double ").append(name);
    text += "\nelement face ";
    appendWhole(text, whole.panels.size());
    text += "\nproperty list uchar int vertex_indices\nelement edge ";
    appendWhole(text, whole.links.size());
    text += "\nproperty int vertex1\nproperty int vertex2\nproperty double strain\n"
            "property double tension\nend_header\n";

    for (std::size_t i = 0; i < frame.position.size(); ++i) {
        appendVector(text, frame.position[i]);
        text += ' ';
        appendVector(text, frame.velocity[i]);
        text += '\n';
    }
    for (const std::size_t i : whole.panels) {
        text += '3';
        for (const int corner : layout.panelCorners[i]) {
            text += ' ';
            appendWhole(text, std::size_t(corner));
        }
        text += '\n';
    }
    for (const std::size_t i : whole.links) {
        appendWhole(text, std::size_t(layout.links[i].a));
        text += ' ';
        appendWhole(text, std::size_t(layout.links[i].b));
        text += ' ';
        appendNumber(text, frame.strain[i]);
        text += ' ';
        appendNumber(text, frame.tension[i]);
        text += '\n';
    }
    return text;
}

} // namespace ripstop
