#include "lab/scene/gltf/accessor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

namespace glint::scene::gltf {
namespace {

/// Beyond any valid index; below it no product of counts and strides overflows 64 bits.
constexpr uint64_t kMaxCount = uint64_t(1) << 32;

struct ShapeName {
    std::string_view name;
    ElementShape shape;
};
constexpr std::array<ShapeName, 7> kShapes = {{
    {"SCALAR", {1, 1}},
    {"VEC2", {2, 1}},
    {"VEC3", {3, 1}},
    {"VEC4", {4, 1}},
    {"MAT2", {2, 2}},
    {"MAT3", {3, 3}},
    {"MAT4", {4, 4}},
}};

ComponentType readComponentType(const JsonObject& object) {
    const uint64_t number = object.requiredCount("componentType");
    switch (number) {
    case 5120:
    case 5121:
    case 5122:
    case 5123:
    case 5125:
    case 5126: return static_cast<ComponentType>(number);
    default:
        object.diagnostics().fail("{} is {}, which is no component type of glTF", object.pathOf("componentType"),
                                  number);
        return ComponentType::Float32;
    }
}

/// Checks that `count` elements of `size` bytes, `stride` apart, end inside the view.
void checkRange(Document& document, const std::string& what, int viewIndex, uint64_t offset, uint64_t count,
                uint64_t stride, uint64_t size) {
    if (count == 0 || document.failed())
        return;
    const uint64_t end = offset + (count - 1) * stride + size;
    const uint64_t available = document.views[size_t(viewIndex)].bytes.size();
    if (end > available)
        document.diagnostics.fail("{} ends at byte {} but bufferView {} has {}", what, end, viewIndex, available);
}

uint64_t effectiveStride(const Document& document, const Accessor& accessor) {
    const uint32_t stride = document.views[size_t(accessor.bufferView)].stride;
    return stride ? stride : elementBytes(accessor.componentType, accessor.shape);
}

SparseAccessor readSparse(Document& document, const JsonObject& object, const Accessor& accessor) {
    SparseAccessor sparse;
    sparse.count = object.requiredCount("count");
    if (sparse.count > accessor.count)
        document.diagnostics.fail("accessor {} has {} sparse values but only {} elements", accessor.index, sparse.count,
                                  accessor.count);
    const JsonObject indices = object.object("indices");
    sparse.indicesView = indices.requiredIndex("bufferView", document.views.size(), "bufferViews");
    sparse.indicesOffset = indices.count("byteOffset").value_or(0);
    sparse.indicesType = readComponentType(indices);
    const JsonObject values = object.object("values");
    sparse.valuesView = values.requiredIndex("bufferView", document.views.size(), "bufferViews");
    sparse.valuesOffset = values.count("byteOffset").value_or(0);
    if (sparse.indicesType != ComponentType::UInt8 && sparse.indicesType != ComponentType::UInt16 &&
        sparse.indicesType != ComponentType::UInt32)
        document.diagnostics.fail("{} must be an unsigned integer type", indices.pathOf("componentType"));

    const uint64_t indexSize = componentBytes(sparse.indicesType);
    const uint64_t valueSize = elementBytes(accessor.componentType, accessor.shape);
    checkRange(document, fmt::format("accessor {}: sparse.indices", accessor.index), sparse.indicesView,
               sparse.indicesOffset, sparse.count, indexSize, indexSize);
    checkRange(document, fmt::format("accessor {}: sparse.values", accessor.index), sparse.valuesView,
               sparse.valuesOffset, sparse.count, valueSize, valueSize);
    return sparse;
}

Accessor readAccessor(Document& document, const JsonObject& object, size_t index) {
    Accessor accessor;
    accessor.index = static_cast<int>(index);
    accessor.componentType = readComponentType(object);
    accessor.normalized = object.boolean("normalized", false);
    accessor.count = object.requiredCount("count");
    if (accessor.count > kMaxCount)
        document.diagnostics.fail("accessor {} has {} elements; at most {} can be indexed", index, accessor.count,
                                  kMaxCount);
    const std::string type = object.string("type");
    const auto shape = std::find_if(kShapes.begin(), kShapes.end(), [&](const ShapeName& s) { return s.name == type; });
    if (shape == kShapes.end())
        document.diagnostics.fail("accessor {} has type \"{}\", which is none of glTF's", index, type);
    else
        accessor.shape = shape->shape;
    accessor.bufferView = object.index("bufferView", document.views.size(), "bufferViews");
    accessor.byteOffset = object.count("byteOffset").value_or(0);
    if (document.failed())
        return accessor;

    if (accessor.bufferView >= 0) {
        const uint64_t size = elementBytes(accessor.componentType, accessor.shape);
        const uint64_t stride = effectiveStride(document, accessor);
        if (stride < size)
            document.diagnostics.fail("accessor {} has elements of {} bytes but bufferView {} has byteStride {}", index,
                                      size, accessor.bufferView, stride);
        checkRange(document, fmt::format("accessor {}", index), accessor.bufferView, accessor.byteOffset,
                   accessor.count, stride, size);
    }
    if (const JsonObject sparse = object.object("sparse"); sparse.exists())
        accessor.sparse = readSparse(document, sparse, accessor);
    return accessor;
}

template <class T>
T load(const uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(value));
    return value;
}

// glTF 2.0 specification, section 3.11, "Animations": f = max(c / (2^(bits-1) - 1), -1) and f = c / (2^bits - 1).
template <class T>
float normalizedFloat(T value) {
    return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

float loadFloat(const uint8_t* bytes, ComponentType type, bool normalized) {
    const auto convert = [normalized](auto value) {
        return normalized ? normalizedFloat(value) : static_cast<float>(value);
    };
    switch (type) {
    case ComponentType::Int8: return convert(load<int8_t>(bytes));
    case ComponentType::UInt8: return convert(load<uint8_t>(bytes));
    case ComponentType::Int16: return convert(load<int16_t>(bytes));
    case ComponentType::UInt16: return convert(load<uint16_t>(bytes));
    case ComponentType::UInt32: return convert(load<uint32_t>(bytes));
    case ComponentType::Float32: return load<float>(bytes);
    }
    return 0;
}

uint32_t loadInteger(const uint8_t* bytes, ComponentType type) {
    switch (type) {
    case ComponentType::UInt8: return load<uint8_t>(bytes);
    case ComponentType::UInt16: return load<uint16_t>(bytes);
    case ComponentType::UInt32: return load<uint32_t>(bytes);
    default: return 0; // rejected by readIntegers
    }
}

/// Calls `store(position, componentBytes)` for every component of `count` elements; position counts components.
template <class Store>
void forEachComponent(const Accessor& accessor, const uint8_t* first, uint64_t count, uint64_t stride, Store&& store) {
    const uint32_t size = componentBytes(accessor.componentType);
    const uint32_t columnBytes = elementBytes(accessor.componentType, accessor.shape) / accessor.shape.columns;
    size_t position = 0;
    for (uint64_t element = 0; element < count; ++element)
        for (uint32_t column = 0; column < accessor.shape.columns; ++column)
            for (uint32_t row = 0; row < accessor.shape.rows; ++row)
                store(position++, first + element * stride + column * columnBytes + row * size);
}

/// Replaces base values by the sparse ones.
template <class T, class Load>
void applySparse(Document& document, const Accessor& accessor, std::vector<T>& values, Load&& loadComponent) {
    const SparseAccessor& sparse = *accessor.sparse;
    if (sparse.count == 0)
        return;
    const uint8_t* indices = document.views[size_t(sparse.indicesView)].bytes.data() + sparse.indicesOffset;
    const uint8_t* replacements = document.views[size_t(sparse.valuesView)].bytes.data() + sparse.valuesOffset;
    const uint32_t indexSize = componentBytes(sparse.indicesType);
    const uint32_t valueSize = elementBytes(accessor.componentType, accessor.shape);
    const uint32_t components = accessor.shape.components();
    for (uint64_t i = 0; i < sparse.count; ++i) {
        const uint64_t target = loadInteger(indices + i * indexSize, sparse.indicesType);
        if (target >= accessor.count) {
            document.diagnostics.fail("accessor {} replaces element {} but has {}", accessor.index, target,
                                      accessor.count);
            return;
        }
        forEachComponent(accessor, replacements + i * valueSize, 1, valueSize,
                         [&](size_t position, const uint8_t* bytes) {
                             values[target * components + position] = loadComponent(bytes);
                         });
    }
}

/// Reads from the view, from `packed`, or zeros; then applies the sparse values.
template <class T, class Load>
std::vector<T> readComponents(Document& document, const Accessor& accessor, const std::span<const uint8_t>* packed,
                              Load&& loadComponent) {
    const uint64_t total = accessor.count * accessor.shape.components();
    const uint64_t size = elementBytes(accessor.componentType, accessor.shape);
    if (packed ? packed->size() < accessor.count * size
               : accessor.bufferView < 0 && accessor.count > document.limits.unbackedElements) {
        document.diagnostics.fail("accessor {} has {} elements but no data for them", accessor.index, accessor.count);
        return {};
    }
    if (!document.reserve(total * sizeof(T), fmt::format("accessor {}", accessor.index)))
        return {};
    std::vector<T> values(total);
    const auto store = [&](size_t position, const uint8_t* bytes) { values[position] = loadComponent(bytes); };
    if (packed)
        forEachComponent(accessor, packed->data(), accessor.count, size, store);
    else if (accessor.bufferView >= 0)
        forEachComponent(accessor, document.views[size_t(accessor.bufferView)].bytes.data() + accessor.byteOffset,
                         accessor.count, effectiveStride(document, accessor), store);
    if (accessor.sparse)
        applySparse(document, accessor, values, loadComponent);
    return document.failed() ? std::vector<T>() : values;
}

std::vector<float> readFloatsFrom(Document& document, const Accessor& accessor,
                                  const std::span<const uint8_t>* packed) {
    return readComponents<float>(document, accessor, packed, [&](const uint8_t* bytes) {
        return loadFloat(bytes, accessor.componentType, accessor.normalized);
    });
}

std::vector<uint32_t> readIntegersFrom(Document& document, const Accessor& accessor,
                                       const std::span<const uint8_t>* packed) {
    const ComponentType type = accessor.componentType;
    if (type != ComponentType::UInt8 && type != ComponentType::UInt16 && type != ComponentType::UInt32) {
        document.diagnostics.fail("accessor {} must hold unsigned integers to be used as indices or joints",
                                  accessor.index);
        return {};
    }
    return readComponents<uint32_t>(document, accessor, packed,
                                    [type](const uint8_t* bytes) { return loadInteger(bytes, type); });
}

} // namespace

uint32_t componentBytes(ComponentType type) {
    switch (type) {
    case ComponentType::Int8:
    case ComponentType::UInt8: return 1;
    case ComponentType::Int16:
    case ComponentType::UInt16: return 2;
    case ComponentType::UInt32:
    case ComponentType::Float32: return 4;
    }
    return 4;
}

uint32_t elementBytes(ComponentType type, const ElementShape& shape) {
    const uint32_t column = shape.rows * componentBytes(type);
    return shape.columns == 1 ? column : (column + 3) / 4 * 4 * shape.columns;
}

std::string shapeName(const ElementShape& shape) {
    const auto found =
        std::find_if(kShapes.begin(), kShapes.end(), [&](const ShapeName& s) { return s.shape == shape; });
    return std::string(found->name);
}

void readAccessors(Document& document) {
    const std::vector<JsonObject> objects = document.root().objects("accessors");
    document.accessors.reserve(objects.size());
    for (size_t i = 0; i < objects.size() && !document.failed(); ++i)
        document.accessors.push_back(readAccessor(document, objects[i], i));
}

std::vector<float> readFloats(Document& document, const Accessor& accessor) {
    return readFloatsFrom(document, accessor, nullptr);
}

std::vector<float> readFloats(Document& document, const Accessor& accessor, std::span<const uint8_t> packed) {
    return readFloatsFrom(document, accessor, &packed);
}

std::vector<uint32_t> readIntegers(Document& document, const Accessor& accessor) {
    return readIntegersFrom(document, accessor, nullptr);
}

std::vector<uint32_t> readIntegers(Document& document, const Accessor& accessor, std::span<const uint8_t> packed) {
    return readIntegersFrom(document, accessor, &packed);
}

const Accessor* findAccessor(Document& document, const JsonObject& object, const char* key,
                             std::initializer_list<ElementShape> shapes) {
    const int index = object.index(key, document.accessors.size(), "accessors");
    if (index < 0)
        return nullptr;
    const Accessor& accessor = document.accessors[size_t(index)];
    if (std::find(shapes.begin(), shapes.end(), accessor.shape) == shapes.end()) {
        document.diagnostics.fail("accessor {} is {}, but {} needs {}", index, shapeName(accessor.shape),
                                  object.pathOf(key), shapeName(*shapes.begin()));
        return nullptr;
    }
    return &accessor;
}

} // namespace glint::scene::gltf
