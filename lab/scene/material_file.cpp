// Material overrides as JSON.
#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/scene/gltf/json_access.hpp"
#include "lab/scene/material_overrides.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace glint::scene {
namespace {

using gltf::Json;

constexpr size_t kLongestFile = size_t{16} << 20;
constexpr std::string_view kTopKeys[] = {"materials", "description"};

std::string suggestion(std::string_view text, const std::vector<std::string_view>& known) {
    const std::string_view meant = likelyMeant(text, known);
    return meant.empty() ? std::string() : fmt::format("; did you mean '{}'?", printable(meant));
}

/// The JSON of one file; stops at the first error.
class MaterialFile {
public:
    MaterialFile(const std::string& path, const Scene& scene) : path_(path), scene_(scene) {}

    Result<MaterialOverrides> read() {
        GLINT_TRY(text, readFile(path_, kLongestFile));
        GLINT_TRY(root, gltf::parseJson({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, path_));
        for (const auto& [key, value] : root.items())
            if (std::ranges::find(kTopKeys, key) == std::end(kTopKeys))
                return fail(key, fmt::format("is unknown; a material file has \"materials\"{}",
                                             suggestion(key, {std::begin(kTopKeys), std::end(kTopKeys)})));
        if (!root.contains("materials") || !root["materials"].is_object())
            return fail("materials", "must be an object: {\"materials\": {\"floor\": {\"roughness\": 0.1}}}");
        // `#index` is more specific than a name, which several materials may have.
        for (const bool byIndex : {false, true})
            for (const auto& [key, json] : root["materials"].items()) {
                GLINT_TRY(indices, find(key));
                if (indices.byIndex == byIndex)
                    for (const size_t index : indices.materials)
                        GLINT_CHECK(readMaterial(key, json, index));
            }
        return std::move(overrides_);
    }

private:
    struct Found {
        std::vector<size_t> materials;
        bool byIndex = false;
    };

    Error fail(std::string_view where, std::string_view what) const {
        return invalidInput("{}: {} {}", path_, printable(where), what);
    }

    Result<Found> find(const std::string& key) const {
        Found found;
        std::vector<std::string_view> names;
        for (size_t i = 0; i < scene_.materials.size(); ++i) {
            names.push_back(scene_.materials[i].name);
            if (names.back() == key)
                found.materials.push_back(i);
        }
        if (!found.materials.empty())
            return found;
        size_t index = 0;
        const char* const end = key.data() + key.size();
        if (key.starts_with('#'))
            if (const auto [rest, error] = std::from_chars(key.data() + 1, end, index);
                error == std::errc() && rest == end) {
                if (index >= scene_.materials.size())
                    return fail(key, fmt::format("is no material: the scene has {}", scene_.materials.size()));
                return Found{{index}, true};
            }
        std::erase(names, "");
        return fail(key, "is no material of the scene" + suggestion(key, names));
    }

    Result<void> readMaterial(const std::string& key, const Json& json, size_t index) {
        if (!json.is_object())
            return fail(key, "must be an object: {\"roughness\": 0.1}");
        MaterialOverride& override = overrides_[index];
        if (const auto kind = json.find("kind"); kind != json.end()) {
            GLINT_TRY(choice, readChoice(key + ".kind", *kind, kMaterialKindNames));
            override.kind = static_cast<MaterialKind>(choice);
        }
        const MaterialKind kind = kindOf(scene_.materials[index], override);
        for (const auto& [name, value] : json.items()) {
            const std::string where = fmt::format("{}.{}", key, name);
            if (name == "textures") {
                GLINT_CHECK(readTextures(where, value, kind, override));
            } else if (name != "kind") {
                GLINT_TRY(field, findRow(where, name, kind, materialFields(), {"kind", "textures"}));
                GLINT_TRY(read, readValue(where, value, materialFields()[field]));
                override.values[field] = read;
            }
        }
        return {};
    }

    /// Returns the row with this name that the kind of material has.
    template <class Row>
    Result<size_t> findRow(const std::string& where, std::string_view name, MaterialKind kind,
                           std::span<const Row> rows, std::vector<std::string_view> known) const {
        bool ofAnotherKind = false;
        for (size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].name == name && (rows[i].kinds & kindBit(kind)) != 0)
                return i;
            ofAnotherKind |= rows[i].name == name;
            if ((rows[i].kinds & kindBit(kind)) != 0)
                known.push_back(rows[i].name);
        }
        const std::string_view kindName = kMaterialKindNames[static_cast<size_t>(kind)];
        if (ofAnotherKind)
            return fail(where, fmt::format("does not exist in a material of kind {}", kindName));
        return fail(where, "is unknown" + suggestion(name, known));
    }

