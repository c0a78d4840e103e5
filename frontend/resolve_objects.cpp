// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve_objects.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "base/overloaded.h"
#include "frontend/object_slots.h"
#include "ir/builder.h"
#include "ir/walk.h"

namespace clipc {
namespace {

constexpr std::size_t kMaxInstances = 4096;
constexpr int kMaxCallDepth = 200;

// What a function's copy for certain objects does with them.
struct Instance {
  ir::FunctionId function;
  Slots result;
  std::vector<Slots> ins, outs;  // by parameter of the original
};

// The function whose body is worked on.
struct Frame {
  const ir::Function* function = nullptr;
  std::map<ir::VarId, Slots> slots;
  std::map<ir::VarId, int> depths;  // how many branches and loops the variable's declaration is inside of
  std::map<std::tuple<ir::VarId, SlotPath, std::size_t>, ir::VarId> companions;  // hold indices known at run time
  std::vector<ir::StmtId> declarations;                                         // of companions
  std::vector<ir::StmtId> before;  // what has to run before the current statement
  std::optional<Slots> result;
  int depth = 0;
  bool may_emit = true;
};

class Resolver {
 public:
  Resolver(ir::Program& program, Diagnostics& diagnostics) : program_(program), diagnostics_(diagnostics) {}

  void Run() {
    if (!IsNeeded()) return;
    NumberFields();
    for (ir::VarId id : program_.vars.ids()) {
      if (program_.vars[id].storage == ir::Storage::kUniform && Holds(program_.vars[id].type)) SplitUniform(id);
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

 private:
  struct Value {
    ir::ExprId expr;  // none: an object, or what has been done already
    Slots slots;
  };

  // ---- types

  bool Holds(ir::TypeId type) {
    const auto [known, is_new] = holds_.try_emplace(type, false);
    if (!is_new) return known->second;
    bool holds = false;
    const ir::Type& shape = program_.types[type];
    if (shape.kind == ir::TypeKind::kObject) holds = true;
    if (shape.kind == ir::TypeKind::kArray) holds = Holds(shape.element);
    if (shape.kind == ir::TypeKind::kStruct) {
      for (const ir::Field& field : program_.types.StructOf(type).fields) holds = Holds(field.type) || holds;
    }
    return holds_[type] = holds;
  }
  bool IsObject(ir::TypeId type) const { return IsObjectType(program_.types, type); }

  // Shaders that use objects as global variables only, nearly all, are left alone.
  bool IsNeeded() {
    for (ir::VarId id : program_.vars.ids()) {
      const ir::Var& var = program_.vars[id];
      if (var.storage != ir::Storage::kResource && Holds(var.type)) return true;
    }
    for (ir::FunctionId id : program_.functions.ids()) {
      if (Holds(program_.functions[id].return_type)) return true;
    }
    return false;
  }

  void NumberFields() {
    for (ir::StructId id : program_.types.structs().ids()) {
      std::vector<std::uint32_t>& numbers = field_numbers_.emplace_back();
      std::uint32_t next = 0;
      for (const ir::Field& field : program_.types[id].fields) numbers.push_back(IsObject(field.type) ? ~0u : next++);
    }
  }

  void RemoveFields() {
    for (ir::StructId id : program_.types.structs().ids()) {
      std::erase_if(program_.types[id].fields, [&](const ir::Field& field) { return IsObject(field.type); });
    }
  }

  // ---- variables outside functions

  void SplitUniform(ir::VarId id) {
    AddResources(program_.vars[id].type, program_.vars[id].name, program_.vars[id].span, {}, globals_[id]);
  }

  void AddResources(ir::TypeId type, const std::string& name, Span span, SlotPath path, Slots& slots) {
    if (!Holds(type)) return;
    if (IsObject(type)) {
      ir::Var var;
      var.name = name;
      var.type = type;
      var.storage = ir::Storage::kResource;
      var.span = span;
      const ir::VarId resource = program_.vars.Add(std::move(var));
      while (program_.types[type].kind == ir::TypeKind::kArray) type = program_.types[type].element;
      const ir::ObjectKind kind = program_.types[type].object;
      const bool is_sampler = kind >= ir::ObjectKind::kSampler && kind <= ir::ObjectKind::kSamplerCube;
      ir::Register reg;
      reg.letter = is_sampler ? 's' : ir::IsWritable(kind) ? 'u' : 't';
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

  void PrepareGlobal(ir::VarId id) {
    if (!program_.vars[id].init) return;
    Value value = Visit(program_.vars[id].init);
    program_.vars[id].init = value.expr;
    globals_[id] = std::move(value.slots);
  }

  // ---- functions

  // A function without objects in its signature stays one function.
  ir::FunctionId InPlace(ir::FunctionId id) {
    if (const auto known = in_place_.find(id); known != in_place_.end()) return known->second;
    ir::Function function = program_.functions[id];
    Frame frame;
    Body(function, frame);
    const ir::FunctionId added = functions_.Add(std::move(function));
    in_place_[id] = added;
    NoteEntry(id, added);
    return added;
  }

  void NoteEntry(ir::FunctionId old, ir::FunctionId added) {
    if (old == program_.entry) entry_ = added;
  }

  void Body(ir::Function& function, Frame& frame) {
    if (call_depth_ >= kMaxCallDepth) {
      diagnostics_.Report(function.span, diag::CheckTooDeep, kMaxCallDepth);
      return;
    }
    ++call_depth_;
    frame.function = &function;
    Frame* const outer = std::exchange(frame_, &frame);
    const ir::StmtId body = Rewrite(function.body);
    std::vector<ir::StmtId> stmts = frame.declarations;
    const auto rest = std::as_const(program_).stmt_lists[std::get<ir::Block>(program_.stmts[body].node).body];
    stmts.insert(stmts.end(), rest.begin(), rest.end());
    function.body = ir::Builder(program_, program_.stmts[body].span).BlockOf(stmts);
    frame_ = outer;
    --call_depth_;
  }

  bool SignatureHolds(const ir::Function& function) {
    return Holds(function.return_type) ||
           std::ranges::any_of(function.parameters, [&](ir::VarId id) { return Holds(program_.vars[id].type); });
  }

  // The copy of a function for the objects in its arguments. Indices known at run time are parameters behind the others.
  const Instance* InstanceFor(ir::FunctionId id, std::vector<Slots>& arguments, std::vector<ir::ExprId>& extra, Span span) {
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

  Instance MakeInstance(ir::FunctionId id, const std::vector<Slots>& arguments, const std::vector<ir::VarId>& extra) {
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

  ir::Scalar TypeOf(const ObjectIndex& index) const {
    return program_.types[index.expr ? program_.exprs[index.expr].type : program_.vars[index.var].type].scalar;
  }

  // `Texture2D Choose() { return color; }` does nothing more.
  bool IsReturnOnly(ir::FunctionId id) const {
    const auto body = program_.stmt_lists[std::get<ir::Block>(program_.stmts[functions_[id].body].node).body];
    return body.size() == 1 && std::holds_alternative<ir::Return>(program_.stmts[body[0]].node);
  }

  // ---- statements

  ir::StmtId EmptyBlock(Span span) { return ir::Builder(program_, span).BlockOf({}); }

  // The statement with what has to run before it; none when nothing is left of it.
  ir::StmtId RewriteOne(ir::StmtId id) {
    std::vector<ir::StmtId> outer = std::exchange(frame_->before, {});
    const ir::StmtId result = Rewrite(id);
    std::vector<ir::StmtId> stmts = std::exchange(frame_->before, std::move(outer));
    if (stmts.empty()) return result;
    if (result) stmts.push_back(result);
    return ir::Builder(program_, program_.stmts[id].span).BlockOf(stmts);
  }

  List<ir::StmtId> RewriteList(List<ir::StmtId> list) {
    std::vector<ir::StmtId> stmts;
    for (std::uint32_t i = 0; i < list.size; ++i) {
      std::vector<ir::StmtId> outer = std::exchange(frame_->before, {});
      const ir::StmtId stmt = Rewrite(program_.stmt_lists[list][i]);
      stmts.insert(stmts.end(), frame_->before.begin(), frame_->before.end());
      frame_->before = std::move(outer);
      if (stmt) stmts.push_back(stmt);
    }
    return program_.stmt_lists.Add(std::span<const ir::StmtId>(stmts));
  }

  ir::StmtId Inner(ir::StmtId id) {
    if (!id) return id;
    ++frame_->depth;
    const ir::StmtId result = RewriteOne(id);
    --frame_->depth;
    return result ? result : EmptyBlock(program_.stmts[id].span);
  }

  // An expression that may run more than once, or not at all: nothing can be put before it.
  ir::ExprId Repeated(ir::ExprId id) {
    if (!id) return id;
    const bool outer = std::exchange(frame_->may_emit, false);
    ++frame_->depth;
    const ir::ExprId result = Visit(id).expr;
    --frame_->depth;
    frame_->may_emit = outer;
    return result;
  }

  ir::StmtId Rewrite(ir::StmtId id) {
    ir::Stmt stmt = program_.stmts[id];
    bool is_left = true;
    std::visit(Overloaded{
                   [&](ir::Block& node) { node.body = RewriteList(node.body); },
                   [&](ir::Declare& node) { is_left = RewriteDeclare(node); },
                   [&](ir::Evaluate& node) {
                     node.expr = Visit(node.expr).expr;
                     is_left = static_cast<bool>(node.expr);
                   },
                   [&](ir::If& node) {
                     node.condition = Visit(node.condition).expr;
                     node.then = Inner(node.then);
                     node.otherwise = Inner(node.otherwise);
                   },
                   [&](ir::For& node) {
                     const bool outer = std::exchange(frame_->may_emit, false);
                     node.init = RewriteList(node.init);
                     frame_->may_emit = outer;
                     node.condition = Repeated(node.condition);
                     node.step = Repeated(node.step);
                     node.body = Inner(node.body);
                   },
                   [&](ir::While& node) {
                     node.condition = Repeated(node.condition);
                     node.body = Inner(node.body);
                   },
                   [&](ir::DoWhile& node) {
                     node.body = Inner(node.body);
                     node.condition = Repeated(node.condition);
                   },
                   [&](ir::Switch& node) { RewriteSwitch(node); },
                   [&](ir::Return& node) { RewriteReturn(node, stmt.span); },
                   [](ir::Break&) {},
                   [](ir::Continue&) {},
               },
               stmt.node);
    program_.stmts[id] = std::move(stmt);
    return is_left ? id : ir::StmtId{};
  }

  bool RewriteDeclare(ir::Declare& node) {
    Value value;
    if (node.init) value = Visit(node.init);
    node.init = value.expr;
    const ir::TypeId type = program_.vars[node.var].type;
    if (!Holds(type)) return true;
    frame_->depths[node.var] = frame_->depth;
    frame_->slots[node.var].clear();
    Bind(node.var, {}, std::move(value.slots), program_.vars[node.var].span);
    return !IsObject(type);
  }

  void RewriteSwitch(ir::Switch& node) {
    node.value = Visit(node.value).expr;
    ++frame_->depth;
    for (std::uint32_t i = 0; i < node.cases.size; ++i) {
      const List<ir::StmtId> body = RewriteList(program_.switch_cases[node.cases][i].body);
      program_.switch_cases[node.cases][i].body = body;
    }
    --frame_->depth;
  }

  void RewriteReturn(ir::Return& node, Span span) {
    if (!node.value) return;
    const ir::TypeId type = program_.exprs[node.value].type;
    Value value = Visit(node.value);
    node.value = value.expr;
    if (!Holds(type)) return;
    for (const auto& [path, object] : value.slots) {
      if (!object.IsKnown()) return ReportChoice(program_.vars[object.resource].name, type, span);
    }
    if (frame_->result && *frame_->result != value.slots) {
      return ReportChoice(frame_->function->name + "()", type, span);
    }
    frame_->result = std::move(value.slots);
  }

  // ---- expressions

  Value Visit(ir::ExprId id) {
    const auto& node = program_.exprs[id].node;
    if (const auto* ref = std::get_if<ir::VarRef>(&node)) return VisitVar(id, ref->var);
    if (std::holds_alternative<ir::FieldRef>(node)) return VisitField(id);
    if (std::holds_alternative<ir::Index>(node)) return VisitIndex(id);
    if (std::holds_alternative<ir::Assign>(node)) return VisitAssign(id);
    if (std::holds_alternative<ir::Comma>(node)) return VisitComma(id);
    if (std::holds_alternative<ir::Construct>(node)) return VisitConstruct(id);
    if (std::holds_alternative<ir::Call>(node)) return VisitCall(id);
    if (std::holds_alternative<ir::ObjectCall>(node)) return VisitObjectCall(id);
    const ir::TypeId type = program_.exprs[id].type;
    if (Holds(type)) {
      if (const auto* choice = std::get_if<ir::Conditional>(&node)) return VisitChoice(id, choice->when_true, choice->when_false);
      if (IsObject(type)) return {};
    }
    ir::MapOperands(program_, id, [&](ir::ExprId operand) { return Visit(operand).expr; });
    return {id, {}};
  }

  Value VisitVar(ir::ExprId id, ir::VarId var) {
    const ir::TypeId type = program_.vars[var].type;
    if (!Holds(type)) return {id, {}};
    Value value{IsObject(type) ? ir::ExprId{} : id, {}};
    if (program_.vars[var].storage == ir::Storage::kResource) {
      value.slots[{}] = {var, {}};
    } else if (const auto global = globals_.find(var); global != globals_.end()) {
      value.slots = global->second;
    } else if (frame_ != nullptr) {
      value.slots = frame_->slots[var];
    }
    return value;
  }

  Value VisitField(ir::ExprId id) {
    const auto field = std::get<ir::FieldRef>(program_.exprs[id].node);
    const ir::StructId structure = program_.types[program_.exprs[field.base].type].structure;
    const Value base = Visit(field.base);
    const std::uint32_t number = field_numbers_[structure.index][field.field];
    Value value{number == ~0u ? ir::ExprId{} : id, Inside(base.slots, field.field)};
    program_.exprs[id].node = ir::FieldRef{base.expr, number};
    return value;
  }

  Value VisitIndex(ir::ExprId id) {
    const auto node = std::get<ir::Index>(program_.exprs[id].node);
    const ir::Type array = program_.types[program_.exprs[node.base].type];
    const Value base = Visit(node.base);
    const ir::ExprId index = Visit(node.index).expr;
    const bool is_object = IsObject(program_.exprs[id].type);
    program_.exprs[id].node = ir::Index{base.expr, index};
    Value value{is_object ? ir::ExprId{} : id, {}};
    if (base.slots.empty()) return value;
    if (const auto* literal = std::get_if<ir::Literal>(&program_.exprs[index].node)) {
      value.slots = Inside(base.slots, static_cast<std::uint32_t>(literal->bits));
      return value;
    }
    if (const auto whole = base.slots.find({}); whole != base.slots.end()) {
      ObjectPath element = whole->second;
      element.indices.push_back({0, {}, index});
      value.slots[{}] = std::move(element);
      return value;
    }
    value.slots = InsideAny(base.slots, array.count);
    return value;
  }

  Value VisitAssign(ir::ExprId id) {
    const auto node = std::get<ir::Assign>(program_.exprs[id].node);
    const ir::TypeId type = program_.exprs[id].type;
    const Span span = program_.exprs[id].span;
    const auto place = Holds(type) ? PlaceOf(node.target) : std::nullopt;
    const std::string name = place || !Holds(type) ? "" : NameOf(node.target);
    const ir::ExprId target = Visit(node.target).expr;
    Value value = Visit(node.value);
    program_.exprs[id].node = ir::Assign{node.op, target, value.expr};
    if (!Holds(type)) return {id, {}};
    if (!place) {
      ReportChoice(name, type, span);
      return {id, {}};
    }
    Bind(place->first, place->second, value.slots, span);
    Value result{IsObject(type) ? ir::ExprId{} : id, {}};
    for (const auto& [path, object] : frame_->slots[place->first]) {
      if (StartsWith(path, place->second)) {
        result.slots[SlotPath(path.begin() + static_cast<std::ptrdiff_t>(place->second.size()), path.end())] = object;
      }
    }
    return result;
  }

  Value VisitComma(ir::ExprId id) {
    const auto node = std::get<ir::Comma>(program_.exprs[id].node);
    const ir::ExprId first = Visit(node.first).expr;
    Value second = Visit(node.second);
    if (!first) return second;
    if (!second.expr) {
      Before(first, program_.exprs[id].span);
      return second;
    }
    program_.exprs[id].node = ir::Comma{first, second.expr};
    return {id, std::move(second.slots)};
  }

  Value VisitConstruct(ir::ExprId id) {
    const auto node = std::get<ir::Construct>(program_.exprs[id].node);
    Value value{IsObject(program_.exprs[id].type) ? ir::ExprId{} : id, {}};
    std::vector<ir::ExprId> arguments;
    for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
      const Value part = Visit(program_.expr_lists[node.arguments][i]);
      AddUnder(value.slots, i, part.slots);
      if (part.expr) arguments.push_back(part.expr);
    }
    program_.exprs[id].node = ir::Construct{program_.expr_lists.Add(std::span<const ir::ExprId>(arguments))};
    return value;
  }

  Value VisitChoice(ir::ExprId id, ir::ExprId when_true, ir::ExprId when_false) {
    const ir::TypeId type = program_.exprs[id].type;
    const ir::ExprId condition = Visit(std::get<ir::Conditional>(program_.exprs[id].node).condition).expr;
    const Value yes = Visit(when_true), no = Visit(when_false);
    if (yes.slots != no.slots) {
      ReportChoice("?:", type, program_.exprs[id].span);
      return {id, {}};
    }
    program_.exprs[id].node = ir::Conditional{condition, yes.expr, no.expr};
    return {IsObject(type) ? ir::ExprId{} : id, yes.slots};
  }

  Value VisitCall(ir::ExprId id) {
    const auto call = std::get<ir::Call>(program_.exprs[id].node);
    const Span span = program_.exprs[id].span;
    const ir::Function callee = program_.functions[call.function];
    std::vector<ir::ExprId> kept;
    std::vector<Slots> slots;
    std::vector<std::optional<std::pair<ir::VarId, SlotPath>>> places;
    for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
      const ir::ExprId argument = program_.expr_lists[call.arguments][i];
      const ir::Var& parameter = program_.vars[callee.parameters[i]];
      const bool is_bound = parameter.storage != ir::Storage::kIn && Holds(parameter.type);
      places.push_back(is_bound ? PlaceOf(argument) : std::nullopt);
      Value value = Visit(argument);
      if (value.expr) kept.push_back(value.expr);
      slots.push_back(std::move(value.slots));
    }
    if (!SignatureHolds(callee)) {
      const ir::FunctionId function = InPlace(call.function);
      program_.exprs[id].node = ir::Call{function, program_.expr_lists.Add(std::span<const ir::ExprId>(kept))};
      return {id, {}};
    }
    const Instance* instance = InstanceFor(call.function, slots, kept, span);
    if (!instance) return {id, {}};
    program_.exprs[id].node = ir::Call{instance->function, program_.expr_lists.Add(std::span<const ir::ExprId>(kept))};
    for (std::size_t i = 0; i < places.size(); ++i) {
      const ir::Var& parameter = program_.vars[callee.parameters[i]];
      if (parameter.storage == ir::Storage::kIn || !Holds(parameter.type)) continue;
      const bool is_known =
          std::ranges::all_of(instance->outs[i], [](const auto& slot) { return slot.second.IsKnown(); });
      // What an inout parameter brings back unchanged needs no word.
      if (parameter.storage == ir::Storage::kInOut && instance->outs[i] == instance->ins[i]) continue;
      if (!places[i] || !is_known) {
        ReportChoice(parameter.name, parameter.type, span);
      } else {
        Bind(places[i]->first, places[i]->second, instance->outs[i], span);
      }
    }
    if (!IsObject(callee.return_type)) return {id, instance->result};
    program_.exprs[id].type = program_.types.Void();
    if (!IsReturnOnly(instance->function)) Before(id, span);
    return {{}, instance->result};
  }

  Value VisitObjectCall(ir::ExprId id) {
    const auto call = std::get<ir::ObjectCall>(program_.exprs[id].node);
    for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
      const ir::ExprId argument = program_.expr_lists[call.arguments][i];
      const ir::TypeId type = program_.exprs[argument].type;
      const std::string name = NameOf(argument);
      const Span span = program_.exprs[argument].span;
      const Value value = Visit(argument);
      ir::ExprId made = value.expr;
      if (IsObject(type)) {
        const auto object = value.slots.find({});
        if (object == value.slots.end()) {
          ReportChoice(name, type, span);
          continue;
        }
        made = Make(object->second, span);
      }
      program_.expr_lists[call.arguments][i] = made;
    }
    return {id, {}};
  }

  ir::ExprId Make(const ObjectPath& object, Span span) {
    ir::Builder at(program_, span);
    ir::ExprId path = at.Ref(object.resource);
    for (const ObjectIndex& index : object.indices) {
      path = index.expr  ? at.At(path, index.expr)
             : index.var ? at.At(path, at.Ref(index.var))
                         : at.At(path, index.literal);
    }
    return path;
  }

  // ---- binding

  // The variable and the part of it that a path names, where its indices are known.
  std::optional<std::pair<ir::VarId, SlotPath>> PlaceOf(ir::ExprId expr) const {
    SlotPath path;
    while (true) {
      const auto& node = program_.exprs[expr].node;
      if (const auto* ref = std::get_if<ir::VarRef>(&node)) {
        if (!frame_->slots.contains(ref->var)) return std::nullopt;
        std::ranges::reverse(path);
        return std::pair{ref->var, path};
      }
      if (const auto* field = std::get_if<ir::FieldRef>(&node)) {
        path.push_back(field->field);
        expr = field->base;
        continue;
      }
      const auto* index = std::get_if<ir::Index>(&node);
      const auto* literal = index ? std::get_if<ir::Literal>(&program_.exprs[index->index].node) : nullptr;
      if (!literal) return std::nullopt;
      path.push_back(static_cast<std::uint32_t>(literal->bits));
      expr = index->base;
    }
  }

  // From here on the part of the variable holds these objects. Where that is not so on all paths, it is an error, unless
  // they are the ones it holds anyway.
  void Bind(ir::VarId var, const SlotPath& place, Slots slots, Span span) {
    Slots& held = frame_->slots[var];
    Slots added;
    for (auto& [path, object] : slots) {
      SlotPath whole = place;
      whole.insert(whole.end(), path.begin(), path.end());
      Keep(var, whole, object, span);
      added[whole] = std::move(object);
    }
    const bool is_certain = frame_->depth == frame_->depths[var];
    for (const auto& [path, object] : added) {
      const auto found = held.find(path);
      if (!is_certain && found != held.end() && found->second != object) {
        return ReportChoice(program_.vars[var].name, program_.vars[var].type, span);
      }
    }
    if (is_certain) {
      std::erase_if(held, [&](const auto& slot) { return StartsWith(slot.first, place); });
    }
    for (auto& [path, object] : added) held[path] = std::move(object);
  }

  // Indices known at run time are stored beside the object.
  void Keep(ir::VarId var, const SlotPath& path, ObjectPath& object, Span span) {
    for (std::size_t i = 0; i < object.indices.size(); ++i) {
      ObjectIndex& index = object.indices[i];
      if (index.IsLiteral()) continue;
      const ir::TypeId type = program_.types.Make(TypeOf(index));
      ir::Builder at(program_, span);
      ir::VarId& companion = frame_->companions[{var, path, i}];
      if (!companion) {
        companion = at.Local(program_.vars[var].name + "_index", type);
        frame_->declarations.push_back(at.Stmt(ir::Declare{companion, {}}));
      }
      const ir::ExprId value = index.expr ? index.expr : at.Ref(index.var);
      Before(at.AssignTo(at.Ref(companion), at.ConvertTo(program_.types[program_.vars[companion].type].scalar, value)), span);
      index = {0, companion, {}};
    }
  }

  // Runs the expression before the current statement.
  void Before(ir::ExprId expr, Span span) {
    if (ir::IsPure(program_, expr)) return;
    if (frame_ == nullptr || !frame_->may_emit) {
      diagnostics_.Report(span, diag::Unsupported, "choosing an object in the condition of a loop");
      return;
    }
    frame_->before.push_back(ir::Builder(program_, span).Eval(expr));
  }

  std::string NameOf(ir::ExprId expr) const {
    while (true) {
      const auto& node = program_.exprs[expr].node;
      if (const auto* ref = std::get_if<ir::VarRef>(&node)) return program_.vars[ref->var].name;
      if (const auto* field = std::get_if<ir::FieldRef>(&node)) {
        return NameOf(field->base) + "." + program_.types.StructOf(program_.exprs[field->base].type).fields[field->field].name;
      }
      const auto* index = std::get_if<ir::Index>(&node);
      if (!index) return "this";
      expr = index->base;
    }
  }

  void ReportChoice(const std::string& name, ir::TypeId type, Span span) {
    diagnostics_.Report(span, diag::ObjectNotGlobal, name, program_.types.Name(type));
  }

  ir::Program& program_;
  Diagnostics& diagnostics_;
  std::map<ir::TypeId, bool> holds_;
  std::vector<std::vector<std::uint32_t>> field_numbers_;  // by StructId and field: without the objects; ~0: an object
  std::map<ir::VarId, Slots> globals_;
  std::map<ir::FunctionId, ir::FunctionId> in_place_;
  std::map<std::vector<std::uint32_t>, Instance> instances_;
  Arena<ir::Function> functions_;  // callees before callers
  ir::FunctionId entry_;
  Frame* frame_ = nullptr;
  int call_depth_ = 0;
};

}  // namespace

void ResolveObjects(ir::Program& program, Diagnostics& diagnostics) { Resolver(program, diagnostics).Run(); }

}  // namespace clipc
