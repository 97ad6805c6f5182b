# What the library itself needs, by package (scripts/lib/setup.sh installs them).
find_program(GLSLC glslc REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)
find_program(SPIRV_OPT spirv-opt REQUIRED)

if(CMAKE_CROSSCOMPILING AND WIN32)
    include(GlintHostHeaders)
else()
    find_package(VulkanHeaders REQUIRED)
    find_package(fmt REQUIRED)
    find_package(glm REQUIRED)
    find_package(nlohmann_json REQUIRED)
    # VMA is one header; Debian 12 has no package of it, so the set-up unpacks Debian 13's into .deps/.
    find_path(VMA_INCLUDE_DIR vk_mem_alloc.h HINTS ${PROJECT_SOURCE_DIR}/.deps/vma/include
        PATH_SUFFIXES vma include)
endif()
if(NOT VMA_INCLUDE_DIR)
    message(FATAL_ERROR "vk_mem_alloc.h, the Vulkan Memory Allocator, is not found: install libvulkan-memory-allocator-dev "
        "(Debian 13, Ubuntu 24.04), or say where it is with -DVMA_INCLUDE_DIR=<folder>; scripts/test brings its own")
endif()
add_library(glint_vma INTERFACE)
target_include_directories(glint_vma SYSTEM INTERFACE $<BUILD_INTERFACE:${VMA_INCLUDE_DIR}>)

# fmt's headers alone: src/base/format.cpp compiles its code.
add_library(glint_fmt INTERFACE)
target_include_directories(glint_fmt SYSTEM INTERFACE
    $<BUILD_INTERFACE:$<TARGET_PROPERTY:fmt::fmt-header-only,INTERFACE_INCLUDE_DIRECTORIES>>)
