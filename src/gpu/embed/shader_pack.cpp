// Build tool: reads SPIR-V files and writes one C++ file with each shader's reflected bindings and the words of
// FILE.spv.opt, the same shader optimized, which has lost the bindings that it turned out not to need.
//   glint_shader_pack [--gpu-arithmetic] SET ROOT OUT.cpp ROOT/trace/classify.comp.spv ...
// With --gpu-arithmetic shaders are rewritten so that a software device computes them as GPUs may (gpu_arithmetic.hpp).
#include "gpu/embed/gpu_arithmetic.hpp"
#include "gpu/embed/shader_reflection.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

namespace {

using namespace glint::gpu;

[[noreturn]] void fail(const std::string& message) {
    std::fprintf(stderr, "glint_shader_pack: %s\n", message.c_str());
    std::exit(1);
}

std::string readFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {(std::istreambuf_iterator<char>(file)), {}};
}

ReflectedShader readShader(const std::string& path, bool gpuArithmetic) {
    auto shader = reflectShader(readFile(path), path);
    if (!shader)
        fail(shader.error().message);
    const std::string optimized = readFile(path + ".opt");
    if (optimized.empty() || optimized.size() % sizeof(uint32_t) != 0)
        fail(path + ".opt: not a SPIR-V file");
    shader->words.resize(optimized.size() / sizeof(uint32_t));
    std::memcpy(shader->words.data(), optimized.data(), optimized.size());
    if (gpuArithmetic) {
        auto rewritten = asGpusCompute(shader->words);
        if (!rewritten)
            fail(path + ".opt: " + rewritten.error().message);
        shader->words = *std::move(rewritten);
    }
    return *std::move(shader);
}

/// "ROOT/trace/classify.comp.spv" -> "trace/classify"
std::string nameOf(const std::string& path, const std::string& root) {
    std::string name = path.substr(root.size() + 1);
    name.resize(name.size() - std::string(".spv").size());
    return shaderName(name);
}

const char* kindText(BindingKind kind) {
    switch (kind) {
    case BindingKind::SampledImage: return "SampledImage";
    case BindingKind::StorageImage: return "StorageImage";
    case BindingKind::UniformBuffer: return "UniformBuffer";
    case BindingKind::StorageBuffer: return "StorageBuffer";
    case BindingKind::AccelerationStructure: return "AccelerationStructure";
    }
    return "";
}

} // namespace

int main(int argc, char** argv) {
    const bool gpuArithmetic = argc > 1 && std::strcmp(argv[1], "--gpu-arithmetic") == 0;
    if (gpuArithmetic) {
        --argc;
        ++argv;
    }
    if (argc < 4)
        fail("usage: glint_shader_pack [--gpu-arithmetic] SET ROOT OUT.cpp FILE.spv ...");
    const std::string set = argv[1];
    const std::string root = argv[2];
    std::string arrays;
    std::string table;
    for (int i = 4; i < argc; ++i) {
        const ReflectedShader shader = readShader(argv[i], gpuArithmetic);
        arrays += fmt::format("const uint32_t kWords{}[] = {{", i);
        for (size_t w = 0; w < shader.words.size(); ++w)
            arrays += fmt::format("{}{:#x},", w % 16 == 0 ? "\n    " : " ", shader.words[w]);
        arrays += "};\n";
        if (!shader.bindings.empty())
            arrays += fmt::format("const ShaderBinding kBindings{}[] = {{\n", i);
        for (const ShaderBinding& b : shader.bindings)
            arrays += fmt::format("    {{\"{}\", {}, {}, BindingKind::{}, {}, {}, {}}},\n", b.name, b.set, b.binding,
                                  kindText(b.kind), b.count, b.reads, b.writes);
        if (!shader.bindings.empty())
            arrays += "};\n";
        table += fmt::format("    {{\"{}\", kWords{}, {}, {{{}, {}, {}}}, {}}},\n", nameOf(argv[i], root), i,
                             shader.bindings.empty() ? "{}" : fmt::format("kBindings{}", i), shader.localSize[0],
                             shader.localSize[1], shader.localSize[2], shader.pushConstantSize);
    }
    std::ofstream out(argv[3]);
    out << "// Made by glint_shader_pack.\n#include \"gpu/shader.hpp\"\n\nnamespace glint::gpu {\nnamespace {\n\n"
        << arrays << "\nconst EmbeddedShader kShaders[] = {\n"
        << table << "};\n\n} // namespace\n\nnamespace shaders {\nstd::span<const EmbeddedShader> " << set
        << "() { return kShaders; }\n} // namespace shaders\n\n} // namespace glint::gpu\n";
    if (!out.flush())
        fail(std::string(argv[3]) + ": cannot be written");
}
