// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/build_main.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "base/spelling.h"
#include "frontend/rules/semantics.h"
#include "ir/builder.h"

namespace clipc {
namespace {

// A local variable or a part of one: a field or an element of another.
struct Part {
  enum class Kind : std::uint8_t { kVariable, kField, kElement };
  Kind kind = Kind::kVariable;
  std::uint32_t number = 0;  // of the field or element
  std::size_t whole = 0;     // number of the Part that it is in
  ir::VarId variable = {};
};
using PartNumber = std::size_t;
constexpr PartNumber kNoPart = ~PartNumber{0};

// A scalar or vector inside a parameter: where it is, and which semantic it has.
struct Leaf {
  PartNumber part = kNoPart;
  ir::TypeId type;
  std::string name;  // for messages: "input.position"
  SemanticName semantic;
  Span span;
  ir::Interpolation interpolation = ir::Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
};

// The semantic in force for a part of a parameter. Indices count on through arrays, matrices and
// overridden structs.
struct Cursor {
  SemanticName semantic;
  bool given = false;
  Span span;
  ir::Interpolation interpolation = ir::Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
};

Cursor CursorOf(const EntryParameter& parameter) {
  return {SplitSemantic(parameter.semantic), !parameter.semantic.empty(), parameter.semantic_span,
          parameter.interpolation,           parameter.centroid,          parameter.sample};
}

std::string UpperCase(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return upper;
}

class MainBuilder {
 public:
  MainBuilder(ir::Program& program, const EntrySignature& signature, Diagnostics& diagnostics)
      : program_(program),
        signature_(signature),
        diagnostics_(diagnostics),
        builder_(program, program.functions[program.entry].span) {}

  void Run() {
    const ir::Function& entry = program_.functions[program_.entry];
    for (std::size_t i = 0; i < entry.parameters.size(); ++i)
      PrepareParameter(entry.parameters[i], signature_.parameters[i]);
    CallEntry();
    for (Pending& output : pending_outputs_)
      AddOutputs(output.part, output.type, output.cursor, output.name, output.span);
    WriteDistances(ir::Builtin::kClipDistance, "clip_distance");
    WriteDistances(ir::Builtin::kCullDistance, "cull_distance");
    CheckDistanceCount();
    const ir::StmtId body = builder_.BlockOf(body_);
    program_.main = program_.functions.Add({"main", program_.types.Void(), {}, body, entry.span});
  }

 private:
  struct Pending {
    PartNumber part;
    ir::TypeId type;
    Cursor cursor;
    std::string name;
    Span span;
  };
  // One piece of SV_ClipDistance or SV_CullDistance, waiting for its place in the merged array.
  struct Distance {
    std::uint32_t index = 0;  // of the semantic
    PartNumber part = kNoPart;
    int components = 0;
    bool is_scalar = false;
    Span span;
  };

  // ---- parameters

  void PrepareParameter(ir::VarId id, const EntryParameter& parameter) {
    const ir::Var var = program_.vars[id];
    if (parameter.is_uniform) {
      arguments_.push_back(builder_.Ref(parameter.uniform_var));
      return;
    }
    const bool reads = var.storage != ir::Storage::kOut;
    const bool writes = var.storage != ir::Storage::kIn;
    const Cursor cursor = CursorOf(parameter);
    if (!writes && IsLeaf(var.type)) {
      std::vector<Leaf> leaves = LeavesOf(kNoPart, var.type, cursor, var.name, var.span);
      if (!leaves.empty()) arguments_.push_back(Input(leaves.front()));
      return;
    }
    const ir::VarId local = builder_.Local(var.name, var.type);
    const PartNumber part = Whole(local);
    body_.push_back(builder_.Stmt(ir::Declare{local, {}}));
    if (reads) {
      for (const Leaf& leaf : LeavesOf(part, var.type, cursor, var.name, var.span)) {
        const ir::ExprId value = Input(leaf);
        if (value) body_.push_back(builder_.Eval(builder_.AssignTo(ValueOf(leaf.part), value)));
      }
    }
    arguments_.push_back(builder_.Ref(local));
    if (writes) pending_outputs_.push_back({part, var.type, cursor, var.name, var.span});
  }

