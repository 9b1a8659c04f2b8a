// What a check tells of its samples, and how.
#include "frame/check_report.h"

#include <gtest/gtest.h>

#include "frame/check_text.h"
#include "frame/probe_text.h"
#include "synthetic.h"

namespace strad {
namespace {

const TimeRange kRange{0, 10};

// 40 samples without noise of two quads, "object0" in the world and "object1" on a body: radiance 1 + i /
// 100, the solution off by 0.1 on the second only. One more on the first is off by 0.5.
struct Checked {
  Scene scene;
  std::vector<CheckSample> samples;

  Checked() {
    add_quad(&scene, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    add_quad(&scene, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
    scene.bodies.push_back({});
    scene.bodies.back().name = "shelf";
    scene.objects[1].body = 1;
    scene.materials[0].name = "grey", scene.materials[1].name = "white";
    for (uint32_t i = 0; i < 40; ++i) add(i % 2, i, i % 2 == 1 ? 0.1f : 0);
    add(0, 20, 0.5f);
  }
  void add(uint32_t polygon, uint32_t i, float off) {
    CheckSample sample;
    sample.point = {{polygon, false, {0.5, i / 40.0, double(polygon)}}, i / 4.0, 1, true};
    const float radiance = 1 + static_cast<float>(i) / 100;
    for (Rgb& estimate : sample.estimates) estimate = {radiance, radiance, radiance};
    sample.solution = sample.estimates[0] + Rgb{off, off, off};
    samples.push_back(sample);
  }
  CheckReport report() const { return report_of(scene, samples, kRange); }
};

TEST(CheckReport, GroupsTellWhereTheErrorIs) {
  const CheckReport report = Checked().report();
  ASSERT_EQ(report.tables.size(), 4u);
  const CheckTable& bodies = report.tables[0];
  ASSERT_EQ(bodies.groups.size(), 2u);
  EXPECT_EQ(bodies.groups[0].name, "world");
  EXPECT_EQ(bodies.groups[1].name, "shelf");
  // Squared errors: 0.25 on the first, 20 * 0.01 = 0.2 on the second.
  EXPECT_NEAR(bodies.groups[0].share, 0.25 / 0.45, 1e-4);
  EXPECT_NEAR(bodies.groups[1].share, 0.2 / 0.45, 1e-4);
  // Radiance on the second: 1.01, 1.03, ... 1.39, mean 1.2.
  EXPECT_NEAR(bodies.groups[1].error.rel.value, 0.1 / 1.2, 1e-5);
  EXPECT_NEAR(bodies.groups[1].error.bias.value, 0.1 / 1.2, 1e-5);
  EXPECT_EQ(report.tables[1].groups[1].name, "white");
}

TEST(CheckReport, TenthsCoverAll) {
  const CheckReport report = Checked().report();
  for (const size_t table : {2, 3}) {
    ASSERT_EQ(report.tables[table].groups.size(), 10u);
    size_t points = 0;
    double share = 0, before = -1;
    for (const CheckGroup& group : report.tables[table].groups) {
      points += group.error.points, share += group.share;
      EXPECT_LE(group.from, group.to);
      EXPECT_LE(before, group.from);
      before = group.from;
      EXPECT_NEAR(static_cast<double>(group.error.points), 4.1, 1);
    }
    EXPECT_EQ(points, 41u);
    EXPECT_NEAR(share, 1, 1e-9);
  }
  EXPECT_EQ(report.tables[3].groups[9].to, kRange.end);
}

TEST(CheckReport, FewPointsAreNoGroup) {
  Checked checked;
  checked.scene.materials.push_back({});
  checked.scene.materials.back().name = "rare";
  checked.scene.polygons[0].material = 2;  // 21 points
  checked.samples.resize(18);              // 9 of each
  const CheckReport report = checked.report();
  ASSERT_EQ(report.tables[1].groups.size(), 1u);
  EXPECT_EQ(report.tables[1].groups[0].name, "(others)");
  EXPECT_EQ(report.tables[1].groups[0].error.points, 18u);
}

TEST(CheckReport, WorstPlacesAreThoseSurelyOff) {
  Checked checked;
  // Off by 5 in the mean, but one estimate alone says so: noise.
  checked.add(0, 1, 0);
  checked.samples.back().estimates[3] = {41, 41, 41};
  const CheckReport report = checked.report();
  ASSERT_EQ(report.worst.size(), 10u);
  EXPECT_EQ(report.worst[0].object, "object0");
  EXPECT_NEAR(report.worst[0].error.solution - report.worst[0].error.reference, 0.5, 1e-6);
  EXPECT_EQ(report.worst[0].time, 5);
  EXPECT_EQ(report.worst[0].normal, (Vec3{0, 0, -1}));  // of its back
  for (size_t i = 1; i < 10; ++i) EXPECT_EQ(report.worst[i].object, "object1");
}

TEST(CheckText, ProbeTakesTheWorstPlaces) {
  const Checked checked;
  const std::string text = check_text(checked.report());
  const std::vector<ProbeQuery> queries = parse_probes("text", text.substr(text.find("takes them\n") + 11));
  ASSERT_EQ(queries.size(), 10u);
  const ProbePoint point = nearest_point(checked.scene, queries[0]);
  EXPECT_EQ(point.polygon, 0u);
  EXPECT_FALSE(point.front);
  EXPECT_NEAR(length(point.rest_point - Vec3{0.5, 0.5, 0}), 0, 1e-8);
}

TEST(CheckText, NamesCannotSteerATerminal) {
  Checked checked;
  checked.scene.objects[0].name = "a\nb\x1b";
  checked.scene.materials[0].name = "c\nd";
  const std::string text = check_text(checked.report());
  EXPECT_NE(text.find("on a?b?\n"), std::string::npos);
  EXPECT_NE(text.find("c?d\n"), std::string::npos);
}

}  // namespace
}  // namespace strad
