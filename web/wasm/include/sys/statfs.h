/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Named by LLVM; fs.cpp asks nothing of it. */
#pragma once
