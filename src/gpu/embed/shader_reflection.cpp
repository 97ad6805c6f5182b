#include "gpu/embed/shader_reflection.hpp"

#include <spirv_cross_c.h>

#include <cstring>
#include <memory>

namespace glint::gpu {
namespace {

struct Kind {
    spvc_resource_type type;
    BindingKind kind;
    bool buffer;
    bool storage;
};

constexpr Kind kKinds[] = {
    {SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, BindingKind::SampledImage, false, false},
    {SPVC_RESOURCE_TYPE_STORAGE_IMAGE, BindingKind::StorageImage, false, true},
    {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, BindingKind::UniformBuffer, true, false},
    {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, BindingKind::StorageBuffer, true, true},
    {SPVC_RESOURCE_TYPE_ACCELERATION_STRUCTURE, BindingKind::AccelerationStructure, false, false},
};

/// An image has NonWritable and NonReadable on its variable, a buffer has them on the members of its block.
bool hasDecoration(spvc_compiler compiler, const spvc_reflected_resource& resource, bool buffer, SpvDecoration what) {
    if (!buffer)
        return spvc_compiler_has_decoration(compiler, resource.id, what);
    const SpvDecoration* decorations = nullptr;
    size_t count = 0;
    spvc_compiler_get_buffer_block_decorations(compiler, resource.id, &decorations, &count);
    for (size_t i = 0; i < count; ++i)
        if (decorations[i] == what)
            return true;
    return false;
}

ShaderBinding describe(spvc_compiler compiler, const spvc_reflected_resource& resource, const Kind& kind) {
    ShaderBinding binding;
    binding.set = spvc_compiler_get_decoration(compiler, resource.id, SpvDecorationDescriptorSet);
    binding.binding = spvc_compiler_get_decoration(compiler, resource.id, SpvDecorationBinding);
    binding.kind = kind.kind;
    const spvc_type type = spvc_compiler_get_type_handle(compiler, resource.type_id);
    binding.count = spvc_type_get_num_array_dimensions(type) ? spvc_type_get_array_dimension(type, 0) : 1;
    binding.reads = !kind.storage || !hasDecoration(compiler, resource, kind.buffer, SpvDecorationNonReadable);
    binding.writes = kind.storage && !hasDecoration(compiler, resource, kind.buffer, SpvDecorationNonWritable);
    return binding;
}

} // namespace

Result<ReflectedShader> reflectShader(std::string_view bytes, const std::string& file) {
    if (bytes.empty() || bytes.size() % 4 != 0)
        return invalidInput("{}: not a SPIR-V file", file);
    ReflectedShader shader;
    shader.words.resize(bytes.size() / 4);
    std::memcpy(shader.words.data(), bytes.data(), bytes.size());

    const Error failed = invalidInput("{}: SPIRV-Cross cannot reflect it", file);
    spvc_context made = nullptr;
    if (spvc_context_create(&made) != SPVC_SUCCESS)
        return failed;
    const std::unique_ptr<spvc_context_s, void (*)(spvc_context)> context(made, spvc_context_destroy);
    spvc_parsed_ir ir = nullptr;
    spvc_compiler compiler = nullptr;
    spvc_resources resources = nullptr;
    if (spvc_context_parse_spirv(made, shader.words.data(), shader.words.size(), &ir) != SPVC_SUCCESS ||
        spvc_context_create_compiler(made, SPVC_BACKEND_NONE, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler) !=
            SPVC_SUCCESS ||
        spvc_compiler_create_shader_resources(compiler, &resources) != SPVC_SUCCESS)
        return failed;

    for (const Kind& kind : kKinds) {
        const spvc_reflected_resource* list = nullptr;
        size_t count = 0;
        if (spvc_resources_get_resource_list_for_type(resources, kind.type, &list, &count) != SPVC_SUCCESS)
            return failed;
        for (size_t i = 0; i < count; ++i) {
            shader.names.emplace_back(spvc_compiler_get_name(compiler, list[i].id));
            if (shader.names.back().empty())
                return invalidInput("{}: a binding has no name (was the shader stripped, or a block left without "
                                    "instance name?)",
                                    file);
            shader.bindings.push_back(describe(compiler, list[i], kind));
        }
    }
    for (size_t i = 0; i < shader.names.size(); ++i)
        shader.bindings[i].name = shader.names[i];

    if (spvc_compiler_get_execution_model(compiler) == SpvExecutionModelGLCompute)
        for (unsigned axis = 0; axis < 3; ++axis)
            shader.localSize[axis] =
                spvc_compiler_get_execution_mode_argument_by_index(compiler, SpvExecutionModeLocalSize, axis);
    const spvc_reflected_resource* push = nullptr;
    size_t pushes = 0, size = 0;
    if (spvc_resources_get_resource_list_for_type(resources, SPVC_RESOURCE_TYPE_PUSH_CONSTANT, &push, &pushes) !=
            SPVC_SUCCESS ||
        (pushes > 0 &&
         spvc_compiler_get_declared_struct_size(compiler, spvc_compiler_get_type_handle(compiler, push[0].base_type_id),
                                                &size) != SPVC_SUCCESS))
        return failed;
    shader.pushConstantSize = static_cast<uint32_t>(size);
    return shader;
}

std::string shaderName(std::string file) {
    if (file.ends_with(".comp"))
        file.resize(file.size() - std::string_view(".comp").size());
    return file;
}

std::string shaderFile(std::string_view name) {
    const bool raster = name.ends_with(".vert") || name.ends_with(".frag");
    return std::string(name) + (raster ? "" : ".comp");
}

} // namespace glint::gpu
