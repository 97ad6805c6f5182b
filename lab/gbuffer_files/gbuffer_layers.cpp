#include "lab/gbuffer_files/gbuffer_layers.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace glint::scene {
namespace {

constexpr std::string_view kRootColor = "RGB"; ///< the channels R, G and B that belong to no layer

/// Finds channels by the names of mappings, and reads each channel once.
class LayerTable {
public:
    explicit LayerTable(const ExrChannels& file) : file_(file) {}

    /// One channel: "Depth.Z", or the only channel (or the red one) of layer "Depth".
    Result<size_t> scalar(std::string_view key, const std::string& name) const {
        if (const std::vector<size_t> exact = channelsNamed(name); !exact.empty())
            return unique(key, name, exact);
        const std::vector<std::string> layers = layersNamed(name);
        GLINT_CHECK(checkLayers(key, name, layers));
        const std::vector<size_t> inside = channelsOf(layers.front());
        if (inside.size() == 1)
            return inside.front();
        if (const auto red = find(layers.front() + ".R"))
            return *red;
        return invalidInput("{}: {}: layer {} has the channels {}: name one of them", file_.name(), key,
                            printable(name), channelList(inside));
    }

    /// X, Y and Z, or R, G and B.
    Result<std::array<size_t, 3>> triple(std::string_view key, const std::string& name) const {
        if (name == kRootColor)
            if (const auto root = channels(""))
                return *root;
        const std::vector<std::string> layers = layersNamed(name);
        GLINT_CHECK(checkLayers(key, name, layers));
        if (const auto found = channels(layers.front() + "."))
            return *found;
        return invalidInput("{}: {}: layer {} has the channels {}, but needs X, Y, Z or R, G, B", file_.name(), key,
                            printable(name), channelList(channelsOf(layers.front())));
    }

    /// X and Y, or R and G.
    Result<std::array<size_t, 2>> pair(std::string_view key, const std::string& name) const {
        const std::vector<std::string> layers = layersNamed(name);
        GLINT_CHECK(checkLayers(key, name, layers));
        for (const std::string_view letters : {"XY", "RG"}) {
            const auto a = find(layers.front() + "." + letters[0]), b = find(layers.front() + "." + letters[1]);
            if (a && b)
                return std::array<size_t, 2>{*a, *b};
        }
        return invalidInput("{}: {}: layer {} has the channels {}, but needs X, Y or R, G", file_.name(), key,
                            printable(name), channelList(channelsOf(layers.front())));
    }

    bool isPlainPicture() const {
        return channels("").has_value() &&
               std::ranges::none_of(file_.names(), [](const std::string& name) { return name.find('.') != name.npos; });
    }

    bool hasAll(const ColorSum& sum) const {
        return std::ranges::all_of(namesIn(sum), [this](const std::string& name) { return hasColor(name); });
    }
    bool hasAny(const ColorSum& sum) const {
        return std::ranges::any_of(namesIn(sum), [this](const std::string& name) { return hasColor(name); });
    }

