// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/typing/object_call.h"

namespace clipc::typing {

// A method call in progress: the object, and the operands of the ObjectCall made so far. Each
// public function is the check of some methods, by the table in objects.cpp, and returns the call.
class MethodCheck : IntrinsicCheck {
 public:
  MethodCheck(const IntrinsicCheck& call, ExprId object, ObjectKind kind)
      : IntrinsicCheck(call),
        object_(object),
        kind_(kind),
        traits_(typing::TraitsOf(kind)),
        operands_{{OperandKind::kObject, object}} {}

  // Checks a method whose arguments are the operands of `op`.
  template <ObjectOp op>
  ExprId SampleBy() {
    return TakeSample(op) && TakeRest(op) ? Finish(op, ResultOf(op)) : Error();
  }

  // Checks a Sample. In a stage without neighbours to take a level of detail from, fxc and DXC
  // refuse (X4532), and OpenGL reads level 0.
  ExprId Sample();
  ExprId SampleBias();
  ExprId SampleCmp();
  template <ObjectOp op>
  ExprId LevelOfDetail() {
    return LevelOfDetailBy(op);
  }
  ExprId LevelOfDetailBy(ObjectOp op);
  ExprId SampleCmpLevel() { return HasModel(67) ? SampleBy<ObjectOp::kSampleCmpLevel>() : Error(); }
  ExprId SampleCmpGrad() { return HasModel(68) ? SampleBy<ObjectOp::kSampleCmpGrad>() : Error(); }
  ExprId SampleCmpBias();

  // Checks a gather: after its operands there may be an offset, or one for each of the four texels.
  // GatherCmpGreen, GatherCmpBlue and GatherCmpAlpha are GatherCmp, since only formats of one
  // component are compared (vkd3d's gather-cmp.shader_test, checked against native).
  template <ObjectOp op>
  ExprId Gather() {
    return GatherBy(op);
  }
  ExprId GatherBy(ObjectOp op);
  ExprId TextureLoad();
  ExprId BufferLoad();
  ExprId Counter() { return CheckCounter(*this, object_); }
  template <int words>
  ExprId ByteLoad() {
    return ByteLoadOf(words);
  }
  ExprId ByteLoadOf(int words);
  template <int words>
  ExprId ByteStore() {
    return ByteStoreOf(words);
  }
  ExprId ByteStoreOf(int words);
  ExprId Atomic() { return CheckAtomic(*this, object_); }
  ExprId GetDimensions() { return CheckGetDimensions(*this, object_); }
  ExprId SamplePosition();
  ExprId SubpassLoad();
  ExprId Append();
  ExprId RestartStrip();
  ExprId Unsupported() { return Fail(name_span, diag::MethodUnsupported, name, ObjectName()); }
  ExprId Unusable() { return Fail(name_span, diag::ObjectUnusable, name, ThisStage().name); }

  // Refuses a method that the object does not have, but perhaps one of the names that are near.
  ExprId Unknown(std::span<const std::string_view> near = {});

  // Reports and returns false unless the profile has the method, which came with this model.
  bool HasModel(int model) const;

 private:
  // Reports and returns false for a clamp in a stage that has no level of detail to clamp.
  bool HasLevelToClamp() const;
  void WarnOfLevel(std::string_view level) const;

  // A gather for each of the four offsets from argument `first` on, which have one status: that of
  // the first of them whose texels are not all in memory, since CheckAccessFullyMapped asks about
  // all that the method read (its page in Direct3D's documentation; DXC has that of the first).
  ExprId GatherWithStatus(std::size_t first, ObjectOp op, TypeId type);

  // Adds the offset, if there is one, to the texel's place: GLSL has no texelFetchOffset of
  // multisampled textures.
  void AddOffset();
  std::string ObjectName() const { return program.types.Name(TypeIdOf(object_)); }
  TypeId Element() { return ElementOf(program.types, TypeOf(object_)); }

  // The type of a read of a texture.
  TypeId ResultOf(ObjectOp op);
  ExprId Finish(ObjectOp op, TypeId type);

  // Reports and returns false unless there are `least` arguments and perhaps an offset. From 5.0 on
  // a clamp of the level of detail may come after it, of a sample that does not name the level, and
  // a status at the end (Direct3D 11.2's tiled resources); both are taken here.
  bool CheckCount(std::size_t least);
  bool TakeClamp(std::size_t i);
  bool TakeStatus();
  bool TakeSampler(ObjectKind kind);

  // Takes argument `i` as the operand of that kind.
  bool Take(OperandKind kind, std::size_t i, TypeId type);
  bool TakeFloats(OperandKind kind, std::size_t i, int count);

  // Takes the operands that say what a sample reads: sampler, coordinate and reference.
  bool TakeNamed(ObjectOp op);

  // Checks the number of arguments, and takes those operands.
  bool TakeSample(ObjectOp op);

  // Takes the other operands, which are numbers, gradients and an offset.
  bool TakeRest(ObjectOp op);

  // Reports and returns false for a texture of integers that a sampler cannot read: DXC's
  // uintSample.hlsl and sampleInteger.hlsl. A gather takes integers (its texture.gather-red.hlsl).
  bool HasFloats(bool compares);

  // Checks a load whose one argument is the place to read.
  ExprId LoadAt(ObjectOp op, TypeId place);

  // Takes argument `i`, an optional offset in texels.
  bool TakeOffset(std::size_t i, OffsetRange range = {});

  ExprId object_;
  ObjectKind kind_;
  TextureTraits traits_;
  std::vector<NamedOperand> operands_;
  ExprId clamp_;
  ExprId status_;  // as the user wrote it
};

}  // namespace clipc::typing
