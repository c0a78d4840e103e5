# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Writes the C++ file OUT, which has the commit of the git repository REPOSITORY as clipc::kCommit; empty without a repository.
set(commit)
if(REPOSITORY)
  execute_process(COMMAND git -C ${REPOSITORY} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(WRITE ${OUT} "namespace clipc {\nextern const char kCommit[];\nconst char kCommit[] = \"${commit}\";\n}  // namespace clipc\n")
