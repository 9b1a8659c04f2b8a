// The statements of a motion file, parsed block by block.
#include "scene/motion_blocks.h"

#include <cmath>
#include <span>

#include "base/text.h"
#include "scene/motion_keys.h"
#include "scene/motion_words.h"
#include "scene/name_index.h"

namespace strad {
namespace {

// A statement in column one and the indented lines under it.
struct BlockText {
  const std::string& file;
  const MotionLine& head;
  std::span<const MotionLine> settings;
};

// Refuses a second setting of the same name, except `key` and `parts`, which may be repeated.
class OnceEach {
 public:
  void take(const std::string& setting, const MotionWords& words) {
    if (setting == "key" || setting == "parts") return;
    for (const std::string& seen : seen_)
      if (seen == setting) words.fail("a second " + setting, "one " + setting + " in a block");
    seen_.push_back(setting);
  }

 private:
  std::vector<std::string> seen_;
};

// Calls take(setting, words) for each line of the block.
template <class Take>
void for_each_setting(const BlockText& block, const std::string& expected, Take take) {
  OnceEach once;
  for (const MotionLine& line : block.settings) {
    MotionWords words(block.file, line);
    const std::string setting = words.word(expected);
    once.take(setting, words);
    take(setting, words);
    words.expect_end();
  }
}

std::string name_of(const BlockText& block, const std::string& expected) {
  MotionWords words(block.file, block.head);
  words.word(expected);  // the keyword itself
  std::string name = words.word(expected);
  if (name.empty()) words.fail(expected);
  words.expect_end();
  return name;
}

MotionName take_name(MotionWords& words, const std::string& expected) {
  return {words.word(expected), words.line()};
}

Ease take_ease(MotionWords& words) {
  const std::string ease = words.word("linear or smooth");
  if (ease == "linear") return Ease::kLinear;
  if (ease == "smooth") return Ease::kSmooth;
  words.fail("linear or smooth");
}

Vec3 take_axis(MotionWords& words) {
  const Vec3 axis = words.vector("the axis");
  if (!(length2(axis) > 0)) words.fail("an axis of no length", "a direction");
  return is_unit_to_rounding(length(axis)) ? axis : normalized(axis);
}

std::string degrees_shown(double radians) { return motion_number(std::round(radians / kDegree * 1e9) / 1e9); }

void take_cone(MotionWords& words, Spot& spot) {
  const std::string expected = "two half-angles in degrees, 0 <= inner <= outer < 180, outer > 0";
  spot.inner = words.angle(expected);
  spot.outer = words.angle(expected);
  if (!(spot.inner >= 0 && spot.inner <= spot.outer && spot.outer > 0 && spot.outer < kPi))
    words.fail("a cone from " + degrees_shown(spot.inner) + " to " + degrees_shown(spot.outer), expected);
}

BodyBlock parse_body(const BlockText& text) {
  BodyBlock block;
  block.body.name = name_of(text, "the name of the body");
  if (block.body.name == "world")
    fail_at(text.file, text.head.number, "a body named world", "another name: the world is what never moves");
  const std::string expected = "parts, on, pivot, axis, ease or key";
  for_each_setting(text, expected, [&](const std::string& setting, MotionWords& words) {
    if (setting == "parts") {
      do block.parts.push_back(take_name(words, "names or patterns of objects"));
      while (!words.at_end());
    } else if (setting == "on") {
      block.on = take_name(words, "the name of a body");
    } else if (setting == "pivot") {
      block.body.pivot = words.vector("the pivot");
    } else if (setting == "axis") {
      block.body.axis = take_axis(words);
    } else if (setting == "ease") {
      block.body.ease = take_ease(words);
    } else if (setting == "key") {
      take_key(words, block.body.keys);
    } else {
      words.fail(expected);
    }
  });
  for (const MotionName& part : block.parts) block.body.parts.push_back(part.name);
  return block;
}

SpotBlock parse_spot(const BlockText& text) {
  SpotBlock block;
  block.spot.name = name_of(text, "the name of the spot");
  bool has_cone = false;
  const std::string expected = "on, cone or key";
  for_each_setting(text, expected, [&](const std::string& setting, MotionWords& words) {
    if (setting == "on") {
      block.on = take_name(words, "the name of a body");
    } else if (setting == "cone") {
      take_cone(words, block.spot);
      has_cone = true;
    } else if (setting == "key") {
      take_key(words, block.spot.keys);
    } else {
      words.fail(expected);
    }
  });
  if (!has_cone) fail_at(text.file, text.head.number, "a spot without a cone", "cone INNER OUTER");
  if (block.spot.keys.empty())
    fail_at(text.file, text.head.number, "a spot without a key", "at least one key");
  return block;
}

// Settings of a block that has only keys.
template <class Key>
std::vector<Key> parse_keys(const BlockText& text) {
  std::vector<Key> keys;
  for_each_setting(text, "key", [&](const std::string& setting, MotionWords& words) {
    if (setting != "key") words.fail("key");
    take_key(words, keys);
  });
  if (keys.empty())
    fail_at(text.file, text.head.number, "a " + text.head.words[0] + " without a key", "at least one key");
  return keys;
}

MotionInterval parse_time(const BlockText& text) {
  MotionWords words(text.file, text.head);
  const std::string expected = "start and end in seconds";
  words.word(expected);
  const double start = words.number(expected), end = words.number(expected);
  words.expect_end();
  if (!(start <= end))
    words.fail("an end at " + motion_number(end), "one at " + motion_number(start) + " or later");
  return {start, end};
}

double parse_rate(const BlockText& text) {
  MotionWords words(text.file, text.head);
  const std::string expected = "frames per second, above 0, such as 25 or 24000/1001";
  words.word(expected);
  const double rate = words.ratio(expected);
  if (!(rate > 0)) words.fail(expected);
  words.expect_end();
  return rate;
}

// Takes the blocks of a file. Of two blocks of one name, the later replaces the earlier.
class BlockTaker {
 public:
  void take(const BlockText& text);
  MotionBlocks blocks;