    void wantScalar(size_t channel, std::vector<float>& plane) {
        readers_.emplace_back([this, channel, &plane] { plane = planeOf(channel); });
        want(channel);
    }
    void wantTriple(const std::array<size_t, 3>& channels, std::vector<glm::vec3>& plane) {
        readers_.emplace_back([this, channels, &plane] { plane = tripleOf(channels); });
        for (const size_t channel : channels)
            want(channel);
    }
    void wantPair(const std::array<size_t, 2>& channels, std::vector<glm::vec2>& plane) {
        readers_.emplace_back([this, channels, &plane] {
            const std::vector<float>&x = planeOf(channels[0]), &y = planeOf(channels[1]);
            plane.resize(x.size());
            for (size_t i = 0; i < x.size(); ++i)
                plane[i] = {x[i], y[i]};
        });
        for (const size_t channel : channels)
            want(channel);
    }
    /// `sum`: pairs of times (or nothing) and summands.
    void wantColor(std::vector<std::pair<std::optional<std::array<size_t, 3>>, std::vector<std::array<size_t, 3>>>> sum,
                   std::vector<glm::vec3>& plane) {
        for (const auto& [times, summands] : sum) {
            for (const auto& channels : summands)
                for (const size_t channel : channels)
                    want(channel);
            if (times)
                for (const size_t channel : *times)
                    want(channel);
        }
        readers_.emplace_back([this, terms = std::move(sum), &plane] {
            plane.assign(size_t{file_.width()} * file_.height(), glm::vec3(0));
            for (const auto& [times, summands] : terms)
                for (const auto& channels : summands) {
                    const std::vector<glm::vec3> one = tripleOf(channels);
                    const std::vector<glm::vec3> factor = times ? tripleOf(*times) : std::vector<glm::vec3>();
                    for (size_t i = 0; i < plane.size(); ++i)
                        plane[i] += factor.empty() ? one[i] : one[i] * factor[i];
                }
        });
    }

    /// Reads what was wanted into the planes.
    Result<void> read() {
        std::vector<size_t> channels;
        for (const auto& [channel, plane] : planes_)
            channels.push_back(channel);
        GLINT_TRY(values, file_.read(channels));
        for (size_t i = 0; i < channels.size(); ++i)
            planes_[channels[i]] = std::move(values[i]);
        for (const auto& reader : readers_)
            reader();
        return {};
    }

private:
    std::optional<size_t> find(const std::string& name) const {
        const auto found = std::ranges::find(file_.names(), name);
        return found == file_.names().end() ? std::nullopt : std::optional<size_t>(found - file_.names().begin());
    }

    std::optional<std::array<size_t, 3>> channels(const std::string& prefix) const {
        for (const std::string_view letters : {"XYZ", "RGB"}) {
            const auto a = find(prefix + letters[0]), b = find(prefix + letters[1]), c = find(prefix + letters[2]);
            if (a && b && c)
                return std::array<size_t, 3>{*a, *b, *c};
        }
        return std::nullopt;
    }

    static std::vector<std::string> namesIn(const ColorSum& sum) {
        std::vector<std::string> names;
        for (const ColorTerm& term : sum) {
            names.insert(names.end(), term.sum.begin(), term.sum.end());
            if (!term.times.empty())
                names.push_back(term.times);
        }
        return names;
    }
    bool hasColor(const std::string& name) const {
        return !layersNamed(name).empty() || (name == kRootColor && channels("").has_value());
    }

    static bool endsInName(std::string_view full, std::string_view name) {
        return full == name ||
               (full.size() > name.size() && full.ends_with(name) && full[full.size() - name.size() - 1] == '.');
    }

    /// Exact names go before names that stand behind others, as behind that of a view layer.
    std::vector<size_t> channelsNamed(const std::string& name) const {
        if (const auto exact = find(name))
            return {*exact};
        std::vector<size_t> found;
        for (size_t i = 0; i < file_.names().size(); ++i)
            if (endsInName(file_.names()[i], name) && file_.names()[i].find('.') != std::string::npos &&
                name.find('.') != std::string::npos)
                found.push_back(i);
        return found;
    }

    std::vector<std::string> layersNamed(const std::string& name) const {
        std::vector<std::string> found;
        for (const std::string& channel : file_.names()) {
            const size_t dot = channel.rfind('.');
            if (dot == std::string::npos)
                continue;
            std::string layer = channel.substr(0, dot);
            if (layer == name)
                return {layer};
            if (endsInName(layer, name) && std::ranges::find(found, layer) == found.end())
                found.push_back(std::move(layer));
        }
        return found;
    }

    std::vector<size_t> channelsOf(const std::string& layer) const {
        std::vector<size_t> found;
        for (size_t i = 0; i < file_.names().size(); ++i)
            if (file_.names()[i].starts_with(layer + ".") &&
                file_.names()[i].find('.', layer.size() + 1) == std::string::npos)
                found.push_back(i);
        return found;
    }

