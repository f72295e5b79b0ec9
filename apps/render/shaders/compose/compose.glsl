// SPDX-License-Identifier: Apache-2.0
// How a picture is composed. With f the transmittance of the fog before a surface or the sky S, and A the airlight of all
// lamps before it,
//
//     picture = f S + (1 - f) ambient fog + A.
//
// The first two terms are litfog_apply_fog() (litfog/shaders/fog.glsl), which each surface and the sky call, and to which
// they add the directional light's airlight (moonlight.glsl). compose() adds A, and compose_pane() lays a pane over what
// is behind it. compose_airlight.frag draws A over a picture without it. ReferenceShading::pixel() in
// measure/reference_picture.cpp does the same in double.

// What is seen through the fog, without airlight, and the airlight before it.
vec3 compose(vec3 seen, vec3 airlight) { return seen + airlight; }

// A pane of an opacity o, to be blended over what is behind it; alpha is the opacity.
//
// Light L from behind arrives at the pane, the part that it lets through goes on through the fog before it, which adds
// its own airlight: f ((1 - o) L + o S) + A = (1 - o) (f L + A) + o (f S + A). So the picture without the pane and one of
// the pane alone, each with all of its fog, are mixed by the opacity.
vec4 compose_pane(vec3 pane, vec3 airlight, float opacity) {
  return vec4(opacity * compose(pane, airlight), opacity);
}
