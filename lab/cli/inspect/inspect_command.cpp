// glint inspect: the ray of one pixel, as JSON and drawn over the image.
#include "base/log.hpp"
#include "base/text.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/file_roles.hpp"
#include "lab/cli/inspect/inspect_output.hpp"
#include "lab/cli/inspect/inspect_overlay.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/cli/render/render_output.hpp"
#include "lab/scene/images/image_file.hpp"
#include "lab/session/views.hpp"

#include <charconv>
#include <cstdio>
#include <memory>

namespace glint::cli {
namespace {

struct InspectOptions {
    RenderOptions scene;
    std::string pixel;
    std::string output;
    std::string view = "composite";
};

Result<std::array<uint32_t, 2>> readPixel(const std::string& text) {
    const auto expected = [&] {
        return invalidArgument("--pixel {}: expected X,Y in pixels from the top left, as in 320,180", printable(text));
    };
    const char* const end = text.data() + text.size();
    std::array<uint32_t, 2> pixel = {};
    const auto [comma, xError] = std::from_chars(text.data(), end, pixel[0]);
    if (xError != std::errc() || comma == end || *comma != ',')
        return expected();
    const auto [rest, yError] = std::from_chars(comma + 1, end, pixel[1]);
    if (yError != std::errc() || rest != end)
        return expected();
    return pixel;
}

Result<render::RenderJob> makeJob(const InspectOptions& options) {
    GLINT_TRY(job, makePictureJob(options.scene));
    GLINT_TRY(pixel, readPixel(options.pixel));
    const bool outside = job.width > 0 && (pixel[0] >= job.width || pixel[1] >= job.height);
    if (outside) // without --size, known only from the scene
        return invalidArgument("--pixel {},{}: it lies outside the picture of {}x{}", pixel[0], pixel[1], job.width,
                               job.height);
    job.inspect = pixel;
    if (auto view = render::findView(options.view); !view)
        return makeError(view.error().code, "--view: {}", view.error().message);
    if (options.output.empty())
        return job;
    GLINT_TRY(kind, pictureKind(options.output));
    if (kind != PictureKind::Png)
        return invalidArgument("-o {}: a ray is drawn over a .png picture", printable(options.output));
    GLINT_CHECK(checkFolder("-o", options.output));
    const NamedFile outputs[] = {{"-o", options.output}};
    GLINT_CHECK(checkOutputs(inputFiles(options.scene), outputs));
    job.views = {options.view};
    job.display = true;
    return job;
}

Result<void> inspect(const InspectOptions& options, const render::RenderFunction& render) {
    GLINT_TRY(job, makeJob(options));
    GLINT_TRY(result, render(job));
    for (const std::string& note : result.notes)
        log::warning("{}", note);
    if (!options.output.empty()) {
        GLINT_TRY(picture, displayedBytes(result.views.front()));
        drawRay(*result.inspection, result.width, result.height, picture);
        GLINT_CHECK(scene::writePng(options.output, result.width, result.height, 3, picture));
    }
    const std::string text = inspectionJson(job, result);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return {};
}

} // namespace

void addInspectCommand(CLI::App& program, Command& chosen, const render::RenderFunction& render) {
    const auto options = std::make_shared<InspectOptions>();
    CLI::App* const command = program.add_subcommand("inspect", "Explain the ray of one pixel, as JSON");
    addPictureOptions(*command, options->scene);
    command->add_option("--pixel", options->pixel, "X,Y: the pixel, counted from the top left")->required();
    command->add_option("-o,--output", options->output, "Draw the ray over the picture: a .png file");
    command->add_option("--view", options->view, "The picture under it (glint render --help)")->capture_default_str();
    command->callback([&chosen, options, render] { chosen = [options, render] { return inspect(*options, render); }; });
}

} // namespace glint::cli
