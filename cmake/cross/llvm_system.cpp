// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Replacements of files of LLVM and Clang that are for things that clipc does not do: thirty
// processors (clang/lib/Basic/Targets.cpp; clipc describes its own in
// frontend/lex/lexer_clang.cpp), processes, signals and crashes.
#include <clang/Basic/TargetInfo.h>
#include <llvm/Support/CrashRecoveryContext.h>
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

// Functions that the linker for Windows requires, although nothing that is kept calls them.
#ifdef _WIN32
namespace llvm {

void initGraphWriterOptions() {}
void initRandomSeedOptions() {}
void initSignalsOptions() {}

CrashRecoveryContext* CrashRecoveryContext::GetCurrent() { return nullptr; }
void CrashRecoveryContext::HandleExit(int) {}

}  // namespace llvm

namespace llvm::sys {

void CallOneShotPipeSignalHandler() {}
std::error_code ChangeStdinMode(fs::OpenFlags) { return {}; }
void DontRemoveFileOnSignal(StringRef) {}
bool RemoveFileOnSignal(StringRef, std::string*) { return false; }

}  // namespace llvm::sys
#endif
