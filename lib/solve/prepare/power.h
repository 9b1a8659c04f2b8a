// An estimate of the light of a scene before it is solved.
#pragma once

#include <vector>

#include "light/direct.h"
#include "scene/scene.h"

namespace strad {

// Mean radiance of the surfaces of a closed scene, W / (sr m^2), from the power of its lights (mean over
// `instants`), its area and its mean reflectance: rho / pi * power / area / (1 - rho)
// (the ambient term of Cohen et al. 1988).
double expected_mean_radiance(const Scene& scene, const std::vector<Instant>& instants);

}  // namespace strad
