// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

// How every function of the runtime answers. Nothing in clipc::runtime throws, and a Status holds
// its message in place, so that an error costs no allocation either.
namespace clipc::runtime {

enum class Error : std::int32_t {
  kNone = 0,
  kOutOfMemory,       // only readers of tables and the makers of C objects allocate
  kInvalidArgument,   // a null pointer, a count that cannot be
  kDamagedTable,      // no clip table, or one that contradicts itself
  kWrongLowering,     // the table is for a shader that wants no SetClipPlane
  kInvalidCall,       // a plane index beyond the device's maximum
  kMissingBuffer,     // the table names a constant buffer that is not bound
  kShortBuffer,       // the bound buffer ends before the plane does
  kNotFinite,         // a coefficient is NaN or infinite
  kDeviceFailed,      // the device refused a call
  kSingular,          // a matrix has no inverse, or a plane no normal
  kIllConditioned,    // the result would not be right to float precision
  kNotRepresentable,  // the result is too large or too small for float arithmetic in the clipper
  kWrongProjection,   // the projection has not the shape that the function is for
  kEyeNotClipped,     // near-plane shearing needs the eye strictly on the clipped side
  kNoDepthLeft,       // near-plane shearing would leave too little depth precision
};

// HRESULTs of Direct3D 9 (d3d9.h) that HresultOf answers with.
inline constexpr std::int32_t kD3dOk = 0;
inline constexpr std::int32_t kD3dErrInvalidCall = static_cast<std::int32_t>(0x8876086C);
inline constexpr std::int32_t kD3dErrDriverInternalError = static_cast<std::int32_t>(0x88760827);
inline constexpr std::int32_t kEOutOfMemory = static_cast<std::int32_t>(0x8007000E);

// What an IDirect3DDevice9 would have answered: D3DERR_INVALIDCALL for whatever the caller did
// wrong.
std::int32_t HresultOf(Error error) noexcept;

// "kShortBuffer" => "short buffer".
const char* NameOf(Error error) noexcept;

// Success, or an error with its reason in words. Copyable, no resources.
class [[nodiscard]] Status {
 public:
  static constexpr int kMessageSize = 200;  // with the zero at the end

  Status() noexcept { message_[0] = '\0'; }
  // `format` as printf. A message that does not fit is cut.
#if defined(__GNUC__)
  __attribute__((format(printf, 2, 3)))
#endif
  static Status
  Failure(Error error, const char* format, ...) noexcept;

  bool ok() const noexcept { return error_ == Error::kNone; }
  Error error() const noexcept { return error_; }
  // One sentence without a full stop; empty exactly when ok().
  const char* message() const noexcept { return message_; }

 private:
  Error error_ = Error::kNone;
  char message_[kMessageSize];
};

// A value, or the reason why there is none. `value` is default-made when !ok().
template <typename T>
struct [[nodiscard]] Result {
  T value{};
  Status status;

  bool ok() const noexcept { return status.ok(); }
};

}  // namespace clipc::runtime