  void CallEntry() {
    const ir::Function& entry = program_.functions[program_.entry];
    if (arguments_.size() != entry.parameters.size()) return;  // an error was reported
    const ir::ExprId call = builder_.CallOf(program_.entry, arguments_);
    if (entry.return_type == program_.types.Void()) {
      body_.push_back(builder_.Eval(call));
      return;
    }
    const ir::VarId result = builder_.Local("result", entry.return_type);
    body_.push_back(builder_.Stmt(ir::Declare{result, call}));
    pending_outputs_.push_back(
        {Whole(result), entry.return_type, CursorOf(signature_.result), entry.name, entry.span});
  }

  // ---- taking types apart

  bool IsLeaf(ir::TypeId id) const {
    const ir::TypeKind kind = program_.types[id].kind;
    return kind == ir::TypeKind::kScalar || kind == ir::TypeKind::kVector;
  }

  std::vector<Leaf> LeavesOf(PartNumber part, ir::TypeId type, const Cursor& cursor,
                             const std::string& name, Span span) {
    std::vector<Leaf> leaves;
    leaves.reserve(16);
    Cursor moving = cursor;
    Collect(part, type, moving, name, span, leaves);
    return leaves;
  }

  void Collect(PartNumber part, ir::TypeId id, Cursor& cursor, const std::string& name, Span span,
               std::vector<Leaf>& leaves) {
    const ir::Type type = program_.types[id];
    switch (type.kind) {
      case ir::TypeKind::kError: return;
      case ir::TypeKind::kScalar:
      case ir::TypeKind::kVector: CollectLeaf(part, id, cursor, name, span, leaves); return;
      case ir::TypeKind::kMatrix: {
        const ir::TypeId row = program_.types.Vector(type.scalar, type.columns);
        for (std::uint32_t i = 0; i < type.rows; ++i)
          Collect(Inside(part, Part::Kind::kElement, i), row, cursor, name, span, leaves);
        return;
      }
      case ir::TypeKind::kArray:
        for (std::uint32_t i = 0; i < type.count && leaves.size() < kMaxLeaves; ++i) {
          Collect(Inside(part, Part::Kind::kElement, i), type.element, cursor, name, span, leaves);
        }
        return;
      case ir::TypeKind::kStruct: CollectStruct(part, type.structure, cursor, name, leaves); return;
      default:
        diagnostics_.Report(span, diag::SemanticOnObject, name, program_.types.Name(id));
        return;
    }
  }

  PartNumber Whole(ir::VarId variable) {
    parts_.push_back({Part::Kind::kVariable, 0, 0, variable});
    return parts_.size() - 1;
  }
  PartNumber Inside(PartNumber whole, Part::Kind kind, std::uint32_t number) {
    parts_.push_back({kind, number, whole});
    return parts_.size() - 1;
  }
  // A fresh expression each call.
  ir::ExprId ValueOf(PartNumber number) {
    const Part part = parts_[number];
    switch (part.kind) {
      case Part::Kind::kVariable: return builder_.Ref(part.variable);
      case Part::Kind::kField: return builder_.Field(ValueOf(part.whole), part.number);
      case Part::Kind::kElement: return builder_.At(ValueOf(part.whole), part.number);
    }
    return {};
  }

  void CollectStruct(PartNumber part, ir::StructId structure, Cursor& cursor,
                     const std::string& name, std::vector<Leaf>& leaves) {
    const std::vector<ir::Field> fields = program_.types[structure].fields;
    for (std::uint32_t i = 0; i < fields.size() && leaves.size() < kMaxLeaves; ++i) {
      const ir::Field& field = fields[i];
      const PartNumber inner = Inside(part, Part::Kind::kField, i);
      const std::string inner_name = name + "." + field.name;
      // A semantic on the struct as a whole overrides those of its fields (DXC: "semantic
      // override").
      if (cursor.given) {
        Collect(inner, field.type, cursor, inner_name, field.span, leaves);
        continue;
      }
      Cursor own{SplitSemantic(field.semantic),
                 !field.semantic.empty(),
                 field.semantic_span,
                 field.interpolation == ir::Interpolation::kDefault ? cursor.interpolation
                                                                    : field.interpolation,
                 field.centroid || cursor.centroid,
                 field.sample || cursor.sample};
      Collect(inner, field.type, own, inner_name, field.span, leaves);
    }
  }

