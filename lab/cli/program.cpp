#include "lab/cli/program.hpp"

#include "base/text.hpp"
#include "glint/version.hpp"
#include "lab/cli/commands.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <sstream>

namespace glint::cli {
namespace {

int fail(int exitCode, std::string_view message) {
    fmt::print(stderr, "glint: error: {}\n", printable(message, 2000));
    return exitCode;
}

int exitCodeOf(ErrorCode code) {
    switch (code) {
    case ErrorCode::InvalidArgument:
    case ErrorCode::InvalidInput:
    case ErrorCode::NotFound: return kBadInput;
    case ErrorCode::Unsupported:
    case ErrorCode::DeviceLost:
    case ErrorCode::OutOfMemory:
    case ErrorCode::Io: break;
    }
    return kFailed;
}

/// Names an unknown command, which the parser only reports as missing. Empty if the first word is known or an option.
std::string unknownCommand(const CLI::App& program, int argc, const char* const* argv) {
    if (argc < 2 || argv[1][0] == '-')
        return {};
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({}))
        names.push_back(command->get_name());
    if (std::ranges::find(names, argv[1]) != names.end())
        return {};
    return fmt::format("unknown command '{}'; there are {}", printable(argv[1]), listText(names, " and "));
}

/// Ends with an error if standard output did not take everything, as on a full disk.
int endOutput() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        return fail(kFailed, fmt::format("standard output: {}", std::strerror(errno)));
    return kDone;
}

int run(int argc, const char* const* argv, const render::RenderFunction& render, const AddCommand& view) {
    CLI::App program("Reflections for any Vulkan renderer: renders scenes with them and measures the result.", "glint");
    program.set_version_flag(
        "--version", fmt::format("glint {}.{}.{}", GLINT_VERSION_MAJOR, GLINT_VERSION_MINOR, GLINT_VERSION_PATCH));
    program.set_help_all_flag("--help-all", "Print the help of every command");
    program.require_subcommand(1);
    Command chosen;
    if (render) {
        addRenderCommand(program, chosen, render);
        addInspectCommand(program, chosen, render);
    }
    if (view)
        view(program, chosen);
    addCompareCommand(program, chosen);
    addSequenceCommand(program, chosen);
    addTraceCommand(program, chosen);
    addBakeCommand(program, chosen);
    addBenchCommand(program, chosen);
    addReportCommand(program, chosen);
    addTuneCommand(program, chosen);
    addSharesCommand(program, chosen);
    addSweepCommand(program, chosen);
    addSettingsCommand(program, chosen);
    addViewsCommand(program, chosen);
    addDevicesCommand(program, chosen);
    if (const std::string unknown = unknownCommand(program, argc, argv); !unknown.empty())
        return fail(kBadInput, unknown);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {
        std::ostringstream text;
        program.exit(help, text, text); // writes the requested help
        const std::string written = text.str();
        std::fwrite(written.data(), 1, written.size(), stdout);
        return endOutput();
    } catch (const CLI::ParseError& error) {
        return fail(kBadInput, fmt::format("{} (try glint --help)", error.what()));
    }
    if (auto done = chosen(); !done)
        return fail(exitCodeOf(done.error().code), done.error().message);
    return endOutput();
}

} // namespace

int runProgram(int argc, const char* const* argv, const render::RenderFunction& render, const AddCommand& view) {
    try {
        return run(argc, argv, render, view);
    } catch (const std::bad_alloc&) {
        return fail(kFailed, "not enough memory");
    } catch (const std::exception& exception) {
        return fail(kFailed, exception.what());
    }
}

} // namespace glint::cli
