#include "base/settings/setting_suggestion.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <limits>

namespace glint {
namespace {

constexpr size_t kNone = std::numeric_limits<size_t>::max();

/// "screen.step" without "screen.", "hdrp:refraction:rayMinLevel" without its systems.
std::string_view lastPart(std::string_view name) {
    return name.substr(name.find_last_of(".:") + 1);
}

/// `name`'s distance to `form`; kNone where it is too far for a misspelling.
size_t likelyDistance(std::string_view name, std::string_view form) {
    const size_t distance = editDistance(name, form);
    return isLikelyDistance(distance, name) ? distance : kNone;
}

/// Distance by the last parts alone. A name that states a group means that group: two characters of a misspelt group
/// are less than another group.
size_t lastPartDistance(std::string_view name, std::string_view form) {
    constexpr size_t kOtherGroup = 3;
    const std::string_view last = lastPart(name);
    const size_t distance = likelyDistance(last, form);
    return distance != kNone && last.size() < name.size() ? distance + kOtherGroup : distance;
}

size_t keyDistance(std::string_view name, std::string_view key) {
    const std::string_view last = lastPart(key);
    const size_t distance = std::min(likelyDistance(name, key), lastPartDistance(name, last));
    const std::string_view group = key.substr(0, key.size() - last.size() - 1);
    return last == "enabled" ? std::min(distance, likelyDistance(name, group)) : distance;
}

/// Names and their distances: keeps the nearest.
class Nearest {
public:
    void add(const std::string& name, size_t distance) {
        if (distance == kNone || distance > distance_)
            return;
        if (distance < distance_)
            names_.clear();
        distance_ = distance;
        if (std::ranges::find(names_, name) == names_.end()) // one name may stand for several settings
            names_.push_back(name);
    }
    size_t distance() const { return distance_; }
    const std::vector<std::string>& names() const { return names_; }

private:
    size_t distance_ = kNone;
    std::vector<std::string> names_;
};

bool contains(std::string_view text, std::string_view part) {
    for (size_t at = 0; at + part.size() <= text.size(); ++at)
        if (equalIgnoringCase(text.substr(at, part.size()), part))
            return true;
    return false;
}

std::vector<std::string> keysThatContain(SettingsTargets targets, std::string_view name) {
    constexpr size_t kShortest = 4; // parts of fewer letters are in many words by chance
    constexpr size_t kMost = 8;     // more suggestions say nothing
    const std::string_view wanted = lastPart(name);
    std::vector<std::string> keys;
    for (const SettingsTarget& target : targets) {
        for (const SettingInfo& info : target.table) {
            const std::string_view last = lastPart(info.key);
            if (std::min(wanted.size(), last.size()) >= kShortest && (contains(wanted, last) || contains(last, wanted)))
                keys.push_back(info.key);
        }
    }
    return keys.size() <= kMost ? keys : std::vector<std::string>();
}

} // namespace

std::vector<std::string> likelySettings(SettingsTargets targets, std::string_view name) {
    if (name.size() > kLongestName)
        return {};
    Nearest keys, aliases;
    for (const SettingsTarget& target : targets) {
        for (const SettingInfo& info : target.table) {
            keys.add(info.key, keyDistance(name, info.key));
            for (const SettingAlias& alias : info.aliases) {
                const std::string full = alias.system + ":" + alias.name;
                aliases.add(full, std::min({likelyDistance(name, full), likelyDistance(name, alias.name),
                                            lastPartDistance(name, alias.name)}));
            }
        }
    }
    if (aliases.distance() < keys.distance())
        return aliases.names();
    return keys.names().empty() ? keysThatContain(targets, name) : keys.names();
}

} // namespace glint
