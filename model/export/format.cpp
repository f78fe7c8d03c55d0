// The table comes first: a row for each format with its ending, its words for the screen, what it
// can hold, its size for each element in bytes, and the functions that write it. The functions
// below only read the table, so that a new format is one row.
//
// formatOf() compares the extension without case and whether the name has {frame}, since a sequence
// of files has the extension of a single mesh. openSink() takes the function of the row, or else
// writes a file of the row's content for each frame.
#include "export/format.h"

#include "base/lower_case.h"
#include "export/curve_figure.h"
#include "export/gltf.h"
#include "export/hdf5.h"
#include "export/moment.h"
#include "export/point_cache.h"
#include "export/tubes.h"

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

using Of = ExportFormat::Of;
using Topology = ExportFormat::Topology;
using Beside = ExportFormat::Beside;

constexpr std::array formats{
    ExportFormat{".obj",
                 "Mesh, Wavefront OBJ",
                 "Panels with normals and texture points, and lines. Blender and most others.",
                 Of::Moment,
                 Topology::Free,
                 Beside::Nothing,
                 {110, 40, 14, 0},
                 objMoment,
                 nullptr},
    ExportFormat{".ply",
                 "Mesh, PLY",
                 "Particles with velocities, panels, all links with strain and tension.",
                 Of::Moment,
                 Topology::Free,
                 Beside::Nothing,
                 {115, 18, 55, 0},
                 plyMoment,
                 nullptr},
    ExportFormat{".stl",
                 "Mesh, STL",
                 "The panels alone, for printing and CAD; the format knows no unit: metres.",
                 Of::Moment,
                 Topology::Free,
                 Beside::Nothing,
                 {0, 50, 0, 0},
                 stlMoment,
                 nullptr},
    ExportFormat{".dae",
                 "Mesh, Collada",
                 "Panels with normals, texture points and colours, and lines.",
                 Of::Moment,
                 Topology::Free,
                 Beside::Nothing,
                 {80, 24, 14, 0},
                 colladaMoment,
                 nullptr},
    ExportFormat{".vtp",
                 "Mesh with strains and loads, VTP",
                 "All that is measured, as arrays for ParaView and Python.",
                 Of::Moment,
                 Topology::Free,
                 Beside::Nothing,
                 {45, 45, 30, 0},
                 vtpMoment,
                 nullptr},
    ExportFormat{".glb",
                 "Animation, glTF",
                 "One file with a morph target for each frame and the colours of the fabrics. "
                 "Blender and web pages.",
                 Of::Series,
                 Topology::Constant,
                 Beside::Nothing,
                 {12, 0, 0, 0, 390, 4, 12 * int(Tubes::vertices)},
                 glbMoment,
                 gltfSink},
    ExportFormat{".gltf",
                 "Animation, glTF as text",
                 "The same as text, for looking into it.",
                 Of::Series,
                 Topology::Constant,
                 Beside::Nothing,
                 {16, 0, 0, 0, 840, 5, 16 * int(Tubes::vertices)},
                 nullptr,
                 gltfSink},
    ExportFormat{".pc2",
                 "Point cache, PC2",
                 "With its mesh as OBJ beside it, for Blender's Mesh Cache (Time Mode: Frame).",
                 Of::Series,
                 Topology::Constant,
                 Beside::Obj,
                 {12, 0, 0, 0},
                 nullptr,
                 pc2Sink,
                 true},
    ExportFormat{".mdd",
                 "Point cache, MDD",
                 "With its mesh as OBJ beside it, for Blender, LightWave and Maya.",
                 Of::Series,
                 Topology::Constant,
                 Beside::Obj,
                 {12, 0, 0, 0},
                 nullptr,
                 mddSink},
    ExportFormat{"_{frame}.obj",
                 "Sequence of OBJ files",
                 "A mesh for each frame; tears part it.",
                 Of::Series,
                 Topology::Free,
                 Beside::Nothing,
                 {110, 40, 14, 0},
                 objMoment,
                 nullptr,
                 true},
    ExportFormat{"_{frame}.ply",
                 "Sequence of PLY files",
                 "A mesh for each frame; tears part it.",
                 Of::Series,
                 Topology::Free,
                 Beside::Nothing,
                 {115, 18, 55, 0},
                 plyMoment,
                 nullptr,
                 true},
    ExportFormat{"_{frame}.stl",
                 "Sequence of STL files",
                 "The panels of each frame.",
                 Of::Series,
                 Topology::Free,
                 Beside::Nothing,
                 {0, 50, 0, 0},
                 stlMoment,
                 nullptr,
                 true},
    ExportFormat{".pvd",
                 "Series for ParaView, PVD and VTP",
                 "An index and a folder of VTP files with all that is measured.",
                 Of::Series,
                 Topology::Free,
                 Beside::Folder,
                 {45, 45, 30, 0},
                 nullptr,
                 pvdSink},
    ExportFormat{".h5",
                 "Series for Python, HDF5",
                 "One file of arrays over all frames, with all that is measured and the probes.",
                 Of::Series,
                 Topology::Free,
                 Beside::Nothing,
                 {35, 20, 12, 8},
                 nullptr,
                 hdf5Sink},
    ExportFormat{".csv",
                 "Table of the probes, CSV",
                 "A row for each frame; units stand in the header.",
                 Of::Series,
                 Topology::Free,
                 Beside::Nothing,
                 {0, 0, 0, 20},
                 nullptr,
                 tableSink},
    ExportFormat{".svg",
                 "Figure of the probes, SVG",
                 "Curves over time for a paper, a panel for each unit; sharp at any size.",
                 Of::Series,
                 Topology::Free,
                 Beside::Nothing,
                 {0, 0, 0, 36},
                 nullptr,
                 figureSink},
};

