#include "lab/cli/bench/bench_base.hpp"

#include "base/text.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace glint::cli {
namespace {

using BaseJson = nlohmann::json;

/// Reads members of one object, and says which one is wrong.
class Members {
public:
    Members(const BaseJson& object, std::string where) : object_(object), where_(std::move(where)) {}

    Result<std::string> text(const char* name) const {
        const BaseJson* const value = find(name);
        if (!value || !value->is_string() || value->get_ref<const std::string&>().empty())
            return wrong(name, "a text");
        return value->get<std::string>();
    }
    Result<double> number(const char* name, double least, double most) const {
        const BaseJson* const value = find(name);
        if (!value || !value->is_number() || !(value->get<double>() >= least && value->get<double>() <= most))
            return wrong(name, fmt::format("a number from {:g} to {:g}", least, most));
        return value->get<double>();
    }
    Result<uint32_t> count(const char* name, uint32_t least, uint32_t most) const {
        GLINT_TRY(value, number(name, least, most));
        if (value != std::floor(value))
            return wrong(name, "a whole number");
        return static_cast<uint32_t>(value);
    }
    Result<const BaseJson*> list(const char* name) const {
        const BaseJson* const value = find(name);
        if (!value || !value->is_array() || value->empty())
            return wrong(name, "a list with entries");
        return value;
    }
    const BaseJson* find(const char* name) const {
        const auto found = object_.is_object() ? object_.find(name) : object_.end();
        return object_.is_object() && found != object_.end() ? &*found : nullptr;
    }
    Error wrong(const char* name, const std::string& expected) const {
        return Error{
            ErrorCode::InvalidArgument,
            fmt::format("{}: {}: expected {}: write the file with `glint bench --json`", where_, name, expected)};
    }

private:
    const BaseJson& object_;
    std::string where_;
};

constexpr double kMostFloors = 1e9;
constexpr uint32_t kMostPixels = 65536; ///< a side

Result<void> readPoint(const BaseJson& json, const std::string& where, std::vector<measure::BenchFigure>& figures) {
    const Members point(json, where);
    measure::BenchFigure figure;
    GLINT_TRY(scene, point.text("scene"));
    GLINT_TRY(width, point.count("width", 1, kMostPixels));
    GLINT_TRY(height, point.count("height", 1, kMostPixels));
    figure.scene = std::move(scene);
    figure.size = {width, height};
    if (const BaseJson* const share = point.find("share"); share && !share->is_null()) {
        GLINT_TRY(fraction, point.number("share", 0, 1));
        figure.share = static_cast<float>(fraction);
    }
    GLINT_TRY(configs, point.list("configs"));
    for (size_t i = 0; i < configs->size(); ++i) {
        const Members config((*configs)[i], fmt::format("{}.configs[{}]", where, i));
        GLINT_TRY(name, config.text("name"));
        GLINT_TRY(floors, config.number("floorMultiple", 0, kMostFloors));
        GLINT_TRY(lookups, config.number("lookupsPerRay", 0, kMostFloors));
        figure.config = std::move(name);
        figure.floors = floors;
        figure.lookups = lookups;
        figures.push_back(figure);
    }
    return {};
}

} // namespace

Result<measure::BenchBase> readBenchBase(std::string_view text, const std::string& fileName) {
    const BaseJson json = BaseJson::parse(text, nullptr, false);
    if (json.is_discarded())
        return invalidArgument("{}: not JSON: write the file with `glint bench --json`", printable(fileName));
    const Members root(json, printable(fileName));
    measure::BenchBase base;
    const BaseJson* const device = root.find("device");
    GLINT_TRY(name, Members(device ? *device : BaseJson(), printable(fileName) + ": device").text("name"));
    base.device = std::move(name);
    GLINT_TRY(warmUp, root.count("warmUp", 0, 100000));
    GLINT_TRY(frames, root.count("frames", 1, 100000));
    base.warmUp = warmUp;
    base.frames = frames;
    GLINT_TRY(points, root.list("points"));
    for (size_t i = 0; i < points->size(); ++i)
        GLINT_CHECK(readPoint((*points)[i], fmt::format("{}: points[{}]", printable(fileName), i), base.figures));
    return base;
}

} // namespace glint::cli
