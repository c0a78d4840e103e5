// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cmath>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/evaluate_machine.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::ir {

void Machine::EvalNode(ExprId expr, const Call& node) {
  const Function& function = program_.functions[node.function];
  const std::size_t base = stack_.size();
  std::vector<std::pair<VarId, TargetWords>> written;
  for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
    const ExprId argument = program_.expr_lists[node.arguments][i];
    const VarId parameter = function.parameters[i];
    const Storage storage = program_.vars[parameter].storage;
    if (storage == Storage::kIn) {
      Eval(argument);
      continue;
    }
    const TargetWords place = Locate(argument);
    written.emplace_back(parameter, place);
    if (storage == Storage::kInOut) {
      PushFrom(place, program_.exprs[argument].type);
    } else {
      PushUndefined(program_.exprs[argument].type);
    }
  }
  // All arguments are evaluated before the first parameter gets its value, because an argument may
  // call the same function.
  std::size_t from = base;
  for (VarId parameter : function.parameters) {
    const std::uint32_t words = WordsOf(program_.vars[parameter].type);
    Store({.address = address_[parameter.index]}, words, stack_.data() + from);
    from += words;
  }
  stack_.resize(base);
  const std::uint64_t outer = flow_;
  flow_ = FlowIn(outer, expr.index);
  CallFunction(node.function, base);
  flow_ = outer;
  for (const auto& [parameter, place] : written) {
    Store(place, WordsOf(program_.vars[parameter].type),
          memory_.data() + address_[parameter.index]);
  }
}

void Machine::EvalNode(ExprId expr, const IntrinsicCall& node) {
  if (node.arguments.size > 1 && WritesArgument(node.op, 1)) return EvalWriting(node);
  const IntrinsicCategory category = CategoryOf(node.op);
  // Invocations run one after the other.
  if (category == IntrinsicCategory::kMemory) {
    if (thread_ && WaitsForGroup(node.op) && !thread_->Wait(expr)) is_waiting_ = true;
    return;
  }
  if (category == IntrinsicCategory::kAtomic) return EvalAtomic(node);
  if (category == IntrinsicCategory::kVertices) return EvalVertexCall(node);
  if (category == IntrinsicCategory::kBits) return EvalBits(expr, node);
  const bool asks_quad_of_lanes = thread_ && category == IntrinsicCategory::kQuad;
  if (asks_quad_of_lanes || (thread_ && category == IntrinsicCategory::kWave))
    return EvalWave(expr, node);
  const bool asks_quad =
      category == IntrinsicCategory::kNeighbours || category == IntrinsicCategory::kQuad;
  if (asks_quad && neighbours_) {
    return category == IntrinsicCategory::kQuad ? EvalQuad(expr, node) : EvalDerivative(expr, node);
  }
  if (asks_quad) {
    if (error_.empty()) error_ = std::string(NameOf(node.op)) + " needs neighbouring pixels";
    is_constant_ = false;
    return PushZeros(WordsOf(expr));
  }
  if (category == IntrinsicCategory::kInterpolants || category == IntrinsicCategory::kWave) {
    const bool is_wave = category == IntrinsicCategory::kWave;
    if (error_.empty())
      error_ = std::string(NameOf(node.op)) +
               (is_wave ? " needs the lanes of the wave" : " needs the input's other values");
    is_constant_ = false;
    return PushZeros(WordsOf(expr));
  }
  const std::size_t base = stack_.size();
  std::array<ExprId, 3> arguments{};
  std::array<std::size_t, 3> starts{base, base, base};
  CLIPC_CHECK(node.arguments.size >= 1 && node.arguments.size <= arguments.size());
  for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
    arguments[i] = program_.expr_lists[node.arguments][i];
    starts[i] = stack_.size();
    Eval(arguments[i]);
  }
  const Scalar rep = RepOf(arguments[0]);
  std::array<Word, 16> result{};
  const std::uint32_t words = WordsOf(expr);
  if (category == IntrinsicCategory::kComponents) {
    for (std::uint32_t i = 0; i < words; ++i) {
      result[i] = ComponentFunction(node.op, rep, stack_[starts[0] + i], stack_[starts[1] + i],
                                    stack_[starts[2] + i]);
    }
  } else {
    std::array<EvalArgument, 3> views{};
    for (std::uint32_t i = 0; i < node.arguments.size; ++i)
      views[i] = {&stack_[starts[i]], &TypeOf(arguments[i])};
    VectorFunction(node.op, rep, std::span(views).first(node.arguments.size), result.data());
  }
  stack_.resize(base);
  stack_.insert(stack_.end(), result.begin(), result.begin() + words);
}

