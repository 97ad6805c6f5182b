#include "lab/view/live_shaders.hpp"

namespace glint::view {
namespace {

constexpr const char* kSources = "."; ///< if the program is started in the sources
constexpr double kBetweenLooks = 1;   ///< seconds

} // namespace

Result<void> LiveShaders::follow(const std::string& folder) {
    if (folder.empty() && !ShaderReload::isSourceFolder(kSources))
        return {};
    GLINT_TRY(files, ShaderReload::create(folder.empty() ? kSources : folder));
    files_.emplace(std::move(files));
    byItself_ = !folder.empty();
    return {};
}

void LiveShaders::look(ViewerState& state) {
    if (!byItself_ || state.now - lookedAt_ < kBetweenLooks)
        return;
    lookedAt_ = state.now;
    if (files_->look())
        state.ask(Request::Kind::ReloadShaders);
}

Result<void> LiveShaders::reload(bool all, gpu::Context& context, ViewerState& state,
                                 const std::function<Result<void>()>& remake) {
    if (!files_)
        return makeError(ErrorCode::NotFound, "no shaders to reload: start with --shaders FOLDER");
    files_->look();
    if (all)
        files_->markAll();
    auto compiled = files_->compile();
    if (!compiled) {
        state.shaderError = compiled.error().message;
        return {};
    }
    if (compiled->count == 0) {
        state.say("no shader has changed");
        return {};
    }
    const gpu::ShaderReplacements before = context.replacedShaders();
    context.replaceShaders(compiled->shaders);
    if (auto made = remake(); !made) {
        context.replaceShaders(before);
        state.shaderError = made.error().message;
        return made.error().code == ErrorCode::DeviceLost ? made : Result<void>();
    }
    files_->take(*compiled);
    state.shaderError.clear();
    state.say(fmt::format("{} {} reloaded", compiled->count, compiled->count == 1 ? "shader" : "shaders"));
    return {};
}

} // namespace glint::view
