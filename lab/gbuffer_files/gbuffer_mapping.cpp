#include "lab/gbuffer_files/gbuffer_mapping.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/scene/gltf/json_access.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

namespace glint::scene {
namespace {

using MappingJson = gltf::Json;

constexpr size_t kLongestMapping = size_t{1} << 20; ///< bytes

constexpr std::array<std::string_view, 5> kDepthNames = {"viewZ", "negativeViewZ", "distance", "device",
                                                         "reversedDevice"};
constexpr std::array<std::string_view, 2> kAxesNames = {"yUp", "zUp"};
constexpr std::array<std::string_view, 2> kSpaceNames = {"world", "view"};

struct MappingPreset {
    std::string_view name;
    std::string_view text;
};
constexpr MappingPreset kPresets[] = {{"blender", R"({
  "description": "Blender's multilayer file: passes Combined, Z, Normal, glossy; AOVs BaseColor, Roughness, Metallic, IOR",
  "axes": "zUp",
  "depth": {"layer": "Depth.Z", "is": "viewZ"},
  "position": "Position",
  "normal": {"layer": "Normal", "space": "world"},
  "roughness": "Roughness",
  "metallic": "Metallic",
  "baseColor": "BaseColor",
  "ior": "IOR",
  "motion": {"layer": "Vector", "unit": "pixels", "scale": [1, -1]},
  "color": "Combined",
  "fallbackSpecular": {"times": "GlossCol", "sum": ["GlossDir", "GlossInd"]},
  "optional": ["position", "metallic", "baseColor", "ior", "motion", "fallbackSpecular"]
}
)"},
                                      {"glint", R"({
  "description": "glint render -o x.exr --view scene,fallbackSpecular,depth,normal,roughness,reflectivity,albedo",
  "axes": "yUp",
  "depth": {"layer": "depth.Z", "is": "viewZ"},
  "normal": {"layer": "normal", "space": "world"},
  "roughness": "roughness",
  "f0": "reflectivity",
  "baseColor": "albedo",
  "color": "scene",
  "fallbackSpecular": "fallbackSpecular",
  "optional": ["baseColor", "fallbackSpecular"]
}
)"}};

/// The JSON of one mapping; stops at the first error.
class MappingReader {
public:
    MappingReader(const MappingJson& root, std::string_view name) : root_(root), name_(name) {}

    Result<GBufferMapping> read() {
        for (const auto& [key, value] : root_.items())
            GLINT_CHECK(readKey(key, value));
        GLINT_CHECK(checkComplete());
        return std::move(mapping_);
    }

private:
    using Read = Result<void> (MappingReader::*)(const std::string&, const MappingJson&);
    struct Key {
        std::string_view name;
        Read read;
    };
    static std::span<const Key> keys() {
        static constexpr Key kKeys[] = {{"description", &MappingReader::readNothing},
                                        {"axes", &MappingReader::readAxes},
                                        {"metres", &MappingReader::readMetres},
                                        {"rowsFromBottom", &MappingReader::readRows},
                                        {"depth", &MappingReader::readDepth},
                                        {"position", &MappingReader::readPosition},
                                        {"coverage", &MappingReader::readCoverage},
                                        {"normal", &MappingReader::readNormal},
                                        {"roughness", &MappingReader::readRoughness},
                                        {"smoothness", &MappingReader::readRoughness},
                                        {"f0", &MappingReader::readF0},
                                        {"metallic", &MappingReader::readMetallic},
                                        {"baseColor", &MappingReader::readBaseColor},
                                        {"ior", &MappingReader::readIor},
                                        {"motion", &MappingReader::readMotion},
                                        {"color", &MappingReader::readColor},
                                        {"fallbackSpecular", &MappingReader::readColor},
                                        {"reference", &MappingReader::readColor},
                                        {"optional", &MappingReader::readOptional}};
        return kKeys;
    }

    Error fail(std::string_view key, std::string_view what) const {
        return invalidInput("{}: {} {}", name_, printable(key), what);
    }

