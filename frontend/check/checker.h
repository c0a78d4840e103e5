// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <deque>
#include <memory_resource>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/diagnostics.h"
#include "frontend/check/check.h"
#include "frontend/check/symbols.h"
#include "frontend/parse/ast.h"
#include "frontend/rules/build_main.h"
#include "frontend/rules/conversion.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/program.h"

// The checker behind Check(). Declarations are entered under their names first, all of them; what a
// name means is worked out when something reached first uses it (so other stages' code costs next
// to nothing), in the context of its declaration: the scope it stands in and the names declared
// before it. Function bodies wait in a queue, so calls do not nest. Included by check*.cpp only.
namespace clipc {

class Checker final : TemporaryMaker {
 public:
  Checker(const ast::File& file, const CheckOptions& options, Diagnostics& diagnostics);
  ir::Program Run();

 private:
  // Where the checker stands.
  struct Body;
  struct Context {
    ScopeId scope;
    std::uint32_t order = ~0u;      // namespace symbols from this one on are not declared yet
    std::uint32_t local_floor = 0;  // locals below belong to somebody else
    Body* body = nullptr;           // none outside functions
    bool wants_constant = false;    // a `const` global stands for its initialiser
  };
  // The function body in progress.
  struct Body {
    ir::FunctionId function;
    ir::TypeId return_type;
    ir::VarId self;
    int loops = 0;
    int switches = 0;
    std::vector<ir::VarId>
        temporaries;                  // made while checking the current statement, not declared yet
    std::vector<ir::StmtId> hoisted;  // Declares that go before the first statement
  };
  class ContextSwitch {
   public:
    ContextSwitch(Checker& checker, Context context) : checker_(checker), saved_(checker.context_) {
      checker.context_ = context;
    }
    ~ContextSwitch() { checker_.context_ = saved_; }
    ContextSwitch(const ContextSwitch&) = delete;
    ContextSwitch& operator=(const ContextSwitch&) = delete;

   private:
    Checker& checker_;
    Context saved_;
  };
  // One level of the checker's own recursion; not ok: the limit was reported.
  class Depth {
   public:
    Depth(Checker& checker, Span where, int weight = 1);
    ~Depth() { checker_.depth_ -= weight_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    bool ok() const { return ok_; }

   private:
    Checker& checker_;
    int weight_;
    bool ok_;
  };
  static constexpr int kDeclarationWeight =
      8;  // of a declaration resolved on the way, against an expression's 1
  // Locals declared while it lives are forgotten afterwards.
  class LocalScope {
   public:
    explicit LocalScope(Checker& checker) : checker_(checker), mark_(checker.locals_.size()) {
      checker.local_scopes_.push_back(checker.symbols_.size());
    }
    ~LocalScope() {
      checker_.local_scopes_.pop_back();
      checker_.ForgetLocals(mark_);
    }
    LocalScope(const LocalScope&) = delete;
    LocalScope& operator=(const LocalScope&) = delete;

   private:
    Checker& checker_;
    std::size_t mark_;
  };

  // ---- names and scopes (check_scope.cpp)
  SymbolId Declare(SymbolKind kind, ScopeId scope, Name name, ast::DeclId decl, Span span);
  SymbolId DeclareLocal(SymbolKind kind, Name name, ast::DeclId decl, Span span);
  void ForgetLocals(std::size_t mark);
  SymbolId FindIn(ScopeId scope, Name name, bool types_only = false) const;
  bool IsVisible(SymbolId id) const;
  SymbolId FindUnqualified(Name name, bool types_only = false) const;
  SymbolId FindNested(ScopeId scope, Name name, bool types_only, int depth) const;
  SymbolId Find(const ast::QualifiedName& name, bool types_only = false);
  ScopeId FindScope(const ast::QualifiedName& name, ScopeId* missing_in, Name* missing);
  ScopeId ScopeOf(SymbolId id);
  SymbolId FindLater(Name name) const;
  void ReportUndeclared(Span span, const ast::QualifiedName& name, bool as_type, bool as_function);
  std::string NearText(Name name, bool types_only, bool functions_only) const;
  void ReportRedefinition(SymbolId older, Name name, Span span);
  std::string_view Text(Name name) const { return file_.names[name]; }
  std::string QualifiedText(const ast::QualifiedName& name) const;