  void CollectLeaf(PartNumber part, ir::TypeId id, Cursor& cursor, const std::string& name,
                   Span span, std::vector<Leaf>& leaves) {
    // fxc refuses (X3502); Slang names such an input or output after itself, and nothing wrong can
    // come of it.
    if (!cursor.given) {
      cursor.semantic = SplitSemantic(name.substr(name.rfind('.') + 1));
      cursor.given = true;
      diagnostics_.Report(span, diag::SemanticMissing, name,
                          fmt::format("{}{}", cursor.semantic.name, cursor.semantic.index));
    }
    leaves.push_back({part, id, name, cursor.semantic, cursor.span ? cursor.span : span,
                      cursor.interpolation, cursor.centroid, cursor.sample});
    ++cursor.semantic.index;
  }

  // ---- inputs

  // The input's value in the leaf's own type; none after an error.
  ir::ExprId Input(const Leaf& leaf) {
    const SystemValue value = LookUp(leaf, Direction::kInput);
    if (value.use == SystemValue::Use::kRefused || !MayAdd(leaf, Direction::kInput, value.use))
      return {};
    const ir::Scalar kind = ir::BaseOf(program_.types[leaf.type].scalar);
    if (value.use == SystemValue::Use::kBuiltin) {
      if (!ir::IsInteger(kind) || program_.types[leaf.type].Components() != 1) {
        Refuse(leaf, "a `uint`");
        return {};
      }
      const auto known = std::ranges::find(program_.inputs, value.builtin, &ir::IoVar::builtin);
      if (known != program_.inputs.end()) return Fit(builder_.Ref(known->var), leaf.type);
      const ir::TypeId stored = program_.types.Make(
          value.builtin == ir::Builtin::kBaseVertex ? ir::Scalar::kInt : ir::Scalar::kUint);
      return Fit(builder_.Ref(AddIo(program_.inputs, leaf, stored, value.builtin)), leaf.type);
    }
    return Fit(
        builder_.Ref(AddIo(program_.inputs, leaf, StoredType(leaf.type), ir::Builtin::kNone)),
        leaf.type);
  }

  // A bool travels as a uint; half and minimum-precision kinds as their base.
  ir::TypeId StoredType(ir::TypeId id) {
    const ir::Type type = program_.types[id];
    const ir::Scalar base = ir::BaseOf(type.scalar);
    return Shaped(type, base == ir::Scalar::kBool ? ir::Scalar::kUint : base);
  }
  ir::TypeId Shaped(const ir::Type& type, ir::Scalar kind) {
    return type.kind == ir::TypeKind::kVector ? program_.types.Vector(kind, type.columns)
                                              : program_.types.Make(kind);
  }

  // `value` as `type`, which differs from its own type in the component kind or in being a vector
  // of one.
  ir::ExprId Fit(ir::ExprId value, ir::TypeId type) {
    value = builder_.ConvertTo(program_.types[type].scalar, value);
    if (builder_.TypeOf(value) == type) return value;
    const bool to_vector = program_.types[type].kind == ir::TypeKind::kVector;
    return to_vector ? builder_.ConstructOf(type, {value}) : builder_.Swizzled(value, {0});
  }

  // ---- outputs

  void AddOutputs(PartNumber part, ir::TypeId type, const Cursor& cursor, const std::string& name,
                  Span span) {
    for (const Leaf& leaf : LeavesOf(part, type, cursor, name, span)) Output(leaf);
  }

  void Output(const Leaf& leaf) {
    const SystemValue value = LookUp(leaf, Direction::kOutput);
    if (value.use == SystemValue::Use::kRefused || !MayAdd(leaf, Direction::kOutput, value.use))
      return;
    switch (value.builtin) {
      case ir::Builtin::kNone: WriteOutput(leaf, StoredType(leaf.type), value.builtin); return;
      case ir::Builtin::kPosition: WriteFloats(leaf, 4, "a `float4`", value.builtin); return;
      case ir::Builtin::kPointSize: WriteFloats(leaf, 1, "a `float`", value.builtin); return;
      case ir::Builtin::kClipDistance:
      case ir::Builtin::kCullDistance: AddDistance(leaf, value.builtin); return;
      default: WriteIndex(leaf, value.builtin); return;
    }
  }

