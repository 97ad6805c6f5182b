#include "gpu/embed/shader_variants.hpp"

#include "gpu/embed/shader_reflection.hpp"

#include <optional>
#include <sstream>

namespace glint::gpu {
namespace {

constexpr char kAnyName = '*';

/// What stands for the * of `pattern` in `path`, if it is a file's name without its ending.
std::optional<std::string> nameOf(std::string_view path, std::string_view pattern) {
    const size_t star = pattern.find(kAnyName);
    const std::string_view before = pattern.substr(0, star);
    const std::string_view after = pattern.substr(star + 1);
    if (path.size() <= before.size() + after.size() || !path.starts_with(before) || !path.ends_with(after))
        return std::nullopt;
    path = path.substr(before.size(), path.size() - before.size() - after.size());
    return path.find('/') == path.npos ? std::optional(std::string(path)) : std::nullopt;
}

/// The variants of a line: one, or one of each file where it has a *.
std::vector<std::pair<std::string, ShaderSource>> variantsOf(const std::string& name, const ShaderSource& source,
                                                             std::span<const std::string> files) {
    const size_t star = name.find(kAnyName);
    if (star == name.npos || source.file.find(kAnyName) == source.file.npos)
        return {{name, source}};
    std::vector<std::pair<std::string, ShaderSource>> found;
    for (const std::string& file : files)
        if (const auto one = nameOf(file, source.file))
            found.emplace_back(std::string(name).replace(star, 1, *one), ShaderSource{file, source.macros});
    return found;
}

} // namespace

Result<ShaderVariants> parseShaderVariants(std::string_view text, std::span<const std::string> files) {
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
        for (auto& [oneName, one] : variantsOf(name, source, files))
            if (!variants.emplace(oneName, std::move(one)).second)
                return invalidInput("{}:{}: {} is stated twice", kShaderVariantsFile, number, oneName);
    }
    return variants;
}

ShaderSource shaderSource(const ShaderVariants& variants, std::string_view name) {
    const auto variant = variants.find(name);
    return variant != variants.end() ? variant->second : ShaderSource{shaderFile(name), {}};
}

} // namespace glint::gpu