    Result<size_t> readChoice(const std::string& where, const Json& json,
                              std::span<const std::string_view> choices) const {
        const std::string text = json.is_string() ? json.get<std::string>() : std::string();
        const auto found = std::ranges::find(choices, text);
        if (found != choices.end())
            return static_cast<size_t>(found - choices.begin());
        std::vector<std::string> quoted;
        for (const std::string_view choice : choices)
            quoted.push_back(fmt::format("\"{}\"", choice));
        return fail(where, "must be " + listText(quoted, " or "));
    }

    Result<FieldValue> readValue(const std::string& where, const Json& json, const MaterialField& field) const {
        switch (field.type) {
        case FieldType::Choice: {
            GLINT_TRY(choice, readChoice(where, json, field.choices));
            return FieldValue(static_cast<float>(choice));
        }
        case FieldType::Switch:
            if (!json.is_boolean())
                return fail(where, "must be true or false");
            return FieldValue(json.get<bool>());
        case FieldType::Number:
            if (!inRange(json, field))
                return fail(where, fmt::format("must be a number from {} to {}", field.min, field.max));
            return FieldValue(json.get<float>());
        case FieldType::Color: break;
        }
        const auto good = [&](const Json& part) { return inRange(part, field); };
        if (!json.is_array() || json.size() != 3 || !std::ranges::all_of(json, good))
            return fail(where, fmt::format("must be three numbers from {} to {}", field.min, field.max));
        return FieldValue(json[0].get<float>(), json[1].get<float>(), json[2].get<float>());
    }

    static bool inRange(const Json& json, const MaterialField& field) {
        return json.is_number() && json.get<double>() >= double(field.min) && json.get<double>() <= double(field.max);
    }

    Result<void> readTextures(const std::string& where, const Json& json, MaterialKind kind,
                              MaterialOverride& override) const {
        if (!json.is_object())
            return fail(where, "must be an object: {\"baseColor\": \"file.png\"}");
        for (const auto& [name, value] : json.items()) {
            const std::string place = fmt::format("{}.{}", where, name);
            GLINT_TRY(slot, findRow(place, name, kind, materialTextures(), {}));
            if (!value.is_null() && (!value.is_string() || value.get<std::string>().empty()))
                return fail(place, "must be the path of an image, or null for no texture");
            const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
            override.textures[slot] = {value.is_null() ? "" : (folder / value.get<std::string>()).string(), -1};
        }
        return {};
    }

    const std::string& path_;
    const Scene& scene_;
    MaterialOverrides overrides_;
};

using OrderedJson = nlohmann::ordered_json;

OrderedJson valueJson(const MaterialField& field, FieldValue value) {
    // The shortest decimal that reads back as the same float: 0.1, not 0.10000000149011612.
    const auto number = [](float f) { return OrderedJson::parse(fmt::format("{}", f)); };
    switch (field.type) {
    case FieldType::Choice: return field.choices[static_cast<size_t>(value.x)];
    case FieldType::Switch: return value.x != 0;
    case FieldType::Number: return number(value.x);
    case FieldType::Color: break;
    }
    return {number(value.x), number(value.y), number(value.z)};
}

std::string relativeTo(const std::filesystem::path& folder, const std::filesystem::path& file) {
    const std::filesystem::path here = std::filesystem::current_path();
    return (here / file).lexically_normal().lexically_proximate((here / folder).lexically_normal()).string();
}

OrderedJson materialJson(const MaterialOverride& override, MaterialKind kind, const std::filesystem::path& folder) {
    OrderedJson json = OrderedJson::object();
    if (override.kind)
        json["kind"] = kMaterialKindNames[static_cast<size_t>(*override.kind)];
    for (const auto& [index, value] : override.values)
        if (const MaterialField& field = materialFields()[index]; (field.kinds & kindBit(kind)) != 0)
            json[std::string(field.name)] = valueJson(field, value);
    for (const auto& [index, choice] : override.textures)
        if (const MaterialTexture& info = materialTextures()[index]; (info.kinds & kindBit(kind)) != 0) {
            const std::string file = choice.file.empty() ? "" : relativeTo(folder, choice.file);
            json["textures"][std::string(info.name)] = file.empty() ? OrderedJson() : OrderedJson(file);
        }
    return json;
}

} // namespace

Result<MaterialOverrides> readMaterialFile(const std::string& path, const Scene& scene) {
    return MaterialFile(path, scene).read();
}

std::string materialKey(std::span<const Material> materials, size_t index) {
    const std::string& name = materials[index].name;
    const bool unique = !name.empty() && std::ranges::count(materials, name, &Material::name) == 1;
    return unique ? name : fmt::format("#{}", index);
}

std::string materialFileText(const std::string& path, std::span<const Material> materials,
                             const MaterialOverrides& overrides) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    OrderedJson list = OrderedJson::object();
    for (const auto& [index, override] : overrides)
        if (!override.empty())
            list[materialKey(materials, index)] = materialJson(override, kindOf(materials[index], override), folder);
    OrderedJson root = OrderedJson::object();
    root["materials"] = std::move(list);
    return root.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

} // namespace glint::scene
