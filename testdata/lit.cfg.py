# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""How lit runs the tests in this folder. The build folder's lit.site.cfg.py loads it."""

import os
import sys

import lit.formats

config.name = "clipc"
config.test_format = lit.formats.ShTest(execute_external=False)
config.suffixes = [".hlsl", ".test"]
config.excludes = ["inputs"]

config.environment["TMPDIR"] = config.test_exec_root
for name in ("ASAN_OPTIONS", "UBSAN_OPTIONS", "LLVM_PROFILE_FILE"):
    if name in os.environ:
        config.environment[name] = os.environ[name]

# The tools are found by name, so that the RUN lines read like a shell session.
tool_folders = [
    os.path.dirname(tool) for tool in (config.file_check, config.not_, config.split_file)
]
config.environment["PATH"] = (
    os.pathsep.join(dict.fromkeys(tool_folders)) + os.pathsep + os.environ["PATH"]
)
# Mesa compiles a shader for each draw, in twice the time where it optimises what runs once.
config.environment["GALLIVM_PERF"] = "nopt"
config.environment["FILECHECK_OPTS"] = "--dump-input-filter=annotation-full --dump-input=fail"

if config.windows:
    config.available_features.add("windows")
    # What draws runs on this system with the compiler in it: it says nothing about clipc.exe.
    config.substitutions.append((r"(not |%python [^&|]*)?%draw .*", "true"))

if config.sanitize:
    # What sanitizers look for does not depend on the number of vertices, and a vertex takes ten
    # times as long.
    config.substitutions.append(("%draw compare", config.draw + " compare --random 8"))

config.substitutions += [
    ("%clipc", config.clipc),
    ("%draw", config.draw),
    ("%validate", config.glslang_validator),
    ("%python", sys.executable),
]
