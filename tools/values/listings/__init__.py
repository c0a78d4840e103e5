# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""fxc's listings of pixel shaders as GLSL."""
