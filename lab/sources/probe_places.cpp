#include "lab/sources/probe_places.hpp"

#include "base/file.hpp"
#include "base/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace glint::render {
namespace {

using Json = nlohmann::json;

constexpr size_t kLongestFile = size_t{16} << 20;

/// The JSON of one probe; keeps the first error.
class Place {
public:
    Place(const std::string& name, size_t number) : where_(fmt::format("{}: probe {}", name, number)) {}

    ProbePlace read(const Json& json) {
        ProbePlace place;
        Probe& probe = place.probe;
        allow(json, "",
              {"position", "influence", "blendDistance", "blendNormalDistance", "faceFade", "proxy", "strength",
               "weight"});
        numbers(json, "position", probe.capturePositionWS, true);
        if (!json.contains("influence"))
            fail("influence", "is missing: {\"shape\": \"box\", \"center\": [x, y, z], \"halfExtents\": [x, y, z]}");
        else
            probe.shape = volume(json["influence"], "influence", {"box", "sphere"}, probe.influence) == 1
                              ? ProbeShape::Sphere
                              : ProbeShape::Box;
        numbers(json, "blendDistance", probe.blendDistance, false);
        numbers(json, "blendNormalDistance", probe.blendNormalDistance, false);
        numbers(json, "faceFade", probe.faceFade, false);
        number(json, "strength", probe.strength);
        number(json, "weight", probe.weight);
        place.fitsProxy = !json.contains("proxy");
        if (!place.fitsProxy) {
            constexpr ProbeProxy kProxies[] = {ProbeProxy::Box, ProbeProxy::Sphere, ProbeProxy::Infinite};
            probe.proxy = kProxies[volume(json["proxy"], "proxy", {"box", "sphere", "none"}, probe.proxyVolume)];
        }
        return place;
    }
    const std::optional<Error>& error() const { return error_; }

private:
    void fail(std::string_view key, std::string_view what) {
        if (!error_)
            error_ = invalidInput("{}: \"{}\" {}", where_, printable(key), what);
    }

    void allow(const Json& json, const std::string& under, std::initializer_list<std::string_view> keys) {
        if (!json.is_object())
            return fail(under.empty() ? "probes" : under, "must hold objects, {...}");
        for (const auto& [key, value] : json.items())
            if (std::ranges::find(keys, key) == keys.end())
                fail(under.empty() ? key : fmt::format("{}.{}", under, key), "is unknown");
    }

    void number(const Json& json, const char* key, float& target) {
        if (!json.is_object() || !json.contains(key))
            return;
        const Json& value = json[key];
        if (!value.is_number() || !(std::abs(value.get<double>()) <= 1e9))
            return fail(key, "must be a number");
        target = value.get<float>();
    }

    /// Reads all numbers, or one number for all of them.
    template <size_t N>
    void numbers(const Json& json, const char* key, std::array<float, N>& target, bool needed) {
        if (!json.is_object() || !json.contains(key)) {
            if (needed)
                fail(key, "is missing");
            return;
        }
        const Json& value = json[key];
        if (value.is_number() && N == 6 && std::abs(value.get<double>()) <= 1e9)
            return target.fill(value.get<float>());
        bool ok = value.is_array() && value.size() == N;
        for (size_t i = 0; ok && i < N; ++i) {
            ok = value[i].is_number() && std::abs(value[i].get<double>()) <= 1e9;
            if (ok)
                target[i] = value[i].get<float>();
        }
        if (!ok)
            fail(key, fmt::format("must be {} numbers{}", N, N == 6 ? ", or one for all faces" : ""));
    }

    /// Returns the index of the shape in `shapes`.
    size_t volume(const Json& json, const char* key, std::initializer_list<std::string_view> shapes,
                  ProbeVolume& target) {
        allow(json, key, {"shape", "center", "halfExtents", "radius", "rotation"});
        std::string shape = "box";
        if (json.is_object() && json.contains("shape") && json["shape"].is_string())
            shape = json["shape"].get<std::string>();
        const auto* const found = std::ranges::find(shapes, shape);
        if (found == shapes.end()) {
            fail(key, "has a shape that is not known");
            return 0;
        }
        if (shape == "none")
            return static_cast<size_t>(found - shapes.begin());
        numbers(json, "center", target.centerWS, true);
        numbers(json, "rotation", target.rotation, false);
        if (shape == "sphere") {
            if (json.is_object() && !json.contains("radius"))
                fail(key, "is a sphere and needs a radius");
            number(json, "radius", target.halfExtents[0]);
        } else {
            numbers(json, "halfExtents", target.halfExtents, true);
        }
        return static_cast<size_t>(found - shapes.begin());
    }

    std::string where_;
    std::optional<Error> error_;
};

} // namespace

Result<std::vector<ProbePlace>> parseProbePlaces(const std::string& text, const std::string& name) {
    Json root;
    try { // exceptions, as only they contain the position of the error
        root = Json::parse(text);
    } catch (const Json::exception& exception) {
        const std::string_view what = exception.what();
        return invalidInput("{}: {}", name, what.substr(std::min(what.size(), what.find("] ") + 2)));
    }
    if (!root.is_object() || root.size() != 1 || !root.contains("probes") || !root["probes"].is_array())
        return invalidInput("{}: must be {{\"probes\": [{{...}}, ...]}}", name);
    if (root["probes"].empty() || root["probes"].size() > kMaxProbes)
        return invalidInput("{}: {} probes: there must be 1 to {}", name, root["probes"].size(), kMaxProbes);
    std::vector<ProbePlace> places;
    for (const Json& json : root["probes"]) {
        Place place(name, places.size());
        places.push_back(place.read(json));
        if (place.error())
            return *place.error();
    }
    return places;
}

Result<std::vector<ProbePlace>> readProbePlaces(const std::string& path) {
    GLINT_TRY(text, readFile(path, kLongestFile));
    return parseProbePlaces(text, printable(path));
}

} // namespace glint::render
