# One way to make a target: every source of its folders, our warnings, our sanitizers.

add_library(glint_warnings INTERFACE)
target_compile_options(glint_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
    -Wno-missing-field-initializers # Vulkan structs are named by their type and filled in field by field
    $<$<BOOL:${GLINT_UNITY}>:-Wno-subobject-linkage> # a source's own types, seen from the file that includes it
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
    # Up to eight neighbours are compiled as one: they share the headers' templates. A name that two of them keep to
    # themselves must differ.
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${GLINT_UNITY} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# Takes a source, or all below a folder, out of a target that globbed them.
function(glint_without_source target source)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources EXCLUDE REGEX "^${PROJECT_SOURCE_DIR}/${source}(/|$)")
    set_property(TARGET ${target} PROPERTY SOURCES ${sources})
endfunction()

# For code that no frame and no measurement waits for: compiling it with all optimizations takes half as long again, and
# with UndefinedBehaviorSanitizer, whose checks are for the library under it.
function(glint_compile_quickly target)
    if(GLINT_SANITIZE MATCHES undefined)
        target_compile_options(${target} PRIVATE -fno-sanitize=undefined)
    endif()
    if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT MSVC AND NOT GLINT_SANITIZE)
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
    endif()
endfunction()

function(glint_common target)
    cmake_parse_arguments(arg "" "" "FOLDERS;LIBRARIES;PRIVATE" ${ARGN})
    glint_sources(${target} ${arg_FOLDERS})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include
        ${PROJECT_SOURCE_DIR}/shaders)
    target_link_libraries(${target} PUBLIC ${arg_LIBRARIES}
        PRIVATE $<BUILD_INTERFACE:glint_warnings> ${arg_PRIVATE})
    # Only what include/glint marks GLINT_API leaves a shared library: its copies of VMA, fmt and our own internals must
    # not take the place of a host's.
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    glint_precompile(${target} core)
endfunction()

# An internal part: other parts link it, strangers never see it.
function(glint_static_library target)
    add_library(${target} STATIC)
    glint_common(${target} ${ARGN})
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/shaders>)
endfunction()

# The library that hosts link, as glint::glint: one file that holds the internal PARTS too. Only include/ is visible to
# hosts. What is needed to compile it, its PARTS and COMPILE libraries, stays out of the installed package.
function(glint_library target)
    cmake_parse_arguments(arg "" "" "FOLDERS;LIBRARIES;PRIVATE;PARTS;COMPILE" ${ARGN})
    add_library(${target})
    add_library(glint::${target} ALIAS ${target})
    set(compile)
    foreach(part ${arg_PARTS})
        target_sources(${target} PRIVATE $<TARGET_OBJECTS:${part}>)
    endforeach()
    foreach(library ${arg_PARTS} ${arg_COMPILE})
        list(APPEND compile $<BUILD_INTERFACE:${library}>)
    endforeach()
    glint_common(${target} FOLDERS ${arg_FOLDERS} LIBRARIES ${arg_LIBRARIES} PRIVATE ${arg_PRIVATE} ${compile})
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_features(${target} PUBLIC cxx_std_20)
    if(BUILD_SHARED_LIBS)
        target_compile_definitions(${target} INTERFACE GLINT_SHARED) # include/glint/api.h
        foreach(built ${target} ${arg_PARTS})
            target_compile_definitions(${built} PRIVATE GLINT_SHARED GLINT_BUILDING)
        endforeach()
        set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION}
            SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}) # before 1.0 a minor version may break
        if(UNIX AND NOT APPLE)
            target_link_options(${target} PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/glint.map)
            set_target_properties(${target} PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/glint.map)
        endif()
    endif()
endfunction()
