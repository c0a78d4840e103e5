// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "frontend/resolve/object_slots.h"
#include "frontend/resolve/registers.h"
#include "ir/builder.h"

namespace clipc::resolve {

// The state of one ResolveObjects. Its methods are spread over resolve_objects*.cpp by subject.
class ObjectResolver {
 public:
  ObjectResolver(Program& program, const StructRegisters& registers, Diagnostics& diagnostics)
      : program_(program), registers_(registers), diagnostics_(diagnostics) {}
  void Run();

 private:
  // The copy of a function for certain objects.
  struct Instance {
    FunctionId function;
    Slots result;
    std::vector<VarId> returned;   // Frame::returned
    std::vector<Slots> ins, outs;  // the objects before and after a call, by original parameter
  };

  // The state of the function whose body is rewritten.
  struct Frame {
    const Function* function = nullptr;
    std::map<VarId, Slots> slots;
    // The number of branches and loops around the variable's declaration.
    std::map<VarId, int> depths;
    // Variables that hold indices known at run time, by variable, part of it, and position in the
    // path.
    std::map<std::tuple<VarId, SlotPath, std::size_t>, VarId> companions;
    std::vector<StmtId> declarations;  // the declarations of the companions
    std::vector<StmtId> before;        // statements to run before the current one
    std::optional<Slots> result;       // the objects that the function returns
    // Parameters that give the caller the indices known at run time in `result`, in order and by
    // part and position in the path.
    std::vector<VarId> returned;
    std::map<std::pair<SlotPath, std::size_t>, VarId> returned_of;
    int depth = 0;         // the number of branches and loops around the statement
    bool may_emit = true;  // false if nothing can be put before the expression
  };
  struct Value {
    ExprId expr;  // none of a type that IsRemoved, and for an expression that Before() took
    Slots slots;
  };

  // ---- types
  bool Holds(TypeId type);
  bool IsObject(TypeId type) const { return IsObjectType(program_.types, type); }
  // Whether nothing is left of a value without its objects: it is one, or has nothing else. Asked
  // before RemoveFields.
  bool IsRemoved(TypeId type);
  bool IsNeeded();
  void NumberFields();
  void RemoveFields();

  // ---- variables outside functions
  void SplitUniform(VarId id);
  // Makes a resource of each object in `whole`, the part of a uniform at `path`, and moves
  // `registers` past those that it takes.
  void AddResources(const Var& whole, const SlotPath& path, std::vector<Register>& registers,
                    Slots& slots);
  void PrepareGlobal(VarId id);

  // ---- functions
  FunctionId InPlace(FunctionId id);
  void NoteEntry(FunctionId old, FunctionId added);
  void Body(Function& function, Frame& frame);
  bool SignatureHolds(const Function& function);
  const Instance* InstanceFor(FunctionId id, std::vector<Slots>& arguments,
                              std::vector<ExprId>& extra, Span span);
  Instance MakeInstance(FunctionId id, const std::vector<Slots>& arguments,
                        const std::vector<VarId>& extra);
  Scalar TypeOf(const ObjectIndex& index) const;
  bool IsReturnOnly(FunctionId id) const;

  // ---- statements
  StmtId RewriteOne(StmtId id);
  List<StmtId> RewriteList(List<StmtId> list);
  StmtId Inner(StmtId id);
  ExprId Repeated(ExprId id);
  StmtId Rewrite(StmtId id);
  std::optional<StmtId> ChosenPart(const Stmt& stmt) const;
  void RewriteParts(Stmt& stmt);
  bool RewriteDeclare(Declare& node);
  void RewriteReturn(Return& node, Span span);
  void ReturnIndices(const SlotPath& path, ObjectPath& object, Span span);

  // ---- expressions
  Value Visit(ExprId id);
  Value VisitNode(ExprId id, const VarRef& ref);
  Value VisitNode(ExprId id, const FieldRef& field);
  Value VisitNode(ExprId id, const Index& node);
  Value VisitNode(ExprId id, const Assign& node);
  Value VisitNode(ExprId id, const Comma& node);
  Value VisitNode(ExprId id, const Construct& node);
  Value VisitNode(ExprId id, const Conditional& node);
  Value VisitNode(ExprId id, const Call& call);
  Value VisitNode(ExprId id, const ObjectCall& call);
  Value VisitNode(ExprId id, const auto&) { return VisitOther(id); }
  Value VisitOther(ExprId id);
  Value ResultOf(ExprId call, const Instance& instance, std::vector<ExprId>& arguments);
  ExprId Make(const ObjectPath& object, Span span);

  // ---- binding
  std::optional<std::pair<VarId, SlotPath>> PlaceOf(ExprId expr) const;
  void Bind(VarId var, const SlotPath& place, Slots slots, Span span);
  void Keep(VarId var, const SlotPath& path, ObjectPath& object, Span span);
  void Store(VarId var, ObjectIndex& index, Span span);
  void Before(ExprId expr, Span span);
  std::string NameOf(ExprId expr) const;
  void ReportChoice(const std::string& name, TypeId type, Span span);

  Program& program_;
  const StructRegisters& registers_;
  Diagnostics& diagnostics_;
  std::map<TypeId, bool> holds_, is_removed_;
  // The numbers of fields after those that hold nothing but objects are removed, by StructId and
  // field; ~0 for these.
  std::vector<std::vector<std::uint32_t>> field_numbers_;
  std::map<VarId, Slots> globals_;
  std::map<FunctionId, FunctionId> in_place_;
  std::map<std::vector<std::uint32_t>, Instance> instances_;
  Arena<Function> functions_;  // callees before callers
  FunctionId entry_;
  Frame* frame_ = nullptr;
  int call_depth_ = 0;
};

}  // namespace clipc::resolve
