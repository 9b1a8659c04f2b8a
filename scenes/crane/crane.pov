// A room with a crane that turns, a cart that rolls to and fro, and a lamp that dims: an animation in POV-Ray's language,
// over clock 0 to 1. crane.ini renders it with POV-Ray, `strad-import crane.ini` makes a stream of it.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 200 error_bound 0.4 recursion_limit 3 } }
#default { finish { ambient 0 diffuse 1 } }

#declare Plaster = texture { pigment { rgb <0.7, 0.68, 0.62> } }
#declare Brick = texture { pigment { rgb <0.6, 0.3, 0.22> } }
#declare Steel = texture { pigment { rgb <0.3, 0.42, 0.6> } }
#declare Rubber = texture { pigment { rgb <0.15, 0.15, 0.15> } }

camera {
  location <3 - clock, 2.2, -3.4>
  look_at <0, 0.9, 0>
  right x * image_width / image_height
  angle 70
}

// The lamp under the ceiling dims to a fifth. A panel that falls with the cosine. Beyond a short fade_distance its light
// falls with the square of the distance in POV-Ray, too.
light_source {
  <0, 2.98, 0>, rgb 120 * (1 - 0.8 * clock)
  spotlight point_at <0, 0, 0> radius 90 falloff 90 tightness 1
  area_light <1.2, 0, 0>, <0, 0, 0.8>, 5, 5 adaptive 1
  fade_distance 0.1 fade_power 2
}

// The room, open for the camera only because it stands inside.
#declare Room = union {
  box { <-4, -0.1, -4>, <4, 0, 4> texture { Plaster } }
  box { <-4, 3, -4>, <4, 3.1, 4> texture { Plaster } }
  box { <-4.1, 0, -4>, <-4, 3, 4> texture { Brick } }
  box { <4, 0, -4>, <4.1, 3, 4> texture { Plaster } }
  box { <-4, 0, 4>, <4, 3, 4.1> texture { Plaster } }
  box { <-4, 0, -4.1>, <4, 3, -4> texture { Plaster } }
}
object { Room }

// The foot stands, the mast and the arm turn about it, the hook hangs from the arm and turns against it.
#declare Foot = box { <-0.4, 0, -0.4>, <0.4, 0.3, 0.4> texture { Steel } }
#declare Arm = union {
  box { <-0.12, 0.3, -0.12>, <0.12, 2.2, 0.12> }
  box { <-0.12, 2.2, -0.12>, <1.6, 2.36, 0.12> }
  texture { Steel }
}
#declare Hook = box { <-0.15, -0.5, -0.08>, <0.15, 0, 0.08> texture { Brick } }
object { Foot translate <-1, 0, 0.5> }
object { Arm rotate y * 200 * clock translate <-1, 0, 0.5> }
object { Hook rotate -y * 400 * clock translate <1.45, 2.2, 0> rotate y * 200 * clock translate <-1, 0, 0.5> }

// The cart goes 3 m and half of it back; its wheels of 0.2 m roll on the floor without sliding.
#declare Way = (clock < 0.6 ? 5 * clock : 3 - 3.75 * (clock - 0.6));
#declare Wheel = cylinder { <0, 0, -0.06>, <0, 0, 0.06>, 0.2 texture { Rubber } }
#declare Headlight = light_source {
  <0.52, 0.5, 0>, rgb <90, 80, 60>
  spotlight point_at <2, 0.2, 0> radius 15 falloff 28 fade_distance 0.1 fade_power 2
}
union {
  box { <-0.5, 0.25, -0.3>, <0.5, 0.7, 0.3> texture { Brick } }
  light_source { Headlight }
  translate <-2.2 + Way, 0, -1.6>
}
#for (Side, -1, 1, 2)
  #for (End, -1, 1, 2)
    object { Wheel rotate -z * degrees(Way / 0.2) translate <-2.2 + Way + 0.3 * End, 0.2, -1.6 + 0.37 * Side> }
  #end
#end
