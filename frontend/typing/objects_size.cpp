// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <span>
#include <vector>

#include "frontend/typing/object_call.h"
#include "frontend/typing/objects.h"
#include "ir/access.h"
#include "ir/packing.h"

// GetDimensions of textures and buffers: assignments to the arguments, chained with commas.
namespace clipc::typing {
namespace {

class SizeCheck : IntrinsicCheck {
 public:
  SizeCheck(const IntrinsicCheck& call, ExprId object) : IntrinsicCheck(call), object_(object) {}

  ExprId Texture(const TextureTraits& traits) {
    const std::size_t plain = traits.size + (traits.is_multisampled ? 1 : 0);
    const bool has_level = !traits.is_multisampled && arguments.size() == plain + 2;
    if (!has_level && !HasCount(plain, plain)) return Error();
    Builder builder = Make();
    TypeTable& types = program.types;
    const std::size_t first = has_level ? 1 : 0;
    for (std::size_t i = first; i < arguments.size(); ++i) {
      if (!IsOut(i)) return Error();
    }
    ExprId level = builder.Uint(0);
    if (has_level) {
      const auto given = Converted(0, types.Make(Scalar::kUint));
      if (!given) return Error();
      level = *given;
    }
    const ExprId size = Query(ObjectOp::kTextureSize, VectorOf(Scalar::kInt, traits.size), level);
    if (traits.size == 1) {
      Assign(first, size);
    } else if (const ExprId whole = Together(first, traits.size)) {
      steps_.push_back(builder.AssignTo(whole, Convert(size, TypeIdOf(whole))));
    } else {
      const auto temporary = temporaries.Make(size);
      steps_.push_back(temporary.prologue);
      for (int i = 0; i < traits.size; ++i) {
        Assign(first + static_cast<std::size_t>(i),
               builder.Swizzled(builder.Ref(temporary.var), {i}));
      }
    }
    const TypeId count = types.Make(Scalar::kInt);
    if (has_level) Assign(first + traits.size, Query(ObjectOp::kTextureLevels, count));
    if (traits.is_multisampled)
      Assign(first + traits.size, Query(ObjectOp::kTextureSamples, count));
    return Chain();
  }

  ExprId Buffer(ObjectKind kind) {
    const std::size_t count = IsStructured(kind) ? 2 : 1;
    if (!HasCount(count, count)) return Error();
    for (std::size_t i = 0; i < count; ++i) {
      if (!IsOut(i)) return Error();
    }
    Assign(0, Query(ObjectOp::kBufferSize, program.types.Make(Scalar::kInt)));
    if (count == 2) {
      const TypeId element = ElementOf(program.types, TypeOf(object_));
      Assign(1, Make().Uint(Structured(program.types, element).size));
    }
    return Chain();
  }

 private:
  bool IsOut(std::size_t i) {
    const Type& type = ArgumentType(i);
    if (type.Components() != 1 || type.scalar == Scalar::kBool) {
      BadArgument(i, "a uint or float variable");
      return false;
    }
    return IsTarget(i);
  }

  // The swizzle of a variable that the arguments from `first` on are the components of, size.x and
  // size.y, the variable itself if those are all; none if they are other places.
  ExprId Together(std::size_t first, int count) {
    Swizzle all{.base = {}, .components = {}, .count = static_cast<std::uint8_t>(count)};
    VarId variable;
    for (int i = 0; i < count; ++i) {
      const auto* part = As<Swizzle>(program, arguments[first + static_cast<std::size_t>(i)]);
      const auto* ref = part ? As<VarRef>(program, part->base) : nullptr;
      if (!ref || part->count != 1 || (i > 0 && ref->var != variable)) return {};
      variable = ref->var;
      all.base = part->base;
      all.components[static_cast<std::size_t>(i)] = part->components[0];
    }
    const std::span<const std::uint8_t> components(all.components.data(), all.count);
    for (int i = 0; i < count; ++i) {
      if (std::ranges::count(components, components[static_cast<std::size_t>(i)]) > 1) return {};
    }
    const bool is_whole =
        std::ranges::is_sorted(components) && static_cast<int>(TypeOf(all.base).columns) == count;
    return is_whole ? all.base : Make().Swizzled(all.base, components);
  }

  ExprId Query(ObjectOp op, TypeId type, ExprId level = {}) {
    std::vector<NamedOperand> operands = {
        {OperandKind::kObject, used_ ? Clone(program, object_) : object_}};
    used_ = true;
    if (level) operands.push_back({OperandKind::kLevel, level});
    return Make().ObjectCallOf(op, type, operands);
  }

  void Assign(std::size_t i, ExprId value) {
    const ExprId target = arguments[i];
    steps_.push_back(Make().AssignTo(target, Convert(value, TypeIdOf(target))));
  }

  ExprId Chain() { return After(*this, std::span(steps_).first(steps_.size() - 1), steps_.back()); }

  ExprId object_;
  bool used_ = false;
  std::vector<ExprId> steps_;
};

}  // namespace

ExprId CheckLength(Program& program, ExprId object, Span span) {
  const Type type = TypeOf(program, object);
  const Profile& profile = program.profile;
  if (type.kind != TypeKind::kObject || !profile.IsAtLeast(4, 0) || profile.IsAtLeast(6, 0))
    return {};
  const int size = TraitsOf(type.object).size;
  const bool is_buffer = HasElement(type.object) && HasNamedElements(type.object) && size == 0;
  if (InfoOf(type.object).is_cube || (size == 0 && !is_buffer)) return {};
  Builder at(program, span);
  TypeTable& types = program.types;
  const TypeId whole = size > 1 ? types.Vector(Scalar::kInt, size) : types.Make(Scalar::kInt);
  std::vector<NamedOperand> operands = {{OperandKind::kObject, object}};
  if (!is_buffer) operands.push_back({OperandKind::kLevel, at.Uint(0)});
  const ObjectOp op = is_buffer ? ObjectOp::kBufferSize : ObjectOp::kTextureSize;
  return at.ConvertTo(Scalar::kUint, at.ObjectCallOf(op, whole, operands));
}

ExprId CheckGetDimensions(const IntrinsicCheck& call, ExprId object) {
  const ObjectKind kind = call.TypeOf(object).object;
  SizeCheck check(call, object);
  return TraitsOf(kind).size != 0 ? check.Texture(TraitsOf(kind)) : check.Buffer(kind);
}

}  // namespace clipc::typing
