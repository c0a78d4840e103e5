// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// In place of files of LLVM and Clang that are for what clipc does not do: thirty processors
// (clang/lib/Basic/Targets.cpp; clipc describes its own in frontend/lex/lexer_clang.cpp), processes
// and signals.
#include <clang/Basic/TargetInfo.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/Program.h>
#include <llvm/Support/Signals.h>

namespace clang {

bool TargetInfo::validateOpenCLTarget(const LangOptions&, DiagnosticsEngine&) const { return true; }

}  // namespace clang

namespace llvm::sys {

void RunInterruptHandlers() {}
std::error_code ChangeStdoutMode(fs::OpenFlags) { return {}; }

}  // namespace llvm::sys