  void WriteFloats(const Leaf& leaf, std::uint32_t components, std::string_view wanted,
                   ir::Builtin builtin) {
    const ir::Type type = program_.types[leaf.type];
    if (type.Components() != components || ir::BaseOf(type.scalar) != ir::Scalar::kFloat)
      return Refuse(leaf, wanted);
    const ir::TypeId stored = components == 1 ? program_.types.Make(ir::Scalar::kFloat)
                                              : program_.types.Vector(ir::Scalar::kFloat, 4);
    WriteOutput(leaf, stored, builtin);
  }

  void WriteIndex(const Leaf& leaf, ir::Builtin builtin) {
    const ir::Type type = program_.types[leaf.type];
    if (type.Components() != 1 || !ir::IsInteger(type.scalar)) return Refuse(leaf, "a `uint`");
    WriteOutput(leaf, program_.types.Make(ir::Scalar::kUint), builtin);
  }

  void WriteOutput(const Leaf& leaf, ir::TypeId stored, ir::Builtin builtin) {
    const ir::VarId output = AddIo(program_.outputs, leaf, stored, builtin);
    body_.push_back(
        builder_.Eval(builder_.AssignTo(builder_.Ref(output), Fit(ValueOf(leaf.part), stored))));
  }

  ir::VarId AddIo(std::vector<ir::IoVar>& list, const Leaf& leaf, ir::TypeId type,
                  ir::Builtin builtin) {
    const bool is_input = &list == &program_.inputs;
    const std::string name = (is_input ? "in_" : "vs_") + UpperCase(leaf.semantic.name) +
                             std::to_string(leaf.semantic.index);
    ir::Var var;
    var.name = name;
    var.type = type;
    var.storage = is_input ? ir::Storage::kInput : ir::Storage::kOutput;
    var.span = leaf.span;
    const ir::VarId id = program_.vars.Add(std::move(var));
    std::uint32_t& next = is_input ? next_input_ : next_output_;
    const std::uint32_t location = builtin == ir::Builtin::kNone ? next++ : 0;
    list.push_back({id, leaf.semantic.name, leaf.semantic.index, builtin, location,
                    leaf.interpolation, leaf.centroid, leaf.sample});
    return id;
  }

  // ---- clip and cull distances by hand

  void AddDistance(const Leaf& leaf, ir::Builtin builtin) {
    const ir::Type type = program_.types[leaf.type];
    if (ir::BaseOf(type.scalar) != ir::Scalar::kFloat)
      return Refuse(leaf, "a `float` scalar or vector");
    auto& list = builtin == ir::Builtin::kClipDistance ? clip_ : cull_;
    list.push_back({leaf.semantic.index, leaf.part, static_cast<int>(type.Components()),
                    type.kind == ir::TypeKind::kScalar, leaf.span});
  }

  // The pieces in the order of their semantic index, each kept within a register of four as fxc
  // packs a signature: two float3 are distances 0, 1, 2 and 4, 5, 6. Distances in a gap are 0,
  // which clips nothing.
  void WriteDistances(ir::Builtin builtin, std::string name) {
    auto& list = builtin == ir::Builtin::kClipDistance ? clip_ : cull_;
    if (list.empty()) return;
    std::stable_sort(list.begin(), list.end(),
                     [](const Distance& a, const Distance& b) { return a.index < b.index; });
    std::vector<ir::ExprId> values;
    for (const Distance& piece : list) {
      while (values.size() % 4 + static_cast<std::size_t>(piece.components) > 4)
        values.push_back(builder_.Float(0));
      for (int i = 0; i < piece.components; ++i) {
        ir::ExprId value = ValueOf(piece.part);
        if (!piece.is_scalar) value = builder_.Swizzled(value, {i});
        values.push_back(builder_.ConvertTo(ir::Scalar::kFloat, value));
      }
    }
    distance_count_ += static_cast<std::uint32_t>(values.size());
    const ir::TypeId type = program_.types.Array(program_.types.Make(ir::Scalar::kFloat),
                                                 static_cast<std::uint32_t>(values.size()));
    Leaf leaf;
    leaf.type = type;
    leaf.name = name;
    leaf.semantic.name =
        builtin == ir::Builtin::kClipDistance ? "SV_ClipDistance" : "SV_CullDistance";
    leaf.span = list.front().span;
    const ir::VarId array = AddIo(program_.outputs, leaf, type, builtin);
    program_.vars[array].name = std::move(name);
    for (std::uint32_t i = 0; i < values.size(); ++i) {
      body_.push_back(
          builder_.Eval(builder_.AssignTo(builder_.At(builder_.Ref(array), i), values[i])));
    }
  }