bool isNumbered(std::string_view name)
{
    return name.find(framePlaceholder) != std::string_view::npos;
}

} // namespace

std::span<const ExportFormat> exportFormats() { return formats; }

const ExportFormat* formatOf(const std::filesystem::path& target)
{
    const std::string name = target.filename().string();
    const std::string extension = lowerCase(target.extension().string());
    const auto found = std::ranges::find_if(formats, [&](const ExportFormat& format) {
        return format.ending.substr(format.ending.rfind('.')) == extension
               && isNumbered(format.ending) == isNumbered(name);
    });
    return found == formats.end() ? nullptr : &*found;
}

std::string knownEndings(EndingsOf of)
{
    std::vector<std::string_view> endings;
    for (const ExportFormat& format : formats)
        if (of == EndingsOf::All || (format.content && !isNumbered(format.ending)))
            endings.push_back(format.ending);
    std::string list = "use ";
    for (std::size_t i = 0; i < endings.size(); ++i) {
        list += i == 0 ? "" : i + 1 == endings.size() ? " or " : ", ";
        list += endings[i];
    }
    return list;
}

Result<std::unique_ptr<FrameSink>> openSink(const ExportFormat& format,
                                            const std::filesystem::path& target,
                                            const MeshAppearance& appearance)
{
    return format.open ? format.open(target, appearance)
                       : sequenceSink(target, appearance, format.content);
}

double expectedSize(const ExportFormat& format, const Layout& layout,
                    const MeshAppearance& appearance, std::size_t frames)
{
    const auto& [particle, panel, link, probe, frame, pair, roundLine] = format.bytes;
    const auto roundLines = std::ranges::count_if(
        layout.links, [&](const Layout::Link& row) { return appearance.isRound(row.id); });
    const double each =
        double(particle) * double(layout.particleId.size())
        + double(panel) * double(layout.panelId.size()) + double(link) * double(layout.links.size())
        + double(roundLine) * double(roundLines) + double(probe) * double(layout.probes.size())
        + double(frame) + double(pair) * double(frames);
    return each * double(frames);
}

std::vector<std::filesystem::path> filesOf(const ExportFormat& format,
                                           const std::filesystem::path& target, std::size_t frames,
                                           const MeshAppearance& appearance)
{
    std::vector<std::filesystem::path> files;
    if (isNumbered(target.filename().string()))
        for (std::size_t i = 0; i < frames; ++i)
            files.push_back(fileOfFrame(target, i));
    else
        files.push_back(target);
    if (format.beside == Beside::Obj)
        files.push_back(std::filesystem::path(target).replace_extension(".obj"));
    if (format.beside == Beside::Folder)
        files.push_back(target.parent_path() / target.stem());
    for (const std::filesystem::path& file : {files.front(), files.back()})
        if (const auto materials = objMaterials(file, appearance)) {
            files.push_back(materials->file);
            break;
        }
    return files;
}

} // namespace ripstop
