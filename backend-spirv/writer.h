// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "backend-spirv/emitter.h"
#include "backend-spirv/place.h"
#include "ir/access.h"

namespace clipc::spirv {

// The writing of one module. Its functions are spread over the files of this folder by subject;
// each writes instructions into the current block of the current function, and returns the result.
class Writer : private Emitter {
 public:
  Writer(const ir::Program& program, const Interface& interface, const Options& options);
  Written Run();

 private:
  friend class TextureRead;
  friend class RowReader;

  // ---- interface.cpp: what the shader shares with the pipeline
  void DeclareInputs();
  std::vector<std::size_t> OrderOfOutputs() const;
  std::uint32_t VerticesOfInputs() const;
  bool IsOfPoint(const ir::IoVar& output) const;
  Ref OfPoints(Ref type);
  void DeclareOutputs();
  void DeclareGlobals();
  void DeclareStatic(ir::VarId id);
  void SpecialiseGroup();
  void DeclareGlobal(ir::VarId id, spv::StorageClass storage, Ref initial = 0);
  Ref Specialised(ir::VarId id, std::span<const std::uint64_t> bits);
  void StartMain();
  Ref BlockVariable(ir::CbufferId id);
  void DeclareUnread();
  void Bind(Ref variable, const Interface::Place& place);
  Ref ArrayOfBuffers(Ref block, ir::TypeId type);

  // ---- builtins.cpp
  Ref BuiltinVariable(spv::BuiltIn of, spv::StorageClass as, Ref type, std::string_view name);
  Ref DeclareBuiltin(ir::Builtin input, Ref type);
  bool DeclareBuiltinOutput(const ir::IoVar& output, std::string_view name);
  Ref LoadBuiltin(ir::Builtin input);
  Ref ReadBuiltin(std::size_t number);
  void NameInput(const ir::IoVar& input);

  // ---- parts.cpp
  void RequireBarycentrics();
  void DeclareShared(const ir::IoVar& io, const Interface::Variable& place, spv::StorageClass as);
  void DeclareMember(const ir::IoVar& output);
  void NameSemantic(Ref variable, const ir::IoVar& io);
  void NameType(Ref variable, std::string_view name);
  Ref DeclareGroup(const ir::OutputGroup& group);

  // ---- places.cpp: paths in memory
  void FindMemory(ir::FunctionId id);
  void FindMemoryOf(ir::ExprId expr);
  bool HasPlace(ir::ExprId path) const;
  Place PlaceOf(ir::ExprId path);
  Place PlaceOfVariable(ir::VarId id);
  Ref PointerTo(const Place& place);
  Ref Load(const Place& place);
  Ref LoadBuffer(const Place& place);
  void ChooseBuffer(Place& place, Ref index);
  void Store(const Place& place, Ref value);
  Ref Recast(Ref value, ir::TypeId type, bool row_major, Layout from, Layout to);
  Place NewLocal(ir::TypeId type, std::string_view name = {});
  bool IsOnlyElement(const ir::Index& node) const;

  // ---- long_arrays.cpp
  bool IsLong(ir::TypeId type) const;
  Place PlaceOfField(Place place, std::uint32_t number);
  Place PlaceOfElement(Place place, Ref number);
  Ref LoadLong(const Place& place);
  void StoreElement(const Place& place, Ref value);

  // ---- rows.cpp
  Ref RowsBlock(const ir::Cbuffer& cbuffer, std::string_view name);
  void MoveInRows(Place& place, ir::ExprId index, std::uint32_t bytes);
  void StepInRows(Place& place, Ref index, std::uint32_t bytes);
  void ElementInRows(Place& place, ir::ExprId index);
  Ref LoadInRows(const Place& place);

  // ---- precise.cpp
  void FindPrecise();

  // ---- relaxed.cpp
  void Relax(Ref of, ir::TypeId type);
  void RelaxResult(Ref value, ir::TypeId type);

