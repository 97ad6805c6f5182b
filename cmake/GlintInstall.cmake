# The installed package: find_package(glint), glint::glint, <glint/glint.hpp>. One library file and its headers; presets
# and shaders are inside the library.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/glint)
install(TARGETS glint EXPORT glintTargets)
install(DIRECTORY include/glint DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(FILES LICENSE THIRD-PARTY.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/glint)
install(EXPORT glintTargets NAMESPACE glint:: DESTINATION ${package_folder})

configure_package_config_file(cmake/glintConfig.cmake.in glintConfig.cmake INSTALL_DESTINATION ${package_folder}
    NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(glintConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/glintConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/glintConfigVersion.cmake
    DESTINATION ${package_folder})
