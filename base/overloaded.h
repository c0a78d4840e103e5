// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace clipc {

// std::visit(Overloaded{[](const A&) {...}, [](const B&) {...}}, variant): a forgotten alternative does not compile.
template <typename... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <typename... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

}  // namespace clipc