    static std::string suggestion(std::string_view key, const std::vector<std::string_view>& known) {
        const std::string_view meant = likelyMeant(key, known);
        return meant.empty() ? std::string() : fmt::format("; did you mean '{}'?", meant);
    }

    Result<void> readKey(const std::string& key, const MappingJson& value) {
        const auto found = std::ranges::find(keys(), key, &Key::name);
        if (found != keys().end())
            return (this->*found->read)(key, value);
        std::vector<std::string_view> known;
        for (const Key& one : keys())
            known.push_back(one.name);
        return fail(key, "is not a key of mapping files" + suggestion(key, known));
    }

    Result<std::string> name(const std::string& key, const MappingJson& json) const {
        constexpr size_t kLongestName = 1000;
        const std::string text = json.is_string() ? json.get<std::string>() : std::string();
        if (text.empty() || text.size() > kLongestName)
            return fail(key, "must be the name of a layer");
        return text;
    }

    Result<float> number(const std::string& key, const MappingJson& json, double min, double max) const {
        const double value = json.is_number() ? json.get<double>() : min - 1;
        if (!(value >= min && value <= max))
            return fail(key, fmt::format("must be a number from {} to {}", min, max));
        return static_cast<float>(value);
    }

    Result<size_t> choice(const std::string& key, const MappingJson& json,
                          std::span<const std::string_view> choices) const {
        const std::string text = json.is_string() ? json.get<std::string>() : std::string();
        const auto found = std::ranges::find(choices, text);
        if (found != choices.end())
            return static_cast<size_t>(found - choices.begin());
        return fail(key, "must be " + listText(std::vector<std::string>(choices.begin(), choices.end()), " or "));
    }

    Result<bool> flag(const std::string& key, const MappingJson& json) const {
        if (!json.is_boolean())
            return fail(key, "must be true or false");
        return json.get<bool>();
    }

    /// A name, or an object with "layer" and the given further keys.
    Result<std::string> layer(const std::string& key, const MappingJson& json,
                              const std::vector<std::string_view>& further) const {
        if (!json.is_object())
            return name(key, json);
        for (const auto& [inner, value] : json.items())
            if (inner != "layer" && std::ranges::find(further, inner) == further.end())
                return fail(fmt::format("{}.{}", key, inner), "is unknown" + suggestion(inner, further));
        if (!json.contains("layer"))
            return fail(key + ".layer", "is missing");
        return name(key + ".layer", json["layer"]);
    }

    /// A name or a number.
    Result<LayerSource> source(const std::string& key, const MappingJson& json, double min, double max) const {
        if (json.is_number()) {
            GLINT_TRY(constant, number(key, json, min, max));
            return LayerSource{"", constant};
        }
        GLINT_TRY(found, name(key, json));
        return LayerSource{found, 0};
    }

