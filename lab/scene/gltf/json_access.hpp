// Typed access to JSON of unknown structure. A JsonObject knows its own path ("materials[3].pbrMetallicRoughness"), so
// that messages can state it. Getters never throw: a value of the wrong kind is recorded in Diagnostics and the
// fallback is returned; for an absent value the fallback is returned.
#pragma once

#include "lab/scene/gltf/diagnostics.hpp"

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glint::scene::gltf {

using Json = nlohmann::json;

/// Parses `text`. Errors: InvalidInput with line and column. Nesting deeper than 128 is rejected: such JSON is not
/// glTF, and every later recursion would have to guard its stack.
Result<Json> parseJson(std::span<const uint8_t> text, const std::string& fileName);

class JsonObject {
public:
    /// `value` may be null (absent: every getter then returns its fallback). A value that is not an object is an error.
    JsonObject(const Json* value, std::string path, Diagnostics& diagnostics);

    bool exists() const { return value_ != nullptr; }
    bool has(const char* key) const { return find(key) != nullptr; }
    const std::string& path() const { return path_; }
    std::string pathOf(const char* key) const { return path_.empty() ? key : path_ + "." + key; }
    Diagnostics& diagnostics() const { return *diagnostics_; }

    bool boolean(const char* key, bool fallback) const;
    std::string string(const char* key) const;

    /// Returns a finite number, clamped to [min, max]. Exporters round, so 1.0000001 must not cause an error.
    float number(const char* key, float fallback, float min = std::numeric_limits<float>::lowest(),
                 float max = std::numeric_limits<float>::max()) const;
    std::vector<float> numbers(const char* key) const;
    template <int N>
    glm::vec<N, float> vector(const char* key, glm::vec<N, float> fallback) const;

    /// Returns an integer in [0, 2^53], the range that JSON represents exactly.
    std::optional<uint64_t> count(const char* key) const;
    uint64_t requiredCount(const char* key) const;

    /// Returns an index below `size`, or -1 if absent. `what` names the array in messages ("accessors").
    int index(const char* key, size_t size, const char* what) const;
    int requiredIndex(const char* key, size_t size, const char* what) const;
    std::vector<int> indices(const char* key, size_t size, const char* what) const;

    JsonObject object(const char* key) const;
    JsonObject extension(const char* name) const;
    /// Returns the object `name` in the extras. Extras may be any JSON; if they contain no object of this name, it
    /// counts as absent.
    JsonObject extras(const char* name) const;
    std::vector<JsonObject> objects(const char* key) const;
    std::vector<std::string> strings(const char* key) const;
    std::vector<std::string> keys() const;
    size_t arraySize(const char* key) const;

    void failMissing(const char* key) const;

private:
    const Json* find(const char* key) const;
    const Json* findArray(const char* key) const;
    bool readFloat(const Json& value, float& out) const;

    const Json* value_;
    std::string path_;
    Diagnostics* diagnostics_;
};

template <int N>
glm::vec<N, float> JsonObject::vector(const char* key, glm::vec<N, float> fallback) const {
    if (!has(key))
        return fallback;
    const std::vector<float> values = numbers(key);
    if (values.size() != N) {
        diagnostics_->fail("{} must be {} numbers", pathOf(key), N);
        return fallback;
    }
    glm::vec<N, float> result;
    for (int i = 0; i < N; ++i)
        result[i] = values[size_t(i)];
    return result;
}

} // namespace glint::scene::gltf
