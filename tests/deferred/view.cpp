#include "tests/deferred/view.h"

#include <cmath>
#include <sstream>

namespace deferred {

View::Axes View::axes() const {
  Axes a;
  a.forward = glm::normalize(target - position);
  a.right = glm::normalize(glm::cross(a.forward, up));
  a.up = glm::cross(a.right, a.forward);
  return a;
}

Ray View::ray(double column, double row) const {
  const Axes a = axes();
  const double top = perspective ? std::tan(field_of_view * std::acos(-1.0) / 360) : extent / 2;
  const double x = top * (2 * column - width) / height, y = top * (height - 2 * row) / height;
  const glm::dvec3 aside = x * a.right + y * a.up;
  return perspective ? Ray{position, a.forward + aside} : Ray{position + aside, a.forward};
}

glm::dvec3 View::turned_to_eye(const glm::dvec3& d) const {
  const Axes a = axes();
  return {glm::dot(d, a.right), glm::dot(d, a.up), -glm::dot(d, a.forward)};
}

glm::dvec3 View::to_eye(const glm::dvec3& point) const { return turned_to_eye(point - position); }

double View::distance(const glm::dvec3& point) const { return -to_eye(point).z; }

double View::screen_depth(double d) const {
  return perspective ? (far / d) * (d - near) / (far - near) : (d - near) / (far - near);
}

glm::dvec3 View::from_frame(const glm::dvec3& vertex) const {
  const double share = vertex.z / 32768;
  const double deep = perspective ? near * far / (far - share * (far - near)) : near + share * (far - near);
  const Ray r = ray(vertex.x - 1.5, height - (vertex.y - 0.5));
  return r.origin + deep * r.direction;
}

std::string View::toml() const {
  std::ostringstream text;
  text.precision(17);
  const auto list = [&](const char* name, const glm::dvec3& v) {
    text << name << " = [" << v.x << ", " << v.y << ", " << v.z << "]\n";
  };
  text << "version = 1\nsize = [" << width << ", " << height << "]\n[camera]\nprojection = \""
       << (perspective ? "perspective" : "orthographic") << "\"\n";
  list("position", position);
  list("target", target);
  list("up", up);
  if (perspective) text << "field_of_view = " << field_of_view << "\n";
  if (!perspective) text << "height = " << extent << "\n";
  text << "near = " << near << "\nfar = " << far << "\n";
  return text.str();
}

}  // namespace deferred
