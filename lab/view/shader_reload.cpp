#include "lab/view/shader_reload.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/cli/child_process.hpp"
#include "lab/view/shaders.hpp"

#include <algorithm>

namespace glint::view {
namespace {

namespace fs = std::filesystem;

constexpr size_t kLongestShader = 1 << 20; ///< bytes of a source file
constexpr int kErrorLines = 4;             ///< compiler lines in a message

/// The library's shaders and the programs', in the folder of the sources.
constexpr const char* kRoots[] = {"shaders", "lab/shaders"};

/// The shaders that can be replaced, by name.
std::vector<std::string_view> knownShaders() {
    std::vector<std::string_view> names;
    for (const auto& set : {gpu::shaders::reflect(), gpu::shaders::render(), gpu::shaders::view()})
        for (const gpu::EmbeddedShader& shader : set)
            names.push_back(shader.name);
    return names;
}

/// Returns the names in `#include "..."`, line by line, also those disabled by a comment or #if: then one shader too
/// many is compiled.
std::vector<std::string> includes(std::string_view text) {
    std::vector<std::string> found;
    constexpr std::string_view kWord = "#include \"";
    for (size_t at = text.find(kWord); at != text.npos; at = text.find(kWord, at)) {
        at += kWord.size();
        const size_t end = text.find_first_of("\"\n", at);
        if (end != text.npos && text[end] == '"')
            found.emplace_back(text.substr(at, end - at));
    }
    return found;
}

std::string firstLines(std::string text, const std::string& folder) {
    for (size_t at = text.find(folder + "/"); at != text.npos; at = text.find(folder + "/"))
        text.erase(at, folder.size() + 1);
    size_t end = 0;
    for (int line = 0; line < kErrorLines && end != text.npos; ++line)
        end = text.find('\n', end == 0 ? 0 : end + 1);
    text = text.substr(0, end);
    while (text.ends_with('\n'))
        text.pop_back();
    return text;
}

} // namespace

bool ShaderReload::isSourceFolder(const std::string& folder) {
    std::error_code ignored;
    return std::ranges::all_of(kRoots, [&](const char* root) {
        return fs::exists(fs::path(folder) / root / gpu::kShaderVariantsFile, ignored);
    });
}

Result<ShaderReload> ShaderReload::create(const std::string& folder) {
    if (!isSourceFolder(folder))
        return invalidArgument("{}: not the folder of Glint's sources: it must hold {}/{} and {}/{}", printable(folder),
                               kRoots[0], gpu::kShaderVariantsFile, kRoots[1], gpu::kShaderVariantsFile);
    ShaderReload reload(folder.substr(0, folder.find_last_not_of('/') + 1)); // without trailing slashes
    reload.seen_ = reload.stamps();
    GLINT_CHECK(reload.readVariants());
    return reload;
}

std::map<std::string, ShaderReload::Stamp> ShaderReload::stamps() const {
    std::map<std::string, Stamp> found;
    for (const char* root : kRoots) {
        std::error_code error;
        for (fs::recursive_directory_iterator it(fs::path(folder_) / root, error), end; !error && it != end;
             it.increment(error)) {
            std::error_code gone; // an editor may have just removed the file
            const Stamp stamp = {fs::last_write_time(it->path(), gone), gone ? 0 : fs::file_size(it->path(), gone)};
            if (!gone)
                found[fs::relative(it->path(), folder_, gone).generic_string()] = stamp;
        }
    }
    return found;
}

Result<gpu::ShaderVariants> ShaderReload::readVariants() const {
    gpu::ShaderVariants all;
    for (const char* root : kRoots) {
        const std::string file = (fs::path(folder_) / root / gpu::kShaderVariantsFile).string();
        GLINT_TRY(text, readFile(file, kLongestShader));
        std::vector<std::string> files; // in this root
        const std::string inRoot = fmt::format("{}/", root);
        for (const auto& [path, stamp] : seen_)
            if (path.starts_with(inRoot))
                files.push_back(path.substr(inRoot.size()));
        GLINT_TRY(variants, gpu::parseShaderVariants(text, files));
        for (auto& [name, source] : variants) {
            source.file = fmt::format("{}/{}", root, source.file);
            all[name] = std::move(source);
        }
    }
    return all;
}

/// Returns what a shader is compiled from; its file is a path in the folder.
gpu::ShaderSource ShaderReload::sourceOf(const gpu::ShaderVariants& variants, std::string_view name) const {
    if (const auto variant = variants.find(name); variant != variants.end())
        return variant->second;
    const std::string file = gpu::shaderFile(name);
    std::error_code ignored;
    const bool ours = fs::exists(fs::path(folder_) / kRoots[1] / file, ignored);
    return {fmt::format("{}/{}", kRoots[ours ? 1 : 0], file), {}};
}

/// Returns a shader's file and all included files, by path in the folder.
std::set<std::string> ShaderReload::filesOf(const gpu::ShaderSource& source) const {
    std::set<std::string> known = {source.file};
    std::vector<std::string> open = {source.file};
    std::error_code ignored;
    while (!open.empty()) {
        const fs::path here = open.back();
        open.pop_back();
        const auto text = readFile((fs::path(folder_) / here).string(), kLongestShader);
        for (const std::string& name : text ? includes(*text) : std::vector<std::string>()) {
            std::vector<fs::path> places = {here.parent_path() / name}; // glslc searches here first
            for (const char* root : kRoots)
                places.push_back(fs::path(root) / name);
            const auto place =
                std::ranges::find_if(places, [&](const fs::path& at) { return fs::exists(folder_ / at, ignored); });
            const fs::path& found = place == places.end() ? places.back() : *place;
            if (const std::string path = found.lexically_normal().generic_string(); known.insert(path).second)
                open.push_back(path);
        }
    }
    return known;
}

bool ShaderReload::look() {
    std::map<std::string, Stamp> now = stamps();
    std::set<std::string> changed;
    for (const auto& [file, stamp] : now)
        if (const auto before = seen_.find(file); before == seen_.end() || before->second != stamp)
            changed.insert(file);
    for (const auto& [file, stamp] : seen_)
        if (!now.contains(file))
            changed.insert(file);
    seen_ = std::move(now);
    if (changed.empty())
        return false;
    const bool variantsChanged = std::ranges::any_of(kRoots, [&](const char* root) {
        return changed.contains(fmt::format("{}/{}", root, gpu::kShaderVariantsFile));
    });
    if (variantsChanged) { // rare, so recompile all
        markAll();
        return true;
    }
    const auto variants = readVariants();
    if (!variants) // every shader is already marked; compile() reports the error
        return false;
    bool any = false;
    for (const std::string_view name : knownShaders()) {
        const std::set<std::string> files = filesOf(sourceOf(*variants, name));
        if (std::ranges::any_of(files, [&](const std::string& file) { return changed.contains(file); })) {
            waiting_.insert(std::string(name));
            any = true;
        }
    }
    return any;
}

void ShaderReload::markAll() {
    for (const std::string_view name : knownShaders())
        waiting_.insert(std::string(name));
}

/// Compiles as cmake/GlintShaders.cmake does.
Result<gpu::ReflectedShader> ShaderReload::compileOne(const std::string& name, const gpu::ShaderSource& source) const {
    const std::string file = gpu::shaderFile(name);
    std::vector<std::string> command = {"glslc", "--target-env=vulkan1.3", "--target-spv=spv1.5", "-std=460",
                                        "-Werror"};
    command.push_back("-fshader-stage=" + file.substr(file.rfind('.') + 1));
    for (const std::string& macro : source.macros)
        command.push_back("-D" + macro);
    for (const char* root : kRoots) {
        command.emplace_back("-I");
        command.push_back((fs::path(folder_) / root).string());
    }
    for (const std::string& last : {std::string("-o"), std::string("-"), (fs::path(folder_) / source.file).string()})
        command.push_back(last);
    GLINT_TRY(output, cli::runChild(command));
    if (output.code != 0)
        return invalidInput("{}", firstLines(output.error, folder_));
    return gpu::reflectShader(output.out, file);
}

Result<ShaderReload::Compiled> ShaderReload::compile() {
    Compiled compiled = {taken_, waiting_.size()};
    GLINT_TRY(variants, readVariants());
    for (const std::string& name : waiting_) {
        GLINT_TRY(reflected, compileOne(name, sourceOf(variants, name)));
        auto version = std::make_unique<Version>();
        version->name = name;
        version->reflected = std::move(reflected);
        version->shader = version->reflected.embedded(version->name);
        compiled.shaders[name] = &version->shader;
        versions_.push_back(std::move(version));
    }
    return compiled;
}

void ShaderReload::take(const Compiled& compiled) {
    taken_ = compiled.shaders;
    waiting_.clear();
}

} // namespace glint::view
