// objText() writes positions, texture points and normals, then the faces, with a group where the
// fabric changes, and the lines as the last group. One number serves as the index of position,
// texture point and normal, since a vertex has one of each; OBJ counts from 1.
//
// plyMoment() must declare its counts before the rows, so it first finds which panels and links
// still stand. Then come particles with velocities, panels, and links with strain and tension.
#include "export/moment.h"

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

std::string title(const Frame& frame)
{
    std::string text = "Ripstop " RIPSTOP_VERSION ", t = ";
    appendNumber(text, frame.time);
    return text + " s; metres, y up";
}

} // namespace

std::string objText(const Surface& surface)
{
    std::string text = "# Ripstop " RIPSTOP_VERSION "; metres, y up\n";
    for (const Vec3& position : surface.position)
        appendRow(text, "v ", position);
    for (const auto& [u, v] : surface.texture) {
        text += "vt ";
        appendNumber(text, u);
        text += ' ';
        appendNumber(text, v);
        text += '\n';
    }
    if (!surface.panels.empty())
        for (const Vec3& normal : normalsOf(surface))
            appendRow(text, "vn ", normal);

    // vertices count from 1
    std::optional<std::size_t> fabric;
    for (std::size_t i = 0; i < surface.panels.size(); ++i) {
        if (surface.fabric[i] != fabric) {
            fabric = surface.fabric[i];
            text += "g " + oneWord(surface.fabrics[*fabric].name) + '\n';
        }
        text += 'f';
        for (const int corner : surface.panels[i]) {
            const std::string number = std::to_string(corner + 1);
            text += ' ' + number + '/';
            text += (surface.texture.empty() ? "" : number) + '/' + number;
        }
        text += '\n';
    }
    text += surface.lines.empty() ? "" : "g lines\n";
    for (const auto& [a, b] : surface.lines)
        text += "l " + std::to_string(a + 1) + ' ' + std::to_string(b + 1) + '\n';
    return text;
}

Result<std::string> objMoment(const Frame& frame, const MeshAppearance& appearance)
{
    return objText(surfaceOf(frame, appearance));
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