  // ---- flow.cpp: functions and statements
  struct Loop {
    Ref merge = 0, next = 0;  // of a switch, `next` is that of the loop around it
  };
  void WriteFunction(ir::FunctionId id);
  void WriteStatements(std::span<const ir::StmtId> list);
  void WriteStatement(ir::StmtId id);
  void WriteDeclare(const ir::Declare& node);
  void WriteIf(const ir::If& node, ir::Hint hint);
  void WriteLoop(ir::ExprId condition, ir::ExprId step, ir::StmtId body, bool asks_first,
                 ir::Hint hint);
  void WriteSwitch(const ir::Switch& node, ir::Hint hint);
  void WriteReturn(const ir::Return& node);
  void WriteDiscard();
  Ref FunctionRef(ir::FunctionId id);

  // ---- expr.cpp: values
  Ref Value(ir::ExprId id);
  Ref ValueOf(ir::ExprId id, const ir::Expr& expr);
  Ref ReadPath(ir::ExprId id);
  Ref Element(ir::ExprId id, const ir::Index& node);
  Ref Components(Ref value, const Shape& shape, std::span<const std::uint8_t> components);
  Ref MatrixComponents(ir::ExprId id, const ir::MatrixSwizzle& node);
  Ref Construct(ir::TypeId type, std::span<const ir::ExprId> arguments);
  Ref Truncated(const ir::Type& type, ir::ExprId operand);
  Ref Assigned(const ir::Assign& node);
  Ref Called(const ir::Call& node);
  Ref Chosen(ir::TypeId type, ir::ExprId condition, ir::ExprId when_true, ir::ExprId when_false);
  bool IsTrivial(ir::ExprId id) const;

  // ---- operators.cpp
  Ref Operate(ir::UnaryOp op, ir::ExprId operand);
  Ref Increment(ir::UnaryOp op, ir::ExprId operand);
  Ref Operate(ir::BinaryOp op, ir::ExprId left, ir::ExprId right);
  Ref Combine(ir::BinaryOp op, const Shape& shape, Ref left, Ref right);
  Ref ShortCircuit(bool is_and, ir::ExprId left, ir::ExprId right);
  Ref Converted(Ref value, const Shape& from, ir::Scalar to);
  Ref Splat(const Shape& shape, Ref scalar);
  template <typename Make>
  Ref ByRows(const Shape& shape, Make&& make);

  // ---- intrinsics.cpp
  Ref Intrinsic(ir::TypeId type, const ir::IntrinsicCall& node);
  Ref FromSet(const ExtendedFunction& function, bool is_sign, const Evaluated& of);
  Ref OfNumbers(ir::Intrinsic op, const Evaluated& of);
  Ref OfBits(ir::Intrinsic op, const Evaluated& of);
  Ref Product(ir::ExprId left, ir::ExprId right, const Shape& result);
  Ref Extended(std::uint32_t function, Ref type, std::initializer_list<Ref> arguments);
  Ref Minimum(const Shape& shape, Ref a, Ref b);
  Ref Maximum(const Shape& shape, Ref a, Ref b);
  Ref Clamped(const Shape& shape, Ref value, Ref low, Ref high);
  Ref Saturated(const Shape& shape, Ref value);
  Ref Derivative(ir::Intrinsic op, const Shape& shape, Ref value);
  Ref Writing(const ir::IntrinsicCall& node);
  Ref WordsOf(const ir::IntrinsicCall& node);
  Ref OrderMemory(ir::Intrinsic op);

  // ---- waves.cpp, interpolants.cpp
  Ref Vertices(const ir::IntrinsicCall& node);
  Ref Wave(ir::TypeId type, const ir::IntrinsicCall& node);
  Ref OfWave(spv::Op op, spv::Capability can, Ref type, std::initializer_list<Ref> operands);
  Ref FromQuad(Ref type, Ref value, ir::ExprId lane);
  Ref Interpolant(const ir::IntrinsicCall& node);

  // ---- objects.cpp: textures, samplers and buffers
  Ref ObjectCall(ir::TypeId type, const ir::ObjectCall& node);
  const DeclaredObject& DeclaredOf(ir::VarId id, ir::VarId sampler = {});
  const Interface::Object* PlaceOfObject(ir::VarId id, ir::VarId sampler) const;
  Ref Object(ir::ExprId path, ir::ExprId sampler = {});
  Ref ObjectPointer(ir::ExprId path, ir::ExprId sampler = {});
  std::vector<Ref> IndicesOf(ir::ExprId path);
  bool IsNonUniform(ir::ExprId path) const;
  Ref Marked(Ref value, bool is_non_uniform);
  void RequireNonUniform(spv::Capability capability);
  Shape FourTexels(const ir::Type& object) const;
  Ref ImageType(const ir::Type& object, std::string_view format = {}, bool is_shadow = false);
  Ref ObjectType(ir::TypeId type, const Interface::Object& place);
  void RequireDescriptorIndexing();
  bool HasStorageClass() const { return module_.minor_version() >= 3; }  // of storage buffers

