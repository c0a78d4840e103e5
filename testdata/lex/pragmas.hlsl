// RUN: %clipc --dump=tokens %s 2>&1 | FileCheck %s
// RUN: %clipc --dump=tokens -Wno-unknown-pragma -Wno-malformed-pragma %s 2>&1 | FileCheck %s --check-prefix=QUIET
#pragma pack_matrix(row_major)
#pragma pack_matrix( column_major )
#pragma pack_matrix(sideways)
#pragma warning(disable: 3206; error: 4000) and (push)
#pragma def(vs_5_0, c0, 1.0, 2.0, 3.0, 4.0)
#pragma message("built for tests")
#pragma region names
#pragma endregion
#pragma strange thing
#pragma warning(push)
// CHECK: pragmas.hlsl:5:9: warning: `#pragma pack_matrix` is ignored; it takes (row_major) or (column_major) [-Wmalformed-pragma]
// CHECK: pragmas.hlsl:8:9: note: built for tests
// CHECK: pragmas.hlsl:11:9: warning: unknown pragma `strange` is ignored [-Wunknown-pragma]
// CHECK: pragmas.hlsl:12:9: warning: `#pragma warning(push)` is ignored; HLSL has (disable: 3206), (error: 3206) and (default: 3206) [-Wmalformed-pragma]
// CHECK: pack_matrix row_major
// CHECK-NEXT: pack_matrix column_major
// CHECK-NEXT: end
// QUIET-NOT: warning