  // ---- entering declarations (check_declare.cpp)
  void DeclareAll(std::span<const ast::DeclId> decls, ScopeId scope);
  void DeclareOne(ast::DeclId id, ScopeId scope);
  void DeclareVar(ast::DeclId id, const ast::VarDecl& var, ScopeId scope);
  void DeclareBuffer(ast::DeclId id, const ast::BufferDecl& buffer, ScopeId scope);
  void DeclareNamespace(const ast::NamespaceDecl& space, Span span, ScopeId scope);
  void DeclareStruct(ast::DeclId id, const ast::StructDecl& decl, ScopeId scope);
  void DeclareEnum(ast::DeclId id, const ast::EnumDecl& decl, ScopeId scope);
  void DeclareFunction(ast::DeclId id, const ast::FunctionDecl& decl, ScopeId scope);
  void DeclareUsing(const ast::UsingDecl& use, Span span, ScopeId scope);
  void DeclareTypeInside(ast::TypeId type, ScopeId scope);
  ScopeId AddScope(ScopeKind kind, ScopeId parent, Name name, std::uint32_t order = ~0u);

  // ---- types (check_type.cpp, check_type_names.cpp)
  ir::TypeId ResolveType(ast::TypeId id);
  ir::TypeId ResolveNamedType(const ast::Type& type);
  ir::TypeId ResolveTypeSymbol(SymbolId id);
  ir::TypeId ResolveVarType(const ast::VarDecl& var);
  ir::TypeId ArrayOf(ir::TypeId element, List<ast::ExprId> dimensions, Span span,
                     std::optional<std::uint32_t> implied = {});
  std::optional<std::uint32_t> ArraySize(ast::ExprId dimension);
  std::optional<std::int64_t> ConstantInteger(ast::ExprId id);
  std::uint64_t ComponentsOf(ir::TypeId type) const;
  int DepthOf(ir::TypeId type) const;
  bool IsTooLarge(ir::TypeId type, Span span);
  bool IsRowMajor(ast::Qualifiers qualifiers) const;
  ast::Qualifiers QualifiersOf(const ast::VarDecl& var);
  void DeclareLocalType(ast::DeclId id);
  std::optional<ir::TypeId> NumericType(Name name);
  std::optional<ir::TypeId> GenericNumericType(const ast::Type& type, std::string_view text);
  std::optional<ir::TypeId> ObjectType(const ast::Type& type, std::string_view text);
  ir::TypeId TypeArgument(ast::ExprId id);
  std::string TypeName(ir::TypeId type) const { return program_.types.Name(type); }
  const ir::Type& TypeOf(ir::ExprId expr) const {
    return program_.types[program_.exprs[expr].type];
  }
  ir::TypeId TypeIdOf(ir::ExprId expr) const { return program_.exprs[expr].type; }

  // ---- structs and enums (check_struct.cpp)
  ir::TypeId ResolveStruct(ast::DeclId id, SymbolId symbol, ScopeId scope, std::uint32_t order);
  void AddBases(const ast::StructDecl& decl, ir::TypeId type);
  void AddMember(ast::DeclId id, ir::TypeId type);
  void AddField(const ast::VarDecl& var, ast::DeclId id, ir::TypeId type);
  void MeasureStruct(ir::TypeId type, Span span);
  ir::Field MakeField(const ast::VarDecl& var);
  std::optional<std::uint32_t> FindField(ir::TypeId type, Name name) const;
  SymbolId FindMember(ir::TypeId type, Name name) const;
  const StructInfo* InfoOf(ir::TypeId type) const;
  void ResolveEnum(SymbolId id, const ast::EnumDecl& decl);
  ir::TypeId EnumType(const ast::EnumDecl& decl);
  void ReadInterpolation(ast::Qualifiers qualifiers, ir::Interpolation& interpolation,
                         bool& centroid, bool& sample) const;
  bool DerivesFrom(ir::TypeId derived, ir::TypeId base) const;

