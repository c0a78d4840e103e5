// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/resolve_objects.h"

#include <algorithm>
#include <utility>

#include "frontend/resolve/object_resolver.h"
#include "frontend/resolve/registers.h"
#include "ir/access.h"
#include "ir/clone_body.h"
#include "ir/packing.h"

namespace clipc::resolve {

namespace {

constexpr std::size_t kMaxInstances = 4096;
constexpr int kMaxCallDepth = 200;

}  // namespace

void ObjectResolver::Run() {
  if (!IsNeeded()) return;
  NumberFields();
  for (VarId id : program_.vars.ids()) {
    if (program_.vars[id].storage == Storage::kUniform && Holds(program_.vars[id].type))
      SplitUniform(id);
  }
  for (VarId global : program_.globals) PrepareGlobal(global);
  for (ClipPlane& plane : program_.clip_planes) {
    if (plane.value) plane.value = Visit(plane.value).expr;
  }
  for (Stream& stream : program_.emission.streams) stream.emit = InPlace(stream.emit);
  program_.main = InPlace(program_.main);
  program_.entry = entry_;
  program_.functions = std::move(functions_);
  std::erase_if(program_.globals, [&](VarId id) { return IsRemoved(program_.vars[id].type); });
  for (CbufferId id : program_.cbuffers.ids()) {
    std::erase_if(program_.cbuffers[id].members, [&](const CbufferMember& member) {
      return IsRemoved(program_.vars[member.var].type);
    });
  }
  RemoveFields();
}

// ---- types

bool ObjectResolver::Holds(TypeId type) {
  const Type& shape = program_.types[type];
  if (shape.IsNumeric()) return false;
  const auto [known, is_new] = holds_.try_emplace(type, false);
  if (!is_new) return known->second;
  bool holds = false;
  if (shape.kind == TypeKind::kObject) holds = true;
  if (shape.kind == TypeKind::kArray) holds = Holds(shape.element);
  if (shape.kind == TypeKind::kStruct) {
    for (const Field& field : program_.types.StructOf(type).fields)
      holds = Holds(field.type) || holds;
  }
  return holds_[type] = holds;
}

bool ObjectResolver::IsRemoved(TypeId type) {
  if (!Holds(type)) return false;
  const TypeId inner = program_.types.Innermost(type);
  if (program_.types[inner].kind != TypeKind::kStruct) return true;
  const auto [known, is_new] = is_removed_.try_emplace(inner, false);
  if (!is_new) return known->second;
  return is_removed_[inner] =
             std::ranges::all_of(program_.types.StructOf(inner).fields,
                                 [&](const Field& field) { return IsRemoved(field.type); });
}

// Whether the shader must be changed. Nearly all shaders use objects as global variables only, and
// are left alone.
bool ObjectResolver::IsNeeded() {
  for (VarId id : program_.vars.ids()) {
    const Var& var = program_.vars[id];
    if (var.storage != Storage::kResource && Holds(var.type)) return true;
  }
  for (FunctionId id : program_.functions.ids()) {
    if (Holds(program_.functions[id].return_type)) return true;
  }
  return program_.exprs.AnyOf([&](const Expr& expr) {
    const auto* comma = std::get_if<Comma>(&expr.node);
    if (comma && IsObject(program_.exprs[comma->first].type)) return true;
    return (comma || std::holds_alternative<Conditional>(expr.node)) && IsObject(expr.type);
  });
}

void ObjectResolver::NumberFields() {
  for (StructId id : program_.types.structs().ids()) {
    std::vector<std::uint32_t>& numbers = field_numbers_.emplace_back();
    std::uint32_t next = 0;
    for (const Field& field : program_.types[id].fields)
      numbers.push_back(IsRemoved(field.type) ? ~0u : next++);
  }
}

void ObjectResolver::RemoveFields() {
  for (StructId id : program_.types.structs().ids()) {
    // An array begins a register, also one of objects, which takes no room (vkd3d's test of
    // offsets after objects, checked against native). The fields after it are not moved.
    bool is_after_array = false;
    const std::vector<std::uint32_t>& numbers = field_numbers_[id.index];
    for (std::uint32_t i = 0; i < program_.types[id].fields.size(); ++i) {
      Field& field = program_.types[id].fields[i];
      if (numbers[i] == ~0u) {
        is_after_array = is_after_array || program_.types[field.type].kind == TypeKind::kArray;
      } else if (std::exchange(is_after_array, false)) {
        field.offset = FieldOffset(program_.types, id, i);
      }
    }
    auto number = numbers.begin();
    std::erase_if(program_.types[id].fields, [&](const Field&) { return *number++ == ~0u; });
  }
}

// ---- variables outside functions

void ObjectResolver::SplitUniform(VarId id) {
  const Var whole = program_.vars[id];
  const auto written = registers_.find(id);
  std::vector<Register> registers;
  if (written != registers_.end()) registers = written->second;
  AddResources(whole, {}, registers, globals_[id]);
}

void ObjectResolver::AddResources(const Var& whole, const SlotPath& path,
                                  std::vector<Register>& registers, Slots& slots) {
  if (!Holds(whole.type)) return;
  if (IsObject(whole.type)) {
    const VarId resource = program_.vars.Add({.name = whole.name,
                                              .type = whole.type,
                                              .storage = Storage::kResource,
                                              .span = whole.span,
                                              .row_major = whole.row_major});
    Register reg;
    reg.letter = RegisterLetter(program_.types[program_.types.Innermost(whole.type)].object);
    if (const auto next = std::ranges::find(registers, reg.letter, &Register::letter);
        next != registers.end()) {
      reg = *next;
      next->number += RegisterCount(program_.types, whole.type);
    }
    program_.resources.push_back({resource, reg});
    slots[path] = {resource, {}};
    return;
  }
  const bool is_struct = program_.types[whole.type].kind == TypeKind::kStruct;
  for (std::uint32_t i = 0; i < program_.types.PartCount(whole.type); ++i) {
    SlotPath longer = path;
    longer.push_back(i);
    Var part = whole;
    part.type = program_.types.PartType(whole.type, i);
    part.name += '_';
    if (is_struct) {
      const Field& field = program_.types.StructOf(whole.type).fields[i];
      part.name += field.name;
      part.row_major = field.row_major;
    } else {
      part.name += std::to_string(i);
    }
    AddResources(part, longer, registers, slots);
  }
}

void ObjectResolver::PrepareGlobal(VarId id) {
  if (!program_.vars[id].init) return;
  Value value = Visit(program_.vars[id].init);
  program_.vars[id].init = value.expr;
  globals_[id] = std::move(value.slots);
}

// ---- functions

// The new function for a function without objects in its signature, which is one for all calls.
FunctionId ObjectResolver::InPlace(FunctionId id) {
  if (const auto known = in_place_.find(id); known != in_place_.end()) return known->second;
  Function function = program_.functions[id];
  Frame frame;
  Body(function, frame);
  const FunctionId added = functions_.Add(std::move(function));
  in_place_[id] = added;
  NoteEntry(id, added);
  return added;
}

void ObjectResolver::NoteEntry(FunctionId old, FunctionId added) {
  if (old == program_.entry) entry_ = added;
}

void ObjectResolver::Body(Function& function, Frame& frame) {
  if (call_depth_ >= kMaxCallDepth) {
    diagnostics_.Report(function.span, diag::CheckTooDeep, kMaxCallDepth);
    return;
  }
  ++call_depth_;
  frame.function = &function;
  Frame* const outer = std::exchange(frame_, &frame);
  const StmtId body = Rewrite(function.body);
  std::vector<StmtId> stmts = frame.declarations;
  const auto rest = std::as_const(program_).stmt_lists[As<Block>(program_, body)->body];
  stmts.insert(stmts.end(), rest.begin(), rest.end());
  // The function ends by itself where it returned an object. IsReturnOnly asks for the only one.
  const auto* last =
      frame.result && stmts.size() > 1 ? As<Return>(program_, stmts.back()) : nullptr;
  if (last && !last->value) stmts.pop_back();
  function.body = Builder(program_, program_.stmts[body].span).BlockOf(stmts);
  frame_ = outer;
  --call_depth_;
}

bool ObjectResolver::SignatureHolds(const Function& function) {
  return Holds(function.return_type) || std::ranges::any_of(function.parameters, [&](VarId id) {
           return Holds(program_.vars[id].type);
         });
}

// The copy of a function for the objects in its arguments. Indices known at run time are parameters
// after the others.
const ObjectResolver::Instance* ObjectResolver::InstanceFor(FunctionId id,
                                                            std::vector<Slots>& arguments,
                                                            std::vector<ExprId>& extra, Span span) {
  std::vector<std::uint32_t> key{id.index};
  for (const Slots& slots : arguments) {
    key.push_back(static_cast<std::uint32_t>(slots.size()));
    for (const auto& [path, object] : slots) {
      key.push_back(static_cast<std::uint32_t>(path.size()));
      key.insert(key.end(), path.begin(), path.end());
      key.push_back(object.resource.index);
      for (const ObjectIndex& index : object.indices) {
        key.push_back(index.IsLiteral() ? 0 : 1 + static_cast<std::uint32_t>(TypeOf(index)));
        key.push_back(index.literal);
      }
    }
  }
  std::vector<VarId> extra_parameters;
  const auto known = instances_.find(key);
  for (Slots& slots : arguments) {
    for (auto& [path, object] : slots) {
      for (ObjectIndex& index : object.indices) {
        if (index.IsLiteral()) continue;
        const TypeId type = program_.types.Make(TypeOf(index));
        extra.push_back(index.expr ? index.expr : Builder(program_, span).Ref(index.var));
        if (known != instances_.end()) continue;
        const VarId parameter =
            program_.vars.Add({.name = program_.vars[object.resource].name + "_index",
                               .type = type,
                               .storage = Storage::kIn,
                               .span = span});
        extra_parameters.push_back(parameter);
        index = {0, parameter, {}};
      }
    }
  }
  if (known != instances_.end()) return &known->second;
  if (instances_.size() >= kMaxInstances) {
    diagnostics_.Report(span, diag::TooManyCopies, kMaxInstances, "copies of functions");
    return nullptr;
  }
  Instance instance = MakeInstance(id, arguments, extra_parameters);
  instance.ins = arguments;
  return &instances_.emplace(std::move(key), std::move(instance)).first->second;
}

ObjectResolver::Instance ObjectResolver::MakeInstance(FunctionId id,
                                                      const std::vector<Slots>& arguments,
                                                      const std::vector<VarId>& extra) {
  Function function = program_.functions[id];
  BodyCloner cloner(program_);
  Frame frame;
  std::vector<VarId> all, kept;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const VarId copy = cloner.CloneVar(function.parameters[i]);
    all.push_back(copy);
    if (Holds(program_.vars[copy].type)) {
      frame.slots[copy] = arguments[i];
      frame.depths[copy] = 0;
    }
    if (!IsRemoved(program_.vars[copy].type)) kept.push_back(copy);
  }
  kept.insert(kept.end(), extra.begin(), extra.end());
  function.parameters = kept;
  function.body = cloner.Clone(function.body);
  Body(function, frame);
  Instance instance;
  if (frame.result) instance.result = *frame.result;
  for (const VarId parameter : all) {
    const bool is_out = program_.vars[parameter].storage != Storage::kIn;
    instance.outs.push_back(is_out ? frame.slots[parameter] : Slots{});
  }
  if (IsRemoved(function.return_type)) function.return_type = program_.types.Void();
  instance.returned = frame.returned;
  function.parameters.insert(function.parameters.end(), frame.returned.begin(),
                             frame.returned.end());
  instance.function = functions_.Add(std::move(function));
  NoteEntry(id, instance.function);
  return instance;
}

Scalar ObjectResolver::TypeOf(const ObjectIndex& index) const {
  return program_
      .types[index.expr ? program_.exprs[index.expr].type : program_.vars[index.var].type]
      .scalar;
}

// Whether the body is one `return`, as in `Texture2D Choose() { return color; }`.
bool ObjectResolver::IsReturnOnly(FunctionId id) const {
  const auto body = program_.stmt_lists[As<Block>(program_, functions_[id].body)->body];
  return body.size() == 1 && As<Return>(program_, body[0]);
}

void ResolveObjects(Program& program, const StructRegisters& registers, Diagnostics& diagnostics) {
  ObjectResolver(program, registers, diagnostics).Run();
}

}  // namespace clipc::resolve
