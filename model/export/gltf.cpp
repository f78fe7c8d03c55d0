// Arrays go into one buffer: the first frame as a mesh, and tubes as another where there are any,
// each later frame as a morph target of both, then the animation that blends them, and last
// materials, nodes and scene.
#include "export/gltf.h"

#include "base/program_version.h"
#include "base/tubes_mark.h"
#include "export/moment.h"
#include "export/spooled_sink.h"
#include "export/tubes.h"
#include "io/whole_file.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <sstream>

namespace ripstop {
namespace {

// The lengths in a .glb are 32-bit numbers (glTF 2.0, 4.4); some of it is for the text.
constexpr std::size_t largestBuffer = (std::size_t(1) << 32) - (std::size_t(1) << 26); // bytes

// A model under construction, of which all arrays share one buffer.
class Builder
{
public:
    Builder() { m_model.buffers.emplace_back(); }

    tinygltf::Model& model() { return m_model; }
    std::size_t size() const { return m_model.buffers[0].data.size(); } // bytes

    // Single precision, `width` numbers in an element.
    int addNumbers(std::span<const float> values, std::size_t width, int target)
    {
        const int type = width == 1   ? TINYGLTF_TYPE_SCALAR
                         : width == 2 ? TINYGLTF_TYPE_VEC2
                                      : TINYGLTF_TYPE_VEC3;
        const int index =
            add(values, values.size() / width, type, TINYGLTF_COMPONENT_TYPE_FLOAT, target);
        tinygltf::Accessor& accessor = m_model.accessors[std::size_t(index)];
        accessor.minValues.assign(width, std::numeric_limits<double>::max());
        accessor.maxValues.assign(width, std::numeric_limits<double>::lowest());
        for (std::size_t i = 0; i < values.size(); ++i) {
            double& least = accessor.minValues[i % width];
            double& most = accessor.maxValues[i % width];
            least = std::min(least, double(values[i]));
            most = std::max(most, double(values[i]));
        }
        return index;
    }