// Pushes an input at a vertex of the primitive, or at a control point of the patch.
void Machine::PushInputOf(std::uint32_t vertex, VarId var) {
  const auto input = static_cast<std::size_t>(std::ranges::find(program_.inputs, var, &IoVar::var) -
                                              program_.inputs.begin());
  const std::vector<Scalar> kinds = KindsOf(program_.types, program_.vars[var].type);
  const bool is_given = vertex < inputs_.vertices.size() && input < inputs_.vertices[vertex].size();
  for (std::size_t i = 0; i < kinds.size(); ++i)
    stack_.push_back(is_given ? FromBits(inputs_.vertices[vertex][input][i], kinds[i]) : 0);
}

// Pushes what a control point wrote to an output.
void Machine::PushOutputOf(std::uint32_t point, VarId var) {
  const TypeId type = program_.vars[var].type;
  if (point == inputs_.point) return PushFrom({.address = address_[var.index]}, type);
  if (point >= inputs_.points.size() || inputs_.points[point].values.empty())
    return PushUndefined(type);
  const auto output = static_cast<std::size_t>(
      std::ranges::find(program_.outputs, var, &IoVar::var) - program_.outputs.begin());
  const EvalOutputs& of_point = inputs_.points[point];
  const std::vector<Scalar> kinds = KindsOf(program_.types, type);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const bool is_double = RepOf(kinds[i]) == Scalar::kDouble;
    stack_.push_back(is_double ? BitsOf(of_point.numbers[output][i])
                               : FromBits(of_point.values[output][i], kinds[i]));
  }
}

// Reads an input at a vertex, emits a vertex or ends a strip. Vertices after the most that the
// shader may emit are dropped, as Direct3D does (Direct3D 11.3 functional specification, 13.8).
void Machine::EvalVertexCall(const IntrinsicCall& node) {
  const auto number = [&](std::uint32_t argument) {
    Eval(program_.expr_lists[node.arguments][argument]);
    const std::uint32_t value = UintOf(stack_.back());
    stack_.pop_back();
    return value;
  };
  if (node.op == Intrinsic::kEndPoints) return;
  if (node.op == Intrinsic::kIsFirstPoint) return stack_.push_back(inputs_.point == 0 ? 1 : 0);
  if (node.op == Intrinsic::kInputOfVertex || node.op == Intrinsic::kOutputOfPoint) {
    const auto* ref = As<VarRef>(program_, program_.expr_lists[node.arguments][0]);
    CLIPC_CHECK(ref);
    const std::uint32_t vertex = number(1);
    return node.op == Intrinsic::kInputOfVertex ? PushInputOf(vertex, ref->var)
                                                : PushOutputOf(vertex, ref->var);
  }
  const std::uint32_t stream = number(0);
  starts_strip_.resize(std::max<std::size_t>(starts_strip_.size(), stream + 1), true);
  if (node.op == Intrinsic::kEndPrimitive) {
    starts_strip_[stream] = true;
    return;
  }
  if (vertices_.size() < program_.emission.max_vertices)
    vertices_.push_back({stream, starts_strip_[stream], ReadOutputs()});
  starts_strip_[stream] = false;
}

// Bit patterns are those of floats and doubles, also when the evaluator computes in double.
void Machine::EvalBits(ExprId expr, const IntrinsicCall& node) {
  const std::size_t base = stack_.size();
  for (ExprId argument : program_.expr_lists[node.arguments]) Eval(argument);
  const ExprId first = program_.expr_lists[node.arguments][0];
  const Scalar from = TypeOf(first).scalar;
  const Scalar to = TypeOf(expr).scalar;
  const std::uint32_t words = WordsOf(expr);
  for (std::uint32_t i = 0; i < words; ++i) {
    Word bits = ToBits(stack_[base + i], from);
    if (node.op == Intrinsic::kAsDouble) bits = bits | stack_[base + words + i] << 32;
    if (node.op == Intrinsic::kF16ToF32) bits = BitsOf(HalfToFloat(UintOf(bits)));
    if (node.op == Intrinsic::kF32ToF16) bits = FloatToHalf(FloatOf(bits));
    stack_[base + i] = FromBits(bits, to);
  }
  stack_.resize(base + words);
}

