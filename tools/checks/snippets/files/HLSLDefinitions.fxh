#define MATRIX_PRODUCT(m, v) mul(v, m)
