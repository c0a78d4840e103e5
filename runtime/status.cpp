// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/status.h"

#include <cstdarg>
#include <cstdio>

namespace clipc::runtime {

std::int32_t HresultOf(Error error) noexcept {
  switch (error) {
    case Error::kNone: return kD3dOk;
    case Error::kOutOfMemory: return kEOutOfMemory;
    case Error::kDeviceFailed: return kD3dErrDriverInternalError;
    default: return kD3dErrInvalidCall;
  }
}

const char* NameOf(Error error) noexcept {
  switch (error) {
    case Error::kNone: return "none";
    case Error::kOutOfMemory: return "out of memory";
    case Error::kInvalidArgument: return "invalid argument";
    case Error::kDamagedTable: return "damaged table";
    case Error::kWrongLowering: return "wrong lowering";
    case Error::kInvalidCall: return "invalid call";
    case Error::kMissingBuffer: return "missing buffer";
    case Error::kShortBuffer: return "short buffer";
    case Error::kNotFinite: return "not finite";
    case Error::kDeviceFailed: return "device failed";
    case Error::kSingular: return "singular";
    case Error::kIllConditioned: return "ill conditioned";
    case Error::kNotRepresentable: return "not representable";
    case Error::kWrongProjection: return "wrong projection";
    case Error::kEyeNotClipped: return "eye not clipped";
    case Error::kNoDepthLeft: return "no depth left";
  }
  return "unknown error";
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
