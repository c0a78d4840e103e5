/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Named by LLVM; no process is waited for. */
#pragma once
