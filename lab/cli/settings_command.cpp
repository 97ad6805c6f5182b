// glint settings: every setting with its default, range, unit, meaning and aliases.
#include "base/settings/settings_docs.hpp"
#include "lab/cli/commands.hpp"

#include <cstdio>
#include <memory>

namespace glint::cli {

void addSettingsCommand(CLI::App& program, Command& chosen) {
    struct Options {
        bool json = false;
        bool markdown = false;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* const command = program.add_subcommand("settings", "List every setting: default, range, meaning");
    CLI::Option* const json =
        command->add_flag("--json", options->json, "As JSON, with units and other systems' names");
    command->add_flag("--markdown", options->markdown, "As the page docs/settings.md")->excludes(json);
    command->callback([&chosen, options] {
        chosen = [options]() -> Result<void> {
            const std::string text = options->json       ? settingsTableJson(render::allSettings())
                                     : options->markdown ? render::settingsPage()
                                                         : settingsText(render::allSettings());
            std::fwrite(text.data(), 1, text.size(), stdout);
            return {};
        };
    });
}

} // namespace glint::cli
