// Named values: numbers, texts, points, colours, lists and groups of them.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"

namespace strad {

struct Fact;
struct NamedFact;
using FactList = std::vector<Fact>;
using FactGroup = std::vector<NamedFact>;
struct Fact {
  std::variant<double, std::string, FactList, FactGroup> value;
};
struct NamedFact {
  std::string name;
  Fact fact;
};

inline Fact number_fact(double value) { return {value}; }
inline Fact number_fact(size_t value) { return {static_cast<double>(value)}; }
// A number that is stored as a float is printed with the fewest digits that give this float.
Fact number_fact(float value);
inline Fact text_fact(std::string value) { return {std::move(value)}; }
Fact point_fact(Vec3 p);
Fact colour_fact(Rgb c);
Fact box_fact(const Box& box);  // "empty", or its lower and upper corner

template <typename Item, typename Describe>
Fact list_of(const std::vector<Item>& items, Describe describe) {
  FactList list;
  for (const Item& item : items) list.push_back(describe(item));
  return {std::move(list)};
}

}  // namespace strad