    Result<void> readNothing(const std::string&, const MappingJson&) { return {}; }
    Result<void> readAxes(const std::string& key, const MappingJson& json) {
        GLINT_TRY(index, choice(key, json, kAxesNames));
        mapping_.meaning.axes = static_cast<StoredAxes>(index);
        return {};
    }
    Result<void> readMetres(const std::string& key, const MappingJson& json) {
        GLINT_TRY(metres, number(key, json, 1e-6, 1e6));
        mapping_.meaning.metres = metres;
        return {};
    }
    Result<void> readRows(const std::string& key, const MappingJson& json) {
        GLINT_TRY(value, flag(key, json));
        mapping_.meaning.rowsFromBottom = value;
        return {};
    }
    Result<void> readDepth(const std::string& key, const MappingJson& json) {
        GLINT_TRY(found, layer(key, json, {"is", "background"}));
        mapping_.depth = found;
        if (!json.is_object())
            return {};
        if (json.contains("is")) {
            GLINT_TRY(index, choice(key + ".is", json["is"], kDepthNames));
            mapping_.meaning.depth = static_cast<StoredDepth>(index);
        }
        if (json.contains("background")) {
            GLINT_TRY(background, number(key + ".background", json["background"], 1e-6, 1e30));
            mapping_.background = background;
        }
        return {};
    }
    Result<void> readPosition(const std::string& key, const MappingJson& json) {
        GLINT_TRY(found, name(key, json));
        mapping_.position = found;
        return {};
    }
    Result<void> readCoverage(const std::string& key, const MappingJson& json) {
        GLINT_TRY(found, name(key, json));
        mapping_.coverage = found;
        return {};
    }
    Result<void> readNormal(const std::string& key, const MappingJson& json) {
        GLINT_TRY(found, layer(key, json, {"space", "unorm", "inward"}));
        mapping_.normal = found;
        if (!json.is_object())
            return {};
        if (json.contains("space")) {
            GLINT_TRY(index, choice(key + ".space", json["space"], kSpaceNames));
            mapping_.meaning.normalSpace = static_cast<StoredSpace>(index);
        }
        if (json.contains("unorm")) {
            GLINT_TRY(unorm, flag(key + ".unorm", json["unorm"]));
            mapping_.meaning.normalUnorm = unorm;
        }
        if (json.contains("inward")) {
            GLINT_TRY(inward, flag(key + ".inward", json["inward"]));
            mapping_.meaning.normalInward = inward;
        }
        return {};
    }
    Result<void> readRoughness(const std::string& key, const MappingJson& json) {
        if (hasRoughness_)
            return fail(key, "is given twice: roughness and smoothness exclude each other");
        hasRoughness_ = true;
        GLINT_TRY(found, source(key, json, 0, 1));
        mapping_.roughness = found;
        mapping_.smoothness = key == "smoothness";
        return {};
    }
    Result<void> readF0(const std::string& key, const MappingJson& json) {
        GLINT_TRY(found, name(key, json));
        mapping_.f0 = found;
        return {};
    }
    Result<void> readMetallic(const std::string& key, const MappingJson& json) {
        GLINT_TRY(found, source(key, json, 0, 1));
        mapping_.metallic = found;
        return {};
    }
    Result<void> readBaseColor(const std::string& key, const MappingJson& json) {
        GLINT_TRY(found, name(key, json));
        mapping_.baseColor = found;
        return {};
    }
    Result<void> readIor(const std::string& key, const MappingJson& json) {
        GLINT_TRY(found, source(key, json, 1, 100));
        mapping_.ior = found;
        return {};
    }

    Result<void> readMotion(const std::string& key, const MappingJson& json) {
        static constexpr std::array<std::string_view, 2> kUnits = {"uv", "pixels"};
        GLINT_TRY(found, layer(key, json, {"unit", "scale"}));
        mapping_.motion = found;
        if (!json.is_object())
            return {};
        if (json.contains("unit")) {
            GLINT_TRY(unit, choice(key + ".unit", json["unit"], kUnits));
            mapping_.motionInPixels = unit == 1;
        }
        if (json.contains("scale")) {
            const MappingJson& scale = json["scale"];
            if (!scale.is_array() || scale.size() != 2)
                return fail(key + ".scale", "must be two numbers, for x and y");
            GLINT_TRY(x, number(key + ".scale", scale[0], -1e4, 1e4));
            GLINT_TRY(y, number(key + ".scale", scale[1], -1e4, 1e4));
            mapping_.motionScale = {x, y};
        }
        return {};
    }

    Result<ColorTerm> readTerm(const std::string& key, const MappingJson& json) const {
        ColorTerm term;
        if (!json.is_object()) {
            GLINT_TRY(found, name(key, json));
            term.sum.push_back(found);
            return term;
        }
        for (const auto& [inner, value] : json.items())
            if (inner != "times" && inner != "sum")
                return fail(fmt::format("{}.{}", key, inner), "is unknown; a term has \"times\" and \"sum\"");
        if (json.contains("times")) {
            GLINT_TRY(found, name(key + ".times", json["times"]));
            term.times = found;
        }
        const auto sum = json.find("sum");
        if (sum == json.end() || !sum->is_array() || sum->empty() || sum->size() > kMostTerms)
            return fail(key + ".sum", "must be a list of layers: {\"times\": \"GlossCol\", \"sum\": [\"GlossDir\"]}");
        for (const MappingJson& one : *sum) {
            GLINT_TRY(found, name(key + ".sum", one));
            term.sum.push_back(found);
        }
        return term;
    }

