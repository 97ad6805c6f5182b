# Plays a stranger: installs Glint into an empty prefix, builds examples/embed and examples/embed-c against that and
# nothing else, by CMake and by pkg-config, runs them and looks at the pictures.
# tests/CMakeLists.txt says what it is given.

function(run what)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${what} failed with ${status}:\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run("installing" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)

# Every public header stands alone, in a host that is stricter about warnings than most; and after headers of others that
# take common names for their macros.
file(GLOB headers ${WORK}/prefix/include/glint/*.hpp ${WORK}/prefix/include/glint/*.h)
set(strict ${COMPILER} -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
    -I ${WORK}/prefix/include)
foreach(header ${headers})
    run("compiling ${header} alone" ${strict} -include ${header} -x c++ /dev/null)
    run("compiling ${header} after X11 and windows.h's macros" ${strict}
        -include ${SOURCE}/tests/embed/taken_names.hpp -include ${header} -x c++ /dev/null)
endforeach()

# The header for C is C99, and no compiler adds bytes between its members.
set(strict_c ${C_COMPILER} -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wpadded -Werror
    -I ${WORK}/prefix/include)
run("compiling glint.h as C" ${strict_c} -fsyntax-only -include ${WORK}/prefix/include/glint/glint.h -x c /dev/null)

# Hosts that were compiled with an older header rely on sizes, offsets and constants.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
run("listing the layout" ${Python3_EXECUTABLE} ${SOURCE}/tests/abi/layout.py ${WORK}/prefix/include/glint/glint.h)
file(WRITE ${WORK}/layout.c "${output}")
run("compiling the layout" ${C_COMPILER} -std=c99 -I ${WORK}/prefix/include ${WORK}/layout.c -o ${WORK}/layout)
run("printing the layout" ${WORK}/layout)
file(READ ${SOURCE}/tests/abi/layout.txt expected)
if(NOT output STREQUAL expected)
    file(WRITE ${WORK}/layout.txt "${output}")
    message(FATAL_ERROR "glint.h has another layout than tests/abi/layout.txt says; compare ${WORK}/layout.txt. Hosts that "
        "are compiled already rely on it: members and constants may only be appended; then copy the new list")
endif()

# build_example(FOLDER BUILD): by CMake's package.
function(build_example folder build)
    run("configuring ${folder}" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE}/examples/${folder} -B ${build}
        -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
        -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_BUILD_TYPE=Release -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
        "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_C_FLAGS=${FLAGS}" "-DCMAKE_EXE_LINKER_FLAGS=${LINK_FLAGS}")
    file(STRINGS ${build}/CMakeCache.txt found REGEX "^glint_DIR:")
    if(NOT found MATCHES "=${WORK}/prefix/")
        message(FATAL_ERROR "the example was built against another Glint: ${found}")
    endif()
    file(STRINGS ${build}/CMakeCache.txt found REGEX "^fmt_DIR:")
    if(found)
        message(FATAL_ERROR "the package asks its host for fmt, which is Glint's own matter: ${found}")
    endif()
    run("building ${folder}" ${CMAKE_COMMAND} --build ${build})
endfunction()
build_example(embed ${WORK}/build)
build_example(embed-c ${WORK}/build_c)

# By pkg-config. The shared library's host links nothing else; the static one's asks with --static.
find_program(PKG_CONFIG NAMES pkg-config pkgconf REQUIRED)
file(GLOB_RECURSE pc ${WORK}/prefix/*/glint.pc)
get_filename_component(pc_folder "${pc}" DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${pc_folder})
file(GLOB shared ${pc_folder}/../libglint.so)
set(static)
if(NOT shared)
    set(static --static)
endif()
run("pkg-config" ${PKG_CONFIG} ${static} --cflags --libs glint)
separate_arguments(package UNIX_COMMAND "${output}")
separate_arguments(flags UNIX_COMMAND "${FLAGS} ${LINK_FLAGS}")
run("building the example by pkg-config" ${COMPILER} -std=c++20 ${SOURCE}/examples/embed/main.cpp -o ${WORK}/embed_pc
    ${flags} ${package} -lvulkan -Wl,-rpath,${pc_folder}/..)
run("building the C example by pkg-config" ${C_COMPILER} -std=c99 ${SOURCE}/examples/embed-c/main.c
    -o ${WORK}/embed_c_pc ${flags} ${package} -lvulkan -lm -Wl,-rpath,${pc_folder}/..)