  void CheckDistanceCount() {
    if (distance_count_ <= kMaxDistances) return;
    diagnostics_.Report(clip_.empty() ? cull_.front().span : clip_.front().span,
                        diag::TooManyClipDistances, distance_count_);
  }

  // ---- rules

  SystemValue LookUp(const Leaf& leaf, Direction direction) {
    SystemValue value =
        LookUpSemantic(leaf.semantic.name, leaf.semantic.index, direction, program_.profile);
    const bool is_input = direction == Direction::kInput;
    if (value.use == SystemValue::Use::kRefused) {
      diagnostics_.Report(leaf.span, diag::SemanticNotForStage, leaf.semantic.name,
                          is_input ? "input" : "output");
    } else if (!program_.profile.IsAtLeast(value.major, value.minor)) {
      diagnostics_.Report(leaf.span, diag::ProfileNeededForSemantic, leaf.semantic.name,
                          fmt::format("vs_{}_{}", value.major, value.minor), program_.profile.name);
    }
    return value;
  }

  bool MayAdd(const Leaf& leaf, Direction direction, SystemValue::Use use) {
    const std::string key = UpperCase(leaf.semantic.name) + std::to_string(leaf.semantic.index);
    auto& seen = direction == Direction::kInput ? seen_inputs_ : seen_outputs_;
    const auto [found, is_new] = seen.try_emplace(key, leaf.span);
    if (is_new) return true;
    // Plain data can do no harm: each use becomes a variable of its own, as in glslang and in DXC's
    // SPIR-V. An output that the pipeline reads cannot have two values.
    const std::string_view side = direction == Direction::kInput ? "inputs" : "outputs";
    const bool can_share = direction == Direction::kInput || use == SystemValue::Use::kPlain;
    (can_share ? diagnostics_.Report(leaf.span, diag::SemanticShared, key, side)
               : diagnostics_.Report(leaf.span, diag::SemanticTwice, key, side))
        .Note(found->second, diag::SemanticFirstUsed);
    return can_share;
  }

  void Refuse(const Leaf& leaf, std::string_view wanted) {
    diagnostics_.Report(leaf.span, diag::SemanticType, leaf.semantic.name,
                        program_.types.Name(leaf.type), wanted);
  }

  static constexpr std::size_t kMaxLeaves = 256;
  static constexpr std::uint32_t kMaxDistances = 8;

  ir::Program& program_;
  const EntrySignature& signature_;
  Diagnostics& diagnostics_;
  ir::Builder builder_;
  std::vector<ir::StmtId> body_;
  std::vector<ir::ExprId> arguments_;
  std::vector<Part> parts_;
  std::vector<Pending> pending_outputs_;
  std::vector<Distance> clip_, cull_;
  std::map<std::string, Span> seen_inputs_, seen_outputs_;
  std::uint32_t next_input_ = 0, next_output_ = 0;
  std::uint32_t distance_count_ = 0;
};

}  // namespace

SemanticName SplitSemantic(std::string_view written) {
  std::size_t end = written.size();
  while (end > 0 && written[end - 1] >= '0' && written[end - 1] <= '9' && written.size() - end < 9)
    --end;
  std::uint32_t index = 0;
  for (char c : written.substr(end)) index = index * 10 + static_cast<std::uint32_t>(c - '0');
  return {std::string(written.substr(0, end)), index};
}

void BuildMain(ir::Program& program, const EntrySignature& signature, Diagnostics& diagnostics) {
  MainBuilder(program, signature, diagnostics).Run();
}

}  // namespace clipc
