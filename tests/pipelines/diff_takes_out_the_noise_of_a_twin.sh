# Two noisy halves of the reference and labels: (b - a)(b - a2) has no noise, labelled pixels do not count.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

# Pixels a = 0.5 1.5, a2 = 1.5 0.5, b = 1 1: (b-a)(b-a2) = -0.25 both; so rel_rmse is -0.5.
half='\0\0\0\077' one='\0\0\200\077' more='\0\0\300\077'
printf "PF\n2 1\n-1\n$half$half$half$more$more$more" >a.pfm
printf "PF\n2 1\n-1\n$more$more$more$half$half$half" >a2.pfm
printf "PF\n2 1\n-1\n$one$one$one$one$one$one" >b.pfm
strad-diff a.pfm b.pfm --twin a2.pfm --max 1 | grep -x 'rel_rmse -0.5'
strad-diff a.pfm b.pfm --max 1 | grep -x 'rel_rmse 0.5'

# The second pixel has label 9: left out by bit 8 and by default, not by bit 2. Without it a = 0.5 and b = 1.
printf 'P6\n2 1\n255\n\0\0\0\11\11\11' >labels.ppm
strad-diff a.pfm b.pfm --ignore labels.ppm --max 1 | grep -x 'rel_rmse 1'
strad-diff a.pfm b.pfm --ignore labels.ppm --ignore-bits 8 --max 1 | grep -x 'rel_rmse 1'
strad-diff a.pfm b.pfm --ignore labels.ppm --ignore-bits 2 --max 1 | grep -x 'rel_rmse 0.5'
