// RUN: %clipc --dump=ast %s | FileCheck %s
// AUTOUPDATE
float4 all(float4 p) {
  float a = 1, b[2] = {1, 2}, c;
  const static float k = 3;
  float4 x = a, y;
  struct Local { float f; };
  Local local = {1}, second;
  struct { float g; } unnamed;
  typedef float3 Three;
  Three three = 0;
  ;
  {
    a = 1;
    { }
  }
  if (a) b = 1;
  if (a) { b = 1; } else b = 2;
  if (a)
    if (b) c = 1;
    else c = 2;
  if (a) x = 1; else if (b) x = 2; else if (c) { x = 3; } else x = 4;
  for (;;) break;
  for (int i = 0, j = 1; i < 4 && j; ++i, j--) { continue; }
  for (i = 0; i < 4; i++);
  while (a > 0) a--;
  do a++; while (a < 4);
  switch (i) {
    case 0:
    case 1 + 1:
      x = 1;
      break;
    default: { x = 2; }
    case a ? 1 : 2: return x;
  }
  discard;
  f(a), g(b);
  return;
  return p;
}
