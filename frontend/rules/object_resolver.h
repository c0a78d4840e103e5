// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/diagnostics.h"
#include "frontend/rules/object_slots.h"
#include "ir/builder.h"
#include "ir/program.h"

namespace clipc {

// The state of one ResolveObjects. Its methods are spread over resolve_objects*.cpp by subject.
class ObjectResolver {
 public:
  ObjectResolver(ir::Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics) {}
  void Run();

 private:
  // The copy of a function for certain objects.
  struct Instance {
    ir::FunctionId function;
    Slots result;
    std::vector<Slots> ins, outs;  // the objects before and after a call, by original parameter
  };

  // The state of the function whose body is rewritten.
  struct Frame {
    const ir::Function* function = nullptr;
    std::map<ir::VarId, Slots> slots;
    // The number of branches and loops around the variable's declaration.
    std::map<ir::VarId, int> depths;
    // Variables that hold indices known at run time: of a variable's part, by position in its path.
    std::map<std::tuple<ir::VarId, SlotPath, std::size_t>, ir::VarId> companions;
    std::vector<ir::StmtId> declarations;  // of companions
    std::vector<ir::StmtId> before;        // statements to run before the current one
    std::optional<Slots> result;           // the objects that the function returns
    int depth = 0;                         // the number of branches and loops around the statement
    bool may_emit = true;                  // false where nothing can be put before the expression
  };
  struct Value {
    ir::ExprId expr;  // none for an object, and for an expression that Before() took
    Slots slots;
  };

  // ---- types
  bool Holds(ir::TypeId type);
  bool IsObject(ir::TypeId type) const { return IsObjectType(program_.types, type); }
  bool IsNeeded();
  void NumberFields();
  void RemoveFields();

  // ---- variables outside functions
  void SplitUniform(ir::VarId id);
  void AddResources(ir::TypeId type, const std::string& name, Span span, SlotPath path,
                    Slots& slots);
  void PrepareGlobal(ir::VarId id);

  // ---- functions
  ir::FunctionId InPlace(ir::FunctionId id);
  void NoteEntry(ir::FunctionId old, ir::FunctionId added);
  void Body(ir::Function& function, Frame& frame);
  bool SignatureHolds(const ir::Function& function);
  const Instance* InstanceFor(ir::FunctionId id, std::vector<Slots>& arguments,
                              std::vector<ir::ExprId>& extra, Span span);
  Instance MakeInstance(ir::FunctionId id, const std::vector<Slots>& arguments,
                        const std::vector<ir::VarId>& extra);
  ir::Scalar TypeOf(const ObjectIndex& index) const;
  bool IsReturnOnly(ir::FunctionId id) const;

  // ---- statements
  ir::StmtId EmptyBlock(Span span) { return ir::Builder(program_, span).BlockOf({}); }
  ir::StmtId RewriteOne(ir::StmtId id);
  List<ir::StmtId> RewriteList(List<ir::StmtId> list);
  ir::StmtId Inner(ir::StmtId id);
  ir::ExprId Repeated(ir::ExprId id);
  ir::StmtId Rewrite(ir::StmtId id);
  bool RewriteDeclare(ir::Declare& node);
  void RewriteSwitch(ir::Switch& node);
  void RewriteReturn(ir::Return& node, Span span);

  // ---- expressions
  Value Visit(ir::ExprId id);
  Value VisitVar(ir::ExprId id, ir::VarId var);
  Value VisitField(ir::ExprId id);
  Value VisitIndex(ir::ExprId id);
  Value VisitAssign(ir::ExprId id);
  Value VisitComma(ir::ExprId id);
  Value VisitConstruct(ir::ExprId id);
  Value VisitChoice(ir::ExprId id, ir::ExprId when_true, ir::ExprId when_false);
  Value VisitCall(ir::ExprId id);
  Value VisitObjectCall(ir::ExprId id);
  ir::ExprId Make(const ObjectPath& object, Span span);

  // ---- binding
  std::optional<std::pair<ir::VarId, SlotPath>> PlaceOf(ir::ExprId expr) const;
  void Bind(ir::VarId var, const SlotPath& place, Slots slots, Span span);
  void Keep(ir::VarId var, const SlotPath& path, ObjectPath& object, Span span);
  void Before(ir::ExprId expr, Span span);
  std::string NameOf(ir::ExprId expr) const;
  void ReportChoice(const std::string& name, ir::TypeId type, Span span);

  ir::Program& program_;
  Diagnostics& diagnostics_;
  std::map<ir::TypeId, bool> holds_;
  // By StructId and field: the field's number when the objects are removed; ~0 for an object.
  std::vector<std::vector<std::uint32_t>> field_numbers_;
  std::map<ir::VarId, Slots> globals_;
  std::map<ir::FunctionId, ir::FunctionId> in_place_;
  std::map<std::vector<std::uint32_t>, Instance> instances_;
  Arena<ir::Function> functions_;  // callees before callers
  ir::FunctionId entry_;
  Frame* frame_ = nullptr;
  int call_depth_ = 0;
};

}  // namespace clipc
