// File names of an export for POV-Ray.
#include <gtest/gtest.h>

#include "base/error.h"
#include "export/pov/names.h"

namespace strad {
namespace {

TEST(PovNames, FollowFromThePattern) {
  const PovNames names("out/room.%04d.inc", true);
  EXPECT_EQ(names.frame(61), "out/room.0061.inc");
  EXPECT_EQ(names.scene(), "out/room.pov");
  EXPECT_EQ(names.ini(), "out/room.ini");
  EXPECT_EQ(names.geometry(0), "out/room_geometry.inc");
  EXPECT_EQ(names.geometry(1), "out/room_geometry2.inc");
  EXPECT_EQ(names.texture(0), "out/room_texture1.ppm");
  EXPECT_EQ(names.folder(), "out/");
  EXPECT_EQ(names.frame_expression("n"), "concat(\"room.\", str(n, -4, 0), \".inc\")");
}

TEST(PovNames, BaseOfUnusualPatterns) {
  EXPECT_EQ(PovNames("room_%d", true).scene(), "room.pov");
  EXPECT_EQ(PovNames("%d.inc", true).scene(), "strad.pov");
  EXPECT_EQ(PovNames("still.inc", false).scene(), "still.pov");
  EXPECT_EQ(PovNames("still", false).scene(), "still.pov");
  EXPECT_EQ(PovNames("still.inc", false).frame_expression("n"), "\"still.inc\"");
}

TEST(PovNames, RefusesWhatCannotWork) {
  EXPECT_THROW(PovNames("room.inc", true), BadInput);
  EXPECT_THROW(PovNames("%d/room.inc", true), BadInput);
  EXPECT_THROW(PovNames("room.%s.inc", true), BadInput);
  EXPECT_THROW(PovNames("out/", true), BadInput);
  EXPECT_THROW(PovNames("a\"b.%d.inc", true), BadInput);
  EXPECT_THROW(PovNames("still.pov", false), BadInput);
}

}  // namespace
}  // namespace strad
