// Where every path returns, nothing is missing at the end.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 -E main
// RUN: %draw compare %s -T vs_5_0 -E at_once --target glsl120,essl100
float branches(float x) { if (x > 1) return 1; else if (x > 0) { return 2; } else return 3; }
float forever(float x) { while (true) { x += 1; if (x > 9) return x; } }
float also_forever(float x) { for (;;) { x += 1; if (x > 9) return x; } }
float at_least_once(float x) { do { return x; } while (x > 0); }
float cases(int x) { switch (x) { case 0: return 1; case 1: default: return 2; } }
static const int kOne = 1;
float always(float x) { if (1) return x; }
float always_known(float x) { if (kOne < 2) { x += 1; return x; } else x = 3; }
float otherwise(float x) { if (false) x = 4; else return x + 5; }
float4 at_once(float4 position : POSITION) : SV_Position { if (true) return position * otherwise(2); }
// CHECK: main
float4 main(float4 position : POSITION) : SV_Position {
  return branches(1) + forever(1) + also_forever(1) + at_least_once(1) + cases(1) + always(position.x) +
         always_known(position.y) + otherwise(position.z);
}
