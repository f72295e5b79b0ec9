// SPDX-License-Identifier: Apache-2.0
// How a picture is composed. With f the transmittance of the fog before a surface or the sky S, and A the airlight of
// all lamps before it,
//
//     picture = f S + (1 - f) ambient fog + A.
//
// Each surface and the sky compute the first two terms by litfog_apply_fog() (litfog/shaders/fog.glsl) and add the
// directional light's airlight (moonlight.glsl). compose() adds A, and compose_pane() draws a pane over what is behind
// it. compose_airlight.frag adds A to a whole picture. ReferenceShading::pixel() in measure/reference_picture.cpp does
// the same in double.

// seen  radiance through the fog, without airlight
vec3 compose(vec3 seen, vec3 airlight) { return seen + airlight; }

// A pane of opacity o, premultiplied for blending; alpha is o.
//
// The pane lets (1 - o) of the light L from behind through. The fog before the pane dims this and adds airlight:
// f ((1 - o) L + o S) + A = (1 - o) (f L + A) + o (f S + A). So opacity mixes the picture without the pane with a
// picture of the pane alone, each with all of its fog.
vec4 compose_pane(vec3 pane, vec3 airlight, float opacity) {
  return vec4(opacity * compose(pane, airlight), opacity);
}
