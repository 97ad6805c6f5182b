#include "lab/scene/gltf/meshes.hpp"

#include "lab/scene/gltf/attributes.hpp"
#include "lab/scene/gltf/shading_frames.hpp"
#include "lab/scene/gltf/topology.hpp"

#include <algorithm>
#include <numeric>

namespace glint::scene::gltf {
namespace {

PrimitiveMode readMode(const JsonObject& object) {
    const uint64_t mode = object.count("mode").value_or(4);
    if (mode > 6)
        object.diagnostics().fail("{} is {}, which is no primitive mode of glTF", object.pathOf("mode"), mode);
    return mode > 6 ? PrimitiveMode::Triangles : static_cast<PrimitiveMode>(mode);
}

void readSkinSets(Attributes& attributes, Primitive& primitive) {
    for (int set = 0;; ++set) {
        const std::string joints = fmt::format("JOINTS_{}", set);
        const std::string weights = fmt::format("WEIGHTS_{}", set);
        if (!attributes.has(joints.c_str()) || !attributes.has(weights.c_str()))
            return;
        SkinSet skin{attributes.joints(joints.c_str()), attributes.weights(weights.c_str())};
        if (skin.joints.size() != skin.weights.size())
            return; // one of them failed
        // Joints with weight 0 are often left over from other skins and must not be checked against this one.
        for (size_t i = 0; i < skin.joints.size(); ++i)
            for (int k = 0; k < 4; ++k)
                if (!(skin.weights[i][k] > 0)) {
                    skin.weights[i][k] = 0;
                    skin.joints[i][k] = 0;
                }
        primitive.skinSets.push_back(std::move(skin));
    }
}

void readMorphTargets(Document& document, const JsonObject& object, Primitive& primitive) {
    for (const JsonObject& target : object.objects("targets")) {
        Attributes attributes(document, target, nullptr); // Draco leaves targets uncompressed
        attributes.setVertexCount(primitive.geometry.positions.size());
        primitive.morphTargets.push_back(
            {attributes.positions("POSITION"), attributes.vec3("NORMAL"), attributes.vec3("TANGENT")});
        if (document.failed())
            return;
    }
}

void readAttributes(Document& document, const JsonObject& object, const DracoMesh* draco, Primitive& primitive) {
    const JsonObject attributeObject = object.object("attributes");
    Attributes attributes(document, attributeObject, draco);
    Geometry& geometry = primitive.geometry;
    geometry.positions = attributes.positions("POSITION");
    if (document.failed())
        return;
    attributes.setVertexCount(geometry.positions.size());
    geometry.normals = attributes.vec3("NORMAL");
    geometry.tangents = attributes.vec4("TANGENT");
    for (uint32_t set = 0; set < kMaxTexCoords; ++set)
        geometry.uvs[set] = attributes.vec2(fmt::format("TEXCOORD_{}", set).c_str());
    geometry.colors = attributes.color("COLOR_0");
    readSkinSets(attributes, primitive);
    if (!document.failed())
        readMorphTargets(document, object, primitive);
}

/// Returns the file's indices, or 0, 1, 2, ... without any.
std::vector<uint32_t> readIndices(Document& document, const JsonObject& object, size_t vertexCount) {
    std::vector<uint32_t> indices;
    if (object.has("indices")) {
        const Accessor* accessor = findAccessor(document, object, "indices", {kScalar});
        if (accessor)
            indices = readIntegers(document, *accessor);
    } else if (document.reserve(vertexCount * sizeof(uint32_t), object.path())) {
        indices.resize(vertexCount);
        std::iota(indices.begin(), indices.end(), 0u);
    }
    return indices;
}

bool checkIndices(Document& document, const JsonObject& object, const std::vector<uint32_t>& indices,
                  size_t vertexCount) {
    const auto bad = std::find_if(indices.begin(), indices.end(), [&](uint32_t index) { return index >= vertexCount; });
    if (bad == indices.end())
        return true;
    document.diagnostics.fail("{}: index {} is vertex {} but there are {}", object.path(), bad - indices.begin(), *bad,
                              vertexCount);
    return false;
}

/// Returns the texture coordinate set of the material's normal map, if it has one.
std::optional<uint32_t> normalMapTexCoord(const Scene& scene, int material) {
    if (material < 0)
        return std::nullopt;
    const Material& m = scene.materials[size_t(material)];
    if (m.normalTexture.texture >= 0)
        return m.normalTexture.texCoord;
    if (m.clearcoatNormalTexture.texture >= 0)
        return m.clearcoatNormalTexture.texCoord;
    return std::nullopt;
}

void completeShadingFrames(Document& document, const Scene& scene, Primitive& primitive) {
    Geometry& geometry = primitive.geometry;
    if (geometry.normals.empty())
        geometry.tangents.clear(); // tangents without normals are undefined
    repairShadingFrames(geometry);
    if (geometry.normals.empty() && geometry.topology == Topology::Triangles)
        makeFlatNormals(document, primitive);
    const std::optional<uint32_t> texCoord = normalMapTexCoord(scene, primitive.material);
    if (!document.failed() && geometry.tangents.empty() && texCoord)
        makeTangents(document, primitive, *texCoord);
}

Primitive readPrimitive(Document& document, const JsonObject& object, const Scene& scene) {
    Primitive primitive;
    PrimitiveMode mode = readMode(object);
    primitive.material = object.index("material", scene.materials.size(), "materials");

    const JsonObject compression = object.extension("KHR_draco_mesh_compression");
    DracoMesh draco;
    if (compression.exists()) {
        draco = decodeDraco(document, compression, object.object("attributes"));
        mode = PrimitiveMode::Triangles; // strips are unrolled by the codec
    }
    if (document.failed())
        return primitive;
    readAttributes(document, object, compression.exists() ? &draco : nullptr, primitive);
    if (document.failed())
        return primitive;

    Geometry& geometry = primitive.geometry;
    std::vector<uint32_t> indices =
        compression.exists() ? std::move(draco.indices) : readIndices(document, object, geometry.positions.size());
    if (document.failed() || !checkIndices(document, object, indices, geometry.positions.size()) ||
        !document.reserve(indices.size() * 3 * sizeof(uint32_t), object.path())) // a strip grows threefold
        return primitive;
    geometry.topology = listTopology(mode);
    geometry.indices = expandToList(mode, std::move(indices));
    completeShadingFrames(document, scene, primitive);
    return primitive;
}

Mesh readMesh(Document& document, const JsonObject& object, const Scene& scene) {
    Mesh mesh;
    mesh.name = object.string("name");
    for (const JsonObject& primitiveObject : object.objects("primitives")) {
        if (!primitiveObject.object("attributes").has("POSITION")) {
            document.diagnostics.warn("{} has no POSITION and is not drawn", primitiveObject.path());
            continue;
        }
        mesh.primitives.push_back(readPrimitive(document, primitiveObject, scene));
        if (document.failed())
            return mesh;
        if (mesh.primitives.back().morphTargets.size() != mesh.primitives.front().morphTargets.size())
            document.diagnostics.fail("{}: all primitives of a mesh must have the same number of morph targets",
                                      object.path());
    }
    mesh.weights = object.numbers("weights");
    const size_t targets = mesh.primitives.empty() ? 0 : mesh.primitives.front().morphTargets.size();
    if (!mesh.weights.empty() && mesh.weights.size() != targets)
        document.diagnostics.fail("{} has {} numbers but the mesh has {} morph targets", object.pathOf("weights"),
                                  mesh.weights.size(), targets);
    mesh.weights.resize(targets, 0.0f);
    return mesh;
}

} // namespace

void readMeshes(Document& document, Scene& scene) {
    for (const JsonObject& object : document.root().objects("meshes")) {
        scene.meshes.push_back(readMesh(document, object, scene));
        if (document.failed())
            return;
    }
}

} // namespace glint::scene::gltf
