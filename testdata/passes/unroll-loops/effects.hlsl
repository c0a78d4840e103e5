// Values are known between other uses of their variables: in calls that write them, in parts of them, and where a branch may skip them.
// RUN: %clipc %s -T vs_5_0 --target=webgl1 --validate --verify -o %t.vert
// RUN: %clipc %s -T vs_6_0 --target=webgl1 --validate --verify -o %t.vert
// RUN: %draw compare %s -T vs_5_0 --target essl100,glsl450 --ints 0..9
// RUN: %draw compare %s -T vs_6_0 --target essl100,glsl450 --ints 0..9
void Step(inout int n, out int old) {
  old = n;
  n += 2;
}
float Sum(int2 n, float x) {
  int m = n.x, old = 1;
  for (int i = 0, j = 5; i < j; i++, j--) {
    Step(m, old);
    x += old + m * i;
    m = j;
    Step(m, n.y);
    x -= m;
    m -= 3;
  }
  n.x += m;
  return x + n.x + n.y;
}
float4 main(float4 p : P, int4 q : Q) : SV_Position {
  int i = 3;
  int2 v = int2(0, 4);
  while (v.x < v.y) {
    v += int2(1, 0);
    p.x += v.x;
    int2 part = v;
    part.x = q.x;
    part[1]++;
    p.y += part.x * part.y;
  }
  int n = 0;
  for (int step = 0, other = 2; step < other; ++step, other += 0) {
    int before = p.x > 0 ? n++ : ++n;
    p.y += before;
    bool both = p.x > 1 && n++ > 1;
    p.z += both ? n : 0;
    if (p.y > 2) n = q.y;
    p.w += n;
    n = step;
    n += n++ + step;
    if (p.x > 3) n += q.z;
    p.x -= n;
    i += n = 2;
    if (p.z < 0) return p * i;
  }
  static int s = 2;
  int m = 0;
  while (m < 3) {
    int w = m;
    w += w++ + m;
    p.w += w;
    m++;
    s = m + i;
    p.x += s;
    if (m == 2) {
      i++;
    } else if (p.y > 1) {
      i += 2;
    }
  }
  for (int a = 0, b = 4; a != b; a += 2, b += 1)
    if (a >= 6) break;
    else p.y += a;
  int table[4] = { 3, 1, 0, 2 };
  int at = 0;
  while (at < 3) {
    p.x += table[at];
    if (p.y > 0) table[1] = at;
    p.y -= table[1] * 2;
    table[at] += 1;
    p.z += table[q.x > 3 ? 3 : at];
    at++;
  }
  return p + Sum(int2(m, 7), p.z) + Sum(int2(0, 1), p.y) + Sum(q.xy, 0.5) + i;
}
