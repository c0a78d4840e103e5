# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# conan create packaging/conan
# LLVM is the system's or the one that the option llvm_prefix names: Conan's own packages of it have no Clang libraries.
from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Clipc(ConanFile):
    name = "clipc"
    version = "0.1.0"
    license = "Apache-2.0 WITH LLVM-exception"
    description = "HLSL to GLSL and SPIR-V, every stage and effects, clip planes kept: the compiler, as a program and a library, and the runtime"
    settings = "os", "compiler", "build_type", "arch"
    options = {"llvm_prefix": ["ANY"]}
    default_options = {"llvm_prefix": "/usr/lib/llvm-19"}

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "README.md", "CHANGELOG.md", "*/*"):
            copy(
                self,
                pattern,
                f"{self.recipe_folder}/../..",
                self.export_sources_folder,
                excludes=("build/*", ".git/*"),
            )

    def requirements(self):
        self.requires("fmt/[>=9]")
        self.requires("glslang/[>=1.3.236 <1.3.275]")
        self.requires("nlohmann_json/[>=3.11]")
        self.requires("spirv-headers/[>=1.3]")
        self.requires("spirv-tools/[>=1.3]")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["BUILD_TESTING"] = False
        toolchain.cache_variables["CLIPC_STATIC"] = False
        toolchain.cache_variables["CLIPC_WERROR"] = False
        toolchain.cache_variables["CLIPC_LLVM_PREFIX"] = str(self.options.llvm_prefix)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, f"{self.package_folder}/licenses")

    def package_info(self):
        # The package's own files for CMake, which also have clipc_add_shader().
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs.append("lib/cmake/clipc")