namespace {

// What an atomic operation writes where `old` was.
Word NewValueOf(Intrinsic op, Scalar rep, Word old, Word value) {
  using enum Intrinsic;
  switch (op) {
    case kInterlockedAdd: return BinaryComponent(BinaryOp::kAdd, rep, old, value);
    case kInterlockedAnd: return BinaryComponent(BinaryOp::kBitAnd, rep, old, value);
    case kInterlockedOr: return BinaryComponent(BinaryOp::kBitOr, rep, old, value);
    case kInterlockedXor: return BinaryComponent(BinaryOp::kBitXor, rep, old, value);
    case kInterlockedMin: return ComponentFunction(kMin, rep, old, value, 0);
    case kInterlockedMax: return ComponentFunction(kMax, rep, old, value, 0);
    default: return value;
  }
}

}  // namespace

// Evaluates InterlockedAdd and its kin, which change a variable that the group shares.
void Machine::EvalAtomic(const IntrinsicCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const TypeId type = program_.exprs[arguments[0]].type;
  const TargetWords place = Locate(arguments[0]);
  const bool compares = node.arguments.size > 2;
  const Word comparand = compares ? EvalScalar(arguments[1]) : 0;
  const Word value = EvalScalar(arguments[node.arguments.size - 1]);
  is_atomic_ = true;
  PushFrom(place, type);
  const Word old = stack_.back();
  const Word written = NewValueOf(node.op, RepOf(program_.types[type].scalar), old, value);
  if (!compares || old == comparand) Store(place, 1, &written);
  is_atomic_ = false;
}

namespace {

// The results of a writing intrinsic for one component: its value and the values that it writes.
struct Parts {
  Word value, first, second;
};

template <typename T>
Parts FloatParts(Intrinsic op, T x) {
  if (op == Intrinsic::kModf) {
    const T whole = std::trunc(x);
    return {BitsOf(x - whole), BitsOf(whole), 0};
  }
  if (op == Intrinsic::kFrexp) {
    int exponent = 0;
    // The mantissa is positive, as in fxc and DXC, which mask the sign away.
    const T mantissa = std::fabs(std::frexp(x, &exponent));
    return {BitsOf(mantissa), BitsOf(std::isfinite(x) ? static_cast<T>(exponent) : T{0}), 0};
  }
  const double angle = x;
  return {0, BitsOf(static_cast<T>(std::sin(angle))), BitsOf(static_cast<T>(std::cos(angle)))};
}

Parts PartsOf(Intrinsic op, Scalar rep, Word x) {
  if (op == Intrinsic::kAsUint) return {0, x & 0xffffffffu, x >> 32};
  if (rep == Scalar::kFloat) return FloatParts(op, FloatOf(x));
  if (rep == Scalar::kDouble) return FloatParts(op, DoubleOf(x));
  return {0, x, 0};  // modf of integers
}

}  // namespace

// Evaluates modf, frexp, sincos and asuint of a double: the arguments after the first are written,
// left to right.
void Machine::EvalWriting(const IntrinsicCall& node) {
  const auto argument = [&](std::uint32_t i) { return program_.expr_lists[node.arguments][i]; };
  const bool has_value = node.op == Intrinsic::kModf || node.op == Intrinsic::kFrexp;
  const std::uint32_t words = WordsOf(argument(0));
  const std::size_t base = stack_.size();
  Eval(argument(0));
  std::array<TargetWords, 2> places{};
  for (std::uint32_t i = 1; i < node.arguments.size; ++i) places[i - 1] = Locate(argument(i));
  std::array<Word, 16> first{};
  std::array<Word, 16> second{};
  for (std::uint32_t i = 0; i < words; ++i) {
    const Parts parts = PartsOf(node.op, RepOf(argument(0)), stack_[base + i]);
    stack_[base + i] = parts.value;
    first[i] = parts.first;
    second[i] = parts.second;
  }
  Store(places[0], words, first.data());
  if (node.arguments.size > 2) Store(places[1], words, second.data());
  if (!has_value) stack_.resize(base);
}

