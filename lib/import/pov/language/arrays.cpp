// POV-Ray's arrays, and names that may stand for them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/language/interpreter.h"

namespace strad {

const PovValue* PovInterpreter::sample_of(const PovValue* value) {
  while (value && std::holds_alternative<std::shared_ptr<PovArray>>(*value)) {
    const auto& items = std::get<std::shared_ptr<PovArray>>(*value)->items;
    const auto filled =
        std::find_if(items.begin(), items.end(), [](const auto& item) { return item.has_value(); });
    if (filled == items.end()) break;
    value = &**filled;
  }
  return value;
}

size_t PovInterpreter::indices_into(const PovArray& array, const std::string& name) {
  size_t index = 0;
  for (const size_t size : array.sizes) {
    expect("[");
    const PovPlace place = this->place();
    double at = number();
    if (!(at >= 0 && at < static_cast<double>(size))) {
      std::array<char, 40> found;
      std::snprintf(found.data(), found.size(), "index %.10g", at);
      const std::string what = found.data() + (" of the array " + name);
      if (!options_.skip_unknown || !std::isfinite(at))
        fail_at(place.file, place.line, what + ", expected 0 to " + std::to_string(size - 1));
      at = at < 0 ? 0 : static_cast<double>(size - 1);
      report_->add(what + " is taken as the nearest that there is", place.file, place.line);
    }
    index = index * size + static_cast<size_t>(at);
    expect("]");
  }
  return index;
}

PovValue PovInterpreter::take_named() {
  const std::string name(take().text);
  PovValue found = *find(name);
  while (std::holds_alternative<std::shared_ptr<PovArray>>(found) && next_is_plainly("[")) {
    const auto array = std::get<std::shared_ptr<PovArray>>(found);
    const size_t index = indices_into(*array, name);
    if (!array->items[index]) fail("an element of the array " + name + " is used before it is declared");
    found = *array->items[index];
  }
  if (const auto* text = std::get_if<std::string>(&found)) charge(text->size());
  return found;
}

PovValue PovInterpreter::array_value() {
  constexpr double kMostItems = 1e8;
  constexpr size_t kMaxDimensions = 5;  // as in POV-Ray
  auto array = std::make_shared<PovArray>();
  double count = 1;
  while (next_is_plainly("[")) {
    take();
    const double size = number();
    count *= size;
    if (!(size >= 1 && count <= kMostItems)) fail("the array has " + std::to_string(count) + " elements");
    array->sizes.push_back(static_cast<size_t>(size));
    if (array->sizes.size() > kMaxDimensions) fail("the array has more than 5 dimensions");
    expect("]");
  }
  if (array->sizes.empty()) fail_expected("[");
  if (next_is_plainly("{")) {
    size_t next = 0;
    fill_array(array.get(), 0, &next);
  }
  charge(static_cast<size_t>(count) * sizeof(array->items[0]));
  array->items.resize(static_cast<size_t>(count));
  return array;
}

// Items are appended as they are read, so that a false count takes no memory.
void PovInterpreter::fill_array(PovArray* array, size_t dimension, size_t* next) {
  expect("{");
  for (size_t i = 0; i < array->sizes[dimension]; ++i) {
    if (dimension + 1 < array->sizes.size()) {
      fill_array(array, dimension + 1, next);
    } else {
      array->items.push_back(item_for(array));
      ++*next;
    }
    skip_comma();
  }
  expect("}");
}

// What a name or an element is given: a copy of an array that has a name, where macros get the array itself.
PovValue PovInterpreter::kept(PovValue value) {
  if (const auto* array = std::get_if<std::shared_ptr<PovArray>>(&value); array && array->use_count() > 1) {
    charge((*array)->items.size() * sizeof((*array)->items[0]));
    value = std::make_shared<PovArray>(**array);
  }
  return value;
}

PovValue PovInterpreter::item_for(PovArray* array) {
  PovValue item = kept(value());
  enclose(item, &array->depth);
  return item;
}

// Values within values are freed, and functions within functions run, by calls within calls: their depth has
// an end.
void PovInterpreter::enclose(const PovValue& value, size_t* depth) {
  *depth = std::max(*depth, 1 + depth_of(value));
  if (*depth > kMaxValueDepth) fail("arrays or functions are within each other too deep");
}

void PovInterpreter::declare_element(const std::string& name) {
  const PovValue* known = find(name);
  if (!known || !std::holds_alternative<std::shared_ptr<PovArray>>(*known)) fail(name + " is not an array");
  const auto array = std::get<std::shared_ptr<PovArray>>(*known);
  const size_t index = indices_into(*array, name);
  expect("=");
  array->items[index] = item_for(array.get());
  if (next_is_plainly(";")) take();
}

}  // namespace strad
