// RUN: not %clipc -T vs_6_6 %s -o %t 2>&1 | FileCheck %s
template<typename T> struct Node {
  T value;
  // CHECK: [[#@LINE+1]]:3: error: type `Node` contains itself [type-contains-itself, X3000]
  Node<T> next;
};
float4 main(float4 p : POSITION) : SV_Position {
  Node<float> node;
  node.value = 1;
  return p * node.value;
}
