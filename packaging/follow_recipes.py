#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Follows the port of vcpkg and the recipe of Conan step by step, with stand-ins for their tools.

usage: follow_recipes.py BUILD_FOLDER SCRATCH_FOLDER

A stand-in does what the tool's documentation says of the step. The build is configured with what the recipe gives, of which nothing
may be unused; what it would compile is installed from BUILD_FOLDER, a build that exists. Then examples/first is configured with the
package and its shader compiled. Without the repository that the sources are of, nothing is followed: status 77.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import types

ROOT = pathlib.Path(__file__).resolve().parents[1]

# The functions of vcpkg's ports that the port calls.
VCPKG = r"""
function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 given "" "SOURCE_PATH" "OPTIONS")
  list(TRANSFORM given_OPTIONS REPLACE "=${CURRENT_INSTALLED_DIR}$" "=${LLVM}")
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${given_SOURCE_PATH} -B ${SCRATCH}/configured -G Ninja ${given_OPTIONS}
    ERROR_VARIABLE said OUTPUT_QUIET RESULT_VARIABLE status)
  if(status OR said MATCHES "not used by the project")
    message(FATAL_ERROR "the port does not configure:\n${said}")
  endif()
endfunction()
function(vcpkg_cmake_install)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${CURRENT_PACKAGES_DIR} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_copy_tools)
  cmake_parse_arguments(PARSE_ARGV 0 given "AUTO_CLEAN" "" "TOOL_NAMES")
  foreach(name IN LISTS given_TOOL_NAMES)
    file(INSTALL ${CURRENT_PACKAGES_DIR}/bin/${name} DESTINATION ${CURRENT_PACKAGES_DIR}/tools/${PORT} USE_SOURCE_PERMISSIONS)
  endforeach()
  if(given_AUTO_CLEAN)
    file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/bin)
  endif()
endfunction()
# The files move to share/PORT, and paths in them follow: those of programs to tools/PORT.
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 given "" "CONFIG_PATH" "")
  if(NOT EXISTS ${CURRENT_PACKAGES_DIR}/${given_CONFIG_PATH}/${PORT}-config.cmake)
    message(FATAL_ERROR "there is no ${given_CONFIG_PATH}/${PORT}-config.cmake")
  endif()
  file(MAKE_DIRECTORY ${CURRENT_PACKAGES_DIR}/share)
  file(RENAME ${CURRENT_PACKAGES_DIR}/${given_CONFIG_PATH} ${CURRENT_PACKAGES_DIR}/share/${PORT})
  set(up "get_filename_component(_IMPORT_PREFIX \"\${_IMPORT_PREFIX}\" PATH)\n")
  file(GLOB files ${CURRENT_PACKAGES_DIR}/share/${PORT}/*.cmake)
  foreach(file IN LISTS files)
    file(READ ${file} text)
    string(REPLACE "${up}${up}${up}" "${up}${up}" text "${text}")
    string(REPLACE "\${_IMPORT_PREFIX}/bin/" "\${_IMPORT_PREFIX}/tools/${PORT}/" text "${text}")
    file(WRITE ${file} "${text}")
  endforeach()
endfunction()
function(vcpkg_fixup_pkgconfig)
  file(GLOB found ${CURRENT_PACKAGES_DIR}/lib/pkgconfig/*.pc)
  if(NOT found)
    message(FATAL_ERROR "there is no lib/pkgconfig/*.pc")
  endif()
endfunction()
function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 given "" "" "FILE_LIST")
  file(READ ${given_FILE_LIST} text)
  file(WRITE ${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright "${text}")
endfunction()
include(${PORTFILE})
"""


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{words}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def use(package, prefix_path, scratch):
    """Configures examples/first with the package and compiles its shader."""
    run(
        "cmake",
        "-S",
        ROOT / "examples/first",
        "-B",
        scratch,
        "-G",
        "Ninja",
        f"-DCMAKE_PREFIX_PATH={prefix_path}",
    )
    said = run("cmake", "--build", scratch)
    assert "Compiling shader water" in said, f"{package}: {said}"


def follow_vcpkg(build, scratch, llvm):
    package = scratch / "packages/clipc"
    script = scratch / "port.cmake"
    script.write_text(VCPKG)
    values = {
        "PORT": "clipc",
        "PORTFILE": ROOT / "packaging/vcpkg/clipc/portfile.cmake",
        "BUILD": build,
        "SCRATCH": scratch,
        "LLVM": llvm,
        "CURRENT_INSTALLED_DIR": scratch / "installed",
        "CURRENT_PACKAGES_DIR": package,
    }
    run("cmake", *(f"-D{name}={value}" for name, value in values.items()), "-P", script)
    for path in ("share/clipc/copyright", "tools/clipc/clipc", "include/clipc/clipc.h"):
        assert (package / path).is_file(), path
    assert not (package / "bin").exists()
    use("vcpkg", package / "share/clipc", scratch / "first")


