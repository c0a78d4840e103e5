// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// An application's own header, which none of clipc's headers may find in place of theirs.
#error "runtime/status.h of the application is included by clipc"
