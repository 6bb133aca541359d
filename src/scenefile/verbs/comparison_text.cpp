// Comparisons of pictures as text and JSON.

#include "scenefile/base/text.h"
#include "scenefile/verbs/compare_pictures.h"

#include <fmt/format.h>

namespace scenefile {

std::string not_finite_text(const DecodedPicture& picture) {
  return fmt::format("{} of its pixels {} not finite (NaN or infinite)", picture.not_finite,
                     picture.not_finite == 1 ? "is" : "are");
}

std::string no_mistake_text(std::string_view what) {
  return fmt::format("{}; this is not a mistake by itself", what);
}

std::string causes_text(const PictureComparison& found) {
  if (found.exchanged) {
    return "the second picture shows the scene, and the first does not: give the reference first\n";
  }
  if (found.equal_in_8_bits) {
    return "cause: none; as 8-bit pictures, both are equal\n";
  }
  const CauseReport& report = found.causes;
  std::string text;
  for (const Claim& claim : report.claims) {
    text += fmt::format("cause: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  for (const Claim& claim : report.rivals) {
    if (claim.said) {
      continue;
    }
    text += fmt::format("   or: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  if (found.right_at_other_size) {
    text += found.place ? "cause: none; the part that was compared is right\n"
                        : "cause: none; the picture is right, at another size\n";
  } else if (report.claims.empty() && found.measures.comparable && found.scene_fits()) {
    text +=
        !report.notes.empty()
            ? fmt::format("cause: none; apart from the following, the pictures only differ {}\n",
                          found.details)
        : report.only_details
            ? fmt::format("cause: none; the pictures only differ {}\n", found.details)
        : found.other_outlines
            ? "cause: no known mistake explains the difference, and few edges match: is this a "
              "picture of the same scene, from the same camera?\n"
        : found.scene_used ? "cause: no known mistake explains the difference\n"
                           : "cause: none found from the pictures alone; most causes need "
                             "--scene SCENE, the scene of the pictures\n";
    if (!report.confined.empty()) {
      text += fmt::format("       {}\n", report.confined);
    }
  }
  for (const Claim& claim : report.partial) {
    text += fmt::format("in part: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  for (const Claim& note : report.notes) {
    text += fmt::format(" note: {}\n", no_mistake_text(note.what));
  }
  if (!found.scene_used) {
    return text;
  }
  if (!found.scene_fits()) {
    return text + fmt::format(
                      "the scene does not match the reference: our picture of it differs in "
                      "{:.0f} % of the pixels; is it the right scene, with its textures? If so, "
                      "give the {} that the reference was made with\n",
                      100 * report.share_scene_unlike,
                      found.realtime ? "--parameters, --near, --far, --filter and --milestone"
                                     : "--profile and --features");
  }
  if (!found.drawn_with.empty()) {
    text += fmt::format("reference: {} drawn with {}{}\n", found.drawn_exactly ? "as" : "nearly as",
                        found.drawn_with,
                        found.contradicted.empty()
                            ? ""
                            : fmt::format(", not with {}, which was given", found.contradicted));
  }
  return text;
}

std::string where_text(const PictureComparison& found,
                       const std::function<std::string(const glm::ivec2& pixel)>& command) {
  if (!found.where) {
    return {};
  }
  const PlaceToLook& place = *found.where;
  const WorstRegion& r = place.region;
  std::string text = fmt::format("worst: {},{}..{},{}, {:.0f} % of the difference", r.x0, r.y0,
                                 r.x1, r.y1, 100 * r.share);
  if (place.hit) {
    text +=
        fmt::format("; it shows {}{}", escaped(place.object, 80),
                    place.location.known() ? fmt::format(" (line {})", place.location.line) : "");
  } else if (found.scene_used && found.scene_fits()) {
    text += "; it shows nothing of the scene";
  }
  return text + (command && found.scene_used && found.scene_fits()
                     ? fmt::format("\n       try: {}\n", command({r.x, r.y}))
                     : fmt::format("\n       look at pixel {},{}\n", r.x, r.y));
}

void add_claims(Json& json, std::string_view name, const std::vector<Claim>& claims) {
  json.add_objects(name, claims, [&](const Claim& claim) {
    json.add({{"cause", name_of(claim.cause)},
              {"what", claim.what},
              {"evidence", claim.evidence},
              {"explained", claim.explained}});
    if (claim.said) {
      json.add("said", true);
    }
  });
}

void add_measures(Json& json, const PictureMeasures& m) {
  json.add({{"same_size", m.same_size()},
            {"psnr_db", m.difference.psnr_db},
            {"mean_difference", m.difference.mean}});
  if (m.linear) {
    json.add("max_difference", m.difference.max);
  } else {
    json.add("max_difference", static_cast<int>(m.difference.max));
  }
  json.add({{"share_over", m.difference.share_over},
            {"linear", m.linear},
            {"ssim", m.ssim},
            {"flip_mean", m.flip_mean},
            {"flip_max", m.flip_max}});
}

void add_comparison(Json& json, const PictureComparison& found) {
  json.add({{"same", found.broken.empty()},
            {"scaled", found.resampled},
            {"reference_redrawn", found.drawn}});
  if (found.place) {
    const auto& [corner, size] = *found.place;
    json.add_object("place",
                    {{"x", corner.x}, {"y", corner.y}, {"width", size.x}, {"height", size.y}});
  }
  json.add({{"right_at_other_size", found.right_at_other_size},
            {"exchanged", found.exchanged},
            {"other_outlines", found.other_outlines},
            {"equal_in_8_bits", found.equal_in_8_bits},
            {"confined", found.causes.confined}});
  add_measures(json, found.measures);
  json.add("broken", found.broken);
  add_claims(json, "causes", found.causes.claims);
  add_claims(json, "rivals", found.causes.rivals);
  add_claims(json, "partial", found.causes.partial);
  add_claims(json, "notes", found.causes.notes);
  if (found.where) {
    const auto& [region, hit, object, location] = *found.where;
    json.begin_object("worst");
    json.add({{"x0", region.x0},
              {"y0", region.y0},
              {"x1", region.x1},
              {"y1", region.y1},
              {"x", region.x},
              {"y", region.y},
              {"mean_difference", region.mean},
              {"share", region.share}});
    if (hit) {
      json.add("object", object);
      if (location.known()) {
        json.add("line", location.line);
      }
    }
    json.end_object();
  }
  if (found.scene_used) {
    json.add({{"share_scene_unlike", found.causes.share_scene_unlike},
              {"reference_drawn_with", found.drawn_with},
              {"given_way_contradicted", !found.contradicted.empty()}});
  }
}

}  // namespace scenefile
