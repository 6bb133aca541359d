#include "scenefile/base/components.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/base/text.h"
#include "scenefile/grade/realtime_causes.h"
#include "scenefile/verbs/explain_tree.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace scenefile {

namespace {

// Rays that change the pixel by less than half an 8-bit step are not described in detail.
constexpr double half_step = 0.5 / 255;

class Explanation {
 public:
  Explanation(const LoadedScene& scene, const ExplainReport& report, const ExplainStyle& style)
      : loaded_(scene),
        scene_(scene.ready.scene),
        pixel_(report.pixel),
        remarks_(report.remarks),
        yours_(report.yours),
        compared_(report.compared),
        realtime_(report.realtime),
        style_(style),
        names_(scene.written, scene.ready.sources) {}

  std::string text() const {
    const RenderOptions& options = pixel_.options;
    std::string text =
        fmt::format("{}, pixel {},{} of {}x{}, {}\n", escaped(shown_name(loaded_.path)), pixel_.x,
                    pixel_.y, options.width, options.height,
                    realtime_ ? realtime_words(realtime_->panel)
                              : fmt::format("profile {}, mode {}", profile_word(options.profile),
                                            mode_word(options.mode)));
    ExplainItem top;
    top.add(result());
    if (yours_) {
      top.add(yours());
    }
    if (!realtime_) {
      top.add(samples());
      top.add(shown_sample());
    } else {
      if (realtime_->pixel.shares.size() > 1 || realtime_->panel.filter != Filter::none) {
        top.add(frame());
      }
      top.add(frame_pixel());
    }
    return text + tree_text(top);
  }

 private:
  std::string bold(std::string_view text) const { return bold_text(text, style_); }
  std::string remark_text(const Remark& remark) const {
    return style_.color ? fmt::format("\033[33m! {}\033[0m", remark.text) : "! " + remark.text;
  }
  std::string color(const Color& c) const { return color_text(c, style_); }

  bool course() const { return pixel_.options.profile == Profile::course; }

  ExplainItem result() const {
    const auto& v = pixel_.value;
    return fmt::format("{} {} = {} {} {} of 255, {}", bold("color"), color(pixel_.color), v[0],
                       v[1], v[2], course() ? "truncated" : "rounded");
  }

  ExplainItem yours() const {
    const auto& v = yours_->value;
    ExplainItem item(fmt::format("{} {} {} {} of 255{}", bold("yours"), v[0], v[1], v[2],
                                 yours_->equal ? ": equals ours" : ""));
    if (compared_) {
      add_compared_lines(item);
    }
    for (const YoursFit& fit : yours_->fits) {
      item.add(fmt::format("equals ours {} = {:.1f} {:.1f} {:.1f} of 255", fit.what, fit.value.x,
                           fit.value.y, fit.value.z));
    }
    if (!yours_->equal && yours_->fits.empty() && !compared_) {
      item.add("no single change of our terms gives this value");
    }
    return item;
  }

  // The lines of `diff`, and what they mean for this pixel.
  void add_compared_lines(ExplainItem& item) const {
    const PictureComparison& found = compared_->found;
    const std::string lines =
        (found.other_size() ? found.broken.front() + '\n' : std::string()) +
        (found.broken.empty() ? "the pictures are equal\n" : causes_text(found));
    for (std::string_view rest = lines; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1)) {
      std::string_view line = rest.substr(0, rest.find('\n'));
      line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
      item.add(std::string(line));
    }
    if (!found.causes.asked) {
      return;
    }
    const std::size_t mistakes = found.causes.claims.size() + found.causes.partial.size();
    const glm::dvec3 with = glm::clamp(found.causes.asked->color, glm::dvec3(0), glm::dvec3(255));
    ExplainItem& sum = item.add(fmt::format(
        "{} with {} = {:.1f} {:.1f} {:.1f} of 255, {}", bold("ours"),
        mistakes == 0   ? "that"
        : mistakes == 1 ? "this mistake"
                        : "these mistakes",
        with.x, with.y, with.z, compared_->explained ? "as yours" : "which is not yours"));
    for (const TermWith& term : compared_->terms) {
      const bool same =
          glm::all(glm::lessThan(glm::abs(term.ours - term.mistaken), glm::dvec3(0.5)));
      sum.add(fmt::format("{} {:.1f} {:.1f} {:.1f}{}", term.name, term.ours.x, term.ours.y,
                          term.ours.z,
                          same ? std::string()
                               : fmt::format(", with it {:.1f} {:.1f} {:.1f}", term.mistaken.x,
                                             term.mistaken.y, term.mistaken.z)));
    }
  }

