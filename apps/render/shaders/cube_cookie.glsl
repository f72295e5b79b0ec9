// SPDX-License-Identifier: Apache-2.0
// Lights whose cone is replaced by a cube map (Ronald Frazier 2000, "Real-Time Per-Pixel Point Lights and Spot Lights
// in OpenGL", section "Neat Tricks Using the Spot Light"). All cookies of a scene are in one array, because a loop over
// lights cannot choose among cube maps: six faces each, +x -x +y -y +z -z.

#define LITFOG_COOKIES
#include "litfog/shaders/light.glsl"

uniform sampler2DArray cookies;
uniform samplerBuffer cookie_cones;  // a light's cookie and the cookie's y axis in world space

vec4 litfog_cookie_cone(float cookie) { return texelFetch(cookie_cones, int(cookie)); }

float litfog_cookie(LitfogLight light, vec3 direction) {
  vec3 up = light.cone.yzw;
  vec3 right = cross(light.axis_profile.xyz, up);
  vec3 d = vec3(dot(direction, right), dot(direction, up), -dot(direction, light.axis_profile.xyz));
  vec3 a = abs(d);
  vec3 uv_face;  // OpenGL 3.3, 3.8.6
  float along;
  if (a.x >= a.y && a.x >= a.z) {
    along = a.x;
    uv_face = d.x > 0.0 ? vec3(-d.z, -d.y, 0.0) : vec3(d.z, -d.y, 1.0);
  } else if (a.y >= a.z) {
    along = a.y;
    uv_face = d.y > 0.0 ? vec3(d.x, d.z, 2.0) : vec3(d.x, -d.z, 3.0);
  } else {
    along = a.z;
    uv_face = d.z > 0.0 ? vec3(d.x, -d.y, 4.0) : vec3(-d.x, -d.y, 5.0);
  }
  if (along == 0.0) return 0.0;  // at the light itself: no direction
  return textureLod(cookies, vec3(0.5 + 0.5 * uv_face.xy / along, light.cone.x * 6.0 + uv_face.z), 0.0).r;
}
