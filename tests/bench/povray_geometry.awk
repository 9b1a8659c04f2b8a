# From strad's geometry for POV-Ray (strad-pov(5)), which has a texture for each vertex, to one that POV-Ray lights
# itself: a texture for each material.
/^  texture_list/ { split("", first); ranges = 0; text = ""; listing = 1; next }
listing && /#for/ {
  match($0, /strad_i, [0-9]+/)
  first[++ranges] = substr($0, RSTART + 9, RLENGTH - 9) + 0
  match($0, /strad_pigment_[A-Za-z0-9_]+/)
  text = text "\n    texture { pigment { " substr($0, RSTART, RLENGTH) " } finish { strad_finish } }"
  next
}
listing && /^  [}]/ { print "  texture_list { " ranges "," text "\n  }"; listing = 0; next }
/^  face_indices/ { faces = 1; print; next }
faces && /^<[0-9]+,[0-9]+,[0-9]+>,[0-9]/ {
  split($0, part, /[<>,]+/)
  for (i = ranges; i > 1 && first[i] > part[2]; --i);
  print "<" part[2] "," part[3] "," part[4] ">," i - 1
  next
}
/^  [}]/ { faces = 0 }
{ print }
