// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <utility>

/// The answer of every function that can fail. No function of clipc::runtime throws, and a Status
/// holds its message in place, so that an error allocates nothing.
namespace clipc::runtime {

enum class Error : std::int32_t {
  kNone = 0,
  kOutOfMemory,       ///< only readers of tables and the makers of C objects allocate
  kInvalidArgument,   ///< a null pointer, or an impossible count
  kDamagedTable,      ///< the bytes are not a clip table, or the table contradicts itself
  kWrongLowering,     ///< the table is for a shader that clips in another way
  kInvalidCall,       ///< a plane index beyond the device's maximum
  kMissingBuffer,     ///< the table names a constant buffer that is not bound
  kShortBuffer,       ///< the bound buffer ends before the plane does
  kNotFinite,         ///< a coefficient is NaN or infinite
  kDeviceFailed,      ///< the device refused a call
  kSingular,          ///< a matrix has no inverse, or a plane has no normal
  kIllConditioned,    ///< the result is not right to float precision
  kNotRepresentable,  ///< the result is too large or too small for float arithmetic in the clipper
  kWrongProjection,   ///< the projection does not have the shape that the function needs
  kEyeNotClipped,     ///< near-plane shearing needs the eye strictly on the clipped side
  kNoDepthLeft,       ///< near-plane shearing would leave too little depth precision
  kLooksTransposed,   ///< a matrix for column vectors where one for row vectors is meant
};

/// The HRESULTs of Direct3D 9 (d3d9.h) that HresultOf returns.
inline constexpr std::int32_t kD3dOk = 0;
inline constexpr std::int32_t kD3dErrInvalidCall = static_cast<std::int32_t>(0x8876086C);
inline constexpr std::int32_t kD3dErrDriverInternalError = static_cast<std::int32_t>(0x88760827);
inline constexpr std::int32_t kEOutOfMemory = static_cast<std::int32_t>(0x8007000E);

/// The HRESULT that an IDirect3DDevice9 returns in the same situation: D3DERR_INVALIDCALL for every
/// mistake of the caller.
std::int32_t HresultOf(Error error) noexcept;

/// The error in words: "short buffer" for kShortBuffer.
const char* NameOf(Error error) noexcept;

/// Success, or an error with its reason in words. Copyable, no resources.
class [[nodiscard]] Status {
 public:
  static constexpr int kMessageSize = 200;  ///< with the zero at the end

  Status() noexcept { message_[0] = '\0'; }
  /// An error with a message, of which `format` is as printf has it. A message that does not fit is
  /// cut.
#if defined(__GNUC__)
  __attribute__((format(printf, 2, 3)))
#endif
  static Status
  Failure(Error error, const char* format, ...) noexcept;

  bool ok() const noexcept { return error_ == Error::kNone; }
  Error error() const noexcept { return error_; }
  /// One sentence without a full stop; empty exactly when ok().
  const char* message() const noexcept { return message_; }

 private:
  Error error_ = Error::kNone;
  char message_[kMessageSize];
};

/// A value, or the reason why there is none. `value` is default-constructed if !ok().
template <typename T>
struct [[nodiscard]] Result {
  T value{};
  Status status;

  Result() = default;
  Result(T made) : value(std::move(made)) {}
  Result(T made, const Status& with) : value(std::move(made)), status(with) {}
  Result(const Status& why) noexcept : status(why) {}

  bool ok() const noexcept { return status.ok(); }
};

}  // namespace clipc::runtime
