#include "trace/add_up.h"

#include "scenefile/trace/no_denormals.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace scenefile::trace_test {

namespace {

// Keeps the first discrepancy.
class Sums {
 public:
  Sums(const RenderScene& scene, const PixelRecord& pixel) : scene_(scene), pixel_(pixel) {}

  std::string check() {
    for (const RayRecord& ray : pixel_.rays) {
      check_ray(ray);
    }
    const SampleRecord& shown = pixel_.samples.at(pixel_.shown);
    expect(pixel_.rays.at(0).color, shown.color, "the first ray is the sample");
    expect(double(pixel_.rays.size()), shown.rays, "every ray has a record");
    expect(mean(), pixel_.color, "the samples are the pixel");
    for (int c = 0; c < 3; ++c) {
      expect(double(static_cast<float>(pixel_.color[c])), pixel_.picture[c], "single precision");
      expect(quantize(pixel_.picture[c], rounding_of(pixel_.options.profile)), pixel_.value[c],
             "8-bit value");
    }
    return wrong_;
  }

 private:
  template <typename T, typename U>
  void expect(const T& sum, const U& recorded, const char* what) {
    if (wrong_.empty() && sum != T(recorded)) {
      wrong_ = what;
    }
  }

  bool course() const { return pixel_.options.profile == Profile::course; }

  void check_ray(const RayRecord& ray) {
    if (!ray.surface.has_value()) {
      expect(ray.color, Color(0), "a ray that hits nothing is black");
      return;
    }
    const SurfaceRecord& s = *ray.surface;
    expect(s.ray.origin + s.t * s.ray.direction, s.position, "the hit is on the ray");
    if (pixel_.options.mode == Mode::normals) {
      expect(0.5 * (s.normal + 1.0), ray.color, "color of a normal");
      return;
    }
    if (ray.inner_wall) {
      expect(ray.local, Color(0), "an inner wall is not lit");
    } else {
      check_local(ray, s);
    }
    check_sum(ray);
  }

  void check_local(const RayRecord& ray, const SurfaceRecord& s) {
    const RenderMaterial& material = scene_.materials.at(s.material);
    expect(double(scene_.global.ambient) * Color(material.ambient), ray.ambient, "ambient");
    check_diffuse(s, material);
    Color sum = ray.ambient;
    for (const LightRecord& light : ray.lights) {
      check_light(light, s, material);
      sum += light.contribution;
    }
    expect(double(ray.lights.size()), double(scene_.lights.size()), "every light has a record");
    expect(sum, ray.local, "ambient and lights");
  }

  void check_sum(const RayRecord& ray) {
    Color bounced(0);
    for (const BranchRecord* branch : {&ray.mirror, &ray.glass}) {
      if (branch->outcome == BranchOutcome::followed) {
        const RayRecord& child = pixel_.rays.at(branch->ray);
        expect(ray.weight * branch->factor, child.weight, "weight of a bounced ray");
        bounced += branch->factor * child.color;
      }
    }
    expect(ray.local + bounced, ray.sum, "mirror and glass");
    expect(course() ? glm::clamp(ray.sum, Color(0), Color(1)) : ray.sum, ray.color, "clamping");
  }

  void check_diffuse(const SurfaceRecord& s, const RenderMaterial& material) {
    const Color plain = double(scene_.global.diffuse) * Color(material.diffuse);
    const Color expected =
        s.texture.has_value() ? glm::mix(plain, s.texture->color, s.texture->blend) : plain;
    expect(expected, s.diffuse_color, "diffuse color");
    expect(double(scene_.global.specular) * Color(material.specular), s.specular_color,
           "specular color");
  }

  void check_light(const LightRecord& record, const SurfaceRecord& s,
                   const RenderMaterial& material) {
    const RenderLight& light = scene_.lights.at(record.light);
    Color sum(0);
    for (const LightSample& sample : record.samples) {
      check_light_sample(light, sample, s, material);
      sum += sample.contribution;
    }
    if (light.type == LightType::area && record.unlit != Unlit::in_this_mode) {
      sum /= double(record.taken);
    }
    expect(sum, record.contribution, "samples of a light");
  }

  void check_light_sample(const RenderLight& light, const LightSample& l, const SurfaceRecord& s,
                          const RenderMaterial& material) {
    expect(Color(light.color) * (l.attenuation * l.spot_factor), l.color, "color of a light");
    expect(glm::dot(s.normal, l.to_light), l.n_dot_l, "N.L");
    expect(s.diffuse_color * std::max(0.0, l.n_dot_l), l.diffuse, "diffuse term");
    const bool shines = l.r_dot_v > 0 && material.shininess > 0;
    // The tracer uses repeated multiplication, std::pow uses logarithms.
    const Color specular =
        shines ? s.specular_color * std::pow(l.r_dot_v, double(material.shininess)) : Color(0);
    const Color gap = glm::abs(specular - l.specular);
    const Color close = 1e-12 * specular;
    expect(gap.r <= close.r && gap.g <= close.g && gap.b <= close.b, true, "specular term");
    const Color share = l.diffuse + l.specular;
    expect(share == Color(0) ? share : share * l.color * l.visibility, l.contribution,
           "contribution of a light");
    if (l.shadow_ray && l.blockers.size() < max_blockers) {
      Color left(1);
      for (const Blocker& blocker : l.blockers) {
        left *= blocker.passes;
      }
      const Color miss = glm::abs(left - l.visibility);
      expect(std::max({miss.r, miss.g, miss.b}) < 1e-9, true,
             "the listed occluders cause the shadow");
    }
  }

  // The color of a sample, or of the sample that represents it.
  Color value_of(std::uint32_t index) const {
    const SampleRecord& sample = pixel_.samples[index];
    return sample.refined ? quarter_sum(index) : sample.color;
  }

  Color quarter_sum(std::uint32_t refined) const {
    Color sum(0);
    for (std::uint32_t i = 0; i < pixel_.samples.size(); ++i) {
      if (pixel_.samples[i].refines == refined) {
        sum += value_of(i);
      }
    }
    return sum / 4.0;
  }

  Color mean() const {
    Color sum(0);
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < pixel_.samples.size(); ++i) {
      if (pixel_.samples[i].refines == no_index) {
        sum += value_of(i);
        ++count;
      }
    }
    return sum / double(count);
  }

  const RenderScene& scene_;
  const PixelRecord& pixel_;
  std::string wrong_;
};

}  // namespace

std::string what_does_not_add_up(const RenderScene& scene, const PixelRecord& pixel) {
  const NoDenormals no_denormals;  // like the tracer
  return Sums(scene, pixel).check();
}

std::string what_differs(const PixelRecord& pixel, const Image& image) {
  const float* const drawn = image.pixel(pixel.x, pixel.y);
  if (std::equal(pixel.picture.begin(), pixel.picture.end(), drawn)) {
    return "";
  }
  std::ostringstream text;
  text.precision(9);
  for (int c = 0; c < 3; ++c) {
    text << (c == 0 ? "explained " : " ") << pixel.picture[c];
  }
  for (int c = 0; c < 3; ++c) {
    text << (c == 0 ? ", drawn " : " ") << drawn[c];
  }
  return text.str();
}

}  // namespace scenefile::trace_test
