// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What the shader shares with the pipeline: inputs, outputs, constant buffers and global variables.
#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "backend-spirv/block_fit.h"
#include "backend-spirv/writer.h"
#include "ir/evaluate.h"

namespace clipc::spirv {

using namespace ir;

void Writer::DeclareInputs() {
  for (std::size_t i = 0; i < program_.inputs.size(); ++i) {
    const IoVar& input = program_.inputs[i];
    if (!is_read_[input.var.index]) continue;
    if (per_vertex_.contains(input.var.index) && input.builtin != Builtin::kNone) {
      const Ref type = module_.Type(spv::Op::OpTypeArray, {types_.Of((*this)[input.var].type),
                                                           types_.Uint(VerticesOfInputs())});
      pointers_[input.var.index] = DeclareBuiltin(input.builtin, type);
      storages_[input.var.index] = spv::StorageClass::Input;
      part_indices_[input.var.index].push_back(types_.Int(0));
    } else if (IsArrayInput(input.builtin)) {
      const std::uint32_t factors = FactorCount(input.builtin);
      const Ref type = factors > 0 ? module_.Type(spv::Op::OpTypeArray,
                                                  {types_.Of(Scalar::kFloat), types_.Uint(factors)})
                                   : types_.Of((*this)[input.var].type);
      const Ref variable = DeclareBuiltin(input.builtin, type);
      if (factors > 0) module_.Decorate(variable, spv::Decoration::Patch);
      pointers_[input.var.index] = variable;
      storages_[input.var.index] = spv::StorageClass::Input;
    } else if (input.builtin != Builtin::kNone) {
      builtin_inputs_.emplace(input.var.index, i);
    } else if (!interface_.inputs[i].location) {
      Lack("an input without a location");
    } else {
      DeclareShared(input, interface_.inputs[i], spv::StorageClass::Input);
    }
  }
}

// Drivers write the outputs in the order of their declarations. It costs least if that is the order
// in which the shader writes them, and the position is the last.
std::vector<std::size_t> Writer::OrderOfOutputs() const {
  std::vector<std::size_t> order(program_.outputs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t output) {
    const IoVar& io = program_.outputs[output];
    const auto mention = std::ranges::find(mentioned_outputs_, io.var);
    return std::pair(io.builtin != Builtin::kNone, mention - mentioned_outputs_.begin());
  });
  return order;
}

void Writer::DeclareOutputs() {
  constexpr auto kStorage = spv::StorageClass::Output;
  for (const std::size_t i : OrderOfOutputs()) {
    const IoVar& output = program_.outputs[i];
    const Interface::Variable& place = interface_.outputs[i];
    storages_[output.var.index] = kStorage;
    if (DeclareBuiltinOutput(output, place.name)) continue;
    if (output.reader && output.reader->group)
      DeclareMember(output);
    else if (!place.location)
      Lack("an output without a location");
    else
      DeclareShared(output, place, kStorage);
  }
}

// Runs before the statements of `main`: gives the static variables their first values, and the
// depth that of the primitive, which a path that does not write it has; finds the control point.
void Writer::StartMain() {
  for (const VarId id : late_) Store(PlaceOfVariable(id), Value((*this)[id].init));
  // The outputs are arrays of all control points, of which `main` writes its own.
  const bool makes_patches = InfoOf(program_.stage).makes_patches;
  const Ref point = makes_patches ? LoadBuiltin(Builtin::kControlPointId) : Ref{0};
  for (const IoVar& output : program_.outputs)
    if (IsOfPoint(output)) part_indices_[output.var.index].front() = point;
  for (const IoVar& output : program_.outputs) {
    if (!IsDepth(output.builtin) || !output.may_be_unwritten || output.is_unwritten) continue;
    const Ref place = LoadBuiltin(Builtin::kPixelPosition);
    Store(PlaceOfVariable(output.var), Part(types_.Of(Scalar::kFloat), place, 2));
  }
}

void Writer::DeclareGlobals() {
  for (const VarId id : program_.globals) {
    if (!is_read_[id.index]) continue;
    if ((*this)[id].storage == Storage::kShared)
      DeclareGlobal(id, spv::StorageClass::Workgroup);
    else
      DeclareStatic(id);
  }
}

void Writer::DeclareGlobal(VarId id, spv::StorageClass storage, Ref initial) {
  const Var& var = (*this)[id];
  const Ref variable =
      module_.Variable(types_.Pointer(storage, types_.Of(var.type)), storage, initial);
  module_.Name(variable, var.name);
  Relax(variable, var.type);
  if (module_.minor_version() >= 4) shared_.push_back(variable);
  pointers_[id.index] = variable;
  storages_[id.index] = storage;
}

