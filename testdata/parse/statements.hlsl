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

// CHECK: function all : float4
// CHECK-NEXT:   parameter p : float4
// CHECK-NEXT:   block
// CHECK-NEXT:     variable a : float = 1
// CHECK-NEXT:     variable b[2] : float = {1, 2}
// CHECK-NEXT:     variable c : float
// CHECK-NEXT:     variable k : float static const = 3
// CHECK-NEXT:     variable x : float4 = a
// CHECK-NEXT:     variable y : float4
// CHECK-NEXT:     struct Local
// CHECK-NEXT:       field f : float
// CHECK-NEXT:     variable local : Local = {1}
// CHECK-NEXT:     variable second : Local
// CHECK-NEXT:     variable unnamed : <unnamed>
// CHECK-NEXT:       struct <unnamed>
// CHECK-NEXT:         field g : float
// CHECK-NEXT:     typedef Three : float3
// CHECK-NEXT:     variable three : Three = 0
// CHECK-NEXT:     empty
// CHECK-NEXT:     block
// CHECK-NEXT:       expression (a = 1)
// CHECK-NEXT:       block
// CHECK-NEXT:     if a
// CHECK-NEXT:       expression (b = 1)
// CHECK-NEXT:     if a
// CHECK-NEXT:       block
// CHECK-NEXT:         expression (b = 1)
// CHECK-NEXT:     else
// CHECK-NEXT:       expression (b = 2)
// CHECK-NEXT:     if a
// CHECK-NEXT:       if b
// CHECK-NEXT:         expression (c = 1)
// CHECK-NEXT:       else
// CHECK-NEXT:         expression (c = 2)
// CHECK-NEXT:     if a
// CHECK-NEXT:       expression (x = 1)
// CHECK-NEXT:     else
// CHECK-NEXT:       if b
// CHECK-NEXT:         expression (x = 2)
// CHECK-NEXT:       else
// CHECK-NEXT:         if c
// CHECK-NEXT:           block
// CHECK-NEXT:             expression (x = 3)
// CHECK-NEXT:         else
// CHECK-NEXT:           expression (x = 4)
// CHECK-NEXT:     for
// CHECK-NEXT:       break
// CHECK-NEXT:     for
// CHECK-NEXT:       init
// CHECK-NEXT:         variable i : int = 0
// CHECK-NEXT:         variable j : int = 1
// CHECK-NEXT:       while ((i < 4) && j)
// CHECK-NEXT:       step ((++i) , (j--))
// CHECK-NEXT:       block
// CHECK-NEXT:         continue
// CHECK-NEXT:     for
// CHECK-NEXT:       init
// CHECK-NEXT:         expression (i = 0)
// CHECK-NEXT:       while (i < 4)
// CHECK-NEXT:       step (i++)
// CHECK-NEXT:       empty
// CHECK-NEXT:     while (a > 0)
// CHECK-NEXT:       expression (a--)
// CHECK-NEXT:     do
// CHECK-NEXT:       expression (a++)
// CHECK-NEXT:     while (a < 4)
// CHECK-NEXT:     switch i
// CHECK-NEXT:       block
// CHECK-NEXT:         case 0
// CHECK-NEXT:         case (1 + 1)
// CHECK-NEXT:         expression (x = 1)
// CHECK-NEXT:         break
// CHECK-NEXT:         default
// CHECK-NEXT:         block
// CHECK-NEXT:           expression (x = 2)
// CHECK-NEXT:         case (a ? 1 : 2)
// CHECK-NEXT:         return x
// CHECK-NEXT:     discard
// CHECK-NEXT:     expression (f(a) , g(b))
// CHECK-NEXT:     return
// CHECK-NEXT:     return p
