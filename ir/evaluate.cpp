// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/evaluate.h"

#include <algorithm>
#include <utility>

#include "ir/evaluate_machine.h"
#include "ir/packing.h"
#include "ir/scalar.h"

namespace clipc::ir {
Machine::Machine(const Program& program, const EvalInputs& inputs, const EvalOptions& options,
                 Neighbours* neighbours, GroupThread* thread)
    : program_(program),
      inputs_(inputs),
      options_(options),
      neighbours_(neighbours),
      thread_(thread) {}

EvalResult Machine::Run() {
  if (inputs_.start) inputs_.start();
  if (!Prepare())
    return {.outputs = {}, .error = "the program's variables are too large to evaluate"};
  for (CbufferId id : program_.cbuffers.ids()) LoadCbuffer(id);
  for (std::size_t i = 0; i < program_.inputs.size() && i < inputs_.values.size(); ++i) {
    LoadInput(program_.inputs[i], inputs_.values[i]);
  }
  InitialiseGlobals();
  CallFunction(program_.main, stack_.size());
  return {.outputs = ReadOutputs(), .vertices = std::move(vertices_), .error = error_};
}

bool Machine::Prepare() {
  std::uint64_t end = 0;
  address_.resize(program_.vars.size());
  for (const bool is_shared : {true, false}) {
    for (VarId id : program_.vars.ids()) {
      if ((program_.vars[id].storage == Storage::kShared) != is_shared) continue;
      address_[id.index] = static_cast<std::uint32_t>(end);
      end += WordsOf(program_.vars[id].type);
      if (end > kMaxWords) return false;
    }
    if (is_shared) shared_words_ = static_cast<std::uint32_t>(end);
  }
  for (ExprId id : program_.exprs.ids()) {
    if (WordsOf(id) > kMaxWords) return false;
  }
  memory_.assign(end, 0);
  for (const IoVar& io : program_.outputs) SetUndefined(io.var);
  for (const VarId id : program_.globals)
    if (program_.vars[id].storage == Storage::kShared) SetUndefined(id);
  if (thread_) thread_->Start(std::span(memory_).first(shared_words_));
  for (const Resource& resource : program_.resources) {
    const std::uint32_t address = address_[resource.var.index];
    for (std::uint32_t i = 0; i < WordsOf(program_.vars[resource.var].type); ++i) {
      memory_[address + i] = Word{resource.var.index} << 32 | i;
    }
  }
  return true;
}

// ---- cbuffers, inputs and outputs

void Machine::LoadCbuffer(CbufferId id) {
  static const std::vector<std::uint8_t> kNoBytes;
  const Cbuffer& buffer = program_.cbuffers[id];
  const auto& bytes = id.index < inputs_.cbuffers.size() ? inputs_.cbuffers[id.index] : kNoBytes;
  for (const CbufferMember& member : buffer.members) {
    const Var& var = program_.vars[member.var];
    Word* to = memory_.data() + address_[member.var.index];
    const bool is_constant_buffer = buffer.kind == CbufferKind::kConstantBuffer;
    const TypeId type = is_constant_buffer ? program_.types.Innermost(var.type) : var.type;
    for (std::uint32_t element = 0; element < buffer.count; ++element) {
      Unpack(bytes, std::uint64_t{element} * buffer.size + member.offset, type, var.row_major, to);
    }
  }
}

void Machine::Unpack(const std::vector<std::uint8_t>& bytes, std::uint64_t offset, TypeId id,
                     bool row_major, Word*& to) {
  const Type& type = program_.types[id];
  if (type.kind == TypeKind::kMatrix) return UnpackMatrix(bytes, offset, type, row_major, to);
  if (type.kind == TypeKind::kArray) {
    const std::uint64_t stride = ArrayStride(program_.types, id, row_major);
    for (std::uint32_t i = 0; i < type.count; ++i)
      Unpack(bytes, offset + i * stride, type.element, row_major, to);
    return;
  }
  if (type.kind == TypeKind::kStruct) {
    const auto& fields = program_.types[type.structure].fields;
    for (std::uint32_t i = 0; i < fields.size(); ++i) {
      const std::uint32_t field = FieldOffset(program_.types, type.structure, i);
      Unpack(bytes, offset + field, fields[i].type, fields[i].row_major, to);
    }
    return;
  }
  if (type.kind == TypeKind::kObject) return void(++to);
  const std::uint64_t size = ByteSize(type.scalar);
  for (std::uint32_t i = 0; i < type.Components(); ++i)
    *to++ = UnpackComponent(bytes, offset + i * size, type.scalar);
}

void Machine::UnpackMatrix(const std::vector<std::uint8_t>& bytes, std::uint64_t offset,
                           const Type& type, bool row_major, Word*& to) {
  const std::uint32_t size = ByteSize(type.scalar);
  const std::uint32_t length = row_major ? type.columns : type.rows;
  const std::uint32_t stride = (length * size + 15) / 16 * 16;
  for (std::uint32_t row = 0; row < type.rows; ++row) {
    for (std::uint32_t column = 0; column < type.columns; ++column) {
      const std::uint32_t place =
          row_major ? row * stride + column * size : column * stride + row * size;
      *to++ = UnpackComponent(bytes, offset + place, type.scalar);
    }
  }
}

Word Machine::UnpackComponent(const std::vector<std::uint8_t>& bytes, std::uint64_t offset,
                              Scalar kind) const {
  Word bits = 0;
  for (std::uint64_t i = 0; i < ByteSize(kind); ++i) {
    if (offset + i < bytes.size()) bits |= Word{bytes[offset + i]} << (8 * i);
  }
  if (kind == Scalar::kBool) return bits != 0 ? 1 : 0;
  return FromBits(bits, kind);
}

void Machine::LoadInput(const IoVar& io, const IoBits& bits) {
  const std::vector<Scalar> kinds = KindsOf(program_.types, program_.vars[io.var].type);
  Word* to = memory_.data() + address_[io.var.index];
  for (std::size_t i = 0; i < kinds.size() && i < bits.size(); ++i)
    to[i] = FromBits(bits[i], kinds[i]);
}

EvalOutputs Machine::ReadOutputs() const {
  EvalOutputs outputs;
  for (const IoVar& io : program_.outputs) {
    IoBits bits{};
    IoNumbers numbers{};
    const std::vector<Scalar> kinds = KindsOf(program_.types, program_.vars[io.var].type);
    const Word* from = memory_.data() + address_[io.var.index];
    for (std::size_t i = 0; i < kinds.size() && i < bits.size(); ++i) {
      bits[i] = ToBits(from[i], kinds[i]);
      numbers[i] = NumberOf(from[i], RepOf(kinds[i]));
    }
    outputs.values.push_back(bits);
    outputs.numbers.push_back(numbers);
  }
  outputs.wrote_out_of_bounds = wrote_out_of_bounds_;
  outputs.is_discarded = is_discarded_;
  return outputs;
}

// Initialises the globals in their order, then the variables that are declared inside functions and
// have a value before they run.
void Machine::InitialiseGlobals() {
  for (VarId var : program_.globals) Initialise(var);
  std::vector<bool> is_global(program_.vars.size(), false);
  for (VarId var : program_.globals) is_global[var.index] = true;
  for (VarId var : program_.vars.ids()) {
    const Storage storage = program_.vars[var].storage;
    if (!is_global[var.index] && (storage == Storage::kConstant || storage == Storage::kStatic))
      Initialise(var);
  }
}

void Machine::Initialise(VarId var) {
  if (const ExprId init = program_.vars[var].init) EvalInto(init, address_[var.index]);
}

// ---- how values lie in words

Scalar Machine::RepOf(Scalar kind) const {
  const Scalar base = BaseOf(kind);
  return base == Scalar::kFloat && options_.in_double ? Scalar::kDouble : base;
}

Word Machine::FromBits(Word bits, Scalar kind) const {
  return ConvertBits(bits, BaseOf(kind), RepOf(kind));
}
Word Machine::ToBits(Word word, Scalar kind) const {
  return ConvertBits(word, RepOf(kind), BaseOf(kind));
}

Word Machine::UndefinedOf(Scalar kind, std::size_t component, bool negated) const {
  const double value =
      (negated ? -options_.undefined : options_.undefined) * static_cast<double>(component + 1);
  return ConvertBits(BitsOf(value), Scalar::kDouble, RepOf(kind));
}

// The sign of an undefined value is a bit of a hash of EvalOptions::undefined and of the number of
// such values read before, so that the sign of a product of two is not fixed. The first keeps its
// sign.
bool Machine::NextUndefinedIsNegated() {
  const std::uint64_t hash =
      (BitsOf(options_.undefined) ^ 0x9e3779b97f4a7c15u * undefined_reads_) * 0xbf58476d1ce4e5b9u;
  return undefined_reads_++ != 0 && hash >> 63 != 0;
}

void Machine::SetUndefined(VarId var) {
  const auto to = memory_.begin() + address_[var.index];
  const TypeId type = program_.vars[var].type;
  if (options_.undefined == 0) {
    std::fill_n(to, WordsOf(type), 0);
    return;
  }
  const std::vector<Scalar> kinds = KindsOf(program_.types, type);
  for (std::size_t i = 0; i < kinds.size(); ++i)
    to[static_cast<std::ptrdiff_t>(i)] = UndefinedOf(kinds[i], i, false);
}

std::uint32_t Machine::WordsOf(TypeId id) {
  const Type& type = program_.types[id];
  if (type.IsNumeric()) return type.Components();
  if (type.kind == TypeKind::kObject) return 1;
  if (type.kind != TypeKind::kArray && type.kind != TypeKind::kStruct) return 0;
  if (id.index >= aggregate_words_.size()) aggregate_words_.resize(id.index + 1, 0);
  if (aggregate_words_[id.index] != 0) return aggregate_words_[id.index];
  std::uint64_t words = 0;
  if (type.kind == TypeKind::kArray) {
    words = std::uint64_t{type.count} * WordsOf(type.element);
  } else {
    for (const Field& field : program_.types[type.structure].fields) words += WordsOf(field.type);
  }
  return aggregate_words_[id.index] =
             static_cast<std::uint32_t>(std::min<std::uint64_t>(words, kMaxWords + 1));
}

std::uint32_t Machine::FieldWord(StructId id, std::uint32_t field) {
  if (id.index >= field_words_.size()) field_words_.resize(id.index + 1);
  if (field_words_[id.index].empty()) {
    std::vector<std::uint32_t> offsets;
    std::uint32_t end = 0;
    for (const Field& each : program_.types[id].fields) {
      offsets.push_back(end);
      end += WordsOf(each.type);
    }
    field_words_[id.index] = std::move(offsets);
  }
  return field_words_[id.index][field];
}

std::vector<Word> Machine::Value(ExprId expr) {
  if (!Prepare()) return {};
  InitialiseGlobals();
  Eval(expr);
  return std::move(stack_);
}

EvalResult RunMain(const Program& program, const EvalInputs& inputs, const EvalOptions& options) {
  return Machine(program, inputs, options).Run();
}

PatchResult RunPatch(const Program& program, const EvalInputs& inputs, const EvalOptions& options) {
  const std::uint32_t count = program.tessellation.output_points;
  EvalInputs of_point = inputs;
  of_point.values.resize(program.inputs.size());
  of_point.points.assign(count, {});
  for (std::uint32_t i = count; i-- > 0;) {
    of_point.point = i;
    for (std::size_t k = 0; k < program.inputs.size(); ++k) {
      if (program.inputs[k].builtin == Builtin::kControlPointId) of_point.values[k][0] = i;
    }
    EvalResult result = Machine(program, of_point, options).Run();
    if (!result) return {{}, result.error};
    of_point.points[i] = std::move(result.outputs);
  }
  return {std::move(of_point.points)};
}

}  // namespace clipc::ir
