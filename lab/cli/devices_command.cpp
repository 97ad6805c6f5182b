// glint devices: every Vulkan device of this machine, and what each can and cannot do here.
#include "base/text.hpp"
#include "gpu/context.hpp"
#include "lab/cli/commands.hpp"

#include <cstdio>

namespace glint::cli {

static std::string describe(size_t index, const gpu::DeviceInfo& device) {
    std::string text = fmt::format("{}: {}\n   driver: {}\n   Vulkan: {}\n   runs on: {}\n", index, device.name,
                                   device.driver, device.apiVersion, device.software ? "the CPU" : "a GPU");
    text += device.usable() ? "   usable: yes\n"
                            : fmt::format("   usable: no, it lacks {}\n", listText(device.missing, " and "));
    text += fmt::format("   ray query: {}\n", device.rayQuery ? "yes" : "no");
    return text;
}

void addDevicesCommand(CLI::App& program, Command& chosen) {
    CLI::App* const command = program.add_subcommand("devices", "List every Vulkan device and what it can do here");
    command->callback([&chosen] {
        chosen = []() -> Result<void> {
            auto devices = gpu::Context::listDevices();
            if (!devices) // this machine's fault, not the arguments'
                return makeError(ErrorCode::Unsupported, "{}", devices.error().message);
            if (devices->empty())
                return makeError(ErrorCode::Unsupported,
                                 "no Vulkan device: install a driver (scripts/glint brings one)");
            for (size_t i = 0; i < devices->size(); ++i)
                fmt::print("{}", describe(i, (*devices)[i]));
            return {};
        };
    });
}

} // namespace glint::cli
