// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/resolve_objects.h"

#include <algorithm>

#include "frontend/rules/object_resolver.h"

namespace clipc {

namespace {

constexpr std::size_t kMaxInstances = 4096;
constexpr int kMaxCallDepth = 200;

}  // namespace

void ObjectResolver::Run() {
  if (!IsNeeded()) return;
  NumberFields();
  for (ir::VarId id : program_.vars.ids()) {
    if (program_.vars[id].storage == ir::Storage::kUniform && Holds(program_.vars[id].type))
      SplitUniform(id);
  }
  for (ir::VarId global : program_.globals) PrepareGlobal(global);
  for (ir::ClipPlane& plane : program_.clip_planes) {
    if (plane.value) plane.value = Visit(plane.value).expr;
  }
  program_.main = InPlace(program_.main);
  program_.entry = entry_;
  program_.functions = std::move(functions_);
  RemoveFields();
  for (ir::CbufferId id : program_.cbuffers.ids()) {
    std::erase_if(program_.cbuffers[id].members, [&](const ir::CbufferMember& member) {
      return globals_.contains(member.var) && member.size == 0;
    });
  }
}

// ---- types

bool ObjectResolver::Holds(ir::TypeId type) {
  const ir::Type& shape = program_.types[type];
  if (shape.IsNumeric()) return false;
  const auto [known, is_new] = holds_.try_emplace(type, false);
  if (!is_new) return known->second;
  bool holds = false;
  if (shape.kind == ir::TypeKind::kObject) holds = true;
  if (shape.kind == ir::TypeKind::kArray) holds = Holds(shape.element);
  if (shape.kind == ir::TypeKind::kStruct) {
    for (const ir::Field& field : program_.types.StructOf(type).fields)
      holds = Holds(field.type) || holds;
  }
  return holds_[type] = holds;
}

// Shaders that use objects as global variables only, nearly all, are left alone.
bool ObjectResolver::IsNeeded() {
  for (ir::VarId id : program_.vars.ids()) {
    const ir::Var& var = program_.vars[id];
    if (var.storage != ir::Storage::kResource && Holds(var.type)) return true;
  }
  for (ir::FunctionId id : program_.functions.ids()) {
    if (Holds(program_.functions[id].return_type)) return true;
  }
  return false;
}

void ObjectResolver::NumberFields() {
  for (ir::StructId id : program_.types.structs().ids()) {
    std::vector<std::uint32_t>& numbers = field_numbers_.emplace_back();
    std::uint32_t next = 0;
    for (const ir::Field& field : program_.types[id].fields)
      numbers.push_back(IsObject(field.type) ? ~0u : next++);
  }
}

void ObjectResolver::RemoveFields() {
  for (ir::StructId id : program_.types.structs().ids()) {
    std::erase_if(program_.types[id].fields,
                  [&](const ir::Field& field) { return IsObject(field.type); });
  }
}

// ---- variables outside functions

void ObjectResolver::SplitUniform(ir::VarId id) {
  AddResources(program_.vars[id].type, program_.vars[id].name, program_.vars[id].span, {},
               globals_[id]);
}

void ObjectResolver::AddResources(ir::TypeId type, const std::string& name, Span span,
                                  SlotPath path, Slots& slots) {
  if (!Holds(type)) return;
  if (IsObject(type)) {
    ir::Var var;
    var.name = name;
    var.type = type;
    var.storage = ir::Storage::kResource;
    var.span = span;
    const ir::VarId resource = program_.vars.Add(std::move(var));
    const ir::TypeId element = program_.types.Innermost(type);
    ir::Register reg;
    reg.letter = ir::RegisterLetter(program_.types[element].object);
    program_.resources.push_back({resource, reg});
    slots[path] = {resource, {}};
    return;
  }
  const auto part = [&](std::uint32_t number, ir::TypeId inner, const std::string& suffix) {
    SlotPath longer = path;
    longer.push_back(number);
    AddResources(inner, name + "_" + suffix, span, std::move(longer), slots);
  };
  const ir::Type shape = program_.types[type];
  if (shape.kind == ir::TypeKind::kArray) {
    for (std::uint32_t i = 0; i < shape.count; ++i) part(i, shape.element, std::to_string(i));
    return;
  }
  const std::vector<ir::Field> fields = program_.types.StructOf(type).fields;
  for (std::uint32_t i = 0; i < fields.size(); ++i) part(i, fields[i].type, fields[i].name);
}

void ObjectResolver::PrepareGlobal(ir::VarId id) {
  if (!program_.vars[id].init) return;
  Value value = Visit(program_.vars[id].init);
  program_.vars[id].init = value.expr;
  globals_[id] = std::move(value.slots);
}

// ---- functions

// A function without objects in its signature stays one function.
ir::FunctionId ObjectResolver::InPlace(ir::FunctionId id) {
  if (const auto known = in_place_.find(id); known != in_place_.end()) return known->second;
  ir::Function function = program_.functions[id];
  Frame frame;
  Body(function, frame);
  const ir::FunctionId added = functions_.Add(std::move(function));
  in_place_[id] = added;
  NoteEntry(id, added);
  return added;
}

void ObjectResolver::NoteEntry(ir::FunctionId old, ir::FunctionId added) {
  if (old == program_.entry) entry_ = added;
}

void ObjectResolver::Body(ir::Function& function, Frame& frame) {
  if (call_depth_ >= kMaxCallDepth) {
    diagnostics_.Report(function.span, diag::CheckTooDeep, kMaxCallDepth);
    return;
  }
  ++call_depth_;
  frame.function = &function;
  Frame* const outer = std::exchange(frame_, &frame);
  const ir::StmtId body = Rewrite(function.body);
  std::vector<ir::StmtId> stmts = frame.declarations;
  const auto rest =
      std::as_const(program_).stmt_lists[std::get<ir::Block>(program_.stmts[body].node).body];
  stmts.insert(stmts.end(), rest.begin(), rest.end());
  function.body = ir::Builder(program_, program_.stmts[body].span).BlockOf(stmts);
  frame_ = outer;
  --call_depth_;
}

bool ObjectResolver::SignatureHolds(const ir::Function& function) {
  return Holds(function.return_type) || std::ranges::any_of(function.parameters, [&](ir::VarId id) {
           return Holds(program_.vars[id].type);
         });
}

// The copy of a function for the objects in its arguments. Indices known at run time are parameters
// after the others.
const ObjectResolver::Instance* ObjectResolver::InstanceFor(ir::FunctionId id,
                                                            std::vector<Slots>& arguments,
                                                            std::vector<ir::ExprId>& extra,
                                                            Span span) {
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
  std::vector<ir::VarId> extra_parameters;
  const auto known = instances_.find(key);
  for (Slots& slots : arguments) {
    for (auto& [path, object] : slots) {
      for (ObjectIndex& index : object.indices) {
        if (index.IsLiteral()) continue;
        const ir::TypeId type = program_.types.Make(TypeOf(index));
        extra.push_back(index.expr ? index.expr : ir::Builder(program_, span).Ref(index.var));
        if (known != instances_.end()) continue;
        ir::Var var;
        var.name = program_.vars[object.resource].name + "_index";
        var.type = type;
        var.storage = ir::Storage::kIn;
        var.span = span;
        const ir::VarId parameter = program_.vars.Add(std::move(var));
        extra_parameters.push_back(parameter);
        index = {0, parameter, {}};
      }
    }
  }
  if (known != instances_.end()) return &known->second;
  if (instances_.size() >= kMaxInstances) {
    diagnostics_.Report(span, diag::TooManyInstances, kMaxInstances);
    return nullptr;
  }
  Instance instance = MakeInstance(id, arguments, extra_parameters);
  instance.ins = arguments;
  return &instances_.emplace(std::move(key), std::move(instance)).first->second;
}

ObjectResolver::Instance ObjectResolver::MakeInstance(ir::FunctionId id,
                                                      const std::vector<Slots>& arguments,
                                                      const std::vector<ir::VarId>& extra) {
  ir::Function function = program_.functions[id];
  BodyCloner cloner(program_);
  Frame frame;
  std::vector<ir::VarId> all, kept;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const ir::VarId copy = cloner.CloneVar(function.parameters[i]);
    all.push_back(copy);
    if (Holds(program_.vars[copy].type)) {
      frame.slots[copy] = arguments[i];
      frame.depths[copy] = 0;
    }
    if (!IsObject(program_.vars[copy].type)) kept.push_back(copy);
  }
  kept.insert(kept.end(), extra.begin(), extra.end());
  function.parameters = kept;
  function.body = cloner.Clone(function.body);
  Body(function, frame);
  Instance instance;
  if (frame.result) instance.result = *frame.result;
  for (const ir::VarId parameter : all) {
    const bool is_out = program_.vars[parameter].storage != ir::Storage::kIn;
    instance.outs.push_back(is_out ? frame.slots[parameter] : Slots{});
  }
  if (IsObject(function.return_type)) function.return_type = program_.types.Void();
  instance.function = functions_.Add(std::move(function));
  NoteEntry(id, instance.function);
  return instance;
}

ir::Scalar ObjectResolver::TypeOf(const ObjectIndex& index) const {
  return program_
      .types[index.expr ? program_.exprs[index.expr].type : program_.vars[index.var].type]
      .scalar;
}

// Whether the body is one `return`, as in `Texture2D Choose() { return color; }`.
bool ObjectResolver::IsReturnOnly(ir::FunctionId id) const {
  const auto body =
      program_.stmt_lists[std::get<ir::Block>(program_.stmts[functions_[id].body].node).body];
  return body.size() == 1 && std::holds_alternative<ir::Return>(program_.stmts[body[0]].node);
}

void ResolveObjects(ir::Program& program, Diagnostics& diagnostics) {
  ObjectResolver(program, diagnostics).Run();
}

}  // namespace clipc
