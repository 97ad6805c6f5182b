# glint_shader_pack: SPIR-V and its reflected bindings -> C++. It runs on the machine that builds, so a build for another
# machine makes it in a project of its own (cmake/shader_pack) with this machine's compiler.
find_package(fmt REQUIRED)

# SPIR-V is reflected at build time, and in the viewer where it recompiles shaders; never in the library. Debian ships
# SPIRV-Cross as one library with a C interface, vcpkg as static libraries with a CMake package each.
find_library(SPIRV_CROSS_C spirv-cross-c-shared)
if(NOT SPIRV_CROSS_C)
    foreach(part core glsl cpp msl hlsl reflect util c)
        find_package(spirv_cross_${part} CONFIG REQUIRED)
    endforeach()
    set(SPIRV_CROSS_C spirv-cross-c)
endif()
find_path(SPIRV_CROSS_C_INCLUDE_DIR spirv_cross_c.h PATH_SUFFIXES spirv_cross REQUIRED)

get_filename_component(glint_root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)

# Shared with the viewer, which reflects what it compiles while it runs.
add_library(glint_shader_reflection STATIC ${glint_root}/src/gpu/embed/shader_reflection.cpp
    ${glint_root}/src/gpu/embed/shader_variants.cpp ${glint_root}/src/base/format.cpp)
target_include_directories(glint_shader_reflection PUBLIC ${glint_root}/src ${glint_root}/include)
target_include_directories(glint_shader_reflection SYSTEM PRIVATE ${SPIRV_CROSS_C_INCLUDE_DIR})
target_link_libraries(glint_shader_reflection PUBLIC fmt::fmt PRIVATE ${SPIRV_CROSS_C} glint_warnings)

add_executable(glint_shader_pack ${glint_root}/src/gpu/embed/shader_pack.cpp
    ${glint_root}/src/gpu/embed/gpu_arithmetic.cpp)
target_link_libraries(glint_shader_pack PRIVATE glint_shader_reflection glint_warnings)
set_target_properties(glint_shader_pack PROPERTIES CROSSCOMPILING_EMULATOR "")