 private:
  NameIndex<BodyBlock> bodies_{&blocks.bodies,
                               [](const BodyBlock& b) -> const std::string& { return b.body.name; }};
  NameIndex<SpotBlock> spots_{&blocks.spots,
                              [](const SpotBlock& b) -> const std::string& { return b.spot.name; }};
  NameIndex<GlowBlock> glows_{&blocks.glows,
                              [](const GlowBlock& b) -> const std::string& { return b.material.name; }};
  NameIndex<Camera> cameras_ = index_of_names(&blocks.cameras);
};

void BlockTaker::take(const BlockText& text) {
  const std::string& keyword = text.head.words[0];
  if (keyword == "body") {
    bodies_.put(parse_body(text));
  } else if (keyword == "spot") {
    spots_.put(parse_spot(text));
  } else if (keyword == "glow") {
    const MotionName material{name_of(text, "the name of a material"), text.head.number};
    glows_.put({material, parse_keys<GlowKey>(text)});
  } else if (keyword == "camera") {
    const std::string name = name_of(text, "the name of the camera");
    cameras_.put({name, parse_keys<CameraKey>(text)});
  } else if (keyword != "time" && keyword != "rate") {
    fail_at(text.file, text.head.number, in_quotes(keyword), "time, rate, body, spot, glow or camera");
  } else if (!text.settings.empty()) {
    const MotionLine& line = text.settings.front();
    fail_at(text.file, line.number, "an indented " + in_quotes(line.words[0]) + " under " + keyword,
            "a statement in column one");
  } else if (keyword == "time") {
    blocks.interval = parse_time(text);
  } else {
    blocks.rate = parse_rate(text);
  }
}

}  // namespace

MotionBlocks parse_motion(std::string_view text, const std::string& file) {
  const std::vector<MotionLine> lines = motion_lines(text, file);
  BlockTaker taker;
  for (size_t i = 0; i < lines.size();) {
    if (lines[i].indented)
      fail_at(file, lines[i].number, "an indented " + in_quotes(lines[i].words[0]) + " under no statement",
              "time, rate, body, spot, glow or camera in column one");
    size_t end = i + 1;
    while (end < lines.size() && lines[end].indented) ++end;
    taker.take({file, lines[i], std::span(lines).subspan(i + 1, end - i - 1)});
    i = end;
  }
  return std::move(taker.blocks);
}

}  // namespace strad
