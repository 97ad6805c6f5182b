// A value of a plan, a JSON file that the user wrote, and its place in it: so that every message says where.
#pragma once

#include "base/result.hpp"
#include "lab/job/program_settings.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

using PlanJson = nlohmann::ordered_json;

/// All errors are InvalidInput, "plan.json: scenes[1].time: expected ...".
class PlanPlace {
public:
    PlanPlace(const PlanJson& json, std::string name) : json_(json), name_(std::move(name)) {}

    const PlanJson& json() const { return json_; }
    const std::string& name() const { return name_; }
    Error wrong(std::string_view expected) const;
    /// "plan.json: scenes[1]: TEXT"
    Error says(std::string_view text) const;

    bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
    /// Requires `has(key)`.
    PlanPlace at(const char* key) const;
    PlanPlace at(size_t index) const;

    /// The value is an object with no other keys than these.
    Result<void> checkKeys(std::span<const std::string_view> keys) const;
    Result<std::string> text() const;
    Result<bool> flag() const;
    Result<double> number(double least, double most) const;
    Result<uint32_t> count(uint32_t least, uint32_t most) const;
    /// The value is a list with at least one entry.
    Result<size_t> list() const;
    Result<std::vector<std::string>> texts() const;
    /// A text of `--config`.
    Result<render::SettingsRequest> config() const;
    /// "WIDTHxHEIGHT"
    Result<std::string> size() const;

private:
    std::string_view separator() const { return name_.ends_with(':') ? " " : "."; }

    const PlanJson& json_;
    std::string name_;
};

} // namespace glint::cli
