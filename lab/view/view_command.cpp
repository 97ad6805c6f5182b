#include "lab/view/view_command.hpp"

#include "lab/view/viewer.hpp"

#include <memory>

namespace glint::view {

void addViewCommand(CLI::App& program, cli::Command& chosen) {
    const auto options = std::make_shared<ViewOptions>();
    CLI::App* const command = program.add_subcommand("view", "Open a window: see a scene, tune it, ask a pixel why");
    cli::addPictureOptions(*command, options->scene);
    command->add_option("--view", options->view, "What to show first (glint render --help)")->capture_default_str();
    command->add_option("--screenshot", options->screenshot,
                        "Write the window as .png after --frames frames, then close it");
    command->add_option("--script", options->script, "A file of keys and clicks to do (docs/viewer.md)");
    command->add_option(
        "--shaders", options->shaders,
        "A folder of Glint's sources: what changes in its shaders is compiled and shown (for developers)");
    command->callback([&chosen, options] { chosen = [options] { return runViewer(*options); }; });
}

} // namespace glint::view