// A constant that the application may give another value when it makes a pipeline.
Ref Writer::Specialised(VarId id, std::span<const std::uint64_t> bits) {
  const Var& var = (*this)[id];
  const Type& type = program_.types[var.type];
  const Ref of = types_.Of(var.type);
  Ref made = 0;
  if (BaseOf(type.scalar) == Scalar::kBool) {
    made = module_.OwnConstant(
        bits[0] != 0 ? spv::Op::OpSpecConstantTrue : spv::Op::OpSpecConstantFalse, of, {});
  } else if (IsWide(type.scalar)) {
    made = module_.OwnConstant(
        spv::Op::OpSpecConstant, of,
        {static_cast<std::uint32_t>(bits[0]), static_cast<std::uint32_t>(bits[0] >> 32)});
  } else {
    made = module_.OwnConstant(spv::Op::OpSpecConstant, of, {static_cast<std::uint32_t>(bits[0])});
  }
  module_.Name(made, var.name);
  module_.Decorate(made, spv::Decoration::SpecId, {*var.constant_id});
  return made;
}

void Writer::DeclareStatic(VarId id) {
  const Var& var = (*this)[id];
  const auto bits =
      var.init ? ConstantBits(program_, var.init) : std::optional<std::vector<std::uint64_t>>();
  if (var.constant_id && !options_.is_opengl) {
    const std::uint64_t zero[] = {0};
    values_[id.index] = Specialised(id, bits ? std::span<const std::uint64_t>(*bits) : zero);
    return;
  }
  const bool is_constant = !var.init || bits;
  Ref initial = 0;
  if (bits) {
    std::span<const std::uint64_t> left(*bits);
    initial = types_.Value(var.type, left);
  } else if (!var.init) {
    initial = types_.Zero(var.type);
  }
  if (is_constant && !in_memory_[id.index]) {
    values_[id.index] = initial;
    return;
  }
  DeclareGlobal(id, spv::StorageClass::Private, initial);
  if (!is_constant) late_.push_back(id);
}

// The array of so many constant buffers as the type of a ConstantBuffer<T>[2][3] says: of one
// dimension, since Vulkan has no others.
Ref Writer::ArrayOfBuffers(Ref block, TypeId type) {
  std::uint32_t count = 1;
  const Type* of = &program_.types[type];
  if (of->kind != TypeKind::kArray) return block;
  for (; of->kind == TypeKind::kArray; of = &program_.types[of->element]) count *= of->count;
  if (count > 0) return module_.Type(spv::Op::OpTypeArray, {block, types_.Uint(count)});
  module_.Require(spv::Capability::RuntimeDescriptorArray);
  RequireDescriptorIndexing();
  return module_.Type(spv::Op::OpTypeRuntimeArray, {block});
}

void Writer::Bind(Ref variable, const Interface::Place& place) {
  if (!options_.is_opengl) module_.Decorate(variable, spv::Decoration::DescriptorSet, {place.set});
  module_.Decorate(variable, spv::Decoration::Binding, {*place.binding});
}

// Declares the objects and constant buffers that no function has named.
void Writer::DeclareUnread() {
  for (const Interface::Block& block : interface_.blocks) BlockVariable(block.cbuffer);
  for (const Interface::Object& object : interface_.objects) DeclaredOf(object.var, object.sampler);
}

Ref Writer::BlockVariable(CbufferId id) {
  const auto found = blocks_.find(id.index);
  if (found != blocks_.end()) return found->second.variable;
  DeclaredBlock& declared = blocks_[id.index];
  const Cbuffer& cbuffer = program_.cbuffers[id];
  const auto place = std::ranges::find(interface_.blocks, id, &Interface::Block::cbuffer);
  auto kept = FittingMembers(program_, cbuffer, is_read_, module_.minor_version() >= 3);
  if (place == interface_.blocks.end() || !(place->binding || place->is_push_constant))
    return Lack("a constant buffer without a place");
  declared.is_rows = !kept;
  if (kept) declared.kept = std::move(*kept);
  const auto storage =
      cbuffer.is_push_constant ? spv::StorageClass::PushConstant : spv::StorageClass::Uniform;
  Ref type = declared.is_rows ? RowsBlock(cbuffer, place->name)
                              : types_.Block(cbuffer, declared.kept, place->name);
  const bool is_constant_buffer = cbuffer.kind == CbufferKind::kConstantBuffer;
  if (is_constant_buffer) type = ArrayOfBuffers(type, (*this)[cbuffer.members[0].var].type);
  declared.variable = module_.Variable(types_.Pointer(storage, type), storage);
  module_.Name(declared.variable,
               is_constant_buffer ? (*this)[cbuffer.members[0].var].name : cbuffer.name);
  NameType(declared.variable, place->user_type);
  if (!cbuffer.is_push_constant) {
    Bind(declared.variable, *place);
  }
  if (module_.minor_version() >= 4) shared_.push_back(declared.variable);
  return declared.variable;
}

}  // namespace clipc::spirv
