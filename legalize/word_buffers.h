// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "legalize/legalizer.h"

// Structured buffers of words, which take the place of buffers whose bytes a target cannot name
// otherwise. What the shader does with such a buffer becomes calls of functions of the buffer
// (Function::is_accessor).
namespace clipc::legalize {

// Makes a buffer of words of each resource that `chosen` accepts, which keeps its type in
// Resource::declared_type, and calls lower(expression, call, buffer) for each call of one.
void MakeWordBuffers(Legalizer& legalizer,
                     const std::function<bool(const ir::Resource& resource)>& chosen,
                     const std::function<void(ir::ExprId expr, const ir::ObjectCall& call,
                                              ir::VarId buffer)>& lower);

// The structured buffers with floats that atomic operations change. GLSL has such operations of
// integers only.
std::set<ir::VarId> BuffersOfExchangedFloats(const ir::Program& program);

// The expressions of statements, whose values nothing reads.
std::set<ir::ExprId> ExpressionsAlone(const ir::Program& program);

// Gives a path of indices the type that the variable at its begin has now.
void Retype(ir::Program& program, ir::ExprId path);

// A function of a buffer that is about to be called: its parameters and their arguments.
class AccessorCall {
 public:
  // The call stands in place of `call` of the buffer at `expr`. Where the buffer is one of an
  // array, its place there is the first parameter.
  AccessorCall(Legalizer& legalizer, ir::ExprId expr, const ir::ObjectCall& call);

  void Pass(std::string_view name, ir::ExprId argument);
  void PassInt(std::string_view name, ir::ExprId argument);  // converted to int
  const std::vector<Parameter>& parameters() const { return parameters_; }
  // Whether the place in an array of buffers differs between invocations.
  bool is_marked() const { return is_marked_; }
  // The beginning of the function's name.
  std::string Name() const;

  // In a function with these parameters: the load of a word, and the store of one.
  ir::ExprId Load(HelperBody& body, ir::ExprId number) const;
  void Store(HelperBody& body, ir::ExprId number, ir::ExprId word) const;
  // The word that was there, in the place of which `word` is if it was `comparand`.
  ir::ExprId CompareExchange(HelperBody& body, ir::ExprId number, ir::ExprId comparand,
                             ir::ExprId word) const;

  // Makes the expression a call of `function`; of none, of a new one that `define` writes.
  void Become(ir::FunctionId& function, std::string_view name, ir::TypeId result,
              const Define& define);

 private:
  ir::ExprId Object(HelperBody& body) const;

  Legalizer& legalizer_;
  ir::ExprId expr_;
  ir::VarId buffer_;
  std::vector<ir::ExprId> arguments_;
  std::vector<Parameter> parameters_;
  bool is_element_ = false, is_marked_ = false;
};

}  // namespace clipc::legalize
