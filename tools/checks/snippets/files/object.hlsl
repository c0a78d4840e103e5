#include "water.hlsl"
