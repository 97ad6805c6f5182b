#include "gpu/embed/shader_variants.hpp"

#include "gpu/embed/shader_reflection.hpp"

#include <sstream>

namespace glint::gpu {

Result<ShaderVariants> parseShaderVariants(std::string_view text) {
    ShaderVariants variants;
    std::istringstream lines{std::string(text)};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.empty() || line.front() == '#')
            continue;
        std::istringstream words(line);
        std::string name;
        ShaderSource source;
        if (!(words >> name >> source.file))
            return invalidInput("{}:{}: \"{}\" is no variant: a line is NAME SOURCE [MACRO ...]", kShaderVariantsFile,
                                number, line);
        for (std::string macro; words >> macro;)
            source.macros.push_back(macro);
        if (!variants.emplace(name, std::move(source)).second)
            return invalidInput("{}:{}: {} is stated twice", kShaderVariantsFile, number, name);
    }
    return variants;
}

ShaderSource shaderSource(const ShaderVariants& variants, std::string_view name) {
    const auto variant = variants.find(name);
    return variant != variants.end() ? variant->second : ShaderSource{shaderFile(name), {}};
}

} // namespace glint::gpu
