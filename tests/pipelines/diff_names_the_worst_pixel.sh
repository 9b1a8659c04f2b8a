# strad-diff prints one `name value` per line; its metrics are those derived by hand.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

# PFM, two pixels in a row: (1 1 1) (1 1 1) against (1 1 1) (1 1 2).
# 6 values, one of them 1 too large, mean 1: RMSE over mean sqrt(1/6) = 0.40824829, bias 1/6.
one='\0\0\200\077' two='\0\0\0\100'
printf "PF\n2 1\n-1\n$one$one$one$one$one$one" >a.pfm
printf "PF\n2 1\n-1\n$one$one$one$one$one$two" >b.pfm

status=0
strad-diff a.pfm b.pfm >out || status=$?
test $status = 1
diff -u - out <<'EOF'
frames 1
rel_rmse 0.40824829
bias 0.166666667
mean_a 1
mean_b 1.16666667
max 1
max_file b.pfm
max_x 1
max_y 0
max_channel b
max_a 1
max_b 2
EOF

# The other way round, one of them from a pipe: 1 / (7/6) - 1 = -1/7.
strad-diff b.pfm - --max 1 <a.pfm | grep -x 'bias -0.142857143'
