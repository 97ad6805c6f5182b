#include "lab/tune/cost_table.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace glint::tune {
namespace {

using CostJson = nlohmann::json;

/// By blur.quality (src/reflect/resolve/screen_resolve.cpp).
constexpr std::array kBlurTaps = {9, 21, 41};

double square(double x) {
    return x * x;
}

double screenRays(const FrameWork& work) {
    return static_cast<double>(work.stats.rays) / work.pixels;
}

double sceneRays(const FrameWork& work) {
    return static_cast<double>(work.stats.scene.rays) / work.pixels;
}

/// Fraction of the frame's pixels whose hits are blurred: some, if the copies of the picture are made.
double blurredPixels(const FrameWork& work) {
    const bool blurs = std::ranges::find(work.passes, "trace/picture") != work.passes.end();
    return blurs ? work.rough.upTo(work.settings->reflect.maxRoughness) : 0;
}

/// Shadow rays from a hit, mean over the pixels: mirrors send one to each light, what the denoiser averages a few.
double shadowRays(const FrameWork& work) {
    if (!work.settings->denoise.enabled)
        return work.lights;
    const double spread = work.rough.upTo(work.settings->rays.maxRoughness);
    return std::lerp(work.lights, std::min<double>(work.settings->rays.shadowRays, work.lights), spread);
}

double blurTaps(const FrameWork& work) {
    const Settings& settings = *work.settings;
    return work.rough.all() *
           square(settings.screen.resolutionScale / static_cast<float>(settings.blur.downsample + 1)) *
           kBlurTaps[static_cast<size_t>(std::clamp(settings.blur.quality, 1, 3) - 1)];
}

constexpr std::array kUnits = {
    CostUnit{"pixels", "pixels of the frame", [](const FrameWork&) { return 1.0; }},
    CostUnit{"traced", "pixels of the traced image: screen.resolutionScale",
             [](const FrameWork& work) {
                 return work.settings->denoise.enabled ? 1 : square(work.settings->screen.resolutionScale);
             }},
    CostUnit{"rays", "screen-space rays", screenRays},
    CostUnit{"lookups", "depth lookups of screen-space rays",
             [](const FrameWork& work) { return screenRays(work) * work.stats.lookupsPerRay; }},
    CostUnit{"spread", "depth lookups of rays that the denoiser spreads over lobes: neighbours take other ways",
             [](const FrameWork& work) {
                 return work.settings->denoise.enabled ? screenRays(work) * work.stats.lookupsPerRay * work.rough.all()
                                                       : 0;
             }},
    CostUnit{"sceneRays", "rays through triangles", sceneRays, true},
    CostUnit{"spreadRays", "rays through triangles that the denoiser spreads over lobes",
             [](const FrameWork& work) {
                 return work.settings->denoise.enabled
                            ? sceneRays(work) * work.rough.upTo(work.settings->rays.maxRoughness)
                            : 0;
             },
             true},
    CostUnit{"litRays", "rays through triangles, times the shadow rays from the hit of each: rays.shadowRays",
             [](const FrameWork& work) { return sceneRays(work) * shadowRays(work); }, true},
    CostUnit{"rough", "pixels that the denoiser averages", [](const FrameWork& work) { return work.rough.all(); }},
    CostUnit{"roughRays", "pixels that the denoiser averages and that send rays through triangles: rays.maxRoughness",
             [](const FrameWork& work) { return work.rough.upTo(work.settings->rays.maxRoughness); }},
    CostUnit{"reused", "neighbours' rays of the pixels that the denoiser averages: reuse.samples",
             [](const FrameWork& work) { return work.rough.all() * work.settings->reuse.samples; }},
    CostUnit{"filtered", "pixels that the denoiser averages, where denoise.maxRadius is above 0",
             [](const FrameWork& work) { return work.settings->denoise.maxRadius > 0 ? work.rough.all() : 0; }},
    CostUnit{"cones", "traced rough pixels whose hits are blurred: rough.cones, reflect.maxRoughness",
             [](const FrameWork& work) { return blurredPixels(work) * square(work.settings->screen.resolutionScale); }},
    CostUnit{"blurTaps", "rough pixels of the blurred image, times taps", blurTaps},
    CostUnit{"backFaces", "pixels of the back-face image",
             [](const FrameWork& work) { return 1 / square(work.settings->screen.backfaceDownsample + 1); }},
    CostUnit{"triangles", "triangles of the scene", [](const FrameWork& work) { return work.triangles / work.pixels; }},
};

/// Throws CostJson::exception for another form; empty for an unknown unit or a cost below 0.
std::optional<CostRow> readRow(const CostJson& json) {
    const auto unit = std::ranges::find(kUnits, json.at("unit").get<std::string>(), &CostUnit::name);
    const double floors = json.at("floors").get<double>();
    if (unit == kUnits.end() || !(floors >= 0))
        return std::nullopt;
    return CostRow{json.at("pass").get<std::string>(), &*unit, floors, json.value("note", "")};
}

} // namespace

std::span<const CostUnit> costUnits() {
    return kUnits;
}

bool CostTable::counts(std::string_view pass) const {
    return std::ranges::find(notCounted, pass) == notCounted.end();
}

bool CostTable::hasRow(std::string_view pass) const {
    return !counts(pass) || std::ranges::find(rows, withoutBackEnd(pass), &CostRow::pass) != rows.end();
}

std::string_view withoutBackEnd(std::string_view pass) {
    for (const std::string_view end : {"_query", "_bvh"})
        if (pass.ends_with(end))
            pass.remove_suffix(end.size());
    return pass;
}

const CostTable& costTable() {
    static const CostTable table = [] {
        Result<CostTable> read = readCosts(embeddedCosts(), "bench/costs.json");
        GLINT_ASSERT(read.ok(), "{}", read.error().message);
        return *std::move(read);
    }();
    return table;
}

Result<CostTable> readCosts(std::string_view text, std::string_view file) {
    CostTable table;
    try {
        const CostJson json = CostJson::parse(text);
        table.measured = json.at("measured").get<std::string>();
        table.notCounted = json.at("notCounted").get<std::vector<std::string>>();
        table.otherPass = json.at("otherPass").get<double>();
        for (const CostJson& each : json.at("rows")) {
            std::optional<CostRow> row = readRow(each);
            if (!row)
                return invalidInput("{}: {}: no such unit, or a cost below 0", printable(file), printable(each.dump()));
            table.rows.push_back(*std::move(row));
        }
    } catch (const CostJson::exception&) {
        return invalidInput("{}: no table of costs, as bench/costs.json is", printable(file));
    }
    return table;
}

std::string costsText(const CostTable& table) {
    std::string text = fmt::format("{{\n \"measured\": {},\n \"notCounted\": [", CostJson(table.measured).dump());
    for (size_t i = 0; i < table.notCounted.size(); ++i)
        text += fmt::format("{}{}", i > 0 ? ", " : "", CostJson(table.notCounted[i]).dump());
    text += fmt::format("],\n \"otherPass\": {},\n \"rows\": [\n", table.otherPass);
    for (size_t i = 0; i < table.rows.size(); ++i) {
        const CostRow& row = table.rows[i];
        text += fmt::format("  {{\"pass\": {}, \"unit\": \"{}\", \"floors\": {}", CostJson(row.pass).dump(),
                            row.unit->name, row.floors);
        text += row.note.empty() ? "" : fmt::format(", \"note\": {}", CostJson(row.note).dump());
        text += i + 1 < table.rows.size() ? "},\n" : "}\n";
    }
    return text + " ]\n}\n";
}

} // namespace glint::tune
