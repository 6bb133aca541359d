#include "scenefile/verbs/grade_references.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/verbs/findings.h"
#include "scenefile/verbs/grade_files.h"
#include "scenefile/verbs/grade_paths.h"
#include "scenefile/verbs/load_file.h"
#include "scenefile/verbs/realtime_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace scenefile {

namespace {

// Pictures with a smaller mean square difference, in 1/255, show the same scene: this is a PSNR of
// 32 dB, which another program reaches in spite of different edges.
constexpr double same_scene_mean_square = 40;

constexpr double infinity = std::numeric_limits<double>::infinity();

// To recognize a picture, some 30,000 of its values are enough: every step_of()th. Not a multiple
// of 3, so that they come from all channels.
std::size_t step_of(const Texture& picture) {
  const std::size_t step = std::max<std::size_t>(1, picture.rgb.size() / 30000);
  return step % 3 == 0 ? step + 1 : step;
}

// The mean square difference of two pictures of the same size, over those values; infinite if it
// is larger than `limit`.
double mean_square(const Texture& a, const Texture& b, double limit) {
  const std::size_t step = step_of(a);
  const std::size_t count = (a.rgb.size() + step - 1) / step;
  const double enough = limit * static_cast<double>(count);
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += step) {
    const double d = static_cast<double>(a.rgb[i]) - b.rgb[i];
    sum += d * d;
    if (sum > enough) {
      return infinity;
    }
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, count));
}

// The variance of these values.
double variance(const Texture& picture) {
  double sum = 0;
  double squares = 0;
  double count = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += step_of(picture)) {
    const double value = picture.rgb[i];
    sum += value;
    squares += value * value;
    ++count;
  }
  return count == 0 ? 0 : squares / count - (sum / count) * (sum / count);
}

class ReferenceLoader {
 public:
  ReferenceLoader(const GradeRequest& request, const std::function<void(const char*)>& entering,
                  ClassReferences& found)
      : request_(request), entering_(entering), found_(found) {}

  Result<void> load(const LoadShownScene& load_scene) {
    if (request_.path) {
      const Result<void> loaded = load_path_references(load_scene);
      return loaded ? check_map() : loaded;
    }
    std::vector<Error> errors;
    const auto found_below = [&](const std::string& folder, bool (*wanted)(std::string_view)) {
      std::vector<FoundFile> found;
      for (const std::string& path : files_below(folder, errors)) {
        if (wanted(path)) {
          found.push_back(found_file(folder, path));
        }
      }
      return found;
    };
    const std::vector<FoundFile> scenes =
        found_below(request_.scenes.empty() ? request_.references : request_.scenes, is_scene_name);
    found_.files = found_below(request_.references, is_picture_name);
    if (!errors.empty()) {
      return errors.front();
    }
    if (const Result<void> refused = refuse_submissions(found_.files); !refused) {
      return refused;
    }
    for (const FoundFile& file : found_.files) {
      add_input("reference", file.path);
    }
    for (const FoundFile& scene : scenes) {
      add_input("scene of a reference", scene.path);
    }
    drop_copies();
    if (const Result<void> read = read_settings(); !read) {
      return read.error();
    }
    std::vector<int> scene_of = match_scenes(scenes);
    drop_textures(scenes, scene_of);
    const std::vector<std::string> names = reference_names(found_.files);
    for (std::size_t i = 0; i < found_.files.size(); ++i) {
      if (entering_) {
        entering_("reading a picture");
      }
      const Result<std::string> bytes = read_file(found_.files[i].path, Limits{}.file_bytes);
      if (!bytes) {
        return bytes.error();
      }
      Result<DecodedPicture> picture =
          decode_picture_file(*bytes, found_.files[i].path, request_.layer);
      if (!picture) {
        return Error{fmt::format("{}; it was taken as a reference, because it is in {}",
                                 picture.error().text, quoted(request_.references, 400)),
                     picture.error().kind};
      }
      ClassReference reference{names[i], *std::move(picture), std::nullopt, {}};
      if (scene_of[i] >= 0) {
        reference.scene = load_scene(scenes[static_cast<std::size_t>(scene_of[i])].path);
      }
      Hash of_file;
      of_file.add(*bytes);
      reference.fingerprint = of_file.value();
      found_.fingerprint.add(names[i]);
      add_number(found_.fingerprint, reference.fingerprint);
      if (reference.scene) {
        found_.fingerprint.add(reference.scene->text);
        add_number(found_.fingerprint, reference.scene->asset_fingerprint);
      }
      reference.ways_to_try = ways_of(found_.files[i]);
      found_.all.push_back(std::move(reference));
    }
    if (found_.all.empty()) {
      return Error{fmt::format("{} contains no pictures", quoted(request_.references, 400))};
    }
    return check_map();
  }

