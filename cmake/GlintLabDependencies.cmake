# What our own programs need besides: glTF payloads, image files, the command line.
find_package(OpenEXR REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(meshoptimizer REQUIRED)
pkg_check_modules(WEBP REQUIRED IMPORTED_TARGET libwebp)
find_package(draco REQUIRED)
find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)

add_library(glint_image_libraries INTERFACE)
target_include_directories(glint_image_libraries SYSTEM INTERFACE ${STB_INCLUDE_DIR})
target_link_libraries(glint_image_libraries INTERFACE OpenEXR::OpenEXR PkgConfig::WEBP)

add_library(glint_mesh_libraries INTERFACE)
target_link_libraries(glint_mesh_libraries INTERFACE meshoptimizer::meshoptimizer draco::draco)

# pagmo is the optimiser of glint tune (lab/tune).
find_package(Pagmo REQUIRED)

# Embree is the oracle that figures are measured against (lab/measure); 3 on Debian 12, 4 later.
find_library(EMBREE_LIBRARY NAMES embree4 embree3 REQUIRED)
add_library(glint_embree INTERFACE)
target_link_libraries(glint_embree INTERFACE ${EMBREE_LIBRARY})
