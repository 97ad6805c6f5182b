# Plays a stranger: installs Glint into an empty prefix, builds examples/embed against that and nothing else, runs it
# and looks at the two pictures.
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
file(GLOB headers ${WORK}/prefix/include/glint/*.hpp)
set(strict ${COMPILER} -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
    -I ${WORK}/prefix/include)
foreach(header ${headers})
    run("compiling ${header} alone" ${strict} -include ${header} -x c++ /dev/null)
    run("compiling ${header} after X11 and windows.h's macros" ${strict}
        -include ${SOURCE}/tests/embed/taken_names.hpp -include ${header} -x c++ /dev/null)
endforeach()

run("configuring the example" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE}/examples/embed -B ${WORK}/build
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
    "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_EXE_LINKER_FLAGS=${LINK_FLAGS}")
file(STRINGS ${WORK}/build/CMakeCache.txt found REGEX "^glint_DIR:")
if(NOT found MATCHES "=${WORK}/prefix/")
    message(FATAL_ERROR "the example was built against another Glint: ${found}")
endif()
run("building the example" ${CMAKE_COMMAND} --build ${WORK}/build)

# With the validation layer, where it is installed, synchronization checks included; it speaks on standard output.
set(ENV{VK_INSTANCE_LAYERS} VK_LAYER_KHRONOS_validation)
set(ENV{VK_LAYER_ENABLES} VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT)
function(run_example folder)
    file(MAKE_DIRECTORY ${folder})
    run("the example" ${DRIVER} ${WORK}/build/embed ${folder})
    message("${output}")
    if(output MATCHES "Validation|VUID-|SYNC-HAZARD")
        message(FATAL_ERROR "the validation layer objects, see above")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

# Once on a device whose queues compute and do not draw, without the features that only drawing needs: the same picture.
set(ENV{VK_ADD_LAYER_PATH} ${LAYERS})
set(ENV{VK_INSTANCE_LAYERS} VK_LAYER_KHRONOS_validation:VK_LAYER_GLINT_compute_only)
run_example(${WORK}/compute_only)
if(NOT output MATCHES "on a queue that only computes")
    message(FATAL_ERROR "the example ran on a queue that draws")
endif()
set(ENV{VK_INSTANCE_LAYERS} VK_LAYER_KHRONOS_validation)
run_example(${WORK})
file(SHA256 ${WORK}/after.ppm whole)
file(SHA256 ${WORK}/compute_only/after.ppm computed)
if(NOT whole STREQUAL computed)
    message(FATAL_ERROR "the picture of the queue that only computes is another one")
endif()

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