  // ---- images.cpp: textures and typed buffers that are written
  Ref ImageCall(ir::TypeId type, const ir::ObjectCall& node);
  Ref ImagePointer(const ir::ObjectCall& node);
  Ref SubpassLoad(ir::TypeId type, const ir::ObjectCall& node);

  // ---- buffers.cpp: structured buffers
  Ref BufferBlock(const ir::Type& buffer, const Interface::Object& place);
  Ref BufferCall(ir::TypeId type, const ir::ObjectCall& node);
  Place ElementPlace(const ir::ObjectCall& node);
  StoredPart PartAlong(const ir::ObjectCall& node);
  void StoreInBuffer(const ir::ObjectCall& node);
  Ref ComponentPointer(const StoredPart& part, std::uint32_t number);
  Ref BufferLength(ir::TypeId type, ir::ExprId object);
  Ref Atomic(const ir::ObjectCall& node, Ref pointer);
  Ref Atomic(const ir::IntrinsicCall& node);
  Ref AtomicOfWord(ir::ObjectOp op, Ref pointer, ir::ExprId value);
  Ref Atomic(ir::ObjectOp op, Ref pointer, spv::Scope by, ir::ExprId comparand, ir::ExprId value);

  const ir::Expr& operator[](ir::ExprId id) const { return program_.exprs[id]; }
  const ir::Var& operator[](ir::VarId id) const { return program_.vars[id]; }
  const ir::Type& TypeAt(ir::ExprId id) const { return program_.types[program_.exprs[id].type]; }
  Shape ShapeAt(ir::ExprId id) const { return ShapeOf(TypeAt(id)); }
  std::span<const ir::ExprId> operator[](List<ir::ExprId> list) const {
    return program_.expr_lists[list];
  }
  template <typename Node>
  const Node* As(auto id) const {
    return ir::As<Node>(program_, id);
  }
  bool IsPixelShader() const { return program_.stage == Stage::kPixel; }

  const Interface& interface_;
  // By VarId: the value of a variable that is never changed; the pointer to another.
  std::vector<Ref> values_, pointers_;
  std::vector<spv::StorageClass> storages_;
  std::vector<bool> in_memory_;  // by VarId: it is changed, or an index chooses a part of it
  std::vector<bool> is_read_;    // by VarId: a function mentions it
  std::vector<ir::VarId> mentioned_outputs_;             // in the order in which functions do
  std::vector<bool> is_precise_var_;                     // by VarId
  std::map<std::uint32_t, std::size_t> builtin_inputs_;  // by VarId: the number among the inputs
  // By VarId: the path to an input or output that is a part of a variable.
  std::map<std::uint32_t, std::vector<Ref>> part_indices_;
  std::map<std::pair<spv::StorageClass, std::uint32_t>, Ref> wholes_;  // of parts, by location
  std::map<std::size_t, Ref> group_variables_;     // by the number of the output group
  std::set<Ref> described_;                        // the variables that have semantics
  std::set<std::uint32_t> per_vertex_;             // by VarId: inputs that are read at each vertex
  std::map<std::uint32_t, DeclaredBlock> blocks_;  // by CbufferId
  // By the VarIds of the object and of its sampler.
  std::map<std::pair<std::uint32_t, std::uint32_t>, DeclaredObject> objects_;
  std::map<std::pair<spv::BuiltIn, spv::StorageClass>, Ref> builtins_;
  std::vector<Ref> shared_;                // the variables that the entry point lists
  std::vector<ir::FunctionId> functions_;  // that `main` reaches, in the order of their first call
  std::map<std::uint32_t, Ref> function_refs_;
  bool has_order_ = false;       // objects are accessed in the order of the primitives
  std::vector<ir::VarId> late_;  // static variables whose value `main` computes

  bool in_main_ = false;
  std::vector<Loop> loops_;
  Ref judged_ = 0;  // the value of the last expression
};

}  // namespace clipc::spirv
