#include "base/settings/settings_json.hpp"

#include "base/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace glint {
namespace {

using Json = nlohmann::ordered_json;
using Kind = SettingInput::Kind;

/// Reads a text and tells how far the parser has come, which the parser itself does not tell its handler.
class TrackingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    TrackingIterator(const char* at, const char** furthest) : at_(at), furthest_(furthest) {}
    reference operator*() const { return *at_; }
    TrackingIterator& operator++() {
        *furthest_ = ++at_;
        return *this;
    }
    TrackingIterator operator++(int) {
        TrackingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const TrackingIterator& other) const { return at_ == other.at_; }
    bool operator!=(const TrackingIterator& other) const { return at_ != other.at_; }

private:
    const char* at_;
    const char** furthest_;
};

/// Takes the parser's events; collects assignments until the first error.
class Reader {
public:
    Reader(SettingsTargets targets, std::string_view text, std::string_view name, std::string_view system)
        : targets_(targets), text_(text), name_(name), system_(system), at_(text.data()) {}

    Result<std::vector<SettingAssignment>> read() {
        const char* const end = text_.data() + text_.size();
        Json::sax_parse(TrackingIterator(text_.data(), &at_), TrackingIterator(end, &at_), this);
        if (error_)
            return *std::move(error_);
        return std::move(assignments_);
    }

    // The names and signatures are nlohmann::json_sax's.
    bool null() { return value({"null", Kind::Any}); }
    bool boolean(bool is) { return value({is ? "true" : "false", Kind::Bool}); }
    bool number_integer(Json::number_integer_t number) { return value({std::to_string(number), Kind::Number}); }
    bool number_unsigned(Json::number_unsigned_t number) { return value({std::to_string(number), Kind::Number}); }
    bool number_float(Json::number_float_t, const std::string& text) { return value({text, Kind::Number}); }
    bool string(const std::string& text) { return value({text, Kind::String}); }
    bool binary(const Json::binary_t&) { return false; } // never comes from text

    bool start_object(size_t) {
        if (list_)
            return failInList();
        if (inside_)
            groups_.push_back(key_);
        inside_ = true;
        return true;
    }
    bool key(const std::string& key) {
        key_ = key;
        keyAt_ = at_;
        return true;
    }
    bool end_object() {
        if (!groups_.empty())
            groups_.pop_back();
        return true;
    }
    bool start_array(size_t) {
        if (!inside_)
            return value({});
        if (list_)
            return failInList();
        list_.emplace();
        return true;
    }
    bool end_array() {
        const std::string list = *std::exchange(list_, std::nullopt);
        return value({list, Kind::List});
    }

    bool parse_error(size_t position, const std::string&, const nlohmann::detail::exception& exception) {
        // "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error ..."
        std::string_view reason = exception.what();
        if (const size_t column = reason.find(", column "); column != reason.npos)
            reason.remove_prefix(std::min(reason.find(": ", column) + 2, reason.size()));
        return fail(text_.data() + std::clamp<size_t>(position, 1, text_.size() + 1) - 1, printable(reason, 200));
    }

private:
    bool fail(const char* at, std::string_view reason) {
        const auto line = 1 + std::count(text_.data(), at, '\n');
        error_ = invalidInput("{}:{}: {}", name_, line, reason);
        return false;
    }

    bool failInList() {
        return fail(at_, path() + ": a list holds the numbers of a colour and nothing else: [0.9, 0.5, 0.2]");
    }

    /// The last key, with the groups that it lies in.
    std::string path() const {
        std::string path;
        for (const std::string& group : groups_)
            path += group + ".";
        return path + key_;
    }

    bool listElement(const SettingInput& input) {
        if (input.kind != Kind::Number)
            return failInList();
        if (!list_->empty())
            *list_ += ", ";
        *list_ += input.text;
        return true;
    }

    bool value(const SettingInput& input) {
        if (list_)
            return listElement(input);
        if (!inside_)
            return fail(at_, "expected an object of settings: {\"screen\": {\"step\": 1}}");
        if (groups_.empty() && key_ == "description" && input.kind == Kind::String)
            return true;
        auto resolved = resolveSetting(targets_, path(), input, system_);
        if (!resolved)
            return fail(keyAt_, resolved.error().message);
        for (const SettingAssignment& assignment : *resolved) {
            const auto same = [&](const SettingAssignment& other) {
                return other.info == assignment.info && !other.implied && !assignment.implied;
            };
            if (std::ranges::any_of(assignments_, same))
                return fail(keyAt_, assignment.info->key + " is set twice");
            assignments_.push_back(assignment);
        }
        return true;
    }

    SettingsTargets targets_;
    std::string_view text_, name_, system_;
    const char* at_;              ///< just behind what the parser has read
    const char* keyAt_ = nullptr; ///< just behind the last key: numbers are read one character too far, keys are not
    bool inside_ = false;         ///< within the outermost object
    std::string key_;
    std::vector<std::string> groups_;
    std::optional<std::string> list_; ///< within a list: its numbers so far
    std::vector<SettingAssignment> assignments_;
    std::optional<Error> error_;
};

} // namespace

Result<void> readSettingsJson(SettingsTargets targets, std::string_view text, std::string_view name,
                              std::string_view system) {
    GLINT_TRY(assignments, Reader(targets, text, name, system).read());
    assignSettings(assignments);
    return {};
}

std::string writeSettingsJson(SettingsTargets targets) {
    Json root = Json::object();
    for (const SettingsTarget& target : targets) {
        for (const SettingInfo& info : target.table) {
            Json* node = &root;
            std::string_view rest = info.key;
            for (size_t dot = rest.find('.'); dot != rest.npos; dot = rest.find('.')) {
                node = &(*node)[std::string(rest.substr(0, dot))];
                rest.remove_prefix(dot + 1);
            }
            const std::string text = settingText(info, settingValue(info, target.object));
            (*node)[std::string(rest)] = info.type == SettingType::Enum ? Json(text) : Json::parse(text);
        }
    }
    return root.dump(2) + "\n";
}

} // namespace glint
