// The motion chunk to bytes and back.
#include "scene/motion_io.h"

#include "scene/rgb_io.h"

namespace strad {
namespace {

void put_vec3(Bytes* to, Vec3 v) {
  for (int axis = 0; axis < 3; ++axis) put_f64(to, v[axis]);
}

Vec3 get_vec3(ByteReader* from) {
  Vec3 v;
  for (int axis = 0; axis < 3; ++axis) v[axis] = from->f64();
  return v;
}

void put_key(Bytes* to, const BodyKey& key) {
  put_f64(to, key.time);
  put_vec3(to, key.move);
  put_u8(to, key.has_quat ? 1 : 0);
  if (!key.has_quat) return put_f64(to, key.turn);
  for (const double part : {key.quat.w, key.quat.x, key.quat.y, key.quat.z}) put_f64(to, part);
}

void get_key(ByteReader* from, BodyKey* key) {
  key->time = from->f64();
  key->move = get_vec3(from);
  key->has_quat = from->number(1, "the kind of a turn") == 1;
  if (!key->has_quat) {
    key->turn = from->f64();
    return;
  }
  for (double* part : {&key->quat.w, &key->quat.x, &key->quat.y, &key->quat.z}) *part = from->f64();
}

void put_key(Bytes* to, const SpotKey& key) {
  put_f64(to, key.time);
  put_vec3(to, key.at);
  put_vec3(to, key.aim);
  put_rgb(to, key.intensity);
}

void get_key(ByteReader* from, SpotKey* key) {
  key->time = from->f64();
  key->at = get_vec3(from);
  key->aim = get_vec3(from);
  key->intensity = get_rgb(from);
}

void put_key(Bytes* to, const GlowKey& key) {
  put_f64(to, key.time);
  put_f32(to, key.value);
}

void get_key(ByteReader* from, GlowKey* key) {
  key->time = from->f64();
  key->value = from->f32();
}

void put_key(Bytes* to, const CameraKey& key) {
  put_f64(to, key.time);
  for (const Vec3& v : {key.from, key.to, key.up}) put_vec3(to, v);
  put_f64(to, key.fov);
}

void get_key(ByteReader* from, CameraKey* key) {
  key->time = from->f64();
  for (Vec3* v : {&key->from, &key->to, &key->up}) *v = get_vec3(from);
  key->fov = from->f64();
}

constexpr size_t kSmallestKey = 12;  // a glow's

template <typename Key>
void put_keys(Bytes* to, const std::vector<Key>& keys) {
  put_varint(to, keys.size());
  for (const Key& key : keys) put_key(to, key);
}

template <typename Key>
void get_keys(ByteReader* from, std::vector<Key>* keys) {
  keys->resize(from->count(kSmallestKey, "keys"));
  for (Key& key : *keys) get_key(from, &key);
}

void put(Bytes* to, const Body& body) {
  put_text(to, body.name);
  put_varint(to, body.parent);
  put_vec3(to, body.pivot);
  put_vec3(to, body.axis);
  put_u8(to, static_cast<uint8_t>(body.ease));
  put_varint(to, body.parts.size());
  for (const std::string& part : body.parts) put_text(to, part);
  put_keys(to, body.keys);
}

void get(ByteReader* from, Body* body) {
  body->name = from->text();
  body->parent = from->number(kNone, "a parent");
  body->pivot = get_vec3(from);
  body->axis = get_vec3(from);
  body->ease = static_cast<Ease>(from->number(static_cast<uint64_t>(Ease::kSmooth), "an easing"));
  body->parts.resize(from->count(1, "parts"));
  for (std::string& part : body->parts) part = from->text();
  get_keys(from, &body->keys);
}

void put(Bytes* to, const Spot& spot) {
  put_text(to, spot.name);
  put_varint(to, spot.body);
  put_f64(to, spot.inner);
  put_f64(to, spot.outer);
  put_keys(to, spot.keys);
}

void get(ByteReader* from, Spot* spot) {
  spot->name = from->text();
  spot->body = from->number(kNone, "a body");
  spot->inner = from->f64();
  spot->outer = from->f64();
  get_keys(from, &spot->keys);
}

void put(Bytes* to, const Glow& glow) {
  put_varint(to, glow.material);
  put_keys(to, glow.keys);
}

void get(ByteReader* from, Glow* glow) {
  glow->material = from->number(kNone, "a material");
  get_keys(from, &glow->keys);
}

void put(Bytes* to, const Camera& camera) {
  put_text(to, camera.name);
  put_keys(to, camera.keys);
}

void get(ByteReader* from, Camera* camera) {
  camera->name = from->text();
  get_keys(from, &camera->keys);
}

template <typename Item>
void put_list(Bytes* to, const std::vector<Item>& items) {
  put_varint(to, items.size());
  for (const Item& item : items) put(to, item);
}

// `bytes_each`: the least size of an item.
template <typename Item>
void get_list(ByteReader* from, size_t bytes_each, const char* what, std::vector<Item>* items) {
  items->assign(from->count(bytes_each, what), Item{});
  for (Item& item : *items) get(from, &item);
}

}  // namespace

void put_motion(Bytes* to, const Scene& scene) {
  put_f64(to, scene.start);
  put_f64(to, scene.end);
  put_f64(to, scene.rate);
  put_list(to, scene.bodies);
  put_list(to, scene.spots);
  put_list(to, scene.glows);
  put_list(to, scene.cameras);
}

Bytes motion_of_light(const Scene& scene) {
  Bytes bytes;
  put_f64(&bytes, scene.start);
  put_f64(&bytes, scene.end);
  put_list(&bytes, scene.bodies);
  put_list(&bytes, scene.spots);
  put_list(&bytes, scene.glows);
  for (const Object& object : scene.objects) put_varint(&bytes, object.body);
  return bytes;
}

void get_motion(ByteReader* from, Scene* scene) {
  scene->start = from->f64();
  scene->end = from->f64();
  scene->rate = from->f64();
  get_list(from, 53, "bodies", &scene->bodies);
  get_list(from, 19, "spots", &scene->spots);
  get_list(from, 2, "glows", &scene->glows);
  get_list(from, 2, "cameras", &scene->cameras);
}

}  // namespace strad
