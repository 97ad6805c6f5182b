// glint bake: reflection probes for a scene, into a file that `glint render --probes` reads.
#include "base/file.hpp"
#include "gpu/context.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/file_roles.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/session/bake_job.hpp"
#include "lab/sources/probe_world.hpp"

#include <unistd.h>

#include <bit>
#include <chrono>
#include <cstdio>
#include <memory>

namespace glint::cli {
namespace {

struct BakeCommandOptions {
    RenderOptions scene;
    std::string output;
    std::string placing = "auto";
    int64_t most = render::BakeOptions().most;
    int64_t faceSize = render::BakeOptions().faceSize;
    int64_t bounces = render::BakeOptions().bounces;
};

/// Only on a terminal, not into a pipe or a file.
void showProgress(const char* what, size_t done, size_t of) {
    if (isatty(fileno(stderr)))
        fmt::print(stderr, "\r\x1b[K{} {} of {}{}", what, done + 1, of, done + 1 == of ? "\n" : "");
}

Result<render::BakeOptions> makeBakeOptions(const BakeCommandOptions& options) {
    render::BakeOptions bake;
    if (options.placing != "auto") {
        GLINT_TRY(places, render::readProbePlaces(options.placing));
        bake.places = std::move(places);
    }
    if (options.most < 1 || options.most > 256)
        return invalidArgument("--count {}: expected 1 to 256", options.most);
    if (options.faceSize < 16 || options.faceSize > 1024 ||
        !std::has_single_bit(static_cast<uint64_t>(options.faceSize)))
        return invalidArgument("--face {}: expected a power of two from 16 to 1024", options.faceSize);
    if (options.bounces < 1 || options.bounces > 4)
        return invalidArgument("--bounces {}: expected 1 to 4", options.bounces);
    bake.most = static_cast<uint32_t>(options.most);
    bake.faceSize = static_cast<uint32_t>(options.faceSize);
    bake.bounces = static_cast<uint32_t>(options.bounces);
    bake.progress = showProgress;
    return bake;
}

Result<void> bakeProbes(const BakeCommandOptions& options) {
    GLINT_TRY(bake, makeBakeOptions(options));
    GLINT_TRY(job, makePictureJob(options.scene));
    const std::string output = options.output.empty() ? render::probeFileFor(options.scene.scene) : options.output;
    GLINT_CHECK(checkFolder("-o", output));
    std::vector<NamedFile> inputs = inputFiles(options.scene);
    inputs.push_back({"--probes", options.placing});
    const NamedFile outputs[] = {{"-o", output}};
    GLINT_CHECK(checkOutputs(inputs, outputs));
    const auto start = std::chrono::steady_clock::now();
    GLINT_TRY(context, gpu::Context::create({job.device, job.validate}));
    GLINT_TRY(set, render::runBakeJob(*context, job, bake));
    if (!context->validationMessages().empty())
        return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                         context->validationMessages().size(), context->validationMessages().front());
    const std::string bytes = render::encodeProbes(set);
    GLINT_CHECK(writeFile(output, bytes));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("{}: {} probes of {} texels a face, {:.1f} MB, in {:.1f} s\n", output, set.probes.size(), bake.faceSize,
               static_cast<double>(bytes.size()) * 1e-6, seconds);
    for (const render::BakedProbe& baked : set.probes) {
        const auto& at = baked.probe.capturePositionWS;
        fmt::print("  at {:.2f} {:.2f} {:.2f}\n", at[0], at[1], at[2]);
    }
    return {};
}

} // namespace

void addBakeCommand(CLI::App& program, Command& chosen) {
    const auto options = std::make_shared<BakeCommandOptions>();
    CLI::App* const command = program.add_subcommand("bake", "Place and bake reflection probes for a scene");
    command->add_option("SCENE", options->scene.scene, sceneHelp())->required();
    addSceneOptions(*command, options->scene);
    command->add_option("--size", options->scene.size, "Picture size whose shape the camera has, WIDTHxHEIGHT");
    command->add_option("--set", options->scene.settings.assignments, "KEY=VALUE; may be repeated (glint settings)")
        ->allow_extra_args(false);
    command->add_option("--probes", options->placing, "How probes are placed: auto, or a JSON file of places")
        ->capture_default_str();
    command->add_option("--count", options->most, "Probes at most; fewer where more are of no use")
        ->capture_default_str();
    command->add_option("--face", options->faceSize, "Texels along a cube's face, a power of two")
        ->capture_default_str();
    command->add_option("--bounces", options->bounces, "Mirrors that light meets at most, the first among them")
        ->capture_default_str();
    command->add_option("-o,--output", options->output, "File to write (default: the scene's name with .probes)");
    command->callback([&chosen, options] { chosen = [options] { return bakeProbes(*options); }; });
}

} // namespace glint::cli