    std::string channelList(const std::vector<size_t>& channels) const {
        std::vector<std::string> names;
        for (const size_t channel : channels)
            names.push_back(file_.names()[channel]);
        return printable(joinText(names, ", "), 200);
    }

    Result<size_t> unique(std::string_view key, const std::string& name, const std::vector<size_t>& found) const {
        if (found.size() == 1)
            return found.front();
        return invalidInput("{}: {}: several channels are called {}: {}: write the whole name of one", file_.name(),
                            key, printable(name), channelList(found));
    }

    Result<void> checkLayers(std::string_view key, const std::string& name,
                             const std::vector<std::string>& found) const {
        if (found.size() == 1)
            return {};
        if (!found.empty())
            return invalidInput("{}: {}: several layers are called {}: {}: write the whole name of one", file_.name(),
                                key, printable(name), printable(joinText(found, ", "), 200));
        std::vector<std::string> layers;
        for (const std::string& channel : file_.names())
            if (std::string layer = channel.substr(0, std::min(channel.rfind('.'), channel.size()));
                std::ranges::find(layers, layer) == layers.end())
                layers.push_back(std::move(layer));
        return invalidInput("{}: {}: no layer is called {}; the file has {} (--mapping says which is which)",
                            file_.name(), key, printable(name), printable(joinText(layers, ", "), 300));
    }

    void want(size_t channel) { planes_.try_emplace(channel); }
    const std::vector<float>& planeOf(size_t channel) const { return planes_.at(channel); }
    std::vector<glm::vec3> tripleOf(const std::array<size_t, 3>& channels) const {
        const std::vector<float>&x = planeOf(channels[0]), &y = planeOf(channels[1]), &z = planeOf(channels[2]);
        std::vector<glm::vec3> result(x.size());
        for (size_t i = 0; i < x.size(); ++i)
            result[i] = {x[i], y[i], z[i]};
        return result;
    }

    const ExrChannels& file_;
    std::map<size_t, std::vector<float>> planes_; ///< by channel
    std::vector<std::function<void()>> readers_;
};

/// Asks the tables for the mapping's layers, key by key.
class LayerRequests {
public:
    LayerRequests(const GBufferMapping& mapping, GBufferLayers& layers) : mapping_(mapping), layers_(layers) {}

    Result<void> scalar(LayerTable& table, std::string_view key, const std::string& name, std::vector<float>& plane) {
        if (name.empty())
            return {};
        const auto found = table.scalar(key, name);
        if (!found)
            return missing(key, found.error());
        table.wantScalar(*found, plane);
        return {};
    }

    Result<void> triple(LayerTable& table, std::string_view key, const std::string& name,
                        std::vector<glm::vec3>& plane) {
        if (name.empty())
            return {};
        const auto found = table.triple(key, name);
        if (!found)
            return missing(key, found.error());
        table.wantTriple(*found, plane);
        return {};
    }

    Result<void> pair(LayerTable& table, std::string_view key, const std::string& name, std::vector<glm::vec2>& plane) {
        if (name.empty())
            return {};
        const auto found = table.pair(key, name);
        if (!found)
            return missing(key, found.error());
        table.wantPair(*found, plane);
        return {};
    }

    Result<void> color(LayerTable& table, std::string_view key, const ColorSum& sum, std::vector<glm::vec3>& plane) {
        if (sum.empty())
            return {};
        std::vector<std::pair<std::optional<std::array<size_t, 3>>, std::vector<std::array<size_t, 3>>>> terms;
        for (const ColorTerm& term : sum) {
            auto& [times, summands] = terms.emplace_back();
            if (!term.times.empty()) {
                const auto found = table.triple(key, term.times);
                if (!found)
                    return missing(key, found.error());
                times = *found;
            }
            for (const std::string& name : term.sum) {
                const auto found = table.triple(key, name);
                if (!found)
                    return missing(key, found.error());
                summands.push_back(*found);
            }
        }
        table.wantColor(std::move(terms), plane);
        return {};
    }

private:
    /// A note for optional keys.
    Result<void> missing(std::string_view key, const Error& error) {
        if (std::ranges::find(mapping_.optional, key) == mapping_.optional.end())
            return error;
        layers_.notes.push_back(error.message);
        return {};
    }

