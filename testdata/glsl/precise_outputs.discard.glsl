layout(location = 0) in highp float vs_SV_CLIPPLANEDISTANCE0;

void clip_planes() {
    if (!(vs_SV_CLIPPLANEDISTANCE0 >= 0.0)) discard;
}
