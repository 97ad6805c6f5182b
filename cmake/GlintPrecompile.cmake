# Precompiled headers: most of a file's compile time went into the headers of packages that all of them include. A set is
# what its files share; headers of our own stay out, for an edit of one would compile everything again. Each file still
# includes what it uses: builds with CMAKE_DISABLE_PRECOMPILE_HEADERS work as well.
set(glint_pch_core <algorithm> <array> <cmath> <cstdint> <cstring> <functional> <limits> <map> <memory> <optional> <span>
    <string> <string_view> <unordered_map> <utility> <vector> <fmt/core.h> <glm/glm.hpp>)
set(glint_pch_vulkan ${glint_pch_core} <vulkan/vulkan.h> <glm/gtc/matrix_transform.hpp> <glm/gtc/type_ptr.hpp>)
set(glint_pch_lab ${glint_pch_vulkan} <fmt/format.h> <filesystem> <fstream> <set> <nlohmann/json.hpp> <glm/gtc/constants.hpp>)
set(glint_pch_tests ${glint_pch_lab} <random> <gmock/gmock.h> <gtest/gtest.h>)

# What the headers of a set need beside the compiler's own.
set(glint_pch_packages_core glint_fmt glm::glm)
set(glint_pch_packages_vulkan ${glint_pch_packages_core} Vulkan::Headers)
set(glint_pch_packages_lab ${glint_pch_packages_vulkan} fmt::fmt nlohmann_json::nlohmann_json)
set(glint_pch_packages_tests ${glint_pch_packages_lab} GTest::gmock GTest::gtest)

# glint_precompile(TARGET SET): call it after the target's compile options are set. A set is compiled once for all targets
# with the same options, in a target of its own: a compiler refuses a header that another macro was defined for.
function(glint_precompile target set)
    get_target_property(options ${target} COMPILE_OPTIONS)
    get_target_property(visibility ${target} CXX_VISIBILITY_PRESET)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL EXECUTABLE)
        set(type program) # position-independent in another way than libraries
    else()
        set(type library)
    endif()
    string(MD5 variant "${options} ${visibility} ${type}")
    string(SUBSTRING ${variant} 0 6 variant)
    set(owner glint_pch_${set}_${variant})
    if(NOT TARGET ${owner})
        file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${owner}.cpp CONTENT "")
        add_library(${owner} OBJECT ${PROJECT_BINARY_DIR}/${owner}.cpp)
        target_link_libraries(${owner} PRIVATE glint_warnings ${glint_pch_packages_${set}})
        if(type STREQUAL program AND CMAKE_CXX_COMPILE_OPTIONS_PIE)
            set_target_properties(${owner} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
            target_compile_options(${owner} PRIVATE ${CMAKE_CXX_COMPILE_OPTIONS_PIE})
        endif()
        if(options)
            target_compile_options(${owner} PRIVATE ${options})
        endif()
        if(visibility)
            set_target_properties(${owner} PROPERTIES CXX_VISIBILITY_PRESET ${visibility} VISIBILITY_INLINES_HIDDEN ON)
        endif()
        target_precompile_headers(${owner} PRIVATE ${glint_pch_${set}})
    endif()
    target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()
