// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/verify.h"

#include <gtest/gtest.h>

#include "ir/intrinsic_list.h"
#include "ir/test_verifier.h"

// Each test breaks one promise of program.h and expects Verify to say so.
namespace clipc::ir {
namespace {

TEST_F(Verifier, AcceptsTheSampleProgram) {
  shader.Append({shader.Return(build.IntrinsicOf(Intrinsic::kMul, F(4), {V(), M()}))});
  EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt);
}

// ---- the tree

TEST_F(Verifier, OneParent) {
  const ExprId shared = build.Float(1);
  ExpectProblemIn(build.BinaryOf(BinaryOp::kAdd, shared, shared), "two parents");
}
TEST_F(Verifier, NoCycle) {
  const ExprId negate = build.UnaryOf(UnaryOp::kNegate, build.Float(1));
  std::get<Unary>(shader.exprs[negate].node).operand = negate;
  ExpectProblemIn(negate, "two parents");
}
TEST_F(Verifier, OneParentOfStatements) {
  const StmtId stmt = build.Eval(build.Float(1));
  shader.Append({stmt, stmt});
  ExpectProblem("a statement has two parents");
}
TEST_F(Verifier, MissingOperand) {
  ExpectProblemIn(build.Add(F(), Unary{UnaryOp::kNegate, {}}), "missing");
}
TEST_F(Verifier, MissingStatement) {
  shader.Append({build.Stmt(If{build.Bool(true), StmtId{12345}, {}})});
  ExpectProblem("a statement is missing");
}
TEST_F(Verifier, ErrorType) {
  ExpectProblemIn(build.Add(shader.types.Error(), Zero{}), "has no type");
}

// ---- expressions

TEST_F(Verifier, LiteralIsScalar) {
  ExpectProblemIn(build.Add(F(2), Literal{0}), "a literal is a scalar");
}
TEST_F(Verifier, BoolLiteral) {
  ExpectProblemIn(build.Add(shader.types.Make(Scalar::kBool), Literal{2}),
                  "a bool literal is 0 or 1");
}
TEST_F(Verifier, ZeroOfVoid) {
  ExpectProblemIn(build.ZeroOf(shader.types.Void()), "there is no such zero");
}
TEST_F(Verifier, RefHasVariableType) {
  ExpectProblemIn(build.Add(F(3), VarRef{shader.parameter}), "the variable's type");
}
TEST_F(Verifier, RefToNothing) {
  ExpectProblemIn(build.Add(F(3), VarRef{VarId{9999}}), "the variable is not of this program");
}
TEST_F(Verifier, FieldOfStruct) {
  ExpectProblemIn(build.Add(F(), FieldRef{V(), 0}), "a field is of a struct");
}
TEST_F(Verifier, FieldExists) {
  const TypeId type = shader.types.Of(shader.types.AddStruct(
      {.name = "S",
       .fields = {{.name = "x", .type = F(), .span = {}, .semantic = {}, .semantic_span = {}}},
       .span = {}}));
  const VarId s = Local("s", type);
  ExpectProblemIn(build.Add(F(), FieldRef{build.Ref(s), 1}), "no such field");
}
TEST_F(Verifier, FieldReferenceHasFieldType) {
  const TypeId type = shader.types.Of(shader.types.AddStruct(
      {.name = "S",
       .fields = {{.name = "x", .type = F(), .span = {}, .semantic = {}, .semantic_span = {}}},
       .span = {}}));
  const VarId s = Local("s", type);
  ExpectProblemIn(build.Add(I(), FieldRef{build.Ref(s), 0}), "the field's type");
}
TEST_F(Verifier, IndexIsInteger) {
  ExpectProblemIn(build.Add(F(), Index{V(), build.Float(0)}), "an index is an int or uint");
}
TEST_F(Verifier, IndexOfVector) {
  ExpectProblemIn(build.Add(F(2), Index{V(), build.Int(0)}), "a component is a scalar");
}
TEST_F(Verifier, IndexOfMatrix) {
  ExpectProblemIn(build.Add(F(3), Index{M(), build.Int(0)}), "a row is a vector");
}
TEST_F(Verifier, IndexOfArray) {
  ExpectProblemIn(build.Add(F(), Index{build.Ref(shader.planes), build.Int(0)}),
                  "the array's element type");
}
TEST_F(Verifier, IndexOfScalar) {
  ExpectProblemIn(build.Add(F(), Index{build.Float(0), build.Int(0)}),
                  "only arrays, vectors and matrices");
}
TEST_F(Verifier, SwizzleOfVector) {
  ExpectProblemIn(build.Add(F(), Swizzle{build.Float(1), {0}, 1}), "a swizzle is of a vector");
}
TEST_F(Verifier, SwizzleInRange) {
  ExpectProblemIn(build.Swizzled(build.SplatTo(F(2), build.Float(1)), {2}), "no such component");
}
TEST_F(Verifier, SwizzleCount) {
  ExpectProblemIn(build.Add(F(), Swizzle{V(), {0}, 0}), "one to four components");
}
TEST_F(Verifier, SwizzleType) {
  ExpectProblemIn(build.Add(F(2), Swizzle{V(), {0}, 1}), "one component is a scalar");
}
TEST_F(Verifier, MatrixSwizzleInRange) {
  ExpectProblemIn(build.Add(F(), MatrixSwizzle{M(), {4}, {0}, 1}),
                  "the matrix has no such component");
}
TEST_F(Verifier, MatrixSwizzleType) {
  ExpectProblemIn(build.Add(F(3), MatrixSwizzle{M(), {0, 1}, {0, 1}, 2}),
                  "one component is a scalar");
}
TEST_F(Verifier, UnaryType) {
  ExpectProblemIn(build.Add(F(), Unary{UnaryOp::kNegate, V()}), "the operand's numeric type");
}
TEST_F(Verifier, NotTakesBool) {
  ExpectProblemIn(build.UnaryOf(UnaryOp::kNot, build.Int(1)), "`!` takes bool");
}
TEST_F(Verifier, ComplementTakesIntegers) {
  ExpectProblemIn(build.UnaryOf(UnaryOp::kComplement, build.Float(1)), "`~` takes integers");
}
TEST_F(Verifier, NegateTakesNumbers) {
  ExpectProblemIn(build.UnaryOf(UnaryOp::kNegate, build.Bool(true)), "`-` takes numbers");
}
TEST_F(Verifier, IncrementTakesTarget) {
  ExpectProblemIn(build.UnaryOf(UnaryOp::kPreIncrement, build.Int(1)), "take an assignment target");
}
TEST_F(Verifier, BinaryOperandsAgree) {
  ExpectProblemIn(build.BinaryOf(BinaryOp::kAdd, build.Float(1), build.Int(1)),
                  "the same numeric type");
}
TEST_F(Verifier, ShiftOfFloats) {
  ExpectProblemIn(build.BinaryOf(BinaryOp::kShiftLeft, build.Float(1), build.Float(1)),
                  "does not take this kind");
}
TEST_F(Verifier, ShiftCountIsInteger) {
  ExpectProblemIn(build.BinaryOf(BinaryOp::kShiftLeft, build.Int(1), build.Float(1)),
                  "a shift count is an integer");
}
TEST_F(Verifier, ShiftCountIsBelowTheNumberOfBits) {
  shader.form = Form::kLegalized;
  shader.Append({build.Eval(build.BinaryOf(BinaryOp::kShiftLeft, build.Int(1), build.Int(31)))});
  EXPECT_EQ(Verify(shader, Form::kLegalized), std::nullopt);
  shader.Append({build.Eval(build.BinaryOf(BinaryOp::kShiftLeft, build.Int(1), build.Int(32)))});
  ExpectProblem("below the number of bits", Form::kLegalized);
}
TEST_F(Verifier, ByteAddressBufferIsOneOfWords) {
  const TypeId bytes = shader.types.Object(ObjectKind::kByteAddressBuffer);
  const VarId buffer = shader.AddVar("buffer", bytes, Storage::kResource);
  shader.resources.push_back({buffer, {.letter = 't', .is_explicit = true}});
  shader.form = Form::kAddressed;
  EXPECT_EQ(Verify(shader, Form::kLegalized), std::nullopt);
  ExpectProblem("a structured buffer of words", Form::kAddressed);
}
TEST_F(Verifier, StructuredBufferHasElementsOfStd430) {
  const TypeId tight = shader.types.Object(ObjectKind::kStructuredBuffer, F(3));
  const VarId buffer = shader.AddVar("buffer", tight, Storage::kResource);
  shader.resources.push_back({buffer, {.letter = 't', .is_explicit = true}});
  shader.form = Form::kAddressed;
  EXPECT_EQ(Verify(shader, Form::kLegalized), std::nullopt);
  ExpectProblem("lie as std430 has them", Form::kAddressed);
}
TEST_F(Verifier, LogicTakesBool) {
  ExpectProblemIn(build.BinaryOf(BinaryOp::kLogicalAnd, build.Int(1), build.Int(1)),
                  "does not take this kind");
}
TEST_F(Verifier, ComparisonGivesBool) {
  ExpectProblemIn(build.Add(F(), Binary{BinaryOp::kLess, build.Float(1), build.Float(2)}),
                  "bool of the operands' shape");
}
TEST_F(Verifier, ArithmeticGivesOperandType) {
  ExpectProblemIn(build.Add(I(), Binary{BinaryOp::kAdd, build.Float(1), build.Float(2)}),
                  "the left operand's type");
}
TEST_F(Verifier, ShortCircuitTakesScalars) {
  const auto yes = [&] {
    return build.SplatTo(shader.types.Vector(Scalar::kBool, 2), build.Bool(true));
  };
  ExpectProblemIn(build.BinaryOf(BinaryOp::kShortCircuitAnd, yes(), yes()),
                  "short-circuit operators take scalars");
}
TEST_F(Verifier, AssignToConstant) {
  ExpectProblemIn(build.AssignTo(build.At(build.Ref(shader.table), 0u), build.Float(1)),
                  "is not an assignment target");
}
TEST_F(Verifier, AssignToUniform) {
  ExpectProblemIn(build.AssignTo(build.Ref(shader.scale), build.Float(1)),
                  "is not an assignment target");
}
TEST_F(Verifier, AssignToRepeatedSwizzle) {
  ExpectProblemIn(build.AssignTo(build.Swizzled(V(), {0, 0}), build.ZeroOf(F(2))),
                  "is not an assignment target");
}
TEST_F(Verifier, AssignToSwizzleOfSwizzle) {
  ExpectProblemIn(build.AssignTo(build.Swizzled(build.Swizzled(V(), {0, 1}), {0}), build.Float(1)),
                  "is not an assignment target");
}
TEST_F(Verifier, AssignOtherType) {
  ExpectProblemIn(build.AssignTo(V(), build.Float(1)), "both sides have the same type");
}
TEST_F(Verifier, AssignWithComparison) {
  ExpectProblemIn(build.AssignTo(V(), build.ZeroOf(F(4)), BinaryOp::kLess),
                  "does not take this kind");
}
TEST_F(Verifier, ConditionalCondition) {
  ExpectProblemIn(build.Add(F(), Conditional{build.Int(1), build.Float(1), build.Float(2)}),
                  "the condition is a bool scalar");
}
TEST_F(Verifier, ConditionalSides) {
  ExpectProblemIn(build.Add(F(), Conditional{build.Bool(true), build.Float(1), build.Int(2)}),
                  "both sides have the value's type");
}
TEST_F(Verifier, SelectCondition) {
  ExpectProblemIn(build.Add(F(4), Select{build.Bool(true), V(), V()}),
                  "a bool vector or matrix of the value's shape");
}
TEST_F(Verifier, ConvertKeepsShape) {
  ExpectProblemIn(build.Add(I(), Convert{V()}), "a conversion keeps the shape");
}
TEST_F(Verifier, SplatOfScalar) {
  ExpectProblemIn(build.Add(F(3), Splat{build.Int(1)}), "a splat takes a scalar");
}
TEST_F(Verifier, SplatGivesVector) {
  ExpectProblemIn(build.Add(F(), Splat{build.Float(1)}), "a splat gives a vector");
}
TEST_F(Verifier, ConstructAddsUp) {
  ExpectProblemIn(build.ConstructOf(F(3), {build.Float(1), build.Float(2)}),
                  "the components do not add up");
}
TEST_F(Verifier, ConstructSameKind) {
  ExpectProblemIn(build.ConstructOf(F(2), {build.Float(1), build.Int(2)}),
                  "scalars and vectors of the same kind");
}
TEST_F(Verifier, ConstructMatrixOfRows) {
  ExpectProblemIn(build.ConstructOf(shader.types.Matrix(Scalar::kFloat, 2, 3),
                                    {build.ZeroOf(F(2)), build.ZeroOf(F(4))}),
                  "a matrix is made of its rows");
}
TEST_F(Verifier, ConstructArray) {
  ExpectProblemIn(build.ConstructOf(shader.types.Array(F(), 2), {build.Float(1)}),
                  "an array is made of its elements");
}
TEST_F(Verifier, ConstructScalar) {
  ExpectProblemIn(build.ConstructOf(F(), {build.Float(1)}), "only vectors, matrices");
}
TEST_F(Verifier, TruncateShrinks) {
  ExpectProblemIn(build.Add(F(3), MatrixTruncate{M()}), "a truncation gives a part of a matrix");
}
TEST_F(Verifier, CommaType) {
  ExpectProblemIn(build.Add(F(), Comma{build.Float(1), build.Int(1)}), "the type of its second");
}
TEST_F(Verifier, IntrinsicTypes) {
  ExpectProblemIn(build.IntrinsicOf(Intrinsic::kDot, F(), {V(), build.ZeroOf(F(3))}),
                  "the types do not fit dot");
}
TEST_F(Verifier, IntrinsicOutArgument) {
  ExpectProblemIn(build.IntrinsicOf(Intrinsic::kModf, F(), {build.Float(1), build.Float(2)}),
                  "an out argument is an assignment");
}
TEST_F(Verifier, NonUniformIsNoted) {
  const TypeId uint = shader.types.Make(Scalar::kUint);
  const ExprId call = build.IntrinsicOf(Intrinsic::kNonUniform, uint, {build.Uint(0)});
  shader.calls_nonuniform = false;
  ExpectProblemIn(call, "the program says that it calls NonUniformResourceIndex");
}

// ---- calls

TEST_F(Verifier, ArgumentCount) {
  ExpectProblemIn(build.CallOf(shader.entry, {}), "wrong number of arguments");
}
TEST_F(Verifier, ArgumentType) {
  const VarId x = shader.AddVar("x", F(), Storage::kIn);
  const FunctionId f = shader.AddFunction("f", F(), {x}, {});
  ExpectProblemIn(build.CallOf(f, std::vector<ExprId>{build.Int(1)}),
                  "exactly the parameter's type");
}
TEST_F(Verifier, OutArgumentIsTarget) {
  const VarId x = shader.AddVar("x", F(), Storage::kOut);
  const FunctionId f = shader.AddFunction("f", F(), {x}, {});
  ExpectProblemIn(build.CallOf(f, std::vector<ExprId>{build.Float(1)}),
                  "out or inout parameter is an assignment target");
}
TEST_F(Verifier, CallType) {
  const FunctionId f = shader.AddFunction("f", F(), {}, {});
  ExpectProblemIn(build.Add(I(), Call{f, {}}), "the function's return type");
}
TEST_F(Verifier, CallOfNothing) {
  ExpectProblemIn(build.Add(F(), Call{FunctionId{99}, {}}),
                  "the called function is not of this program");
}
TEST_F(Verifier, NoRecursion) {
  const FunctionId f = shader.AddFunction("f", F(), {}, {});
  const FunctionId g = shader.AddFunction("g", F(), {}, {shader.Return(build.CallOf(f, {}))});
  shader.functions[f].body = build.BlockOf(std::vector<StmtId>{shader.Return(build.CallOf(g, {}))});
  ExpectProblem("can reach itself");
}
TEST_F(Verifier, MainCallsEntryOnce) {
  shader.functions[shader.main].body = build.BlockOf({});
  ExpectProblem("main calls the entry once");
}

// ---- scope

TEST_F(Verifier, UseBeforeDeclaration) {
  const VarId x = shader.AddVar("x", F(), Storage::kLocal);
  ExpectProblemIn(build.Ref(x), "not declared here");
}
TEST_F(Verifier, UseAfterScope) {
  const VarId x = shader.AddVar("x", F(), Storage::kLocal);
  shader.Append({build.BlockOf(std::vector<StmtId>{shader.DeclareVar(x)})});
  ExpectProblemIn(build.Ref(x), "out of scope here");
}
TEST_F(Verifier, ForVariableEndsWithTheLoop) {
  const VarId i = shader.AddVar("i", I(), Storage::kLocal);
  shader.Append({build.Stmt(For{shader.Stmts({shader.DeclareVar(i)}), {}, {}, build.BlockOf({})})});
  ExpectProblemIn(build.Ref(i), "out of scope here");
}
TEST_F(Verifier, InitialiserDoesNotSeeItsVariable) {
  const VarId x = shader.AddVar("x", F(), Storage::kLocal);
  shader.Append({shader.DeclareVar(x, build.Ref(x))});
  ExpectProblem("not declared here");
}
TEST_F(Verifier, DeclaredTwice) {
  const VarId x = shader.AddVar("x", F(), Storage::kLocal);
  shader.Append({shader.DeclareVar(x), shader.DeclareVar(x)});
  ExpectProblem("declared twice");
}
TEST_F(Verifier, ParameterOfAnotherFunction) {
  const VarId x = shader.AddVar("x", F(), Storage::kIn);
  shader.AddFunction("f", F(), {x}, {});
  ExpectProblemIn(build.Ref(x), "not declared here");
}
TEST_F(Verifier, InputsAreForMainOnly) {
  ExpectProblemIn(build.Ref(shader.position), "not declared here");
}
TEST_F(Verifier, ValuesOfFunctionsAreForAll) {
  const VarId lane = shader.AddVar("lane", shader.types.Make(Scalar::kUint), Storage::kInput);
  shader.inputs.push_back(
      {.var = lane, .semantic = "WaveGetLaneIndex", .builtin = Builtin::kLaneIndex});
  shader.AddFunction("f", shader.types.Make(Scalar::kUint), {}, {shader.Return(build.Ref(lane))});
  EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt);
}
TEST_F(Verifier, GlobalsAreListed) {
  shader.globals.pop_back();
  ExpectProblemIn(build.Ref(shader.table), "not declared here");
}
TEST_F(Verifier, UniformsAreMembers) {
  shader.cbuffers[shader.camera].members.pop_back();
  ExpectProblemIn(build.Ref(shader.scale), "not declared here");
}
TEST_F(Verifier, DeclareOfParameter) {
  shader.Append({shader.DeclareVar(shader.AddVar("x", F(), Storage::kIn))});
  ExpectProblem("only local, constant and static variables");
}
TEST_F(Verifier, InitialiserType) {
  shader.Append({shader.DeclareVar(shader.AddVar("x", F(), Storage::kLocal), build.Int(1))});
  ExpectProblem("the initialiser has the variable's type");
}
TEST_F(Verifier, ConstantHasValue) {
  shader.vars[shader.table].init = {};
  ExpectProblem("a constant has a value");
}
TEST_F(Verifier, GlobalInitialiserHasNoEffect) {
  const VarId x = shader.AddVar("x", F(), Storage::kStatic,
                                build.AssignTo(build.Ref(shader.counter), build.Float(1)));
  shader.globals.push_back(x);
  ExpectProblem("has no effect");
}
TEST_F(Verifier, GlobalStorage) {
  shader.globals.push_back(shader.AddVar("x", F(), Storage::kLocal));
  ExpectProblem("a global is static, shared or a constant");
}