 private:
  // References are configurations of the path tracer.
  Result<void> load_path_references(const LoadShownScene& load_scene) {
    Result<std::vector<PathReference>> found =
        path_references(request_.references, request_.scenes, *request_.path, found_.notes);
    if (!found) {
      return found.error();
    }
    std::vector<FoundFile> files;
    for (const PathReference& one : *found) {
      files.push_back(one.file);
    }
    if (const Result<void> refused = refuse_submissions(files); !refused) {
      return refused;
    }
    for (PathReference& one : *found) {
      add_input("configuration", one.file.path);
      add_input("scene of a reference", one.scene);
      ClassReference& reference = found_.all.emplace_back();
      reference.scene = load_scene(one.scene);
      if (!reference.scene->usable()) {
        return Error{fmt::format("{}: its scene {} cannot be used{}", escaped(one.file.path, 400),
                                 quoted(one.scene, 400),
                                 request_.scenes.empty()
                                     ? "; it is relative to the working directory, or to --scenes"
                                     : ""),
                     failure_of(*reference.scene).value_or(ErrorKind::input)};
      }
      reference.path = one.options;
      found_.fingerprint.add(one.text);
      found_.fingerprint.add(reference.scene->text);
      add_number(found_.fingerprint, reference.scene->asset_fingerprint);
      found_.files.push_back(std::move(one.file));
    }
    const std::vector<std::string> names = reference_names(found_.files);
    for (std::size_t i = 0; i < names.size(); ++i) {
      found_.all[i].name = names[i];
    }
    return {};
  }

  // Fails if files that were handed in are among the references: students would be graded against
  // each other.
  Result<void> refuse_submissions(const std::vector<FoundFile>& files) const {
    const auto is_below = [](const std::string& folder, const std::string& other) {
      return folder == other || folder.starts_with(other == "/" ? other : other + "/");
    };
    const auto real_path = [](const std::string& folder) {
      return real_folder_of(folder + "/file");
    };
    // Not if the references are in the folder of the class, which then contains more than students.
    const std::string handed_in = real_path(request_.handed_in);
    if (!is_folder(request_.handed_in) || !is_below(handed_in, real_path(request_.references))) {
      return {};
    }
    const auto submission = std::find_if(files.begin(), files.end(), [&](const FoundFile& file) {
      return is_below(real_folder_of(file.path), handed_in);
    });
    return submission == files.end()
               ? Result<void>()
               : Error{
                     fmt::format("{} was handed in, but would be a reference, because it is in {}: "
                                 "keep the references in a folder without submissions",
                                 quoted(submission->path, 400), quoted(request_.references, 400)),
                     ErrorKind::usage};
  }

  // Whether all references of the map exist.
  Result<void> check_map() const {
    for (const NamePair& pair : request_.map) {
      if (std::none_of(found_.files.begin(), found_.files.end(),
                       [&](const FoundFile& file) { return is_named(file, pair.reference); })) {
        return Error{fmt::format("the map assigns {} to the reference {}, but {} has no such file",
                                 quoted(pair.handed_in, 400), quoted(pair.reference, 400),
                                 quoted(request_.references, 400)),
                     ErrorKind::input};
      }
    }
    return {};
  }

  // The settings of references of the assignment Realtime, if a table gives them.
  Result<void> read_settings() {
    const std::string path = settings_table(request_.references);
    if (path.empty()) {
      return {};
    }
    add_input("table", path);
    const Result<std::string> text = read_file(path, Limits{}.file_bytes);
    if (!text) {
      return text.error();
    }
    found_.fingerprint.add(*text);
    std::string wrong;
    table_ = read_realtime_table(*text, wrong);
    if (!wrong.empty()) {
      return Error{
          fmt::format("{} in {}: {}", realtime_table_name, quoted(request_.references, 400), wrong),
          ErrorKind::input};
    }
    return {};
  }