  // ---- global variables and buffers (check_global.cpp)
  bool ResolveVar(SymbolId id);
  void ResolveGlobal(SymbolId id, const ast::VarDecl& var);
  void ResolveStatic(SymbolId id, const ast::VarDecl& var);
  void ResolveObject(SymbolId id, const ast::VarDecl& var, ir::TypeId type);
  void ReachBuffer(BufferId id);
  void ResolveMember(Buffer& buffer, SymbolId id);
  void ResolveConstantBuffer(SymbolId id, const ast::VarDecl& var);
  bool HoldsObjects(ir::TypeId type) const;
  bool IsConstantExpr(ir::ExprId expr) const;
  std::uint32_t OrderOf(SymbolId id) const;
  bool IsConstantBuffer(const ast::VarDecl& var) const;
  ir::VarId AddVar(Name name, ir::TypeId type, ir::Storage storage, Span span);
  void FinishBuffers();
  void FinishBuffer(const Buffer& buffer);
  void FinishMember(const ast::VarDecl& var, ir::CbufferMember& member);
  void FinishGlobals();
  std::uint32_t CountOfArray(ir::TypeId type) const;
  const ast::RegisterBinding* BindingOf(List<ast::RegisterBinding> bindings,
                                        std::string_view letters) const;
  Context ContextOf(SymbolId id) const;

  // ---- functions (check_function.cpp)
  void ResolveSignature(FunctionInfoId id);
  void AddParameter(const ast::VarDecl& var, ast::DeclId id, FunctionInfo& info,
                    std::vector<Parameter>& parameters);
  std::vector<FunctionInfoId> OverloadsOf(SymbolId first, ir::TypeId self);
  FunctionInfoId InfoOfFunction(SymbolId id, ir::TypeId self);
  FunctionInfoId MergeOverloads(FunctionInfoId known, FunctionInfoId added);
  std::string ParameterKey(const FunctionInfo& info) const;
  bool SameParameters(const FunctionInfo& a, const FunctionInfo& b) const;
  ir::FunctionId Reach(FunctionInfoId id);
  void CheckBodies();
  void CheckBody(FunctionInfoId id);
  void CheckRecursion();
  std::string SignatureText(const FunctionInfo& info) const;
  const ast::FunctionDecl& DeclOf(const FunctionInfo& info) const;
  void FindOutOfLine(FunctionInfo& info);
  FunctionInfo& Info(FunctionInfoId id) { return functions_[id.index]; }
  const FunctionInfo& Info(FunctionInfoId id) const { return functions_[id.index]; }

  // ---- which methods change their object (check_self.cpp)
  bool MayChangeSelf(const ast::FunctionDecl& decl, ScopeId scope);
  bool CallChangesSelf(SymbolId id, ScopeId scope);
  bool StmtChangesSelf(ast::StmtId id, ScopeId scope);
  bool ExprChangesSelf(ast::ExprId id, ScopeId scope);
  bool IsPartOfSelf(ast::ExprId id, ScopeId scope) const;

  // ---- templates (check_template.cpp)
  std::optional<ir::TypeId> InstantiateStruct(SymbolId id, const ast::Type& type);
  FunctionInfoId InstantiateFunction(SymbolId id, ir::TypeId self,
                                     List<ast::ExprId> explicit_arguments,
                                     std::span<const ir::ExprId> arguments);
  void Deduce(ast::TypeId pattern, ir::TypeId type, const ast::FunctionDecl& decl,
              std::vector<std::uint64_t>& found);
  bool ReadTemplateArguments(List<ast::TemplateParameter> parameters, List<ast::ExprId> arguments,
                             std::vector<std::uint64_t>& found);
  ScopeId BindTemplate(List<ast::TemplateParameter> parameters, ScopeId parent, std::uint32_t order,
                       std::vector<std::uint64_t>& found);
  static std::string InstanceKey(ast::DeclId decl, ScopeId scope, ir::TypeId self,
                                 const std::vector<std::uint64_t>& found);

  // ---- the entry point (check_entry.cpp)
  std::optional<Name> NameOf(std::string_view text) const;
  FunctionInfoId FindEntry();
  std::vector<SymbolId> EntriesIn(ScopeId scope, Name name) const;
  std::string ScopedName(SymbolId id) const;
  void ReportNoEntry();
  EntrySignature SignatureOf(FunctionInfoId entry);
  ir::VarId AddUniformParameter(const ast::VarDecl& var, const Parameter& parameter);
  std::vector<std::span<const ast::Attr>> PrototypeAttributes(FunctionInfoId entry) const;
  void ReachClipPlanes(FunctionInfoId entry);
  void ReachNames(ast::ExprId id);
  void CheckPlanes(FunctionInfoId entry);
  std::string TextOf(ast::ExprId id) const;

