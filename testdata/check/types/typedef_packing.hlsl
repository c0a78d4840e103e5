// A typedef keeps the #pragma pack_matrix that it stands under. Without one, a matrix is packed as where it is used, and an array
// by columns (vkd3d's test of the pragma, checked against native).
// RUN: %clipc -T vs_5_0 %s --validate | FileCheck %s
typedef float2x3 Open;
typedef float2x3 Columns[2];
#pragma pack_matrix(row_major)
typedef float2x3 Rows;
typedef Open RowsToo;
typedef Columns StillColumns;
#pragma pack_matrix(column_major)
typedef Rows Again;
Rows rows;        // CHECK: {{^    }}mat2x3 rows;
Again again;      // CHECK: {{^    }}mat2x3 again;
RowsToo too;      // CHECK: {{^    }}mat2x3 too;
Open open_here;   // CHECK: {{^    }}layout(row_major) mat2x3 open_here;
#pragma pack_matrix(row_major)
Open rows_here;   // CHECK: {{^    }}mat2x3 rows_here;
StillColumns a;   // CHECK: {{^    }}layout(row_major) mat2x3 a[2];
float4 main() : SV_Position {
  return float4(rows[0] + again[0] + too[0] + open_here[0] + rows_here[0] + a[1][0], 1);
}