class Settings:
    """What Conan gives a recipe: its folders, its options, and a place for what the recipe says."""

    def __init__(self, build, scratch, llvm):
        self.recipe_folder = str(ROOT / "packaging/conan")
        self.export_sources_folder = self.source_folder = str(scratch / "sources")
        self.package_folder, self.build_folder = str(scratch / "package"), str(scratch / "build")
        self.existing, self.needed, self.cache = build, [], {}
        self.options = types.SimpleNamespace(llvm_prefix=llvm)
        properties = {}
        self.cpp_info = types.SimpleNamespace(
            properties=properties, set_property=properties.__setitem__, builddirs=[]
        )

    def requires(self, reference):
        self.needed.append(reference.split("/")[0])


def stand_ins():
    """The modules that the recipe imports."""

    class Toolchain:
        def __init__(self, recipe):
            self.recipe, self.cache_variables = recipe, {}

        def generate(self):
            self.recipe.cache.update(self.cache_variables)

    class Cmake:
        def __init__(self, recipe):
            self.recipe = recipe

        def configure(self):
            words = [f"-D{name}={value}" for name, value in self.recipe.cache.items()]
            source, build = self.recipe.source_folder, self.recipe.build_folder
            said = run("cmake", "-S", source, "-B", build, "-G", "Ninja", *words)
            assert "not used by the project" not in said, said

        def build(self):
            pass  # BUILD_FOLDER is

        def install(self):
            run("cmake", "--install", self.recipe.existing, "--prefix", self.recipe.package_folder)

    def copy(recipe, pattern, src, dst, excludes=()):
        src, dst = pathlib.Path(src).resolve(), pathlib.Path(dst)
        listed = (
            run("git", "-C", ROOT, "-c", "safe.directory=*", "ls-files") if src == ROOT else pattern
        )
        for name in listed.splitlines():
            path = pathlib.PurePath(name)
            is_kept = path.match(pattern) or ("/" in pattern and "/" in name)
            if not is_kept or any(path.match(one) for one in excludes):
                continue
            (dst / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(src / name, dst / name, follow_symlinks=False)

    modules = {
        "conan": {"ConanFile": Settings},
        "conan.tools": {},
        "conan.tools.cmake": {
            "CMake": Cmake,
            "CMakeDeps": lambda recipe: types.SimpleNamespace(generate=lambda: None),
            "CMakeToolchain": Toolchain,
            "cmake_layout": lambda recipe: None,
        },
        "conan.tools.files": {"copy": copy},
    }
    for name, contents in modules.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(contents)


def follow_conan(build, scratch, llvm):
    stand_ins()
    scope = {}
    exec((ROOT / "packaging/conan/conanfile.py").read_text(), scope)
    recipe = scope["Clipc"](build, scratch, llvm)
    for step in (
        "export_sources",
        "requirements",
        "layout",
        "generate",
        "build",
        "package",
        "package_info",
    ):
        getattr(recipe, step)()
    port = (ROOT / "packaging/vcpkg/clipc/vcpkg.json").read_text().replace("-", "_")
    for name in recipe.needed:
        assert f'"{name.replace("-", "_")}"' in port, f"vcpkg does not need {name}, and Conan does"
    assert (pathlib.Path(recipe.package_folder) / "licenses/LICENSE").is_file()
    use(
        "Conan",
        pathlib.Path(recipe.package_folder) / recipe.cpp_info.builddirs[0],
        scratch / "first",
    )


def main():
    if not (ROOT / ".git").exists():
        print("no repository: nothing was followed")
        return 77
    build, scratch = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    cache = (build / "CMakeCache.txt").read_text()
    llvm = pathlib.Path(re.search(r"^FILECHECK:\w+=(.*)$", cache, re.M)[1]).resolve().parents[1]
    shutil.rmtree(scratch, ignore_errors=True)
    for name, follow in (("vcpkg", follow_vcpkg), ("Conan", follow_conan)):
        (scratch / name).mkdir(parents=True)
        follow(build, (scratch / name).resolve(), llvm)
        print(f"the recipe of {name} was followed")
    shutil.rmtree(scratch)
    return 0


if __name__ == "__main__":
    sys.exit(main())
