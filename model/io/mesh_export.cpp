// One moment as a mesh: particles are vertices, panels are faces, links are lines. Every particle
// is written, so that vertex i is the same particle in every moment.
#include "io/export.h"

#include "io/json_text.h"
#include "io/standing.h"
#include "io/whole_file.h"

#include <algorithm>

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

// A texture point for each particle; false when all of them are at 0, 0, as nobody has set them.
bool appendTexture(std::string& text, const Layout& layout, const Scene& scene)
{
    std::vector<const Particle*> rows;
    bool isSet = false;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& row : part.particles) {
            rows.push_back(&row);
            isSet = isSet || row.textureU != 0.0 || row.textureV != 0.0;
        }
    });
    if (!isSet)
        return false;
    std::ranges::sort(rows, {}, &Particle::id);
    for (const std::uint32_t id : layout.particleId) {
        const auto row = std::ranges::lower_bound(rows, Id(id), {}, &Particle::id);
        const bool isThere = row != rows.end() && (*row)->id == Id(id);
        text += "vt ";
        appendNumber(text, isThere ? (*row)->textureU : 0.0);
        text += ' ';
        appendNumber(text, isThere ? (*row)->textureV : 0.0);
        text += '\n';
    }
    return true;
}

std::string title(const Frame& frame)
{
    std::string text = "Ripstop " RIPSTOP_VERSION ", t = ";
    appendNumber(text, frame.time);
    return text + " s; metres, y up";
}

} // namespace

std::optional<Failure> writeObj(const Frame& frame, const std::filesystem::path& file,
                                const Scene* scene)
{
    const Layout& layout = *frame.layout;
    const Standing whole = standing(frame);
    std::string text = "# " + title(frame) + "\n";
    for (const Vec3& position : frame.position) {
        text += "v ";
        appendVector(text, position);
        text += '\n';
    }
    const bool isTextured = scene && appendTexture(text, layout, *scene);
    // Vertices count from 1.
    text += whole.panels.empty() ? "" : "g panels\n";
    for (const std::size_t i : whole.panels) {
        text += 'f';
        for (const int corner : layout.panelCorners[i]) {
            text += ' ';
            appendWhole(text, std::size_t(corner) + 1);
            if (!isTextured)
                continue;
            text += '/';
            appendWhole(text, std::size_t(corner) + 1);
        }
        text += '\n';
    }
    text += whole.links.empty() ? "" : "g links\n";
    for (const std::size_t i : whole.links) {
        text += "l ";
        appendWhole(text, std::size_t(layout.links[i].a) + 1);
        text += ' ';
        appendWhole(text, std::size_t(layout.links[i].b) + 1);
        text += '\n';
    }
    return replaceFile(file, text, Flush::Later);
}

std::optional<Failure> writePly(const Frame& frame, const std::filesystem::path& file)
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
    return replaceFile(file, text, Flush::Later);
}

} // namespace ripstop