  std::string object(const ObjectRef& ref) const { return object_text(names_, ref); }

  std::string why_more() const {
    std::vector<std::string_view> reasons;
    if (pixel_.more.noisy) {
      reasons.push_back("the first samples differ");
    }
    if (pixel_.more.penumbra) {
      reasons.push_back("one sees a penumbra");
    }
    if (pixel_.more.neighbors) {
      reasons.push_back("a neighboring pixel differs");
    }
    return reasons.empty() ? "" : fmt::format(", more than at first: {}", fmt::join(reasons, ", "));
  }

  ExplainItem samples() const {
    const std::size_t count = pixel_.samples.size();
    ExplainItem item(fmt::format("{} {}{}", bold("samples"), count, why_more()));
    for (std::size_t i = 0; i < std::min(count, max_explained_samples); ++i) {
      item.add(sample_text(i));
    }
    if (count > max_explained_samples) {
      item.add(fmt::format("and {} more", count - max_explained_samples));
    }
    return item;
  }

  std::string sample_text(std::size_t index) const {
    const SampleRecord& s = pixel_.samples[index];
    std::string text =
        fmt::format("{:>2} at {:.4f},{:.4f}{}: {}, {}, {}", index, s.point.x, s.point.y,
                    s.lens == glm::dvec2(0)
                        ? ""
                        : fmt::format(" through the lens at {:.3f},{:.3f}", s.lens.x, s.lens.y),
                    color(s.color), counted(s.rays, "ray"),
                    s.object.has_value() ? object(*s.object) : "background");
    if (s.refines != no_index) {
      text += fmt::format(", for a quarter of {}", s.refines);
    }
    if (s.refined) {
      text += ", differs from a neighbor: sampled again";
    }
    return text + (index == pixel_.shown ? "  <- shown" : "");
  }

  ExplainItem shown_sample() const {
    const SampleRecord& s = pixel_.samples[pixel_.shown];
    ExplainItem item(fmt::format("{} {}: {}", bold("sample"), pixel_.shown, color(s.color)));
    item.add(ray_item(0));
    return item;
  }

  // How the frame's pixels make up the picture's.
  ExplainItem frame() const {
    const RealtimePixel& pixel = realtime_->pixel;
    ExplainItem item(fmt::format("{} of {}x{} pixels, filter {}", bold("frame"), pixel.frame.x,
                                 pixel.frame.y, word_of(realtime_->panel.filter)));
    std::string_view of_sum = "sum";
    switch (realtime_->panel.filter) {
      case Filter::none:
      case Filter::blur:
      case Filter::sharpen:
        break;
      case Filter::invert:
        of_sum = "1 - sum";
        break;
      case Filter::grayscale:
        of_sum = "0.299 red + 0.587 green + 0.114 blue of the sum";
        break;
    }
    const std::size_t count = pixel.shares.size();
    item.add(fmt::format("color = {} of {} of the frame, counted from the lower left", of_sum,
                         counted(count, "pixel")));
    for (std::size_t i = 0; i < std::min(count, max_explained_samples); ++i) {
      const RealtimeFramePixel& share = pixel.shares[i];
      item.add(
          fmt::format("{:.4f} times {},{}: {}, {}", share.weight, share.at.x, share.at.y,
                      color(pixel_.samples[i].color),
                      share.surface ? object(share.surface->object) : std::string("background")));
    }
    if (count > max_explained_samples) {
      item.add(fmt::format("and {} more", count - max_explained_samples));
    }
    return item;
  }

  ExplainItem frame_pixel() const {
    const RealtimeFramePixel& share = realtime_->pixel.shares[pixel_.shown];
    const RayRecord& ray = pixel_.rays.front();
    ExplainItem item(fmt::format("{} {},{} from the lower left: {}", bold("frame pixel"),
                                 share.at.x, share.at.y,
                                 color(pixel_.samples[pixel_.shown].color)));
    if (ray.surface.has_value()) {
      item.add(surface_item(*ray.surface));
      add_remarks(item, 0, no_index);
      add_terms(item, 0);
    } else {
      item.add("nothing is drawn here: the background is black");
    }
    return item;
  }