  // Folders of scenes may contain their textures: pictures in such a folder are references only if
  // a scene has their name, or if nothing else is a reference.
  void drop_textures(const std::vector<FoundFile>& scenes, std::vector<int>& scene_of) {
    const auto is_texture = [&](std::size_t i) {
      return !scenes.empty() && scene_of[i] < 0 && is_in_texture_folder(found_.files[i]) &&
             row_of(table_, found_.files[i]) == nullptr;
    };
    std::vector<FoundFile> files;
    std::vector<int> of_files;
    for (std::size_t i = 0; i < found_.files.size(); ++i) {
      if (!is_texture(i)) {
        files.push_back(found_.files[i]);
        of_files.push_back(scene_of[i]);
      }
    }
    if (!files.empty()) {
      found_.files = std::move(files);
      scene_of = std::move(of_files);
    }
  }

  // The same reference in several formats counts once, in the best one.
  void drop_copies() {
    std::vector<FoundFile> files;
    for (FoundFile& file : found_.files) {
      const auto same = std::find_if(files.begin(), files.end(), [&](const FoundFile& other) {
        return other.stem == file.stem && other.folders == file.folders;
      });
      if (same == files.end()) {
        files.push_back(std::move(file));
      } else if (format_rank(file) < format_rank(*same)) {
        *same = std::move(file);
      }
    }
    found_.files = std::move(files);
  }

  // The ways in which a reference may have been drawn; the table's settings take precedence.
  std::vector<DrawnWay> ways_of(const FoundFile& file) const {
    const RealtimeRow* const row = row_of(table_, file);
    if (row == nullptr || !std::any_of(request_.compare.ways.begin(), request_.compare.ways.end(),
                                       [](const DrawnWay& way) { return way.realtime; })) {
      return folder_first(file.path, request_.compare.ways);
    }
    return {realtime_way(row->panel, {})};
  }

  // A scene may belong to several references: intersect and illuminate.
  std::vector<int> match_scenes(const std::vector<FoundFile>& scenes) const {
    std::vector<int> result;
    for (const FoundFile& file : found_.files) {
      const RealtimeRow* const row = row_of(table_, file);
      const int named = row == nullptr ? -1 : file_named(scenes, row->scene);
      const int matched = named >= 0 ? named : best_named(file, scenes);
      result.push_back(matched >= 0 ? matched : scene_of_variant(file, scenes));
    }
    return result;
  }

  void add_input(std::string_view role, const std::string& path) {
    found_.inputs.push_back(input_file(role, path));
  }

  const GradeRequest& request_;
  const std::function<void(const char*)>& entering_;
  ClassReferences& found_;
  std::vector<RealtimeRow> table_;
};

}  // namespace

Result<ClassReferences> load_references(const GradeRequest& request,
                                        const LoadShownScene& load_scene,
                                        const std::function<void(const char* phase)>& entering) {
  ClassReferences found;
  const Result<void> loaded = ReferenceLoader(request, entering, found).load(load_scene);
  return loaded ? Result<ClassReferences>(std::move(found)) : loaded.error();
}

const ClassReference* shown_instead(const ClassReferences& references,
                                    const ClassReference& reference, const Texture& picture) {
  const auto off = [&](const ClassReference& r, double limit) {
    const Texture& other = r.picture.texture;
    return other.width == picture.width && other.height == picture.height
               ? mean_square(other, picture, limit)
               : infinity;
  };
  const double here = off(reference, infinity);
  const ClassReference* best = nullptr;
  double least = same_scene_mean_square;
  for (const ClassReference& r : references.all) {
    if (r.scene && reference.scene && r.scene->text == reference.scene->text) {
      continue;
    }
    if (const double there = off(r, std::min(least, here / 20));
        there < least && 20 * there < here && 20 * there < variance(r.picture.texture)) {
      best = &r;
      least = there;
    }
  }
  return best;
}

UsedFile input_file(std::string_view role, const std::string& path) {
  return {path, fmt::format("the {} {}", role, escaped(path))};
}

void add_number(Hash& hash, std::uint64_t number) {
  hash.add({reinterpret_cast<const char*>(&number), sizeof number});
}

}  // namespace scenefile
