#include "frame/cryptomatte.h"

#include <algorithm>
#include <bit>
#include <cstdio>

namespace strad {
namespace {

constexpr size_t kLayers = 3;  // of two things each, as most renderers write

std::string hexadecimal(uint32_t number) {
  char text[9];
  std::snprintf(text, sizeof text, "%08x", number);
  return text;
}

// A string of JSON (RFC 8259).
std::string json_text(const std::string& text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      json += "\\u" + hexadecimal(static_cast<unsigned char>(c)).substr(4);
    } else {
      json += c;
    }
  }
  return json + "\"";
}

uint32_t little_endian(std::string_view bytes) {
  uint32_t word = 0;
  for (size_t i = 0; i < bytes.size(); ++i) word |= uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return word;
}

}  // namespace

uint32_t murmur_hash(std::string_view text) {
  const auto scrambled = [](uint32_t word) { return std::rotl(word * 0xcc9e2d51u, 15) * 0x1b873593u; };
  const auto length = static_cast<uint32_t>(text.size());
  uint32_t hash = 0;
  for (; text.size() >= 4; text.remove_prefix(4))
    hash = std::rotl(hash ^ scrambled(little_endian(text.substr(0, 4))), 13) * 5 + 0xe6546b64u;
  hash ^= scrambled(little_endian(text));
  hash ^= length;
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

float cryptomatte_id(std::string_view name) {
  uint32_t bits = murmur_hash(name);
  const uint32_t exponent = bits >> 23 & 255;
  if (exponent == 0 || exponent == 255) bits ^= 1u << 23;
  return std::bit_cast<float>(bits);
}

void Coverage::add(uint32_t thing, float share) {
  for (auto& [known, sum] : shares_) {
    if (known != thing) continue;
    sum += share;
    return;
  }
  shares_.push_back({thing, share});
}

std::vector<std::pair<uint32_t, float>> Coverage::largest() const {
  std::vector<std::pair<uint32_t, float>> sorted = shares_;
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second > b.second : a.first < b.first;
  });
  return sorted;
}

Cryptomatte::Cryptomatte(std::string name, std::vector<std::string> things, uint32_t width, uint32_t height)
    : name_(std::move(name)), things_(std::move(things)), width_(width) {
  for (const std::string& thing : things_) ids_.push_back(cryptomatte_id(thing));
  for (size_t i = 0; i < kLayers; ++i)
    layers_.push_back(
        {name_ + "0" + std::to_string(i), "RGBA", true, std::vector<float>(size_t{4} * width * height)});
}

void Cryptomatte::set(uint32_t x, uint32_t y, const Coverage& coverage) {
  const auto largest = coverage.largest();
  for (size_t rank = 0; rank < std::min(largest.size(), 2 * kLayers); ++rank) {
    float* pair = &layers_[rank / 2].samples[4 * (size_t{y} * width_ + x) + 2 * (rank % 2)];
    pair[0] = ids_[largest[rank].first];
    pair[1] = largest[rank].second;
  }
}

void Cryptomatte::finish(LayeredImage* image) {
  std::string manifest;
  std::vector<std::string> names = things_;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  for (const std::string& name : names) {
    manifest += (manifest.empty() ? "" : ",") + json_text(name) + ":\"" +
                hexadecimal(std::bit_cast<uint32_t>(cryptomatte_id(name))) + "\"";
  }
  const std::string key = "cryptomatte/" + hexadecimal(murmur_hash(name_)).substr(0, 7) + "/";
  image->texts.push_back({key + "name", name_});
  image->texts.push_back({key + "hash", "MurmurHash3_32"});
  image->texts.push_back({key + "conversion", "uint32_to_float32"});
  image->texts.push_back({key + "manifest", "{" + manifest + "}"});
  for (Layer& layer : layers_) image->layers.push_back(std::move(layer));
}

}  // namespace strad