    Result<void> readColor(const std::string& key, const MappingJson& json) {
        ColorSum sum;
        const MappingJson list = json.is_array() ? json : MappingJson::array({json});
        if (list.empty() || list.size() > kMostTerms)
            return fail(key, fmt::format("must have 1 to {} terms", kMostTerms));
        for (const MappingJson& one : list) {
            GLINT_TRY(term, readTerm(key, one));
            sum.push_back(std::move(term));
        }
        (key == "color"       ? mapping_.color
         : key == "reference" ? mapping_.reference
                              : mapping_.fallbackSpecular) = std::move(sum);
        return {};
    }

    Result<void> readOptional(const std::string& key, const MappingJson& json) {
        constexpr std::string_view kMayMiss[] = {"position", "metallic",         "baseColor", "ior",
                                                 "motion",   "fallbackSpecular", "coverage",  "reference"};
        if (!json.is_array())
            return fail(key, "must be a list of keys");
        for (const MappingJson& one : json) {
            GLINT_TRY(index, choice(key, one, kMayMiss));
            mapping_.optional.emplace_back(kMayMiss[index]);
        }
        return {};
    }

    Result<void> checkComplete() const {
        if (mapping_.depth.empty() && mapping_.position.empty())
            return fail("depth", "is missing: name the layer of depth, or of \"position\"");
        if (mapping_.normal.empty())
            return fail("normal", "is missing: name the layer of normals");
        if (!hasRoughness_)
            return fail("roughness", "is missing: name a layer, or give one number for all surfaces");
        if (mapping_.color.empty())
            return fail("color", "is missing: name the layer of the lit picture");
        return {};
    }

    static constexpr size_t kMostTerms = 32;
    const MappingJson& root_;
    std::string_view name_;
    GBufferMapping mapping_;
    bool hasRoughness_ = false;
};

} // namespace

std::span<const std::string_view> storedDepthNames() {
    return kDepthNames;
}
std::span<const std::string_view> storedAxesNames() {
    return kAxesNames;
}
std::span<const std::string_view> storedSpaceNames() {
    return kSpaceNames;
}

std::vector<std::string_view> mappingPresets() {
    std::vector<std::string_view> names;
    for (const MappingPreset& preset : kPresets)
        names.push_back(preset.name);
    return names;
}

Result<std::string_view> mappingPresetText(std::string_view name) {
    const auto found = std::ranges::find(kPresets, name, &MappingPreset::name);
    if (found == std::end(kPresets))
        return makeError(ErrorCode::NotFound, "no mapping is called {}", printable(name));
    return found->text;
}

Result<GBufferMapping> parseMapping(std::string_view text, std::string_view name) {
    GLINT_TRY(root, gltf::parseJson({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, std::string(name)));
    return MappingReader(root, name).read();
}

Result<GBufferMapping> readMapping(const std::string& asked) {
    if (const auto preset = mappingPresetText(asked))
        return parseMapping(*preset, asked);
    std::error_code ignored;
    if (!std::filesystem::exists(asked, ignored)) {
        const std::vector<std::string_view> presets = mappingPresets();
        return makeError(ErrorCode::NotFound, "--mapping {}: no such file, and no such preset; there are {}",
                         printable(asked), listText(std::vector<std::string>(presets.begin(), presets.end()), " and "));
    }
    GLINT_TRY(text, readFile(asked, kLongestMapping));
    return parseMapping(text, printable(asked));
}

} // namespace glint::scene
