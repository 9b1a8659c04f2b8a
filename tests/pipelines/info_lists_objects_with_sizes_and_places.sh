# strad-info --objects: what objects, materials and bodies have of the surfaces.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

# A floor of 4 m by 2 m, of two quads, and a triangle of 3 m^2 above it in the other material.
cat >s.mtl <<'END'
newmtl grey
Kd 0.5 0.5 0.5
newmtl red
Kd 0.6 0.1 0.1
END
cat >s.obj <<'END'
mtllib s.mtl
v 0 0 0
v 2 0 0
v 4 0 0
v 0 0 -2
v 2 0 -2
v 4 0 -2
v 0 1 0
v 3 1 0
v 0 3 0
o floor
usemtl grey
f 1 2 5 4
f 2 3 6 5
o flag
usemtl red
f 7 8 9
END
strad-import s.obj | strad-motion <(printf 'body pole\n  parts flag\n') >s.strad
strad-info --objects s.strad >info
[ "$(grep -c . <(sed -n '/^objects:/,/^bytes:/p' info))" = 11 ]  # 2 objects, 2 materials, 2 bodies, 3 heads, 2 ends
grep -qx '    name floor, body world, materials grey, polygons 2, area m^2 8, bounds m lower 0 0 -2, upper 4 0 0' info
grep -qx '    name flag, body pole, materials red, polygons 1, area m^2 3, bounds m lower 0 1 0, upper 3 3 0' info
grep -qx '    name red, polygons 1, area m^2 3, bounds m lower 0 1 0, upper 3 3 0' info
grep -qx '    name world, polygons 2, area m^2 8, bounds m lower 0 0 -2, upper 4 0 0' info
grep -qx '    name pole, polygons 1, area m^2 3, bounds m lower 0 1 0, upper 3 3 0' info
strad-info --objects --json s.strad | grep '"of bodies": \[' >/dev/null
if strad-info s.strad | grep '^objects:' >/dev/null; then exit 1; fi
