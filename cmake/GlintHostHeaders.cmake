# Dependencies of a build for Windows on Linux. What the library needs is headers alone, and those of this machine's
# packages will do: they are copied out of /usr/include, whose C library is of another system.
# -DGLINT_HEADERS=<folder> uses a folder that has vulkan/, vk_video/, vk_mem_alloc.h, fmt/, glm/ and nlohmann/ instead.
set(GLINT_HEADERS "" CACHE PATH "Headers of Vulkan, VMA, fmt, glm and nlohmann-json for a cross build; empty: this machine's")
set(headers ${GLINT_HEADERS})
if(NOT headers)
    set(headers ${CMAKE_BINARY_DIR}/headers)
    foreach(name vulkan vk_video vk_mem_alloc.h fmt glm nlohmann)
        find_path(GLINT_HEADERS_OF_${name} ${name} PATHS ${PROJECT_SOURCE_DIR}/.deps/vma/include /usr/include
            /usr/include/vma NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
        if(NOT GLINT_HEADERS_OF_${name})
            message(FATAL_ERROR "no headers ${name} in /usr/include or .deps: scripts/test -N installs them, or say "
                "where all headers are with -DGLINT_HEADERS=<folder>")
        endif()
        file(COPY ${GLINT_HEADERS_OF_${name}}/${name} DESTINATION ${headers})
    endforeach()
endif()
foreach(target Vulkan::Headers fmt::fmt-header-only glm::glm nlohmann_json::nlohmann_json)
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE ${headers})
endforeach()
target_compile_definitions(fmt::fmt-header-only INTERFACE FMT_HEADER_ONLY=1)
set(VMA_INCLUDE_DIR ${headers})