# With the validation layer, where it is installed, synchronization checks included; it speaks on standard output.
set(ENV{VK_INSTANCE_LAYERS} VK_LAYER_KHRONOS_validation)
set(ENV{VK_LAYER_ENABLES} VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT)
function(run_example program folder)
    file(MAKE_DIRECTORY ${folder})
    run("the example" ${DRIVER} ${program} ${folder})
    message("${output}")
    if(output MATCHES "Validation|VUID-|SYNC-HAZARD")
        message(FATAL_ERROR "the validation layer objects, see above")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

# Once on a device whose queues compute and do not draw, without the features that only drawing needs: the same picture.
if(LAYERS)
    set(ENV{VK_ADD_LAYER_PATH} ${LAYERS})
    set(ENV{VK_INSTANCE_LAYERS} VK_LAYER_KHRONOS_validation:VK_LAYER_GLINT_compute_only)
    run_example(${WORK}/build/embed ${WORK}/compute_only)
    if(NOT output MATCHES "on a queue that only computes")
        message(FATAL_ERROR "the example ran on a queue that draws")
    endif()
    set(ENV{VK_INSTANCE_LAYERS} VK_LAYER_KHRONOS_validation)
endif()
# Each host draws the same picture to the last bit.
run_example(${WORK}/embed_pc ${WORK}/by_pkg_config)
run_example(${WORK}/embed_c_pc ${WORK}/c_by_pkg_config)
run_example(${WORK}/build_c/embed_c ${WORK}/c)
run_example(${WORK}/build/embed ${WORK})
file(GLOB others ${WORK}/*/after.ppm)
foreach(picture after before)
    file(SHA256 ${WORK}/${picture}.ppm expected)
    foreach(other ${others})
        string(REPLACE after.ppm ${picture}.ppm other ${other})
        file(SHA256 ${other} found)
        if(NOT found STREQUAL expected)
            message(FATAL_ERROR "${other} is another picture than ${WORK}/${picture}.ppm")
        endif()
    endforeach()
endforeach()

# pixel(NAME FILE X Y): the colour of one pixel, three numbers.
function(pixel name file x y)
    file(READ ${file} header LIMIT 32 HEX)
    string(REGEX MATCH "^50360a((3[0-9])+)20((3[0-9])+)0a3235350a" header "${header}") # P6, width height, 255
    if(NOT header)
        message(FATAL_ERROR "${file} is not a PPM file")
    endif()
    string(REGEX REPLACE "3([0-9])" "\\1" width "${CMAKE_MATCH_1}")
    string(LENGTH ${header} digits)
    math(EXPR offset "${digits} / 2 + (${y} * ${width} + ${x}) * 3")
    file(READ ${file} bytes OFFSET ${offset} LIMIT 3 HEX)
    string(REGEX MATCH "(..)(..)(..)" bytes "${bytes}")
    math(EXPR r "0x${CMAKE_MATCH_1}")
    math(EXPR g "0x${CMAKE_MATCH_2}")
    math(EXPR b "0x${CMAKE_MATCH_3}")
    set(${name} ${r} ${g} ${b} PARENT_SCOPE)
endfunction()

# distance(NAME A B): the largest difference of a channel.
function(distance name a b)
    set(most 0)
    foreach(one other IN ZIP_LISTS ${a} ${b})
        math(EXPR difference "${one} - ${other}")
        string(REPLACE "-" "" difference ${difference})
        if(difference GREATER most)
            set(most ${difference})
        endif()
    endforeach()
    set(${name} ${most} PARENT_SCOPE)
endfunction()

# The example tells where its mirrors must show a surface of one flat colour, from geometry alone.
set(claim "pixel ([0-9]+),([0-9]+) of after.ppm must show the colour of ([0-9]+),([0-9]+)")
string(REGEX MATCHALL "${claim}" claims "${output}")
list(LENGTH claims count)
if(NOT count EQUAL 2)
    message(FATAL_ERROR "the example does not say which pixels to compare")
endif()
foreach(one_claim IN LISTS claims)
    string(REGEX MATCH "${claim}" one_claim "${one_claim}")
    set(x ${CMAKE_MATCH_1})
    set(y ${CMAKE_MATCH_2})
    pixel(expected ${WORK}/before.ppm ${CMAKE_MATCH_3} ${CMAKE_MATCH_4})
    pixel(before ${WORK}/before.ppm ${x} ${y})
    pixel(after ${WORK}/after.ppm ${x} ${y})
    distance(change before after)
    distance(error after expected)
    message("the mirror at ${x},${y} showed ${before}, shows ${after}, should show ${expected}")
    if(change LESS 40)
        message(FATAL_ERROR "the picture with reflections is hardly another one")
    endif()
    if(error GREATER 1) # half floats, then rounding
        message(FATAL_ERROR "the mirror shows the wrong colour")
    endif()
endforeach()