  // ---- statements (check_stmt.cpp, check_loop.cpp)
  void CheckStmt(ast::StmtId id);
  void CheckStmts(List<ast::StmtId> stmts);
  ir::StmtId CheckBlock(ast::StmtId id);
  void CheckDeclStmt(const ast::DeclStmt& stmt);
  void CheckLocal(ast::DeclId id, const ast::VarDecl& var);
  void CheckStaticLocal(ast::DeclId id, const ast::VarDecl& var);
  void CheckIf(const ast::IfStmt& stmt, Span span);
  void CheckReturn(const ast::ReturnStmt& stmt, Span span);
  void CheckFor(const ast::ForStmt& stmt, Span span);
  void CheckForInit(ast::StmtId init, ir::For& loop);
  void CheckWhile(const ast::WhileStmt& stmt, Span span);
  void CheckDo(const ast::DoStmt& stmt, Span span);
  void CheckSwitch(const ast::SwitchStmt& stmt, Span span);
  std::optional<std::int64_t> CheckCaseLabel(const ast::CaseStmt& stmt, Span span,
                                             std::unordered_set<std::int64_t>& seen);
  void HoistLoopVariable(SymbolId id);
  ir::ExprId CheckCondition(ast::ExprId id, std::string_view statement);
  void Emit(Span span, decltype(ir::Stmt::node) node);
  void DeclareTemporaries();
  void EmitValue(ir::ExprId value);
  std::vector<ir::VarId> TakeBehind(ir::VarId var);
  ir::ExprId Unwrap(ir::ExprId value);
  bool FallsThrough(ir::StmtId id) const;
  bool Breaks(ir::StmtId id) const;

  // ---- expressions (check_expr.cpp)
  ir::ExprId CheckExpr(ast::ExprId id);
  ir::ExprId CheckLiteral(const ast::Literal& literal, Span span);
  ir::ExprId CheckName(const ast::NameExpr& name, Span span);
  ir::ExprId UseSymbol(SymbolId id, Span span);
  ir::ExprId UseVariable(SymbolId id, Span span);
  ir::ExprId CheckConditional(const ast::ConditionalExpr& expr, Span span);
  ir::ExprId CheckCast(const ast::CastExpr& expr, Span span);
  ir::ExprId CheckSizeof(const ast::SizeofExpr& expr, Span span);
  ir::ExprId ErrorExpr(Span span);
  bool IsError(ir::ExprId expr) const { return TypeOf(expr).kind == ir::TypeKind::kError; }
  ir::ExprId Hoist(ir::ExprId value, std::vector<ir::ExprId>& prologue);
  ir::ExprId WithPrologue(std::span<const ir::ExprId> prologue, ir::ExprId value);
  ir::ExprId Implicit(ir::ExprId value, ir::TypeId to);
  ir::ExprId ConvertSilently(ir::ExprId value, ir::TypeId to);
  std::optional<ir::TypeId> Common(ir::TypeId left, ir::TypeId right) {
    return CommonType(program_.types, left, right);
  }
  ir::Builder At(Span span) { return ir::Builder(program_, span); }
  Temporary Make(ir::ExprId value) override;

  // ---- members, swizzles, indices (check_member.cpp)
  ir::ExprId CheckMember(const ast::MemberExpr& expr, Span span);
  ir::ExprId CheckSwizzle(ir::ExprId base, std::string_view text, Span name_span, Span span);
  ir::ExprId CheckMatrixSwizzle(ir::ExprId base, std::string_view text, Span name_span, Span span);
  ir::ExprId CheckIndex(const ast::IndexExpr& expr, Span span);
  ir::ExprId CheckMips(const ast::IndexExpr& expr, Span span);
  ir::ExprId ConvertIndex(ir::ExprId index);
  bool CheckBounds(ir::ExprId base, ir::ExprId index);
  void ReportNoMember(ir::TypeId type, Name name, Span span);

