// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/status.h"

#include <cstdarg>
#include <cstdio>
#include <iterator>

#include "clip-table/vocabulary.h"

namespace clipc::runtime {
namespace {

constexpr Named<Error> kErrorNames[] = {{Error::kNone, "none"},
                                        {Error::kOutOfMemory, "out of memory"},
                                        {Error::kInvalidArgument, "invalid argument"},
                                        {Error::kDamagedTable, "damaged table"},
                                        {Error::kWrongLowering, "wrong lowering"},
                                        {Error::kInvalidCall, "invalid call"},
                                        {Error::kMissingBuffer, "missing buffer"},
                                        {Error::kShortBuffer, "short buffer"},
                                        {Error::kNotFinite, "not finite"},
                                        {Error::kDeviceFailed, "device failed"},
                                        {Error::kSingular, "singular"},
                                        {Error::kIllConditioned, "ill conditioned"},
                                        {Error::kNotRepresentable, "not representable"},
                                        {Error::kWrongProjection, "wrong projection"},
                                        {Error::kEyeNotClipped, "eye not clipped"},
                                        {Error::kNoDepthLeft, "no depth left"},
                                        {Error::kLooksTransposed, "looks transposed"}};

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
  return index < std::size(kErrorNames) ? NameIn<kErrorNames>(error) : "unknown error";
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
