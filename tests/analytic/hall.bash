# The corners of a hall of 4 x 3 x 2.5 m, for tests that build on them: begin_hall NAME writes NAME.mtl and prints the head
# of an OBJ file.
begin_hall() {
  printf 'newmtl white\nKd 0.8 0.8 0.8\n' >"$1.mtl"
  printf 'mtllib %s.mtl\nusemtl white\n' "$1"
  printf 'v %s\n' '0 0 0' '4 0 0' '4 3 0' '0 3 0' '0 0 2.5' '4 0 2.5' '4 3 2.5' '0 3 2.5'
}
