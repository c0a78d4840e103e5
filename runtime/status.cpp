// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/status.h"

#include <cstdarg>
#include <cstdio>
#include <iterator>

namespace clipc::runtime {
namespace {

// The names of the errors, in the order of the enumerators.
constexpr const char* kErrorNames[] = {
    "none",          "out of memory",    "invalid argument",  "damaged table",    "wrong lowering",
    "invalid call",  "missing buffer",   "short buffer",      "not finite",       "device failed",
    "singular",      "ill conditioned",  "not representable", "wrong projection", "eye not clipped",
    "no depth left", "looks transposed",
};

}  // namespace

std::int32_t HresultOf(Error error) noexcept {
  switch (error) {
    case Error::kNone: return kD3dOk;
    case Error::kOutOfMemory: return kEOutOfMemory;
    case Error::kDeviceFailed: return kD3dErrDriverInternalError;
    default: return kD3dErrInvalidCall;
  }
}

const char* NameOf(Error error) noexcept {
  const auto index = static_cast<std::uint32_t>(error);
  return index < std::size(kErrorNames) ? kErrorNames[index] : "unknown error";
}

Status Status::Failure(Error error, const char* format, ...) noexcept {
  Status status;
  status.error_ = error;
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(status.message_, kMessageSize, format, arguments);
  va_end(arguments);
  return status;
}

}  // namespace clipc::runtime
