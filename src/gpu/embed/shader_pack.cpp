// Build tool: SPIR-V files in, one C++ file out, with each shader's words and its reflected bindings.
//   glint_shader_pack SET ROOT OUT.cpp ROOT/trace/linear.comp.spv ...
#include <fmt/format.h>
#include <spirv_cross_c.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

[[noreturn]] void fail(const std::string& message) {
    std::fprintf(stderr, "glint_shader_pack: %s\n", message.c_str());
    std::exit(1);
}

void check(spvc_result result, const std::string& file) {
    if (result != SPVC_SUCCESS)
        fail(file + ": SPIRV-Cross cannot reflect it");
}

std::vector<uint32_t> readWords(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
    if (bytes.empty() || bytes.size() % 4 != 0)
        fail(path + ": not a SPIR-V file");
    std::vector<uint32_t> words(bytes.size() / 4);
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(words.data()));
    return words;
}

/// "…/trace/linear.comp.spv" -> "trace/linear"; raster stages keep theirs: "render/gbuffer.vert".
std::string shaderName(const std::string& path, const std::string& root) {
    std::string name = path.substr(root.size() + 1);
    name.resize(name.size() - std::string(".spv").size());
    if (name.ends_with(".comp"))
        name.resize(name.size() - std::string(".comp").size());
    return name;
}

struct Kind {
    spvc_resource_type type;
    const char* name;
    bool buffer;
    bool storage;
};

constexpr Kind kKinds[] = {
    {SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, "SampledImage", false, false},
    {SPVC_RESOURCE_TYPE_STORAGE_IMAGE, "StorageImage", false, true},
    {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, "UniformBuffer", true, false},
    {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, "StorageBuffer", true, true},
    {SPVC_RESOURCE_TYPE_ACCELERATION_STRUCTURE, "AccelerationStructure", false, false},
};

/// NonWritable and NonReadable stand on an image's variable, but on the members of a buffer's block.
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

std::string describeBindings(spvc_compiler compiler, spvc_resources resources, const std::string& file) {
    std::string text;
    for (const Kind& kind : kKinds) {
        const spvc_reflected_resource* list = nullptr;
        size_t count = 0;
        check(spvc_resources_get_resource_list_for_type(resources, kind.type, &list, &count), file);
        for (size_t i = 0; i < count; ++i) {
            const std::string name = spvc_compiler_get_name(compiler, list[i].id);
            if (name.empty())
                fail(file +
                     ": a binding has no name (was the shader stripped, or a block left without instance name?)");
            const bool readOnly =
                !kind.storage || hasDecoration(compiler, list[i], kind.buffer, SpvDecorationNonWritable);
            const bool writeOnly =
                kind.storage && hasDecoration(compiler, list[i], kind.buffer, SpvDecorationNonReadable);
            const spvc_type type = spvc_compiler_get_type_handle(compiler, list[i].type_id);
            const unsigned arrayLength =
                spvc_type_get_num_array_dimensions(type) ? spvc_type_get_array_dimension(type, 0) : 1;
            text += fmt::format("    {{\"{}\", {}, {}, BindingKind::{}, {}, {}, {}}},\n", name,
                                spvc_compiler_get_decoration(compiler, list[i].id, SpvDecorationDescriptorSet),
                                spvc_compiler_get_decoration(compiler, list[i].id, SpvDecorationBinding), kind.name,
                                arrayLength, !writeOnly, !readOnly);
        }
    }
    return text;
}

size_t pushConstantSize(spvc_compiler compiler, spvc_resources resources, const std::string& file) {
    const spvc_reflected_resource* list = nullptr;
    size_t count = 0;
    check(spvc_resources_get_resource_list_for_type(resources, SPVC_RESOURCE_TYPE_PUSH_CONSTANT, &list, &count), file);
    size_t size = 0;
    if (count > 0)
        check(spvc_compiler_get_declared_struct_size(
                  compiler, spvc_compiler_get_type_handle(compiler, list[0].base_type_id), &size),
              file);
    return size;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 4)
        fail("usage: glint_shader_pack SET ROOT OUT.cpp FILE.spv ...");
    const std::string set = argv[1];
    const std::string root = argv[2];
    std::string arrays;
    std::string table;
    for (int i = 4; i < argc; ++i) {
        const std::string path = argv[i];
        const std::vector<uint32_t> words = readWords(path);
        spvc_context context = nullptr;
        spvc_parsed_ir ir = nullptr;
        spvc_compiler compiler = nullptr;
        spvc_resources resources = nullptr;
        check(spvc_context_create(&context), path);
        check(spvc_context_parse_spirv(context, words.data(), words.size(), &ir), path);
        check(spvc_context_create_compiler(context, SPVC_BACKEND_NONE, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler),
              path);
        check(spvc_compiler_create_shader_resources(compiler, &resources), path);

        const std::string bindings = describeBindings(compiler, resources, path);
        unsigned localSize[3] = {1, 1, 1};
        if (spvc_compiler_get_execution_model(compiler) == SpvExecutionModelGLCompute)
            for (unsigned axis = 0; axis < 3; ++axis)
                localSize[axis] =
                    spvc_compiler_get_execution_mode_argument_by_index(compiler, SpvExecutionModeLocalSize, axis);

        arrays += fmt::format("const uint32_t kWords{}[] = {{", i);
        for (size_t w = 0; w < words.size(); ++w)
            arrays += fmt::format("{}{:#x},", w % 16 == 0 ? "\n    " : " ", words[w]);
        arrays += "};\n";
        if (!bindings.empty())
            arrays += fmt::format("const ShaderBinding kBindings{}[] = {{\n{}}};\n", i, bindings);
        table += fmt::format("    {{\"{}\", kWords{}, {}, {{{}, {}, {}}}, {}}},\n", shaderName(path, root), i,
                             bindings.empty() ? "{}" : fmt::format("kBindings{}", i), localSize[0], localSize[1],
                             localSize[2], pushConstantSize(compiler, resources, path));
        spvc_context_destroy(context);
    }
    std::ofstream out(argv[3]);
    out << "// Made by glint_shader_pack.\n#include \"gpu/shader.hpp\"\n\nnamespace glint::gpu {\nnamespace {\n\n"
        << arrays << "\nconst EmbeddedShader kShaders[] = {\n"
        << table << "};\n\n} // namespace\n\nnamespace shaders {\nstd::span<const EmbeddedShader> " << set
        << "() { return kShaders; }\n} // namespace shaders\n\n} // namespace glint::gpu\n";
    if (!out.flush())
        fail(std::string(argv[3]) + ": cannot be written");
}
