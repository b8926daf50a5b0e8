// scenes/default.toml for POV-Ray: the same camera, lights and geometry, coordinates of the scene file throughout; shaders
// become what POV-Ray has of their kind. bench/render_bench.py makes heights.png and teapot.inc beside it.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 3 }

#declare Ambient = rgb 0.28 * <0.80, 0.90, 1.0>;

// Right-handed, as the scene: x is mirrored in the camera.
camera {
  perspective
  location <0.35, 1.75, 7.2>
  right -x * image_width / image_height
  up y
  angle 2 * degrees(atan(tan(radians(40 / 2)) * image_width / image_height))
  look_at <0.1, 1.15, 0>
}

light_source { <0.62, 0.62, 0.48> * 1000 rgb 0.85 * <1.0, 0.92, 0.80> parallel point_at 0 }
light_source {
  <-2.6, 5.0, 4.2> rgb 0.55 * <1.0, 0.86, 0.62>
  spotlight point_at <-0.4, 0.6, 0.3> radius 8 falloff 20
}

#macro Matte(Color)
  texture { pigment { rgb Color } finish { ambient Ambient diffuse 1 } }
#end

// Sky: a backdrop with clouds.
box {
  <-320, -40, -370.1>, <320, 160, -370>
  texture {
    pigment {
      bozo turbulence 0.6 octaves 4 omega 0.5
      color_map { [0.50 rgb <0.35, 0.53, 0.80>] [0.62 rgb <0.99, 0.97, 0.94>] [1 rgb <0.66, 0.70, 0.78>] }
      scale <58, 18, 1>
    }
    finish { ambient 1 diffuse 0 }
  }
  no_shadow
}

// The hills: 840 metres between the lowest and the highest cell.
height_field {
  png "heights.png" smooth
  scale <311.6, 14.86, -330>
  translate <-155.8, 0, 165>
  translate <22, -15, -182>
  texture {
    pigment {
      bozo scale 5 turbulence 0.4 octaves 2
      color_map { [0.45 rgb <0.38, 0.44, 0.22>] [0.55 rgb <0.14, 0.24, 0.12>] }
    }
    finish { ambient Ambient diffuse 1 }
  }
}
fog { fog_type 1 distance 250 rgb <0.74, 0.82, 0.90> }

// The floor, whose reflections grow with the angle.
box {
  <-6, -0.2, -2.2>, <6, 0, 6.8>
  texture {
    checker
    texture {
      pigment { marble turbulence 0.8 color_map { [0 rgb <0.80, 0.76, 0.70>] [1 rgb <0.58, 0.55, 0.50>] } }
      finish { ambient Ambient diffuse 1 reflection { 0.05, 0.35 } }
    }
    texture {
      pigment { marble turbulence 0.8 color_map { [0 rgb <0.28, 0.32, 0.31>] [1 rgb <0.19, 0.21, 0.20>] } }
      finish { ambient Ambient diffuse 1 reflection { 0.05, 0.35 } }
    }
    translate <0, 0.5, -0.2>
  }
}

box {
  <0, 0, -1>, <2, 4, 0>
  texture {
    pigment {
      brick pigment { rgb <0.80, 0.76, 0.69> }
      pigment { granite color_map { [0 rgb <0.46, 0.15, 0.10>] [1 rgb <0.80, 0.36, 0.22>] } scale 0.4 }
      brick_size <0.44, 0.147, 0.22> mortar 0.022
    }
    normal { average normal_map { [1 bumps 0.5 scale 0.01] [1 brick 0.6 brick_size <0.44, 0.147, 0.22> mortar 0.03] } }
    finish { ambient 0.18 diffuse 1 specular 0.12 }
  }
  translate <-4.1, 0, -1>
}

