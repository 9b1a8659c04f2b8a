// The elements of a mesh as a picture.
#pragma once

#include "frame/show_view.h"
#include "image/image.h"
#include "solution/mesh.h"

namespace strad {

// Each leaf in a colour of its own, which follows from its polygon and its place there, so that it keeps it
// from frame to frame, as its body moves, and from slab to slab. Pixels in which elements or surfaces meet
// are darker; surfaces without a mesh are grey.
Image elements_picture(const ShowView& view, const Mesh& mesh);

}  // namespace strad
