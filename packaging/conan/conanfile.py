"""Glint for Conan 2: `conan create packaging/conan --build=missing` in a checkout. docs/embedding.md says what was tried."""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class Glint(ConanFile):
    name = "glint"
    description = "Reflections for any Vulkan renderer"
    license = "MIT"
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False]}
    # SPIRV-Cross, which only the build uses, as the one library with a C interface.
    default_options = {"shared": False, "fPIC": True, "spirv-cross/*:shared": True,
                       "spirv-cross/*:build_executable": False}
    implements = ["auto_shared_fpic"]

    def set_version(self):
        header = load(self, os.path.join(self.recipe_folder, "../../include/glint/api.h"))
        self.version = ".".join(re.search(rf"#define GLINT_VERSION_{part} (\d+)", header).group(1)
                                for part in ("MAJOR", "MINOR", "PATCH"))

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "../..")
        for pattern in ("CMakeLists.txt", "LICENSE", "THIRD-PARTY.md", "cmake/*", "include/*", "presets/*", "shaders/*",
                        "src/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def requirements(self):
        # Headers alone: nothing of them reaches a host but Vulkan's.
        self.requires("vulkan-headers/1.3.268.0", transitive_headers=True)
        self.requires("fmt/10.2.1", visible=False)
        self.requires("glm/0.9.9.8", visible=False)
        self.requires("nlohmann_json/3.11.3", visible=False)
        self.requires("vulkan-memory-allocator/3.0.1", visible=False)

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.25 <4]")
        self.tool_requires("shaderc/2024.1")
        self.tool_requires("spirv-tools/1.3.268.0")
        self.test_requires("spirv-cross/1.3.268.0")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["GLINT_BUILD_LAB"] = False
        toolchain.cache_variables["GLINT_BUILD_TESTS"] = False
        folder = self.dependencies["vulkan-memory-allocator"].cpp_info.includedirs[0]
        toolchain.cache_variables["VMA_INCLUDE_DIR"] = folder
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="glint")

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "glint")
        self.cpp_info.set_property("cmake_target_name", "glint::glint")
        self.cpp_info.libs = ["glint"]
        if self.options.shared:
            self.cpp_info.defines = ["GLINT_SHARED"]
        elif self.settings.os == "Linux":
            self.cpp_info.system_libs = ["dl", "m", "pthread"]
