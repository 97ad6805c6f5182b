#include "gpu/support/pass_table.hpp"

#include "base/text.hpp"
#include "gpu/transfer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace {

constexpr std::string_view kOurs = "glint/";

/// Bound where a frame has no such image or buffer, or in every pass.
constexpr std::array<std::string_view, 3> kNotListed = {"glint/blackCube", "glint/noProbes", "glint/frame"};

uint64_t bytesOf(const gpu::PassLog::Use& use) {
    if (use.mips == 0)
        return use.bufferSize;
    uint64_t bytes = 0;
    for (uint32_t mip = use.firstMip; mip < use.firstMip + use.mips; ++mip)
        bytes += uint64_t{std::max(use.image.width >> mip, 1u)} * std::max(use.image.height >> mip, 1u);
    return bytes * gpu::bytesPerTexel(use.image.format) * use.image.layers * use.image.samples;
}

void addOnce(std::vector<std::string>& names, const std::string& name) {
    if (std::ranges::find(names, name) == names.end())
        names.push_back(name);
}

std::string sizeText(uint64_t bytes) {
    return bytes < 1024 ? fmt::format("{} B", bytes) : fmt::format("{:.0f} KiB", static_cast<double>(bytes) / 1024);
}

} // namespace

/// The row of this name, or a new one after `place`, which is moved to it: rows stay in the order of frames.
PassTable::Row& PassTable::rowAfter(size_t& place, const std::string& name) {
    auto found = std::ranges::find(rows_, name, &Row::name);
    if (found == rows_.end()) {
        found = rows_.insert(rows_.begin() + static_cast<ptrdiff_t>(place), Row{});
        found->name = name;
    }
    place = std::max(place, static_cast<size_t>(found - rows_.begin()) + 1);
    return *found;
}

void PassTable::add(const LoggedFrames& frames) {
    presets_ += frames.isPreset;
    for (size_t size = 0; size < frames.logs.size(); ++size) {
        size_t place = 0;
        for (const std::string& name : frames.logs[size].rows) {
            Row& row = rowAfter(place, name);
            if (!frames.isPreset)
                addOnce(row.otherwise, frames.name);
            else
                addOnce(row.presets, frames.name);
        }
        for (const gpu::PassLog::Use& use : frames.logs[size].uses) {
            Row& row = *std::ranges::find(rows_, use.row, &Row::name);
            shaders_.insert(use.pass);
            if (use.pass != use.row)
                row.shaders.insert(use.pass);
            addUse(row, use, size);
        }
    }
}

void PassTable::addUse(Row& row, const gpu::PassLog::Use& use, size_t size) {
    const bool isTexel = use.mips > 0 && use.image.width == 1 && use.image.height == 1; // the frame needs no such image
    if (isTexel || std::ranges::find(kNotListed, use.resource) != kNotListed.end())
        return;
    const auto found = std::ranges::find_if(row.bound, [&](const Bound& bound) {
        return bound.resource == use.resource && bound.reads == use.reads && bound.writes == use.writes;
    });
    Bound& bound = found == row.bound.end() ? row.bound.emplace_back() : *found;
    bound.resource = use.resource;
    bound.reads = use.reads;
    bound.writes = use.writes;
    bound.isImage = use.mips > 0;
    bound.bytes[size] = std::max(bound.bytes[size], bytesOf(use));
}

/// Bytes per pixel of the frame, if they grow with it. A host's images are as the host made them.
std::string PassTable::bytesText(const Bound& bound) const {
    if (!bound.resource.starts_with(kOurs) || bound.bytes[1] == 0)
        return {};
    const auto pixels = [](glm::uvec2 size) { return double(size.x) * double(size.y); };
    const auto grown = static_cast<double>(bound.bytes[1]) - static_cast<double>(bound.bytes[0]);
    if (grown <= 0)
        return " " + sizeText(bound.bytes[1]);
    return fmt::format(" {:.2g}", grown / (pixels(sizes_[1]) - pixels(sizes_[0])));
}

std::string PassTable::boundText(const Row& row, bool writes) const {
    std::vector<std::string> names;
    for (const Bound& bound : row.bound) {
        if (!(writes ? bound.writes : bound.reads))
            continue;
        std::string_view name = bound.resource;
        if (name.starts_with(kOurs))
            name.remove_prefix(kOurs.size());
        names.push_back(fmt::format("`{}`{}", name, bytesText(bound)));
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return joinText(names, ", ");
}

std::string PassTable::runsText(const Row& row) const {
    constexpr size_t kMost = 3;
    if (row.presets.empty())
        return joinText(std::span(row.otherwise).first(std::min(kMost, row.otherwise.size())), "; ");
    return row.presets.size() == presets_ ? "all presets" : joinText(row.presets, ", ");
}

std::string PassTable::page() const {
    std::string page =
        "# Passes\n"
        "\n"
        "`GLINT_UPDATE_PAGES=1 scripts/test -R '^PassTable'` writes this page from recorded frames; the "
        "test compares it.\n"
        "A row is a row of `--stats`, the timers and the debug labels. Names are those of images and "
        "buffers; the number\n"
        "after a name is its bytes per pixel of the frame, at most, or its whole size with a unit. Images "
        "and buffers\n"
        "without a number are the host's, or of its scene. Every pass also reads the frame block. The last "
        "column has the\n"
        "presets whose frames run the pass, where the host provides everything: back faces, motion, an "
        "environment,\n"
        "probes, mirrors, a scene for rays and a transparent layer. Otherwise it says what runs the pass.\n"
        "\n"
        "| pass | reads | writes | runs |\n"
        "|---|---|---|---|\n";
    for (const Row& row : rows_) {
        const std::vector<std::string> shaders(row.shaders.begin(), row.shaders.end());
        page += fmt::format("| `{}`{} | {} | {} | {} |\n", row.name,
                            shaders.empty() ? "" : " (" + joinText(shaders, ", ") + ")", boundText(row, false),
                            boundText(row, true), runsText(row));
    }
    return page;
}

} // namespace glint::test
