// Facts as text and as JSON.
#include <cstdio>

#include "solution/facts.h"

namespace strad {
namespace {

// At most 15 digits, without needless zeros. Integers below 10^15 have no exponent.
std::string number_text(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15g", number);
  return text;
}

std::string json_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (code < ' ' || code == 0x7f) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", code);
      result += escape;
    } else {
      result += c;
    }
  }
  return result + "\"";
}

// Control characters in names are replaced, so that a file cannot control a terminal.
std::string plain_text(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = '?';
  return text;
}

void put_json(const Fact& fact, const std::string& indent, std::string* out) {
  const std::string inner = indent + "  ";
  std::string separator;
  if (const auto* number = std::get_if<double>(&fact.value)) {
    *out += number_text(*number);
  } else if (const auto* text = std::get_if<std::string>(&fact.value)) {
    *out += json_text(*text);
  } else if (const auto* list = std::get_if<FactList>(&fact.value)) {
    *out += "[";
    for (const Fact& item : *list) {
      *out += separator + "\n" + inner;
      put_json(item, inner, out);
      separator = ",";
    }
    *out += list->empty() ? "]" : "\n" + indent + "]";
  } else {
    *out += "{";
    for (const auto& [name, value] : std::get<FactGroup>(fact.value)) {
      *out += separator + "\n" + inner + json_text(name) + ": ";
      put_json(value, inner, out);
      separator = ",";
    }
    *out += "\n" + indent + "}";
  }
}

bool is_leaf(const Fact& fact) { return fact.value.index() < 2; }

std::string leaf_text(const Fact& fact) {
  const auto* number = std::get_if<double>(&fact.value);
  return number ? number_text(*number) : plain_text(std::get<std::string>(fact.value));
}

// A list or group that holds only plain values is printed on one line.
std::string one_line(const Fact& fact) {
  std::string line;
  if (const auto* list = std::get_if<FactList>(&fact.value)) {
    for (const Fact& item : *list) line += (line.empty() ? "" : " ") + leaf_text(item);
  } else {
    for (const auto& [name, value] : std::get<FactGroup>(fact.value)) {
      line += (line.empty() ? "" : ", ") + name + " ";
      line += is_leaf(value) ? leaf_text(value) : one_line(value);
    }
  }
  return line;
}

void put_text(const FactGroup& group, const std::string& indent, std::string* out) {
  for (const auto& [name, fact] : group) {
    const std::string start = indent + plain_text(name) + ":";
    const auto* list = std::get_if<FactList>(&fact.value);
    if (is_leaf(fact)) {
      *out += start + " " + leaf_text(fact) + "\n";
    } else if (const auto* inner = std::get_if<FactGroup>(&fact.value)) {
      *out += start + "\n";
      put_text(*inner, indent + "  ", out);
    } else if (!list->empty() && std::get_if<double>(&list->front().value)) {
      *out += start + " " + one_line(fact) + "\n";
    } else {
      *out += start + (list->empty() ? " none\n" : "\n");
      for (const Fact& item : *list)
        *out += indent + "  " + (is_leaf(item) ? leaf_text(item) : one_line(item)) + "\n";
    }
  }
}

}  // namespace

std::string to_json(const Fact& fact) {
  std::string out;
  put_json(fact, "", &out);
  return out + "\n";
}

std::string to_text(const Fact& fact) {
  std::string out;
  put_text(std::get<FactGroup>(fact.value), "", &out);
  return out;
}

}  // namespace strad
