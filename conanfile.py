# `conan create .` makes the package; tests/consumer/conan uses it.
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain
from conan.tools.files import load


class Lvsm(ConanFile):
    name = "lvsm"
    description = "The maths of filterable shadow maps, in C++, GLSL, HLSL and WGSL"
    license = "MIT"
    package_type = "header-library"
    settings = "os", "compiler", "build_type", "arch"
    exports_sources = "CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "glsl/*", "hlsl/*", "wgsl/*", "wasm/*"

    def set_version(self):
        self.version = re.search(r"project\(lvsm VERSION (\S+)", load(self, f"{self.recipe_folder}/CMakeLists.txt"))[1]

    def requirements(self):
        self.requires("glm/[>=0.9.9]")

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update(LVSM_BUILD_TESTS=False, LVSM_BUILD_EXAMPLES=False,
                                         LVSM_BUILD_WASM=True)
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_id(self):
        self.info.clear()

    def package_info(self):
        # find_package finds what CMake has installed.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["share/cmake/lvsm"]
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
