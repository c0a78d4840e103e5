// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <vector>

#include "frontend/rules/object_call.h"

// GetDimensions of textures and buffers: assignments to the arguments, chained with commas.
namespace clipc {
namespace {

using ir::ExprId;
using ir::ObjectKind;
using ir::ObjectOp;
using ir::Scalar;
using ir::Type;
using ir::TypeId;

// Bytes of one element of a StructuredBuffer: its components, one after the other.
std::uint32_t StrideOf(const ir::TypeTable& types, TypeId id) {
  const Type& type = types[id];
  if (type.kind == ir::TypeKind::kArray) return type.count * StrideOf(types, type.element);
  if (type.kind == ir::TypeKind::kStruct) {
    std::uint32_t bytes = 0;
    for (const ir::Field& field : types[type.structure].fields)
      bytes += StrideOf(types, field.type);
    return bytes;
  }
  return type.Components() * ByteSize(type.scalar);
}

class SizeCheck {
 public:
  SizeCheck(const IntrinsicCheck& call, ExprId object) : call_(call), object_(object) {}

  ExprId Texture(const TextureTraits& traits) {
    const std::size_t plain = traits.size + (traits.is_multisampled ? 1 : 0);
    const bool has_level = !traits.is_multisampled && call_.arguments.size() == plain + 2;
    if (!has_level && !call_.HasCount(plain, plain)) return call_.Error();
    ir::Builder builder = call_.Make();
    ir::TypeTable& types = call_.program.types;
    const std::size_t first = has_level ? 1 : 0;
    for (std::size_t i = first; i < call_.arguments.size(); ++i) {
      if (!IsOut(i)) return call_.Error();
    }
    ExprId level = builder.Uint(0);
    if (has_level) {
      const auto given = call_.Converted(0, types.Make(Scalar::kUint));
      if (!given) return call_.Error();
      level = *given;
    }
    const ExprId size =
        Query(ObjectOp::kTextureSize, call_.VectorOf(Scalar::kInt, traits.size), {level});
    if (traits.size == 1) {
      Assign(first, size);
    } else {
      const auto temporary = call_.temporaries.Make(size);
      steps_.push_back(temporary.prologue);
      for (int i = 0; i < traits.size; ++i) {
        Assign(first + static_cast<std::size_t>(i),
               builder.Swizzled(builder.Ref(temporary.var), {i}));
      }
    }
    const TypeId count = types.Make(Scalar::kInt);
    if (has_level) Assign(first + traits.size, Query(ObjectOp::kTextureLevels, count, {}));
    if (traits.is_multisampled)
      Assign(first + traits.size, Query(ObjectOp::kTextureSamples, count, {}));
    return Chain();
  }

  ExprId Buffer(ObjectKind kind) {
    const std::size_t count = IsStructured(kind) ? 2 : 1;
    if (!call_.HasCount(count, count)) return call_.Error();
    for (std::size_t i = 0; i < count; ++i) {
      if (!IsOut(i)) return call_.Error();
    }
    Assign(0, Query(ObjectOp::kBufferSize, call_.program.types.Make(Scalar::kInt), {}));
    if (count == 2) {
      const TypeId element = ElementOf(call_.program.types, call_.TypeOf(object_));
      Assign(1, call_.Make().Uint(StrideOf(call_.program.types, element)));
    }
    return Chain();
  }

 private:
  bool IsOut(std::size_t i) {
    const Type& type = call_.ArgumentType(i);
    if (type.Components() != 1 || type.scalar == Scalar::kBool) {
      call_.BadArgument(i, "a uint or float variable");
      return false;
    }
    return call_.IsTarget(i);
  }

  ExprId Query(ObjectOp op, TypeId type, std::initializer_list<ExprId> rest) {
    std::vector<ExprId> arguments{used_ ? Clone(call_.program, object_) : object_};
    used_ = true;
    arguments.insert(arguments.end(), rest);
    return MakeObjectCall(call_.Make(), call_.program, type, op, arguments);
  }

  void Assign(std::size_t i, ExprId value) {
    const ExprId target = call_.arguments[i];
    steps_.push_back(call_.Make().AssignTo(target, call_.Convert(value, call_.TypeIdOf(target))));
  }

  ExprId Chain() { return After(call_, std::span(steps_).first(steps_.size() - 1), steps_.back()); }

  const IntrinsicCheck& call_;
  ExprId object_;
  bool used_ = false;
  std::vector<ExprId> steps_;
};

}  // namespace

ExprId CheckGetDimensions(const IntrinsicCheck& call, ExprId object) {
  const ObjectKind kind = call.TypeOf(object).object;
  SizeCheck check(call, object);
  return TraitsOf(kind).size != 0 ? check.Texture(TraitsOf(kind)) : check.Buffer(kind);
}

}  // namespace clipc
