# GLSL -> SPIR-V -> optimized SPIR-V (both validated) -> one C++ file per set: the words of the optimized SPIR-V beside the
# bindings that the first one says.

if(CMAKE_CROSSCOMPILING AND NOT CMAKE_HOST_SYSTEM_NAME STREQUAL CMAKE_SYSTEM_NAME)
    include(ExternalProject)
    set(shader_pack_folder ${CMAKE_BINARY_DIR}/shader_pack)
    ExternalProject_Add(glint_shader_pack_build SOURCE_DIR ${PROJECT_SOURCE_DIR}/cmake/shader_pack
        BINARY_DIR ${shader_pack_folder} INSTALL_COMMAND "" BUILD_ALWAYS ON
        CMAKE_ARGS -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
        BUILD_BYPRODUCTS ${shader_pack_folder}/glint_shader_pack)
    add_executable(glint_shader_pack IMPORTED)
    set_target_properties(glint_shader_pack PROPERTIES IMPORTED_LOCATION ${shader_pack_folder}/glint_shader_pack)
    add_dependencies(glint_shader_pack glint_shader_pack_build)
else()
    include(GlintShaderPack)
endif()

# One shader: `file`, its name with its stage's suffix, is compiled from `source` with the macros in ARGN. The SPIR-V file
# is added to the list `spirv_files`. lab/view/shader_reload.cpp compiles in the same way.
function(glint_compile_shader set file source)
    set(spirv ${CMAKE_CURRENT_BINARY_DIR}/shaders/${set}/${file}.spv)
    if(spirv IN_LIST spirv_files)
        message(FATAL_ERROR "The shader ${file} is stated twice: as a file, or in variants.txt")
    endif()
    get_filename_component(folder ${spirv} DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    string(REGEX REPLACE ".*\\." "" stage ${file})
    list(TRANSFORM ARGN PREPEND -D OUTPUT_VARIABLE macros)
    # No -O here: bindings are matched by name, so reflection sees all of them with their names.
    # SPIR-V 1.6 would say LocalSizeId, which the packaged SPIRV-Cross reads as 0: ask for 1.5.
    # Drivers optimize anyway, but slowly, and some each time that a pipeline is made: create takes two thirds of the time
    # with what spirv-opt leaves. Paths alone run slower with it, by 8 % (lab/notes/speed.md).
    set(optimize $<$<NOT:$<CONFIG:Debug>>:-O>)
    if(file MATCHES "^rays/")
        set(optimize)
    endif()
    add_custom_command(OUTPUT ${spirv} ${spirv}.opt
        COMMAND ${GLSLC} --target-env=vulkan1.3 --target-spv=spv1.5 -std=460 -Werror -fshader-stage=${stage}
            $<$<CONFIG:Debug>:-g> -I ${PROJECT_SOURCE_DIR}/shaders -I ${root} ${macros}
            -MD -MF ${spirv}.d -o ${spirv} ${source}
        COMMAND ${SPIRV_VAL} --target-env vulkan1.3 --scalar-block-layout ${spirv}
        COMMAND ${SPIRV_OPT} --target-env=vulkan1.3 --scalar-block-layout ${optimize}
            ${spirv} -o ${spirv}.opt
        COMMAND ${SPIRV_VAL} --target-env vulkan1.3 --scalar-block-layout ${spirv}.opt
        DEPENDS ${source} DEPFILE ${spirv}.d
        COMMENT "Compiling shader ${file}" VERBATIM COMMAND_EXPAND_LISTS)
    set(spirv_files ${spirv_files} ${spirv} PARENT_SCOPE)
endfunction()

# glint_embed_shaders(TARGET SET name FOLDERS shaders/trace lab/shaders/render ...)
# A shader is named by its path in its folder `shaders`: shaders/trace/classify.comp is "trace/classify"; raster stages
# keep their suffix, "render/surface.vert". shaders/variants.txt names those that are built from one source with different
# macros; they belong to the folder in their name. The set appears in C++ as glint::gpu::shaders::<name>()
# (gpu/shader.hpp).
function(glint_embed_shaders target)
    cmake_parse_arguments(arg "" "SET" "FOLDERS" ${ARGN})
    set(spirv_files)
    foreach(folder ${arg_FOLDERS})
        string(REGEX REPLACE "^(.*shaders)(/.*)?$" "\\1" root ${folder})
        set(root ${PROJECT_SOURCE_DIR}/${root})
        file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.comp
            ${PROJECT_SOURCE_DIR}/${folder}/*.vert ${PROJECT_SOURCE_DIR}/${folder}/*.frag)
        foreach(source ${sources})
            file(RELATIVE_PATH file ${root} ${source})
            glint_compile_shader(${arg_SET} ${file} ${source})
        endforeach()
        set(variants)
        if(EXISTS ${root}/variants.txt)
            set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/variants.txt)
            file(STRINGS ${root}/variants.txt variants REGEX "^[^#]")
        endif()
        foreach(variant ${variants})
            string(REGEX MATCHALL "[^ \t]+" words "${variant}")
            list(POP_FRONT words file source)
            if(NOT source)
                message(FATAL_ERROR "${root}/variants.txt: ${variant}: a line is NAME SOURCE [MACRO ...]")
            endif()
            get_filename_component(place ${root}/${file} DIRECTORY)
            if(NOT place STREQUAL ${PROJECT_SOURCE_DIR}/${folder})
                continue()
            endif()
            if(NOT file MATCHES "\\.(vert|frag)$")
                string(APPEND file .comp)
            endif()
            set(sources ${root}/${source})
            if(source MATCHES "[*]") # a shader of each such file
                file(GLOB sources CONFIGURE_DEPENDS ${root}/${source})
            endif()
            foreach(one ${sources})
                get_filename_component(name ${one} NAME_WE)
                string(REPLACE "*" ${name} named ${file})
                glint_compile_shader(${arg_SET} ${named} ${one} ${words})
            endforeach()
        endforeach()
    endforeach()
    set(packed ${CMAKE_CURRENT_BINARY_DIR}/shaders/${arg_SET}.cpp)
    add_custom_command(OUTPUT ${packed}
        COMMAND glint_shader_pack $<$<BOOL:${GLINT_GPU_ARITHMETIC}>:--gpu-arithmetic>
            ${arg_SET} ${CMAKE_CURRENT_BINARY_DIR}/shaders/${arg_SET} ${packed} ${spirv_files}
        DEPENDS glint_shader_pack ${spirv_files}
        COMMENT "Packing shaders: ${arg_SET}" VERBATIM COMMAND_EXPAND_LISTS)
    target_sources(${target} PRIVATE ${packed})
endfunction()

# presets/*.json are plain files for people and part of the library: it knows them without opening any file.
function(glint_embed_presets target)
    file(GLOB presets CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/presets/*.json)
    set(embedded ${CMAKE_CURRENT_BINARY_DIR}/presets.cpp)
    add_custom_command(OUTPUT ${embedded}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${embedded} "-DPRESETS=${presets}"
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_presets.cmake
        DEPENDS ${presets} ${PROJECT_SOURCE_DIR}/cmake/embed_presets.cmake
        COMMENT "Embedding presets" VERBATIM)
    target_sources(${target} PRIVATE ${embedded})
endfunction()

# A file of the tree as a part of the program: `function`, declared in `header`, returns its text.
function(glint_embed_text target file header function)
    get_filename_component(name ${file} NAME_WE)
    set(embedded ${CMAKE_CURRENT_BINARY_DIR}/${target}_${name}.cpp)
    add_custom_command(OUTPUT ${embedded}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${embedded} -DINPUT=${PROJECT_SOURCE_DIR}/${file} -DHEADER=${header}
            -DFUNCTION=${function} -P ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
        DEPENDS ${PROJECT_SOURCE_DIR}/${file} ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
        COMMENT "Embedding ${file}" VERBATIM)
    target_sources(${target} PRIVATE ${embedded})
endfunction()
