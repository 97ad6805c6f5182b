# One way to make a target: every source of its folders, our warnings, our sanitizers.

add_library(glint_warnings INTERFACE)
target_compile_options(glint_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
    -Wno-missing-field-initializers # Vulkan structs are named by their type and filled in field by field
    $<$<BOOL:${GLINT_WERROR}>:-Werror>)
target_compile_definitions(glint_warnings INTERFACE $<$<BOOL:${GLINT_ASSERTS}>:GLINT_ASSERTS=1>)

if(GLINT_SANITIZE)
    add_compile_options(-fsanitize=${GLINT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${GLINT_SANITIZE})
endif()

function(glint_sources target)
    set(patterns)
    foreach(folder ${ARGN})
        list(APPEND patterns ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
    endforeach()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${patterns})
    list(FILTER sources EXCLUDE REGEX "^${PROJECT_SOURCE_DIR}/src/.*/embed/") # build tools have a folder of their own
    target_sources(${target} PRIVATE ${sources})
endfunction()

function(glint_common target)
    cmake_parse_arguments(arg "" "" "FOLDERS;LIBRARIES;PRIVATE" ${ARGN})
    glint_sources(${target} ${arg_FOLDERS})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include
        ${PROJECT_SOURCE_DIR}/shaders)
    target_link_libraries(${target} PUBLIC ${arg_LIBRARIES}
        PRIVATE $<BUILD_INTERFACE:glint_warnings> ${arg_PRIVATE})
endfunction()

# An internal part: other parts link it, strangers never see it.
function(glint_static_library target)
    add_library(${target} STATIC)
    glint_common(${target} ${ARGN})
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/shaders>)
endfunction()

# The library that hosts link, as glint::glint. Only include/ is visible to them.
function(glint_library target)
    add_library(${target})
    add_library(glint::${target} ALIAS ${target})
    glint_common(${target} ${ARGN})
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_features(${target} PUBLIC cxx_std_20)
endfunction()