  // ---- operators (check_operator.cpp)
  ir::ExprId CheckUnary(const ast::UnaryExpr& expr, Span span);
  ir::ExprId CheckIncrement(const ast::UnaryExpr& expr, Span span);
  ir::ExprId CheckBinary(const ast::BinaryExpr& expr, Span span);
  ir::ExprId CombineOperands(ast::BinaryOp op, ir::ExprId left, ir::ExprId right, Span op_span,
                             Span span);
  ir::ExprId CombineLogical(ast::BinaryOp op, ir::ExprId left, ir::ExprId right, Span op_span,
                            Span span);
  ir::ExprId CombineShift(ast::BinaryOp op, ir::ExprId left, ir::ExprId right, Span op_span,
                          Span span);
  std::optional<ir::TypeId> OperandType(ast::BinaryOp op, ir::ExprId left, ir::ExprId right,
                                        Span op_span);
  std::optional<ir::ExprId> CallOperator(std::string_view op, std::span<const ir::ExprId> operands,
                                         Span op_span, Span span);

  // ---- assignment (check_assign.cpp)
  ir::ExprId CheckAssign(const ast::AssignExpr& expr, Span span);
  ir::ExprId AssignCompound(ast::BinaryOp op, ir::ExprId target, ir::ExprId value, Span op_span,
                            Span span);
  ir::ExprId StoreTo(ir::ExprId target, ir::ExprId value, Span span);
  ir::ExprId StoreToMatrixSwizzle(ir::ExprId target, ir::ExprId value, Span span);
  ir::ExprId ElementIn(ir::ExprId target) const;
  ir::ExprId AssignElement(const ast::AssignExpr& expr, ir::ExprId target, ir::ExprId element,
                           ir::ExprId value, Span span);
  ir::ExprId ChangeElement(ir::ExprId element, std::vector<ir::ExprId>& prologue);
  bool CheckTarget(ir::ExprId target);
  bool IsPath(ir::ExprId expr) const;
  ir::ExprId Stabilize(ir::ExprId path, std::vector<ir::ExprId>& prologue);
  void MarkConst(ir::VarId var);
  bool IsConstVar(ir::VarId var) const;

  // ---- calls (check_call.cpp, check_overload.cpp, check_construct.cpp)
  ir::ExprId CheckCall(const ast::CallExpr& expr, Span span);
  ir::ExprId CallNamed(const ast::NameExpr& name, Span name_span, const ast::CallExpr& expr,
                       Span span);
  ir::ExprId CallMember(const ast::MemberExpr& member, const ast::CallExpr& expr, Span span);
  ir::ExprId CallIntrinsic(Name name, Span name_span, std::span<const ir::ExprId> arguments,
                           Span span);
  ir::ExprId CallFunction(FunctionInfoId function, ir::ExprId self,
                          std::vector<ir::ExprId> arguments, Span name_span, Span span);
  ir::ExprId BindArgument(const Parameter& parameter, ir::ExprId argument,
                          std::vector<ir::ExprId>& before, std::vector<ir::ExprId>& after);
  bool IsInterface(ir::TypeId type) const;
  ir::VarId MakeEmpty(ir::TypeId type, Span span);
  ir::ExprId CallTemplatedLoad(const ast::MemberExpr& member, ir::ExprId object,
                               std::span<const ir::ExprId> arguments, Span span);
  SymbolId FindFunction(const ast::QualifiedName& name);
  std::vector<FunctionInfoId> CandidatesOf(SymbolId symbol, ir::TypeId self,
                                           List<ast::ExprId> explicit_arguments,
                                           std::span<const ir::ExprId> arguments);
  ir::ExprId BindSelf(const FunctionInfo& function, ir::ExprId self,
                      std::vector<ir::ExprId>& before);
  ir::ExprId DefaultArgument(const FunctionInfo& function, std::uint32_t index);
  ir::ExprId FinishCall(ir::ExprId call, std::span<const ir::ExprId> before,
                        std::span<const ir::ExprId> after);
  bool CheckArguments(List<ast::ExprId> list, std::vector<ir::ExprId>& arguments);
  struct Choice {
    FunctionInfoId function;  // none: nothing fits, or an error was reported
    bool reported = false;
    bool changes_shape = false;  // an argument is splatted or truncated
  };
  Choice ChooseOverload(std::span<const FunctionInfoId> overloads,
                        std::span<const ir::ExprId> arguments, Name name, Span span);
  bool RankArguments(const FunctionInfo& info, std::span<const ir::ExprId> arguments,
                     std::uint64_t& cost, bool& changes_shape) const;
  std::optional<ConversionRank> Rank(ir::TypeId from, ir::TypeId to) const;
  void ReportNoOverload(std::span<const FunctionInfoId> overloads,
                        std::span<const ir::ExprId> arguments, Name name, Span span);
  std::string ArgumentTypes(std::span<const ir::ExprId> arguments) const;
  ir::ExprId CheckConstructor(ir::TypeId type, List<ast::ExprId> arguments, Span span);
  ir::ExprId ConstructVector(ir::TypeId type, std::span<const ir::ExprId> arguments, Span span);
  ir::ExprId ConstructMatrix(ir::TypeId type, std::span<const ir::ExprId> arguments, Span span);
  ir::ExprId ConstructStruct(ir::TypeId type, std::span<const ir::ExprId> arguments, Span span);
  ir::ExprId Component(ir::ExprId vector, std::uint8_t component);
  void TakeApart(ir::ExprId value, std::vector<ir::ExprId>& scalars,
                 std::vector<ir::ExprId>& prologue);