  ExplainItem ray_item(std::uint32_t index) const {
    const RayRecord& ray = pixel_.rays[index];
    ExplainItem item(ray_title(ray));
    if (largest(ray.weight * ray.color) < half_step && ray.kind != RayKind::camera) {
      item.text += ray.surface.has_value()
                       ? fmt::format(": hits {}, too faint to show", object(ray.surface->object))
                       : std::string(": hits nothing");
      return item;
    }
    item.add(way_text(ray));
    for (const WallRecord& wall : ray.walls) {
      item.add(wall_item(wall));
    }
    if (!ray.surface.has_value()) {
      item.add("hits nothing: the background is black");
      add_remarks(item, index, no_index);
      return item;
    }
    item.add(surface_item(*ray.surface));
    if (pixel_.options.mode == Mode::normals) {
      item.add("color = (normal + 1) / 2 = " + color(ray.color));
      return item;
    }
    add_remarks(item, index, no_index);
    add_terms(item, index);
    return item;
  }

  static std::string way_text(const RayRecord& ray) {
    std::string text = fmt::format("from {} along {}", vector_text(ray.ray.origin),
                                   vector_text(ray.ray.direction));
    if (ray.start > 0) {
      text += fmt::format(", t > {:.3g}", ray.start);
    }
    if (ray.depth > 1) {
      text += fmt::format(", weight in the sample {}", color_text(ray.weight));
    }
    return text;
  }

  std::string ray_title(const RayRecord& ray) const {
    const bool fresnel = pixel_.options.fresnel;
    switch (ray.kind) {
      case RayKind::camera:
        return fmt::format("{} {}", bold("camera ray"), color(ray.color));
      case RayKind::reflected:
        return branch_title("reflected ray", fresnel ? "ks Cr + F kt Ct" : "ks Cr",
                            pixel_.rays[ray.parent].mirror, ray);
      case RayKind::refracted:
        return branch_title("refracted ray", fresnel ? "(1 - F) kt Ct" : "kt Ct",
                            pixel_.rays[ray.parent].glass, ray);
    }
    return {};
  }

  std::string branch_title(std::string_view name, std::string_view factor,
                           const BranchRecord& branch, const RayRecord& ray) const {
    return fmt::format("{} {} = {} times {} = {}", bold(name), factor, color_text(branch.factor),
                       color_text(ray.color), color(branch.factor * ray.color));
  }

  ExplainItem wall_item(const WallRecord& wall) const {
    return fmt::format("at t = {:.6g} the wall of {}: {} along {}", wall.t, object(wall.object),
                       wall.mirrored ? "mirrored" : "bent", vector_text(wall.direction));
  }

  ExplainItem surface_item(const SurfaceRecord& s) const {
    ExplainItem item(fmt::format("{} {} {} at {} {:.6g}", realtime_ ? "shows" : "hits",
                                 word_of(s.shape), bold(object(s.object)),
                                 realtime_ ? "distance" : "t =", s.t));
    if (s.shape == Shape::mesh) {
      item.add(
          fmt::format("triangle {} of {}", s.triangle, escaped(scene_.mesh_files[s.mesh].name)));
    } else if (realtime_) {
      item.add(fmt::format("triangle {} of the tessellated shape", s.triangle));
    } else {
      item.add(fmt::format("face {}", face_words[static_cast<std::size_t>(s.face)]));
    }
    item.add("point  " + vector_text(s.position) + ", in object space " +
             vector_text(s.object_position));
    item.add(fmt::format("normal {}{}, in object space {}", vector_text(s.normal),
                         s.bumped ? " (by the bump map)" : "", vector_text(s.object_normal)));
    if (realtime_) {
      item.add("normal of the triangle itself " + vector_text(s.geometric));
    } else {
      item.add(fmt::format("ray in object space from {} along {}", vector_text(s.object_ray.origin),
                           vector_text(s.object_ray.direction)));
      item.add(s.has_uv ? fmt::format("uv     {:.6g} {:.6g}", s.uv.x, s.uv.y)
                        : std::string("uv     the mesh has none"));
    }
    if (s.texture.has_value()) {
      const TextureRecord& t = *s.texture;
      item.add(fmt::format("texture {}: texel {},{} = {}, looked up {}, blend {:.4g}",
                           escaped(scene_.texture_files[t.file].name), t.texel.x, t.texel.y,
                           color_text(t.texel_color), color(t.color), t.blend));
    }
    if (pixel_.options.mode != Mode::normals) {
      item.add("D      " + color(s.diffuse_color) +
               (s.texture.has_value() ? " = (1 - blend) kd Cd + blend texture" : " = kd Cd"));
    }
    return item;
  }

  void add_remarks(ExplainItem& item, std::uint32_t ray, std::uint32_t light) const {
    for (const Remark& remark : remarks_) {
      if (remark.ray == ray && remark.light == light) {
        item.add(remark_text(remark));
      }
    }
  }