// The number of the first component of the part of a `whole` that the steps lead to. A step outside
// leads nowhere.
std::uint32_t Machine::ComponentAt(TypeId whole, std::span<const Word> steps) {
  std::uint64_t first = 0;
  bool is_row = false;
  for (const Word step : steps) {
    const Type& type = program_.types[whole];
    if (type.kind == TypeKind::kStruct) {
      const auto& fields = program_.types.StructOf(whole).fields;
      for (Word i = 0; i < step; ++i) first += WordsOf(fields[i].type);
      whole = fields[step].type;
      continue;
    }
    const bool is_array = type.kind == TypeKind::kArray;
    const bool is_matrix = type.kind == TypeKind::kMatrix && !is_row;
    const std::uint64_t count = is_array ? type.count : is_matrix ? type.rows : type.columns;
    if (step >= count) return ~0u;
    first += step * (is_array ? WordsOf(type.element) : is_matrix ? type.columns : 1);
    if (is_array) whole = type.element;
    is_row = is_matrix;
  }
  return static_cast<std::uint32_t>(first);
}

void Machine::EvalNode(ExprId expr, const ObjectCall& node) {
  const ExprId texel = OperandOf(program_, node, OperandKind::kTexel);
  const std::uint32_t words = WordsOf(texel ? texel : expr);
  const std::size_t base = stack_.size();
  ObjectRequest request{.op = node.op, .object = {}, .sampler = {}};
  std::vector<Word> bits, steps;
  std::vector<double> coordinates;
  ForEachNamedOperand(program_, node, [&](OperandKind kind, ExprId operand) {
    if (kind == OperandKind::kTexel) return;
    Eval(operand);
    if (kind == OperandKind::kObject || kind == OperandKind::kSampler) {
      const bool is_sampler = kind == OperandKind::kSampler;
      const Word object = stack_.back();
      (is_sampler ? request.sampler : request.object) =
          VarId{static_cast<std::uint32_t>(object >> 32)};
      (is_sampler ? request.sampler_element : request.object_element) =
          static_cast<std::uint32_t>(object);
    } else if (kind == OperandKind::kStep) {
      steps.push_back(ToBits(stack_.back(), TypeOf(operand).scalar));
    } else {
      OperandRun& run = request.runs[static_cast<std::size_t>(kind)];
      if (run.count == 0) run.first = static_cast<std::uint32_t>(bits.size());
      for (std::size_t w = base; w < stack_.size(); ++w)
        bits.push_back(ToBits(stack_[w], TypeOf(operand).scalar));
      run.count = static_cast<std::uint32_t>(bits.size()) - run.first;
      if (kind == OperandKind::kValue) request.kind = TypeOf(operand).scalar;
    }
    if (kind == OperandKind::kCoordinate && neighbours_ && AsksNeighbours(node.op))
      coordinates = CoordinatesOf(expr, RepOf(operand), std::span(stack_).subspan(base));
    stack_.resize(base);
  });
  request.words = bits;
  request.coordinates = coordinates;
  if (!steps.empty()) {
    const TypeId object = program_.types.Innermost(program_.vars[request.object].type);
    request.part = ComponentAt(program_.types[object].element, steps);
  }
  std::vector<Word> result(words, 0);
  const bool is_lost = is_discarded_ && WritesObject(node.op);
  if (!thread_ || !thread_->Repeats(result)) {
    if (inputs_.read_object && !is_lost) inputs_.read_object(request, result);
    if (thread_) thread_->Keep(result);
  }
  if (words == 0) return;
  const TypeId type = program_.exprs[texel ? texel : expr].type;
  const std::vector<Scalar> kinds = KindsOf(program_.types, type);
  for (std::uint32_t i = 0; i < words; ++i) stack_.push_back(FromBits(result[i], kinds[i]));
  if (!texel) return;
  const std::vector<Word> value(stack_.begin() + static_cast<std::ptrdiff_t>(base), stack_.end());
  stack_.resize(base);
  Store(Locate(texel), words, value.data());
  stack_.push_back(1);  // all texels are in memory
}

}  // namespace clipc::ir
