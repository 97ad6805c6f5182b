#include "lab/cli/command_text.hpp"

#include "lab/cli/config_option.hpp"

namespace glint::cli {

std::string shellWord(std::string_view word) {
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == word.npos)
        return std::string(word);
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string commandText(const CLI::App& command) {
    std::string positionals, options;
    for (const CLI::Option* const option : command.get_options()) {
        if (option->count() == 0 || option->get_name() == "--help-all")
            continue;
        if (option->get_expected_min() == 0) {
            options += " " + option->get_name();
            continue;
        }
        for (const std::string& value : option->results())
            (option->get_positional() ? positionals : options) +=
                " " + (option->get_positional() ? "" : option->get_name() + " ") + shellWord(value);
    }
    return "glint " + command.get_name() + positionals + options;
}

std::string renderCommand(const RenderOptions& options, const std::string& scene, std::string_view config,
                          uint32_t width, uint32_t height) {
    std::string text = fmt::format("glint render {} --size {}x{}", shellWord(scene), width, height);
    const auto add = [&](std::string_view name, std::string_view value) {
        if (!value.empty())
            text += fmt::format(" {} {}", name, shellWord(value));
    };
    add("--camera", options.camera);
    add("--env", options.environment);
    add("--materials", options.materials);
    add("--probes", options.probes);
    add("--planar", options.planar == "none" ? "" : options.planar);
    add("--device", options.device);
    if (options.time != 0)
        add("--time", fmt::format("{}", options.time));
    if (options.seed != 0)
        add("--seed", fmt::format("{}", options.seed));
    if (const auto request = readConfig(config)) {
        add("--preset", request->preset);
        add("--settings", request->file);
        for (const std::string& assignment : options.settings.assignments)
            add("--set", assignment);
        for (const std::string& assignment : request->assignments)
            add("--set", assignment);
    }
    return text;
}

} // namespace glint::cli
