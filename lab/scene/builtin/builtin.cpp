#include "lab/scene/builtin/builtin.hpp"

#include "base/text.hpp"
#include "lab/scene/builtin/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace glint::scene {

namespace {

struct Entry {
    BuiltinInfo info;
    Scene (*make)(int size); ///< 1 to info.largest
};

const std::array kEntries = {
    Entry{{"hall", "an evening hall with a polished floor, columns, metals, glass and neon: the show piece",
           "three-quarter", "sky", 0.15f},
          [](int) { return builtin::makeHall(); }},
    Entry{{"exact", "emission and perfect mirrors only: every right program draws the same", "front", "none", 1},
          [](int) { return builtin::makeExact(); }},
    Entry{{"mirror", "seven glowing boxes over a floor mirror, each reflected where it can be computed", "main", "none",
           1},
          [](int) { return builtin::makeMirror(); }},
    Entry{{"spheres", "roughness by metalness, and coloured dielectrics, under the sky", "main", "sky", 1},
          [](int) { return builtin::makeSpheres(); }},
    Entry{{"thickness", "balls on a polished floor before an upright mirror", "main", "sky", 1},
          [](int) { return builtin::makeThickness(); }},
    Entry{{"glass", "index of refraction, roughness and absorption of glass before a chequered wall", "main", "sky", 1},
          [](int) { return builtin::makeGlass(); }},
    Entry{{"motion", "floor in strips of roughness under all that moves: for glint sequence", "main", "sky", 0.2f},
          [](int) {
              return builtin::makeMotion(
                  "builtin:motion",
                  {.objects = true, .hidden = true, .lamp = true, .grille = true, .panels = true, .emitters = true});
          }},
    Entry{{"motion-still", "builtin:motion with nothing that moves", "main", "sky", 0.2f},
          [](int) { return builtin::makeMotion("builtin:motion-still", {}); }},
    Entry{{"motion-objects", "the same with a moving ball and box", "main", "sky", 0.2f},
          [](int) { return builtin::makeMotion("builtin:motion-objects", {.objects = true}); }},
    Entry{{"motion-hidden", "the same with a ball that moves where only the floor shows it", "main", "sky", 0.2f},
          [](int) { return builtin::makeMotion("builtin:motion-hidden", {.hidden = true}); }},
    Entry{
        {"motion-lamp", "the same with a lamp that is switched off, on, and then twice a second", "main", "sky", 0.2f},
        [](int) { return builtin::makeMotion("builtin:motion-lamp", {.lamp = true}); }},
    Entry{{"motion-grille", "the same with poles, leaves and a grille; nothing moves", "main", "sky", 0.2f},
          [](int) { return builtin::makeMotion("builtin:motion-grille", {.grille = true}); }},
    Entry{{"motion-panels", "the same with turning mirrors: flat, glossy, bumpy, convex and concave", "main", "sky",
           0.2f},
          [](int) { return builtin::makeMotion("builtin:motion-panels", {.panels = true}); }},
    Entry{{"motion-emitters", "the same with small bright lights that wander over a bumpy floor", "main", "sky", 0.2f},
          [](int) { return builtin::makeMotion("builtin:motion-emitters", {.emitters = true, .bumpyFloor = true}); }},
    Entry{{"city", "a wet street at night, a million triangles; city-2 to city-10: two to ten million", "street", "sky",
           0.15f, 10},
          builtin::makeCity},
};

struct Chosen {
    const Entry* entry = nullptr; ///< null: no such scene
    int size = 1;
};

Chosen choose(std::string_view name) {
    for (const Entry& entry : kEntries) {
        if (name == entry.info.name)
            return {&entry, 1};
        if (!name.starts_with(entry.info.name) || name[entry.info.name.size()] != '-')
            continue;
        for (int size = 2; size <= entry.info.largest; ++size)
            if (name.substr(entry.info.name.size() + 1) == std::to_string(size))
                return {&entry, size};
    }
    return {};
}

} // namespace

std::span<const BuiltinInfo> builtinScenes() {
    static const auto infos = [] {
        std::array<BuiltinInfo, kEntries.size()> list;
        for (size_t i = 0; i < list.size(); ++i)
            list[i] = kEntries[i].info;
        return list;
    }();
    return infos;
}

const BuiltinInfo* findBuiltin(std::string_view name) {
    const Entry* const entry = choose(name).entry;
    return entry ? &entry->info : nullptr;
}

Result<void> checkBuiltinName(std::string_view name) {
    if (findBuiltin(name))
        return {};
    std::string known;
    for (const Entry& entry : kEntries) {
        known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.info.name);
        if (entry.info.largest > 1)
            known += fmt::format(" (and {0}-2 to {0}-{1})", entry.info.name, entry.info.largest);
    }
    return invalidArgument("builtin:{}: no such scene; there are {}", printable(name), known);
}

Result<Scene> builtinScene(std::string_view name) {
    GLINT_CHECK(checkBuiltinName(name));
    const Chosen chosen = choose(name);
    return chosen.entry->make(chosen.size);
}

} // namespace glint::scene
