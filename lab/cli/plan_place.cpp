#include "lab/cli/plan_place.hpp"

#include "base/text.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/render/render_options.hpp"

#include <algorithm>
#include <cmath>

namespace glint::cli {
namespace {

constexpr size_t kMostEntries = 100000; ///< of a list

} // namespace

Error PlanPlace::wrong(std::string_view expected) const {
    return says(fmt::format("expected {}", expected));
}

Error PlanPlace::says(std::string_view text) const {
    return invalidInput("{}{} {}", name_, name_.ends_with(':') ? "" : ":", text);
}

PlanPlace PlanPlace::at(const char* key) const {
    return {json_.at(key), fmt::format("{}{}{}", name_, separator(), key)};
}

PlanPlace PlanPlace::at(size_t index) const {
    return {json_[index], fmt::format("{}[{}]", name_, index)};
}

Result<void> PlanPlace::checkKeys(std::span<const std::string_view> keys) const {
    if (!json_.is_object())
        return wrong("an object");
    for (const auto& [key, value] : json_.items()) {
        if (std::ranges::find(keys, key) != keys.end())
            continue;
        const std::string_view meant = likelyMeant(key, keys);
        const std::vector<std::string> known(keys.begin(), keys.end());
        return says(fmt::format("unknown key '{}'; {}", printable(key),
                                meant.empty() ? "there are " + listText(known, " and ")
                                              : fmt::format("did you mean '{}'?", meant)));
    }
    return {};
}

Result<std::string> PlanPlace::text() const {
    if (!json_.is_string() || json_.get_ref<const std::string&>().empty())
        return wrong("a text");
    return json_.get<std::string>();
}

Result<bool> PlanPlace::flag() const {
    return json_.is_boolean() ? Result<bool>(json_.get<bool>()) : wrong("true or false");
}

Result<double> PlanPlace::number(double least, double most) const {
    if (!json_.is_number() || !(json_.get<double>() >= least && json_.get<double>() <= most))
        return wrong(fmt::format("a number from {:g} to {:g}", least, most));
    return json_.get<double>();
}

Result<uint32_t> PlanPlace::count(uint32_t least, uint32_t most) const {
    const bool whole = json_.is_number() && json_.get<double>() == std::floor(json_.get<double>());
    if (!whole || !(json_.get<double>() >= least && json_.get<double>() <= most))
        return wrong(fmt::format("a whole number from {} to {}", least, most));
    return static_cast<uint32_t>(json_.get<double>());
}

Result<size_t> PlanPlace::list() const {
    if (!json_.is_array() || json_.empty() || json_.size() > kMostEntries)
        return wrong(fmt::format("a list of 1 to {} entries", kMostEntries));
    return json_.size();
}

Result<std::vector<std::string>> PlanPlace::texts() const {
    GLINT_TRY(size, list());
    std::vector<std::string> result;
    for (size_t i = 0; i < size; ++i) {
        GLINT_TRY(one, at(i).text());
        result.push_back(std::move(one));
    }
    return result;
}

/// The error's own words name `--config`.
Result<render::SettingsRequest> PlanPlace::config() const {
    GLINT_TRY(written, text());
    auto request = readConfig(written);
    if (!request)
        return says(request.error().message);
    return request;
}

Result<std::string> PlanPlace::size() const {
    GLINT_TRY(written, text());
    render::RenderJob job;
    if (auto read = readSize("", written, job); !read)
        return invalidInput("{}:{}", name_, read.error().message);
    return written;
}

} // namespace glint::cli
