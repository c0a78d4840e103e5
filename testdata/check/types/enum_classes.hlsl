// Values of an enum class are compared, chosen, assigned and passed as values of that class, and cast to numbers and back.
// RUN: %clipc -T vs_6_0 --target=glsl450 --validate %s 2>%t.messages -o - | FileCheck %s
// RUN: count 0 < %t.messages
enum class Mode { Lit, Flat, Far = 7 };
struct Settings {
  Mode mode;
  Mode others[2];
};
static const Mode kFirst = Mode::Flat;
cbuffer Frame {
  Mode current;
  Settings settings;
}
Mode Next(Mode mode) { return (Mode)((int)mode + 1); }
Mode Same(Mode mode) { return mode; }
template<typename T> T Through(T value) {
  T copy = value;
  return copy;
}
float4 main(float4 p : POSITION, int number : NUMBER) : SV_Position {
  Settings s;
  s.mode = Mode::Lit;
  s.others[0] = Mode::Flat;
  s.others[1] = s.mode;
  Mode mode = Through(Same(Next(s.mode)));
  // CHECK: if ({{.*}} == 1
  if (mode == Mode::Flat && current != Mode::Far || settings.mode == kFirst) mode = number > 2 ? Mode::Lit : Mode::Far;
  int n = (int)mode;
  n += int(Mode::Flat) + int(uint(s.others[1]));
  Mode made = (Mode)number, called = Mode(number);
  uint bits = number;
  made = (Mode)bits, called = (Mode)7u;
  if (made == (Mode)bits) called = Mode(bits);
  switch (mode) {
    case Mode::Lit: n *= 3; break;
    default: break;
  }
  return p * n + int(made) + int(called) * int(Through(Mode::Far));
}
// RUN: %draw compare %s -T vs_6_0