    int addIndices(std::span<const std::uint32_t> values)
    {
        return add(values, values.size(), TINYGLTF_TYPE_SCALAR,
                   TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    }

    // A file as it is, and the texture of it.
    int addPicture(std::string_view bytes)
    {
        addView(bytes.data(), bytes.size(), 0);
        tinygltf::Image image;
        image.bufferView = int(m_model.bufferViews.size()) - 1;
        image.mimeType = bytes.starts_with("\xff\xd8") ? "image/jpeg" : "image/png";
        m_model.images.push_back(std::move(image));
        tinygltf::Texture texture;
        texture.source = int(m_model.images.size()) - 1;
        m_model.textures.push_back(std::move(texture));
        std::vector<unsigned char>& data = m_model.buffers[0].data;
        data.resize((data.size() + 3) / 4 * 4); // what follows are numbers of four bytes
        return int(m_model.textures.size()) - 1;
    }

private:
    void addView(const void* from, std::size_t size, int target)
    {
        std::vector<unsigned char>& data = m_model.buffers[0].data;
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = data.size();
        view.byteLength = size;
        view.target = target;
        const auto* bytes = static_cast<const unsigned char*>(from);
        data.insert(data.end(), bytes, bytes + size);
        m_model.bufferViews.push_back(std::move(view));
    }

    template <typename T>
    int add(std::span<const T> values, std::size_t count, int type, int component, int target)
    {
        addView(values.data(), values.size_bytes(), target);
        tinygltf::Accessor accessor;
        accessor.bufferView = int(m_model.bufferViews.size()) - 1;
        accessor.componentType = component;
        accessor.type = type;
        accessor.count = count;
        m_model.accessors.push_back(std::move(accessor));
        return int(m_model.accessors.size()) - 1;
    }

    tinygltf::Model m_model;
};

// glTF has linear colours where screens have sRGB (IEC 61966-2-1).
double linear(double shown)
{
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

std::vector<float> flat(std::span<const Eigen::Vector3f> vectors)
{
    std::vector<float> numbers;
    numbers.reserve(3 * vectors.size());
    for (const Eigen::Vector3f& v : vectors)
        numbers.insert(numbers.end(), {v.x(), v.y(), v.z()});
    return numbers;
}

std::vector<float> flat(const std::vector<Vec3>& vectors)
{
    std::vector<Eigen::Vector3f> single;
    std::ranges::transform(vectors, std::back_inserter(single),
                           [](const Vec3& v) -> Eigen::Vector3f { return v.cast<float>(); });
    return flat(single);
}

void addMaterials(Builder& builder, const Surface& surface)
{
    tinygltf::Model& model = builder.model();
    for (const MeshAppearance::Fabric& fabric : surface.fabrics) {
        tinygltf::Material material;
        material.name = fabric.name;
        material.doubleSided = true;
        material.pbrMetallicRoughness.metallicFactor = 0.0;
        material.pbrMetallicRoughness.roughnessFactor = 0.8;
        material.pbrMetallicRoughness.baseColorFactor = {
            linear(fabric.color[0]), linear(fabric.color[1]), linear(fabric.color[2]), 1.0};
        // a file that has gone since the design was looked at leaves the cloth plain
        const auto anyStart = [](std::string_view) { return std::optional<Message>(); };
        const auto picture = fabric.picture.empty() ? Result<std::string>(std::string())
                                                    : readWholeFile(fabric.picture, anyStart);
        if (picture && !picture->empty()) {
            material.pbrMetallicRoughness.baseColorTexture.index = builder.addPicture(*picture);
            material.pbrMetallicRoughness.baseColorFactor = {1.0, 1.0, 1.0, 1.0};
        }
        model.materials.push_back(std::move(material));
    }
}

enum class Normals { Given, Left };

// The vertices of panels or lines, one after the other.
template <std::size_t count>
std::vector<std::uint32_t> verticesOf(const std::vector<std::array<int, count>>& elements)
{
    std::vector<std::uint32_t> vertices;
    for (const std::array<int, count>& element : elements)
        vertices.insert(vertices.end(), element.begin(), element.end());
    return vertices;
}

// One primitive for the panels of each fabric and one for its lines, all on the same vertices.
tinygltf::Mesh meshOf(Builder& builder, const Surface& surface, Normals normals)
{
    constexpr int vertices = TINYGLTF_TARGET_ARRAY_BUFFER;
    tinygltf::Primitive common;
    common.attributes["POSITION"] = builder.addNumbers(flat(surface.position), 3, vertices);
    if (normals == Normals::Given) {
        std::vector<Vec3> up = normalsOf(surface);
        std::ranges::replace(up, Vec3(Vec3::Zero()),
                             Vec3(Vec3::UnitY())); // all must be of length 1
        common.attributes["NORMAL"] = builder.addNumbers(flat(up), 3, vertices);
    }
    const auto addTexture = [&](const std::vector<MeshAppearance::TexturePoint>& points) {
        std::vector<float> texture; // v points down here
        for (const auto& [u, v] : points)
            texture.insert(texture.end(), {float(u), float(1.0 - v)});
        return builder.addNumbers(texture, 2, vertices);
    };
    if (!surface.texture.empty())
        common.attributes["TEXCOORD_0"] = addTexture(surface.texture);

    tinygltf::Mesh mesh;
    mesh.name = surface.name;
    for (std::size_t fabric = 0; fabric < surface.fabrics.size(); ++fabric) {
        const auto corners = verticesOf(madeOf(fabric, surface.fabric, surface.panels));
        if (corners.empty())
            continue;
        mesh.primitives.push_back(common);
        mesh.primitives.back().mode = TINYGLTF_MODE_TRIANGLES;
        mesh.primitives.back().indices = builder.addIndices(corners);
        mesh.primitives.back().material = int(fabric);
        if (surface.isPrinted(fabric))
            mesh.primitives.back().attributes["TEXCOORD_0"] = addTexture(surface.prints[fabric]);
    }
    for (std::size_t fabric = 0; fabric < surface.fabrics.size(); ++fabric) {
        const auto ends = verticesOf(madeOf(fabric, surface.lineFabric, surface.lines));
        if (ends.empty())
            continue;
        mesh.primitives.push_back(common);
        mesh.primitives.back().attributes.erase("NORMAL");
        mesh.primitives.back().mode = TINYGLTF_MODE_LINE;
        mesh.primitives.back().indices = builder.addIndices(ends);
        mesh.primitives.back().material = int(fabric);
    }
    return mesh;
}

// Each frame has its own target, fully on at its time and off at its neighbours', of all nodes.
void addAnimation(Builder& builder, const FrameSpool& spool)
{
    const std::size_t frames = spool.count();
    std::vector<float> times;
    std::vector<float> weights(frames * (frames - 1), 0.0f);
    for (std::size_t i = 0; i < frames; ++i) {
        times.push_back(float(spool.time(i) - spool.time(0)));
        if (i > 0)
            weights[i * (frames - 1) + i - 1] = 1.0f;
    }
    tinygltf::AnimationSampler sampler;
    sampler.input = builder.addNumbers(times, 1, 0);
    sampler.output = builder.addNumbers(weights, 1, 0);
    sampler.interpolation = "LINEAR";
    tinygltf::Animation animation;
    animation.name = "flight";
    animation.samplers.push_back(std::move(sampler));
    for (std::size_t node = 0; node < builder.model().nodes.size(); ++node) {
        tinygltf::AnimationChannel channel;
        channel.sampler = 0;
        channel.target_node = int(node);
        channel.target_path = "weights";
        animation.channels.push_back(std::move(channel));
    }
    builder.model().animations.push_back(std::move(animation));
}

// A mesh at another time, as far as its vertices have gone from where they were at first.
void addTarget(Builder& builder, tinygltf::Mesh& mesh, std::span<const Eigen::Vector3f> first,
               std::vector<Eigen::Vector3f> moved)
{
    for (std::size_t k = 0; k < moved.size(); ++k)
        moved[k] -= first[k];
    const int target = builder.addNumbers(flat(std::span<const Eigen::Vector3f>(moved)), 3,
                                          TINYGLTF_TARGET_ARRAY_BUFFER);
    for (tinygltf::Primitive& primitive : mesh.primitives)
        primitive.targets.push_back({{"POSITION", target}});
    mesh.weights.push_back(0.0);
}

// Of the meshes of meshesOf().
std::optional<Failure> addTargets(Builder& builder, std::vector<tinygltf::Mesh>& meshes,
                                  const Tubes& tubes, FrameSpool& spool, ConstantMesh& shapes,
                                  const Progress& progress)
{
    const auto first = shapes.positions(spool, 0);
    if (!first)
        return first.failure();
    const std::vector<Eigen::Vector3f> around = tubes.positions(*first);
    const std::size_t frames = spool.count();
    const std::size_t bytes =
        builder.size() + 12 * (first->size() + around.size()) * frames + 4 * frames * frames;
    if (bytes > largestBuffer)
        return Failure("The animation would have %1 MB, and a glTF file holds 4096 at most; choose "
                       "fewer frames, or a point cache (.pc2).",
                       bytes >> 20);
    builder.model().buffers[0].data.reserve(bytes);
    for (std::size_t i = 1; i < frames; ++i) {
        if (!goesOn(progress, double(i) / double(frames)))
            return exportCancelled;
        auto moved = shapes.positions(spool, i);
        if (!moved)
            return moved.failure();
        if (!tubes.empty())
            addTarget(builder, meshes.back(), around, tubes.positions(*moved));
        addTarget(builder, meshes.front(), *first, std::move(*moved));
    }
    return std::nullopt;
}

// The fabric with its lines as edges, and the tubes of those that are round, if there are any.
std::vector<tinygltf::Mesh> meshesOf(Builder& builder, const Surface& surface, const Tubes& tubes,
                                     Normals normals)
{
    std::vector<tinygltf::Mesh> meshes{meshOf(builder, surface, normals)};
    if (!tubes.empty())
        meshes.push_back(meshOf(builder, tubes.surface(), normals));
    return meshes;
}

void addNodes(Builder& builder, std::vector<tinygltf::Mesh> meshes)
{
    tinygltf::Model& model = builder.model();
    tinygltf::Scene scene;
    for (tinygltf::Mesh& mesh : meshes) {
        tinygltf::Node node;
        node.name = mesh.name;
        node.mesh = int(model.meshes.size());
        if (!scene.nodes.empty())
            node.extras =
                tinygltf::Value(tinygltf::Value::Object{{tubesMark, tinygltf::Value(true)}});
        scene.nodes.push_back(int(model.nodes.size()));
        model.meshes.push_back(std::move(mesh));
        model.nodes.push_back(std::move(node));
    }
    model.scenes.push_back(std::move(scene));
    model.defaultScene = 0;
    model.asset.version = "2.0";
    model.asset.generator = "Ripstop " + std::string(releaseVersion());
}

enum class Container { Text, Binary };

std::optional<Failure> write(tinygltf::Model& model, std::ostream& out, Container container)
{
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, out, container == Container::Text,
                                                     container == Container::Binary))
        return Failure{"The glTF text cannot be written."};
    return std::nullopt;
}

class Gltf final : public SpooledSink
{
public:
    using SpooledSink::SpooledSink;

private:
    std::optional<Failure> write(ConstantMesh& shapes, std::ostream& out,
                                 const Progress& progress) override
    {
        Builder builder;
        const bool moves = spool().count() > 1;
        const Tubes tubes(shapes.surface());
        std::vector<tinygltf::Mesh> meshes =
            meshesOf(builder, shapes.surface(), tubes, moves ? Normals::Left : Normals::Given);
        if (moves)
            if (auto failure = addTargets(builder, meshes, tubes, spool(), shapes, progress))
                return failure;
        addMaterials(builder, shapes.surface());
        addNodes(builder, std::move(meshes));
        if (moves)
            addAnimation(builder, spool());
        return ripstop::write(builder.model(), out,
                              target().extension() == ".gltf" ? Container::Text
                                                              : Container::Binary);
    }
};

} // namespace

Result<std::unique_ptr<FrameSink>> gltfSink(const std::filesystem::path& target,
                                            const MeshAppearance& appearance)
{
    return opened(std::make_unique<Gltf>(target, appearance));
}

Result<std::string> glbMoment(const Frame& frame, const MeshAppearance& appearance)
{
    const Surface surface = surfaceOf(frame, appearance);
    if (surface.panels.empty() && surface.lines.empty())
        return Failure{"There is neither fabric nor a line at this moment to make a mesh of."};
    Builder builder;
    std::vector<tinygltf::Mesh> meshes = meshesOf(builder, surface, Tubes(surface), Normals::Given);
    addMaterials(builder, surface);
    addNodes(builder, std::move(meshes));
    std::ostringstream out;
    if (auto failure = write(builder.model(), out, Container::Binary))
        return *failure;
    return std::move(out).str();
}

} // namespace ripstop