    const GBufferMapping& mapping_;
    GBufferLayers& layers_;
};

/// The file that has all layers of a sum: that of the picture, or else that of the surfaces. Where neither has all, the
/// one that has some is blamed.
LayerTable& tableOf(const ColorSum& sum, LayerTable& color, LayerTable& surface) {
    const bool inColor = !color.isPlainPicture(); // whose channels are the picture alone
    if (inColor && color.hasAll(sum))
        return color;
    if (surface.hasAll(sum))
        return surface;
    return inColor && (color.hasAny(sum) || !surface.hasAny(sum)) ? color : surface;
}

/// Asks for every layer of the mapping.
Result<void> request(const GBufferMapping& mapping, LayerTable& surface, LayerTable& color, GBufferLayers& layers) {
    LayerRequests requests(mapping, layers);
    GLINT_CHECK(requests.scalar(surface, "depth", mapping.depth, layers.depth));
    GLINT_CHECK(requests.triple(surface, "position", mapping.position, layers.position));
    GLINT_CHECK(requests.scalar(surface, "coverage", mapping.coverage, layers.coverage));
    GLINT_CHECK(requests.triple(surface, "normal", mapping.normal, layers.normal));
    GLINT_CHECK(requests.scalar(surface, "roughness", mapping.roughness.layer, layers.roughness));
    GLINT_CHECK(requests.scalar(surface, "metallic", mapping.metallic.layer, layers.metallic));
    GLINT_CHECK(requests.scalar(surface, "ior", mapping.ior.layer, layers.ior));
    GLINT_CHECK(requests.triple(surface, "f0", mapping.f0, layers.f0));
    GLINT_CHECK(requests.triple(surface, "baseColor", mapping.baseColor, layers.baseColor));
    GLINT_CHECK(requests.pair(surface, "motion", mapping.motion, layers.motion));
    if (color.isPlainPicture())
        GLINT_CHECK(requests.triple(color, "color", std::string(kRootColor), layers.color));
    else
        GLINT_CHECK(requests.color(color, "color", mapping.color, layers.color));
    GLINT_CHECK(requests.color(tableOf(mapping.fallbackSpecular, color, surface), "fallbackSpecular",
                               mapping.fallbackSpecular, layers.fallbackSpecular));
    return requests.color(tableOf(mapping.reference, color, surface), "reference", mapping.reference, layers.reference);
}

} // namespace

Result<void> findLayers(const ExrChannels& surfaces, const ExrChannels& colors, const GBufferMapping& mapping) {
    GBufferLayers layers;
    LayerTable surface(surfaces), color(colors);
    return request(mapping, surface, color, layers);
}

Result<GBufferLayers> readLayers(const ExrChannels& surfaces, const ExrChannels& colors,
                                 const GBufferMapping& mapping) {
    if (colors.width() != surfaces.width() || colors.height() != surfaces.height())
        return invalidInput("{}: has {}x{} pixels, but {} has {}x{}: both must be of one frame", colors.name(),
                            colors.width(), colors.height(), surfaces.name(), surfaces.width(), surfaces.height());
    GBufferLayers layers;
    layers.width = surfaces.width();
    layers.height = surfaces.height();
    LayerTable surface(surfaces), color(colors);
    GLINT_CHECK(request(mapping, surface, color, layers));
    GLINT_CHECK(surface.read());
    GLINT_CHECK(color.read());
    return layers;
}

} // namespace glint::scene
