// glint views: every debug view with its channels, its meaning and how its values become colours.
#include "base/text.hpp"
#include "lab/cli/commands.hpp"
#include "lab/session/views.hpp"

#include <cstdio>
#include <memory>

namespace glint::cli {
namespace {

std::string viewsText() {
    std::string text;
    for (const render::ViewInfo& view : render::viewList())
        text += fmt::format("{:<18} {:<5} {}\n", view.name, view.channels, view.meaning);
    return text;
}

} // namespace

void addViewsCommand(CLI::App& program, Command& chosen) {
    const auto markdown = std::make_shared<bool>(false);
    CLI::App* const command = program.add_subcommand("views", "List every debug view: channels, meaning");
    command->add_flag("--markdown", *markdown, "As the page docs/views.md");
    command->callback([&chosen, markdown] {
        chosen = [markdown]() -> Result<void> {
            const std::string text = *markdown ? render::viewsPage() : viewsText();
            std::fwrite(text.data(), 1, text.size(), stdout);
            return {};
        };
    });
}

} // namespace glint::cli