// Distance fields that POV-Ray has no solid for are isosurfaces of the same functions.
#declare Blend = function(a, b, r) { min(a, b) - pow(max(r - abs(a - b), 0), 2) / (4 * r) }
#declare Ball = function(x, y, z, r) { sqrt(x*x + y*y + z*z) - r }
#declare Block = function(x, y, z, sx, sy, sz) {
  sqrt(pow(max(abs(x) - sx/2, 0), 2) + pow(max(abs(y) - sy/2, 0), 2) + pow(max(abs(z) - sz/2, 0), 2))
  + min(max(abs(x) - sx/2, max(abs(y) - sy/2, abs(z) - sz/2)), 0)
}
#declare Belly = function(x, y, z) { 0.13 * (sqrt(pow(x/0.13, 2) + pow(y/0.24, 2) + pow(z/0.13, 2)) - 1) }
#declare Stem = function(x, y, z) { max(sqrt(x*x + z*z) - 0.05, abs(y) - 0.25) }
#declare Baluster = function(x, y, z) {
  Blend(Blend(Blend(Belly(x, y - 0.34, z), Stem(x, y - 0.55, z), 0.1), Block(x, y - 0.05, z, 0.22, 0.1, 0.22), 0.1),
        Block(x, y - 0.81, z, 0.22, 0.08, 0.22), 0.1)
}
#declare OneBaluster = isosurface {
  function { Baluster(x, y, z) }
  contained_by { box { <-0.16, -0.01, -0.16>, <0.16, 0.87, 0.16> } }
  accuracy 0.0005 max_gradient 1.8
}
union {
  #for (K, 0, 13)
    object { OneBaluster translate <0.5 * (K - 6.5), 0.12, 0> }
  #end
  box { <-4, 0, -0.18>, <4, 0.12, 0.18> }
  box { <-4, 0.965, -0.2>, <4, 1.095, 0.2> }
  Matte(<0.86, 0.80, 0.70>)
  translate <0, 0, -1.9>
}

isosurface {
  function {
    Blend(Blend(Ball(x, y - 0.55, z, 0.55), Ball(x - 0.12, y - 1.25, z - 0.05, 0.36), 0.45),
          Ball(x + 0.06, y - 1.75, z, 0.22), 0.45)
  }
  contained_by { box { <-0.7, -0.1, -0.7>, <0.7, 2.1, 0.7> } }
  accuracy 0.0005 max_gradient 1.2
  texture { pigment { rgb <0.75, 0.78, 0.82> } finish { ambient Ambient diffuse 0.3 reflection 0.7 } }
  translate <1.5, 0, 0.1>
}

difference {
  intersection {
    box { -0.5, 0.5 }
    sphere { 0, 0.66 }
  }
  cylinder { -y, y, 0.3 }
  cylinder { -z, z, 0.3 }
  cylinder { -x, x, 0.3 }
  Matte(<0.80, 0.22, 0.16>)
  scale 0.9
  rotate 32 * y
  translate <0.02, 0.45, 0.9>
}

sphere { <1.08, 0.24, 1.75>, 0.24 Matte(<0.13, 0.34, 0.62>) }

union {
  box { <1.25, 0.82, 1.45>, <2.75, 0.9, 2.55> }
  box { <1.3, 0, 1.5>, <1.4, 0.82, 1.6> }
  box { <2.6, 0, 1.5>, <2.7, 0.82, 1.6> }
  box { <1.3, 0, 2.4>, <1.4, 0.82, 2.5> }
  box { <2.6, 0, 2.4>, <2.7, 0.82, 2.5> }
  texture {
    pigment {
      wood turbulence 0.1 color_map { [0 rgb <0.78, 0.54, 0.31>] [1 rgb <0.47, 0.26, 0.12>] }
      scale 0.06 rotate 4 * x
    }
    finish { ambient 0.16 diffuse 1 specular 0.3 }
  }
  translate <-3.6, 0, -1.9>
}

union {
  #include "teapot.inc"
  texture {
    pigment { rgb <0.60, 0.31, 0.16> }
    finish { ambient Ambient diffuse 1 phong 0.6 phong_size 60 }
  }
  rotate -90 * x
  scale 0.19
  translate <-1.6, 0.9, 0.1>
}
