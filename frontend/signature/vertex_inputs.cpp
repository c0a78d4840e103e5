// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/vertex_inputs.h"

#include <utility>

#include "base/spelling.h"

namespace clipc::signature {

void VertexInputs::Start(std::uint32_t vertex) {
  vertex_ = vertex;
  if (vertex == 0) first_ = inputs_.size();
  next_ = first_;
}

ExprId VertexInputs::Read(const Carrier& leaf) {
  if (vertex_ == 0) inputs_.push_back(Add(leaf));
  if (next_ >= inputs_.size()) return {};
  const Input& input = inputs_[next_++];
  if (!input.distances.empty()) return ReadDistances(input, leaf);
  if (!input.var) return {};
  ExprId value = AtVertex(input.var, vertex_);
  const std::uint32_t count = program_.types[leaf.type].Components();
  if (count < program_.types[program_.vars[input.var].type].Components())
    value = builder_.SwizzledRun(value, 0, count);
  return Fit(program_, builder_, value, leaf.type);
}

// The input of a leaf of the first vertex.
VertexInputs::Input VertexInputs::Add(const Carrier& leaf) {
  const SemanticName& semantic = leaf.cursor.semantic;
  for (std::size_t i = 0; shares_ && i < inputs_.size(); ++i) {
    const Input known = inputs_[i];
    if (known.semantic.index == semantic.index &&
        EqualIgnoringCase(known.semantic.name, semantic.name) &&
        (known.type == leaf.type || Fits(known, leaf)))
      return known;
  }
  Input input = Make(leaf);
  input.semantic = semantic;
  input.type = leaf.type;
  return input;
}

bool VertexInputs::Fits(const Input& known, const Carrier& leaf) {
  if (!known.var) return false;
  const TypeId wanted = StoredType(program_.types, leaf.type);
  const Type now = program_.types[program_.vars[known.var].type], type = program_.types[wanted];
  if (!type.IsScalarOrVector() || now.scalar != type.scalar) return false;
  if (type.Components() > now.Components()) Widen(known.var, wanted);
  return true;
}

void VertexInputs::Widen(VarId input, TypeId type) {
  const std::uint32_t count = program_.types[program_.vars[input].type].Components();
  program_.vars[input].type = type;
  const std::vector<VertexRead> reads = std::exchange(reads_, {});
  for (const VertexRead& read : reads) {
    if (read.var != input) {
      reads_.push_back(read);
      continue;
    }
    const auto call = std::get<IntrinsicCall>(program_.exprs[read.value].node);
    const auto arguments = program_.expr_lists[call.arguments];
    const auto vertex = std::get<Literal>(program_.exprs[arguments[1]].node).bits;
    const ExprId whole = AtVertex(input, static_cast<std::uint32_t>(vertex));
    const ExprId part = builder_.SwizzledRun(whole, 0, count);
    program_.exprs[read.value].node = program_.exprs[part].node;
  }
}

// Makes the input. The number of the primitive, which the shader has too,
// is data at a vertex.
VertexInputs::Input VertexInputs::Make(const Carrier& leaf) {
  SystemValue value = semantics_.LookUp(leaf, Direction::kInput);
  semantics_.CheckInterpolation(leaf);
  using Use = SystemValue::Use;
  if (value.use == Use::kRefused || !semantics_.MayAdd(leaf, Direction::kInput, value)) return {};
  const Type type = program_.types[leaf.type];
  const bool is_float = BaseOf(type.scalar) == Scalar::kFloat;
  switch (value.builtin) {
    case Builtin::kClipDistanceInput:
    case Builtin::kCullDistanceInput: {
      if (!is_float) return semantics_.Refuse(leaf, "a `float` scalar or vector"), Input{};
      Input input{{}, Placeholders(leaf)};
      auto& pieces = value.builtin == Builtin::kClipDistanceInput ? clip_ : cull_;
      pieces.Add(leaf.cursor.semantic.index, input.distances, leaf.span);
      return input;
    }
    case Builtin::kPositionInput:
    case Builtin::kPointSizeInput: {
      const bool is_size = value.builtin == Builtin::kPointSizeInput;
      if (!is_float || (is_size && type.Components() != 1))
        return semantics_.Refuse(leaf, is_size ? "a `float`" : "a `float4`"), Input{};
      return {vars_.AddInput(leaf, TypeOf(program_.types, value.builtin), value.builtin), {}};
    }
    default:
      return {vars_.AddInput(leaf, StoredType(program_.types, leaf.type), Builtin::kNone), {}};
  }
}

std::vector<ExprId> VertexInputs::Placeholders(const Carrier& leaf) {
  std::vector<ExprId> values;
  for (std::uint32_t i = 0; i < program_.types[leaf.type].Components(); ++i)
    values.push_back(builder_.Float(0));
  return values;
}

ExprId VertexInputs::ReadDistances(const Input& input, const Carrier& leaf) {
  std::vector<ExprId> values = input.distances;
  if (vertex_ > 0 || shares_) {
    values = Placeholders(leaf);
    for (std::size_t i = 0; i < values.size() && i < input.distances.size(); ++i)
      later_.push_back({values[i], input.distances[i], vertex_});
  }
  const TypeId vector = program_.types.Vector(Scalar::kFloat, static_cast<int>(values.size()));
  return Fit(program_, builder_,
             values.size() == 1 ? values.front() : builder_.ConstructOf(vector, values), leaf.type);
}

void VertexInputs::Finish() {
  const bool has_gaps = FitWithGaps(clip_, cull_);
  Place(Builtin::kClipDistanceInput, clip_, has_gaps);
  Place(Builtin::kCullDistanceInput, cull_, has_gaps);
}

void VertexInputs::Place(Builtin builtin, Distances& pieces, bool has_gaps) {
  if (pieces.empty()) return;
  const std::vector<ExprId> values = pieces.Packed(has_gaps);
  const VarId array = vars_.AddDistances(builtin, pieces, values);
  const auto put = [&](ExprId value, std::uint32_t vertex, std::uint32_t element) {
    const ExprId read = builder_.At(AtVertex(array, vertex), element);
    program_.exprs[value].node = program_.exprs[read].node;
  };
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    put(values[i], 0, i);
    for (const Later& later : later_) {
      if (later.first == values[i]) put(later.value, later.vertex, i);
    }
  }
}

ExprId VertexInputs::AtVertex(VarId input, std::uint32_t vertex) {
  const ExprId value =
      builder_.IntrinsicOf(CommonIntrinsic::kInputOfVertex, program_.vars[input].type,
                           {builder_.Ref(input), builder_.Uint(vertex)});
  reads_.push_back({input, value});
  return value;
}

}  // namespace clipc::signature
