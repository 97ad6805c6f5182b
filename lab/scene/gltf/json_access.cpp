#include "lab/scene/gltf/json_access.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene::gltf {
namespace {

constexpr int kMaxDepth = 128;
constexpr uint64_t kMaxInteger = uint64_t(1) << 53;

/// Checks the nesting depth without recursion, before parsing.
bool nestsTooDeep(std::span<const uint8_t> text) {
    int depth = 0;
    bool inString = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const uint8_t c = text[i];
        if (inString) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            if (++depth > kMaxDepth)
                return true;
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return false;
}

/// Removes the library's error number and line breaks from its message.
std::string withoutPrefix(const std::string& message) {
    const size_t end = message.find("] ");
    std::string text = end == std::string::npos ? message : message.substr(end + 2);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
    constexpr size_t kLongest = 200; // a wrong token may be a whole embedded buffer
    return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

} // namespace

Result<Json> parseJson(std::span<const uint8_t> text, const std::string& fileName) {
    if (nestsTooDeep(text))
        return invalidInput("{}: JSON is nested deeper than {} levels", fileName, kMaxDepth);
    // Exceptions, as without them the library does not report the position of an error.
    try {
        Json root = Json::parse(text.begin(), text.end());
        if (!root.is_object())
            return invalidInput("{}: the JSON is not an object", fileName);
        return root;
    } catch (const Json::exception& exception) {
        return invalidInput("{}: {}", fileName, withoutPrefix(exception.what()));
    }
}

JsonObject::JsonObject(const Json* value, std::string path, Diagnostics& diagnostics)
    : value_(value), path_(std::move(path)), diagnostics_(&diagnostics) {
    if (value_ && !value_->is_object()) {
        diagnostics_->fail("{} must be an object", path_);
        value_ = nullptr;
    }
}

const Json* JsonObject::find(const char* key) const {
    if (!value_)
        return nullptr;
    const auto found = value_->find(key);
    return found == value_->end() ? nullptr : &*found;
}

const Json* JsonObject::findArray(const char* key) const {
    const Json* value = find(key);
    if (value && !value->is_array()) {
        diagnostics_->fail("{} must be an array", pathOf(key));
        return nullptr;
    }
    return value;
}

void JsonObject::failMissing(const char* key) const {
    diagnostics_->fail("{} is missing", pathOf(key));
}

bool JsonObject::boolean(const char* key, bool fallback) const {
    const Json* value = find(key);
    if (!value)
        return fallback;
    if (!value->is_boolean()) {
        diagnostics_->fail("{} must be true or false", pathOf(key));
        return fallback;
    }
    return value->get<bool>();
}

std::string JsonObject::string(const char* key) const {
    const Json* value = find(key);
    if (!value)
        return {};
    if (!value->is_string()) {
        diagnostics_->fail("{} must be a string", pathOf(key));
        return {};
    }
    return value->get<std::string>();
}

bool JsonObject::readFloat(const Json& value, float& out) const {
    if (!value.is_number())
        return false;
    const double number = value.get<double>();
    if (!(std::abs(number) <= double(std::numeric_limits<float>::max())))
        return false;
    out = static_cast<float>(number);
    return true;
}

float JsonObject::number(const char* key, float fallback, float min, float max) const {
    const Json* value = find(key);
    if (!value)
        return fallback;
    float number = fallback;
    if (!readFloat(*value, number)) {
        diagnostics_->fail("{} must be a number within the range of a float", pathOf(key));
        return fallback;
    }
    return std::clamp(number, min, max);
}

std::vector<float> JsonObject::numbers(const char* key) const {
    const Json* array = findArray(key);
    if (!array)
        return {};
    std::vector<float> result(array->size());
    for (size_t i = 0; i < result.size(); ++i) {
        if (!readFloat((*array)[i], result[i])) {
            diagnostics_->fail("{}[{}] must be a number within the range of a float", pathOf(key), i);
            return {};
        }
    }
    return result;
}

namespace {

/// JSON Schema's integer: 3, but also 3.0 and 3e0, which some exporters write.
std::optional<uint64_t> wholeNumber(const Json& value) {
    if (value.is_number_unsigned())
        return value.get<uint64_t>() <= kMaxInteger ? std::optional(value.get<uint64_t>()) : std::nullopt;
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (number >= 0 && number <= double(kMaxInteger) && number == std::floor(number))
            return static_cast<uint64_t>(number);
    }
    return std::nullopt;
}

} // namespace

std::optional<uint64_t> JsonObject::count(const char* key) const {
    const Json* value = find(key);
    if (!value)
        return std::nullopt;
    const std::optional<uint64_t> number = wholeNumber(*value);
    if (!number)
        diagnostics_->fail("{} must be a whole number, 0 or more", pathOf(key));
    return number;
}

uint64_t JsonObject::requiredCount(const char* key) const {
    if (!has(key))
        failMissing(key);
    return count(key).value_or(0);
}

int JsonObject::index(const char* key, size_t size, const char* what) const {
    const std::optional<uint64_t> number = count(key);
    if (!number)
        return -1;
    if (*number >= size) {
        diagnostics_->fail("{} is {} but the file has {} {}", pathOf(key), *number, size, what);
        return -1;
    }
    return static_cast<int>(*number);
}

int JsonObject::requiredIndex(const char* key, size_t size, const char* what) const {
    if (!has(key))
        failMissing(key);
    return index(key, size, what);
}

std::vector<int> JsonObject::indices(const char* key, size_t size, const char* what) const {
    const Json* array = findArray(key);
    if (!array)
        return {};
    std::vector<int> result;
    result.reserve(array->size());
    for (const Json& value : *array) {
        const std::optional<uint64_t> number = wholeNumber(value);
        if (!number || *number >= size) {
            diagnostics_->fail("{}[{}] must be a whole number below {}, the file's {}", pathOf(key), result.size(),
                               size, what);
            return {};
        }
        result.push_back(static_cast<int>(*number));
    }
    return result;
}

JsonObject JsonObject::object(const char* key) const {
    return {find(key), pathOf(key), *diagnostics_};
}

JsonObject JsonObject::extras(const char* name) const {
    const Json* const all = find("extras");
    const auto found = all && all->is_object() ? all->find(name) : Json::const_iterator();
    const bool ours = all && all->is_object() && found != all->end() && found->is_object();
    return {ours ? &*found : nullptr, pathOf("extras") + "." + name, *diagnostics_};
}

JsonObject JsonObject::extension(const char* name) const {
    return object("extensions").object(name);
}

std::vector<JsonObject> JsonObject::objects(const char* key) const {
    const Json* array = findArray(key);
    if (!array)
        return {};
    std::vector<JsonObject> result;
    result.reserve(array->size());
    for (size_t i = 0; i < array->size(); ++i)
        result.emplace_back(&(*array)[i], fmt::format("{}[{}]", pathOf(key), i), *diagnostics_);
    return result;
}

std::vector<std::string> JsonObject::strings(const char* key) const {
    const Json* array = findArray(key);
    if (!array)
        return {};
    std::vector<std::string> result;
    for (const Json& value : *array) {
        if (value.is_string())
            result.push_back(value.get<std::string>());
        else
            diagnostics_->fail("{}[{}] must be a string", pathOf(key), result.size());
    }
    return result;
}

std::vector<std::string> JsonObject::keys() const {
    std::vector<std::string> result;
    if (value_)
        for (const auto& item : value_->items())
            result.push_back(item.key());
    return result;
}

size_t JsonObject::arraySize(const char* key) const {
    const Json* array = findArray(key);
    return array ? array->size() : 0;
}

} // namespace glint::scene::gltf
