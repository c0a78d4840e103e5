// RUN: %clipc --dump=ast %s | FileCheck %s
// AUTOUPDATE
// Precedence and associativity of every operator; parentheses leave no node.
void operators() {
  x = a + b * c - d / e % f;
  x = a << 1 + b >> 2;
  x = a < b == c > d != e <= f;
  x = a & b ^ c | d;
  x = a && b || c && d;
  x = a == b & c;
  x = -a * !b + ~c - +d;
  x = (a + b) * (c - (d));
  a = b += c -= d *= e /= f %= g;
  a &= b |= c ^= d <<= e >>= f;
  x = a ? b : c ? d : e;
  x = a ? b ? c : d : e;
  x = a ? (b, c) : d = e;
  a = b, c = d;
  ++a.x, --b[1], a.x++, b[1]--;
  x = - -a - -b;
}
void postfix() {
  x = m[1][2].xyz._m00_m11;
  x = f(a, g(b), c).r[d](e);
  x = t.Sample(s, uv.xy).rgb;
  x = (a + b).x;
  x = 1.5.xxx + 2.xx;
  x = array[i, j];
  x = ::a + b::c::d;
}
void literals() {
  x = 1 + 2u + 0x1F + 010 + 1l + 2ul;
  x = 1.0 + .5 + 1. + 2e3 + 1.5f + 2.5h + 3.5L;
  x = true + false;
  s = "one" " two";
}
float4 lists[2] = {{1, 2, 3, 4}, float4(5, 6, 7, 8),};

// CHECK: function operators : void
// CHECK-NEXT:   block
// CHECK-NEXT:     expression (x = ((a + (b * c)) - ((d / e) % f)))
// CHECK-NEXT:     expression (x = ((a << (1 + b)) >> 2))
// CHECK-NEXT:     expression (x = (((a < b) == (c > d)) != (e <= f)))
// CHECK-NEXT:     expression (x = (((a & b) ^ c) | d))
// CHECK-NEXT:     expression (x = ((a && b) || (c && d)))
// CHECK-NEXT:     expression (x = ((a == b) & c))
// CHECK-NEXT:     expression (x = ((((-a) * (!b)) + (~c)) - (+d)))
// CHECK-NEXT:     expression (x = ((a + b) * (c - d)))
// CHECK-NEXT:     expression (a = (b += (c -= (d *= (e /= (f %= g))))))
// CHECK-NEXT:     expression (a &= (b |= (c ^= (d <<= (e >>= f)))))
// CHECK-NEXT:     expression (x = (a ? b : (c ? d : e)))
// CHECK-NEXT:     expression (x = (a ? (b ? c : d) : e))
// CHECK-NEXT:     expression (x = (a ? (b , c) : (d = e)))
// CHECK-NEXT:     expression ((a = b) , (c = d))
// CHECK-NEXT:     expression ((((++a.x) , (--b[1])) , (a.x++)) , (b[1]--))
// CHECK-NEXT:     expression (x = ((-(-a)) - (-b)))
// CHECK-NEXT: function postfix : void
// CHECK-NEXT:   block
// CHECK-NEXT:     expression (x = m[1][2].xyz._m00_m11)
// CHECK-NEXT:     expression (x = f(a, g(b), c).r[d](e))
// CHECK-NEXT:     expression (x = t.Sample(s, uv.xy).rgb)
// CHECK-NEXT:     expression (x = (a + b).x)
// CHECK-NEXT:     expression (x = (1.5.xxx + 2.xx))
// CHECK-NEXT:     expression (x = array[(i , j)])
// CHECK-NEXT:     expression (x = (::a + b::c::d))
// CHECK-NEXT: function literals : void
// CHECK-NEXT:   block
// CHECK-NEXT:     expression (x = (((((1 + 2u) + 31) + 8) + 1) + 2u))
// CHECK-NEXT:     expression (x = ((((((1.0 + 0.5) + 1.0) + 2000.0) + 1.5) + 2.5h) + 3.5L))
// CHECK-NEXT:     expression (x = (true + false))
// CHECK-NEXT:     expression (s = "one two")
// CHECK-NEXT: variable lists[2] : float4 = {{\{\{}}1, 2, 3, 4}, float4(5, 6, 7, 8)}
