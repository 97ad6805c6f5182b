# cmake -DOUTPUT=presets.cpp "-DPRESETS=a.json;b.json" -P embed_presets.cmake
set(entries "")
foreach(file ${PRESETS})
    get_filename_component(name ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND entries "    {\"${name}\", R\"preset(${text})preset\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by cmake/embed_presets.cmake from presets/*.json.
#include \"reflect/settings/presets.hpp\"

namespace glint {

static const EmbeddedPreset kPresets[] = {
${entries}};

std::span<const EmbeddedPreset> embeddedPresets() { return kPresets; }

} // namespace glint
")
