# The installed package: find_package(glint), glint::glint, <glint/glint.hpp>, <glint/glint.h>; the same for pkg-config. One
# library file and its headers; presets and shaders are inside the library. And the program with its man pages, where it
# is built.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/glint)
install(TARGETS glint EXPORT glintTargets)
install(DIRECTORY include/glint DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING
    PATTERN "*.hpp" PATTERN "*.h")
install(FILES LICENSE THIRD-PARTY.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/glint)
install(EXPORT glintTargets NAMESPACE glint:: DESTINATION ${package_folder})

configure_package_config_file(cmake/glintConfig.cmake.in glintConfig.cmake INSTALL_DESTINATION ${package_folder}
    NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(glintConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/glintConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/glintConfigVersion.cmake
    DESTINATION ${package_folder})

# pkg-config. A host of the static library asks with --static: a linker that is not C++'s needs C++'s library.
set(pc_static "-lstdc++ -lm -pthread")
if(CMAKE_DL_LIBS)
    string(APPEND pc_static " -l${CMAKE_DL_LIBS}")
endif()
set(pc_cflags)
if(BUILD_SHARED_LIBS)
    set(pc_static)
    set(pc_cflags " -DGLINT_SHARED")
endif()
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR} OR IS_ABSOLUTE ${CMAKE_INSTALL_INCLUDEDIR})
    set(pc_includedir ${CMAKE_INSTALL_FULL_INCLUDEDIR})
    set(pc_libdir ${CMAKE_INSTALL_FULL_LIBDIR})
else() # beside the file: a package that was moved, or installed with --prefix, is found too
    string(REGEX REPLACE "[^/]+" ".." up ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
    set(pc_includedir "\${pcfiledir}/${up}/${CMAKE_INSTALL_INCLUDEDIR}")
    set(pc_libdir "\${pcfiledir}/${up}/${CMAKE_INSTALL_LIBDIR}")
endif()
configure_file(cmake/glint.pc.in glint.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/glint.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(GLINT_BUILD_LAB)
    # Optional: `cmake --install` of a build of the library alone.
    install(TARGETS glint_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} OPTIONAL)
    find_package(Python3 COMPONENTS Interpreter)
    if(Python3_FOUND AND NOT CMAKE_CROSSCOMPILING AND NOT GLINT_SANITIZE)
        set(man ${CMAKE_CURRENT_BINARY_DIR}/man)
        add_custom_command(OUTPUT ${man}/glint.1
            COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/scripts/lib/man_pages.py $<TARGET_FILE:glint_cli> ${man}
            DEPENDS glint_cli ${PROJECT_SOURCE_DIR}/scripts/lib/man_pages.py
            COMMENT "Writing man pages" VERBATIM)
        add_custom_target(glint_man ALL DEPENDS ${man}/glint.1)
        install(DIRECTORY ${man}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
    endif()
endif()

find_program(DOXYGEN doxygen)
if(DOXYGEN AND PROJECT_IS_TOP_LEVEL)
    add_custom_target(docs COMMAND ${CMAKE_COMMAND} -E env sh -c
        "(cat packaging/api/Doxyfile && echo OUTPUT_DIRECTORY = ${CMAKE_CURRENT_BINARY_DIR}/api) | ${DOXYGEN} -"
        WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
endif()