  // ---- initialisers (check_init.cpp)
  struct Leaves;
  ir::ExprId CheckInit(ast::ExprId init, ir::TypeId type);
  ir::ExprId CheckInitList(ast::ExprId init, ir::TypeId type);
  void CollectLeaves(ast::ExprId init, std::vector<ast::ExprId>& leaves) const;
  bool Peek(Leaves& leaves);
  void Open(Leaves& leaves);
  void OpenPart(ir::ExprId value, Leaves& leaves);
  ir::ExprId Take(Leaves& leaves, ir::TypeId type);
  ir::ExprId TakeScalar(Leaves& leaves, ir::Scalar kind);
  ir::ExprId TakeVector(Leaves& leaves, ir::TypeId type);
  ir::ExprId TakeParts(Leaves& leaves, ir::TypeId type);
  std::optional<std::uint32_t> ImpliedCount(ast::ExprId init, ir::TypeId element);
  std::optional<std::uint64_t> CountComponents(ast::ExprId init);

  const ast::File& file_;
  const CheckOptions& options_;
  Diagnostics& diagnostics_;
  ir::Program program_;
  Context context_;
  int depth_ = 0;

  Arena<Symbol> symbols_;
  Arena<Scope> scopes_;
  std::pmr::monotonic_buffer_resource symbol_memory_{4096};
  std::pmr::unordered_map<std::uint64_t, SymbolId> by_scope_and_name_{64, &symbol_memory_};
  ScopeId global_scope_;
  std::vector<SymbolId> local_by_name_;  // by Name: the innermost local
  std::vector<SymbolId> locals_;
  std::vector<std::uint32_t> local_scopes_;  // the first SymbolId of each LocalScope

  Arena<Buffer> buffers_;
  BufferId globals_buffer_, params_buffer_;
  struct Ordered {
    std::uint32_t order;  // of the declaration, as OrderOf
    ir::VarId var;
  };
  std::vector<Ordered> reached_globals_, reached_resources_;
  std::unordered_map<std::uint32_t, ir::Register> resource_registers_;  // by VarId
  std::vector<bool> const_vars_;                                        // by VarId

  std::unordered_map<std::uint32_t, SymbolId>
      struct_symbols_;  // by DeclId: structs defined inside another declaration
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>>
      enum_values_;  // by the enum's SymbolId
  std::unordered_map<std::uint32_t, std::vector<ast::DeclId>>
      out_of_line_;                        // methods defined outside, by Name
  std::vector<ir::TypeId> numeric_types_;  // by Name: float4x3 and the like, once looked up
  std::deque<StructInfo> struct_infos_;    // by StructId

  std::unordered_map<std::string_view, Name>
      operator_names_;  // "+" for operator+, of those the file defines
  std::deque<FunctionInfo> functions_;
  Pool<Parameter> parameters_;
  std::unordered_map<std::uint32_t, bool> changes_self_;           // by a method's DeclId
  std::unordered_map<std::uint64_t, FunctionInfoId> function_of_;  // by SymbolId and self
  std::unordered_map<std::uint64_t, std::vector<FunctionInfoId>>
      overloads_;  // by SymbolId and self
  std::unordered_map<std::string, std::uint32_t>
      instances_;                        // of templates, by decl, scope, arguments
  std::vector<FunctionInfoId> waiting_;  // reached, bodies not checked
  struct CallEdge {
    ir::FunctionId caller, callee;
    Span span;
  };
  std::vector<CallEdge> calls_;
  std::vector<ir::StmtId> stmts_;  // the statements of the blocks in progress
};

}  // namespace clipc
