// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// In place of files of LLVM and Clang that are for what clipc does not do: thirty processors
// (clang/lib/Basic/Targets.cpp; clipc describes its own in frontend/lex/lexer_clang.cpp),
// processes, signals and crashes.
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

// The linker for Windows wants what nothing that is kept calls, too.
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
