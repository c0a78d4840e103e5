/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* C11's word, for libunwind. */
#pragma once
#ifndef __cplusplus
#define thread_local _Thread_local
#endif
