#include "solution/fact_values.h"

#include <charconv>

namespace strad {

Fact number_fact(float value) {
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  double shortest = 0;
  std::from_chars(text, end, shortest);
  return {shortest};
}

Fact point_fact(Vec3 p) {
  const auto coordinate = [](double x) { return number_fact(static_cast<float>(x)); };
  return {FactList{coordinate(p.x), coordinate(p.y), coordinate(p.z)}};
}

Fact colour_fact(Rgb c) { return {FactList{number_fact(c.r), number_fact(c.g), number_fact(c.b)}}; }

Fact box_fact(const Box& box) {
  if (box.empty()) return text_fact("empty");
  return {FactGroup{{"lower", point_fact(box.lower)}, {"upper", point_fact(box.upper)}}};
}

}  // namespace strad
