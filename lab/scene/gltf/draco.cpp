#include "lab/scene/gltf/draco.hpp"

#include "lab/scene/gltf/accessor.hpp"

#include <draco/compression/decode.h>

#include <cstring>

namespace glint::scene::gltf {
namespace {

template <class T>
bool copyValues(const draco::PointAttribute& attribute, uint32_t vertexCount, uint32_t components,
                std::vector<uint8_t>& out) {
    const size_t elementSize = sizeof(T) * components;
    out.resize(vertexCount * elementSize);
    std::vector<T> element(components);
    for (uint32_t i = 0; i < vertexCount; ++i) {
        const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(i));
        if (value.value() >= attribute.size() ||
            !attribute.ConvertValue<T>(value, static_cast<int8_t>(components), element.data()))
            return false;
        std::memcpy(out.data() + i * elementSize, element.data(), elementSize);
    }
    return true;
}

bool copyAs(ComponentType type, const draco::PointAttribute& attribute, uint32_t vertexCount, uint32_t components,
            std::vector<uint8_t>& out) {
    const bool wantsFloat = type == ComponentType::Float32;
    if (wantsFloat != (attribute.data_type() == draco::DT_FLOAT32))
        return false; // Draco would convert the numbers in ways that glTF does not define
    switch (type) {
    case ComponentType::Int8: return copyValues<int8_t>(attribute, vertexCount, components, out);
    case ComponentType::UInt8: return copyValues<uint8_t>(attribute, vertexCount, components, out);
    case ComponentType::Int16: return copyValues<int16_t>(attribute, vertexCount, components, out);
    case ComponentType::UInt16: return copyValues<uint16_t>(attribute, vertexCount, components, out);
    case ComponentType::UInt32: return copyValues<uint32_t>(attribute, vertexCount, components, out);
    case ComponentType::Float32: return copyValues<float>(attribute, vertexCount, components, out);
    }
    return false;
}

std::unique_ptr<draco::Mesh> decodeBytes(Document& document, const JsonObject& extension) {
    const int view = extension.requiredIndex("bufferView", document.views.size(), "bufferViews");
    if (document.failed())
        return nullptr;
    const std::span<const uint8_t> bytes = document.views[size_t(view)].bytes;
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::Decoder decoder;
    auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok()) {
        document.diagnostics.fail("bufferView {}: Draco: {}", view, mesh.status().error_msg_string());
        return nullptr;
    }
    return std::move(mesh).value();
}

} // namespace

DracoMesh decodeDraco(Document& document, const JsonObject& extension, const JsonObject& attributes) {
    DracoMesh result;
    const std::unique_ptr<draco::Mesh> mesh = decodeBytes(document, extension);
    if (!mesh)
        return result;
    const JsonObject ids = extension.object("attributes");
    for (const std::string& name : ids.keys()) {
        const uint64_t id = ids.count(name.c_str()).value_or(0);
        const int accessorIndex = attributes.requiredIndex(name.c_str(), document.accessors.size(), "accessors");
        if (document.failed())
            return result;
        const Accessor& accessor = document.accessors[size_t(accessorIndex)];
        const draco::PointAttribute* attribute = id <= std::numeric_limits<uint32_t>::max()
                                                     ? mesh->GetAttributeByUniqueId(static_cast<uint32_t>(id))
                                                     : nullptr;
        if (!attribute) {
            document.diagnostics.fail("{} is {}, but the Draco data has no such attribute", ids.pathOf(name.c_str()),
                                      id);
            return result;
        }
        if (accessor.count != mesh->num_points()) {
            document.diagnostics.fail("accessor {} has {} elements but its Draco data has {}", accessorIndex,
                                      accessor.count, mesh->num_points());
            return result;
        }
        const uint64_t bytes = accessor.count * elementBytes(accessor.componentType, accessor.shape);
        if (!document.reserve(bytes, ids.path()))
            return result;
        if (!copyAs(accessor.componentType, *attribute, mesh->num_points(), accessor.shape.components(),
                    result.attributes[name]))
            document.diagnostics.fail("{}: the Draco data does not fit accessor {}", ids.pathOf(name.c_str()),
                                      accessorIndex);
    }
    if (!document.reserve(uint64_t(mesh->num_faces()) * 12, extension.path()))
        return result;
    result.indices.reserve(size_t(mesh->num_faces()) * 3);
    for (uint32_t i = 0; i < mesh->num_faces(); ++i)
        for (int k = 0; k < 3; ++k)
            result.indices.push_back(mesh->face(draco::FaceIndex(i))[size_t(k)].value());
    return result;
}

} // namespace glint::scene::gltf