  void add_terms(ExplainItem& item, std::uint32_t index) const {
    const RayRecord& ray = pixel_.rays[index];
    item.add(fmt::format("{} ka Ca = {}", bold("ambient"), color(ray.ambient)));
    for (const LightRecord& light : ray.lights) {
      item.add(light_item(light, *ray.surface, index));
    }
    for (const BranchRecord* branch : {&ray.mirror, &ray.glass}) {
      if (branch->outcome == BranchOutcome::followed) {
        item.add(ray_item(branch->ray));
      }
    }
    item.add(fmt::format("{} {}{}", bold("sum"), color(ray.sum),
                         ray.sum == ray.color ? "" : ", clamped to 0..1"));
  }

  ExplainItem light_item(const LightRecord& record, const SurfaceRecord& s,
                         std::uint32_t ray) const {
    const RenderLight& light = scene_.lights[record.light];
    const WayPoint at = names_.at(light.source);
    ExplainItem item(fmt::format("{}{} {}", bold(fmt::format("{} light", word_of(light.type))),
                                 place_text(at.location), color(record.contribution)));
    add_remarks(item, ray, record.light);
    if (record.taken == 1 && record.samples.size() == 1) {
      add_light_terms(item, light, record.samples.front(), s);
    } else if (!record.samples.empty()) {
      add_light_samples(item, record);
    }
    return item;
  }

  void add_light_terms(ExplainItem& item, const RenderLight& light, const LightSample& l,
                       const SurfaceRecord& s) const {
    const double n = scene_.materials[s.material].shininess;
    item.add(fmt::format("L = {}, distance {:.6g}, N.L = {:.6g}, R.V = {:.6g}",
                         vector_text(l.to_light), l.distance, l.n_dot_l, l.r_dot_v));
    if (l.diffuse != Color(0)) {
      item.add("diffuse  D (N.L) = " + color(l.diffuse));
    }
    if (l.specular != Color(0)) {
      item.add(fmt::format("specular ks Cs (R.V)^{:.6g} = {}", n, color(l.specular)));
    }
    item.add(fmt::format(
        "light    {} times attenuation {:.6g}{} = {}", color_text(Color(light.color)),
        l.attenuation,
        has_cone(light.type) ? fmt::format(" times spot factor {:.6g}", l.spot_factor) : "",
        color(l.color)));
    if (l.shadow_ray) {
      item.add(shadow_item(l));
    }
  }

  ExplainItem shadow_item(const LightSample& l) const {
    if (l.blockers.empty()) {
      return std::string("shadow   no occluder");
    }
    ExplainItem item("shadow   leaves " + color_text(l.visibility));
    for (const Blocker& blocker : l.blockers) {
      item.add(blocker_text(blocker));
    }
    return item;
  }

  std::string blocker_text(const Blocker& blocker) const {
    return fmt::format(
        "{}{} at t = {:.6g}{}", object(blocker.object), blocker.itself ? " itself" : "", blocker.t,
        blocker.passes == Color(0) ? std::string()
                                   : fmt::format(" lets through {}", color_text(blocker.passes)));
  }

  // For area lights.
  void add_light_samples(ExplainItem& item, const LightRecord& record) const {
    item.add(fmt::format("mean over {} points of the light, {} on its bright side", record.taken,
                         record.samples.size()));
    for (std::size_t i = 0; i < std::min(record.samples.size(), max_explained_samples); ++i) {
      const LightSample& l = record.samples[i];
      ExplainItem point(
          fmt::format("distance {:.6g}, N.L = {:.6g}, R.V = {:.6g}, attenuation {:.6g}: {}",
                      l.distance, l.n_dot_l, l.r_dot_v, l.attenuation, color(l.contribution)));
      for (const Blocker& blocker : l.blockers) {
        point.add("shadow of " + blocker_text(blocker));
      }
      item.add(std::move(point));
    }
  }

  const LoadedScene& loaded_;
  const RenderScene& scene_;
  const PixelRecord& pixel_;
  const std::vector<Remark>& remarks_;
  const std::optional<Yours>& yours_;
  const std::optional<YoursCompared>& compared_;
  const std::optional<RealtimeRecord>& realtime_;
  ExplainStyle style_;
  ObjectNames names_;
};

}  // namespace

std::string explain_text(const LoadedScene& scene, const ExplainReport& report,
                         const ExplainStyle& style) {
  return report.path ? explain_path_text(scene, report, style)
                     : Explanation(scene, report, style).text();
}

}  // namespace scenefile