// ---- statements

TEST_F(Verifier, ConditionIsBool) {
  shader.Append({build.Stmt(If{build.Int(1), build.BlockOf({}), {}})});
  ExpectProblem("a condition is a bool scalar");
}
TEST_F(Verifier, BreakOutsideLoop) {
  shader.Append({build.Stmt(Break{})});
  ExpectProblem("break stands in a loop or switch");
}
TEST_F(Verifier, ContinueInSwitchOnly) {
  const std::vector<SwitchCase> arms = {{{}, true, shader.Stmts({build.Stmt(Continue{})})}};
  shader.Append({build.Stmt(
      Switch{build.Int(1), shader.switch_cases.Add(std::span<const SwitchCase>(arms))})});
  ExpectProblem("continue stands in a loop");
}
TEST_F(Verifier, ReturnType) {
  shader.Append({shader.Return(build.Float(1))});
  ExpectProblem("a return has the function's type");
}
TEST_F(Verifier, ReturnWithoutValue) {
  shader.Append({shader.Return({})});
  ExpectProblem("a return has a value exactly where");
}
TEST_F(Verifier, SwitchOverFloat) {
  shader.Append({build.Stmt(Switch{build.Float(1), {}})});
  ExpectProblem("a switch is over an int or uint scalar");
}
TEST_F(Verifier, CaseLabelType) {
  const std::vector<SwitchCase> arms = {{Args({build.Uint(1)}), false, {}}};
  shader.Append({build.Stmt(
      Switch{build.Int(1), shader.switch_cases.Add(std::span<const SwitchCase>(arms))})});
  ExpectProblem("a case label is a literal of the switch's type");
}
TEST_F(Verifier, CaseLabelsDiffer) {
  const std::vector<SwitchCase> arms = {{Args({build.Int(1), build.Int(1)}), false, {}}};
  shader.Append({build.Stmt(
      Switch{build.Int(1), shader.switch_cases.Add(std::span<const SwitchCase>(arms))})});
  ExpectProblem("two case labels are the same");
}
TEST_F(Verifier, OneDefault) {
  const std::vector<SwitchCase> arms = {{{}, true, {}}, {{}, true, {}}};
  shader.Append({build.Stmt(
      Switch{build.Int(1), shader.switch_cases.Add(std::span<const SwitchCase>(arms))})});
  ExpectProblem("a switch has one default");
}
TEST_F(Verifier, ForInit) {
  shader.Append({build.Stmt(For{shader.Stmts({build.BlockOf({})}), {}, {}, build.BlockOf({})})});
  ExpectProblem("a for starts with declarations or one expression");
}
TEST_F(Verifier, BodyIsBlock) {
  shader.functions[shader.entry].body = build.Eval(build.Float(1));
  ExpectProblem("a function's body is a block");
}

}  // namespace
}  // namespace clipc::ir
