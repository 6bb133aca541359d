#include "scenefile/io/asset_roots.h"

#include "scenefile/base/text.h"
#include "scenefile/io/asset_index.h"
#include "scenefile/io/asset_name.h"
#include "scenefile/io/descriptor.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

namespace scenefile {

namespace {

constexpr std::array<std::string_view, 8> sibling_folders{"image", "images", "texture", "textures",
                                                          "mesh",  "meshes", "model",   "models"};
constexpr std::size_t max_searched_entries = 10'000;

// The absolute path without links, "." and ".."; empty if the file does not exist.
std::string canonical(const std::string& path) {
  std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), &std::free);
  if (real == nullptr && errno == ENOMEM) {
    throw std::bad_alloc();
  }
  return real == nullptr ? std::string() : std::string(real.get());
}

std::string joined(const std::string& folder, const std::string& rest) {
  return folder.ends_with('/') ? folder + rest : folder + "/" + rest;
}

bool inside(std::string_view path, std::string_view folder) {
  return path.starts_with(folder) &&
         (folder.ends_with('/') || path.size() == folder.size() || path[folder.size()] == '/');
}

// The number of components, from the end, that path and name share, ignoring case.
std::size_t common_ending(const std::string& path, const AssetName& name) {
  const AssetName other = parse_name(path);
  std::size_t n = 0;
  while (n < std::min(other.parts.size(), name.parts.size()) &&
         lower_case(other.parts[other.parts.size() - 1 - n]) ==
             lower_case(name.parts[name.parts.size() - 1 - n])) {
    ++n;
  }
  return n;
}

// The path of the opened file, because `path` may have become a link since it was checked.
std::string opened_path(const Descriptor& file, const std::string& path) {
  if (std::string opened = canonical(fmt::format("/proc/self/fd/{}", file.get()));
      !opened.empty()) {
    return opened;
  }
  struct stat now {};
  struct stat opened {};
  const bool same = ::stat(path.c_str(), &now) == 0 && ::fstat(file.get(), &opened) == 0 &&
                    now.st_dev == opened.st_dev && now.st_ino == opened.st_ino;
  return same ? canonical(path) : std::string();
}

}  // namespace

std::string_view rule_text(AssetRule rule) {
  switch (rule) {
    case AssetRule::absolute:
      return "as written";
    case AssetRule::scene_folder:
      return "next to the scene";
    case AssetRule::scene_parent:
      return "next to the scene's folder";
    case AssetRule::asset_root:
      return "in an asset root";
    case AssetRule::path_suffix:
      return "by the end of its path";
    case AssetRule::base_name:
      return "by its name alone";
    case AssetRule::not_found:
      return "not found";
  }
  return {};
}

AssetRoots::AssetRoots(AssetRootsOptions options) : options_(std::move(options)) {
  if (own_descriptor(options_.scene_path, 0) < 0) {
    const std::string folder = std::filesystem::path(options_.scene_path).parent_path().string();
    scene_folder_ = canonical(folder.empty() ? "." : folder);
  }
  if (!scene_folder_.empty()) {
    allowed_.push_back(scene_folder_);
    scene_parent_ = std::filesystem::path(scene_folder_).parent_path().string();
    for (const std::string_view name : sibling_folders) {
      // Only real folders, because a link would give access to its target.
      const std::string folder = joined(scene_parent_, std::string(name));
      std::error_code error;
      if (std::filesystem::symlink_status(folder, error).type() ==
          std::filesystem::file_type::directory) {
        allowed_.push_back(folder);
      }
    }
  }
  for (const std::string& root : options_.asset_roots) {
    if (std::string folder = canonical(root); !folder.empty()) {
      given_.push_back(folder);
      allowed_.push_back(std::move(folder));
    }
  }
}

AssetRoots::~AssetRoots() = default;

bool AssetRoots::contains(std::string_view canonical_path) const {
  return options_.allow_outside ||
         std::any_of(allowed_.begin(), allowed_.end(),
                     [&](const std::string& root) { return inside(canonical_path, root); });
}

const AssetIndex& AssetRoots::index() {
  if (index_ == nullptr) {
    index_ = std::make_unique<AssetIndex>(allowed_, max_searched_entries);
  }
  return *index_;
}

/// The search for one name.
class AssetSearch {
 public:
  AssetSearch(AssetRoots& roots, std::string_view written)
      : roots_(roots), written_(written), name_(parse_name(written)) {}

  ResolvedAsset run() {
    if (!by_path() && !by_suffix() && !by_base_name()) {
      explain();
    }
    return std::move(result_);
  }

 private:
  // Returns true if the candidate is the file. Keeps the reason for a failure for the message.
  bool take(const std::string& candidate, AssetRule rule) {
    if (std::find(result_.tried.begin(), result_.tried.end(), candidate) != result_.tried.end()) {
      return false;
    }
    result_.tried.push_back(candidate);
    const std::string path = canonical(candidate);
    if (path.empty() || !roots_.contains(path)) {
      if (const std::string link = link_out_of_roots(candidate); !link.empty()) {
        obstacle_ = fmt::format("{} is a link that leads out of the folders that may be read",
                                escaped(from_scene(link), PATH_MAX));
      }
      return false;
    }
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
      obstacle_ = fmt::format("{} is {}, not a regular file", escaped(candidate, PATH_MAX),
                              kind_of(status));
      return false;
    }
    result_.rule = rule;
    result_.path = path;
    return true;
  }

  bool below(const std::string& folder, const std::string& rest, AssetRule rule) {
    return !folder.empty() && take(joined(folder, rest), rule);
  }

  bool by_path() {
    const std::string path = join_parts(name_.parts, 0);
    if (path.empty()) {
      return false;
    }
    if (name_.absolute) {
      return take("/" + path, AssetRule::absolute);
    }
    return below(roots_.scene_folder_, path, AssetRule::scene_folder) ||
           below(roots_.scene_parent_, path, AssetRule::scene_parent) ||
           by_given(path, AssetRule::asset_root);
  }

  bool by_given(const std::string& path, AssetRule rule) {
    return std::any_of(roots_.given_.begin(), roots_.given_.end(),
                       [&](const std::string& root) { return below(root, path, rule); });
  }

  // Tries the longest suffix first: /course/cs123/data/image/x.png, ..., image/x.png, x.png.
  bool by_suffix() {
    for (std::size_t first = first_plain_part(name_); first < name_.parts.size(); ++first) {
      const std::string path = join_parts(name_.parts, first);
      if (below(roots_.scene_folder_, path, AssetRule::path_suffix) ||
          below(roots_.scene_parent_, path, AssetRule::path_suffix) ||
          by_given(path, AssetRule::path_suffix)) {
        return true;
      }
    }
    return false;
  }

  // Of the files with its base name, ignoring case, the one with the longest end of its path in
  // common; of several, the one that has the name exactly.
  bool by_base_name() {
    if (name_.parts.empty() || name_.parts.back() == "..") {
      return false;
    }
    std::vector<std::string> best;
    std::pair<std::size_t, bool> most;
    for (const std::string& path : roots_.index().find(name_.parts.back())) {
      const std::pair likeness(common_ending(path, name_),
                               path.ends_with("/" + name_.parts.back()));
      if (likeness > most) {
        best.clear();
        most = likeness;
      }
      if (likeness == most) {
        best.push_back(path);
      }
    }
    if (best.size() > 1) {
      obstacle_ = fmt::format("{} files have its name, such as {} and {}", best.size(),
                              escaped(best[0], PATH_MAX), escaped(best[1], PATH_MAX));
    }
    return best.size() == 1 &&
           take(best[0], most.first > 1 ? AssetRule::path_suffix : AssetRule::base_name);
  }

  // The link in the roots through which the path leads out of them; empty if there is none. Follows
  // no link outside, so that the answer is the same whether or not the target exists.
  std::string link_out_of_roots(const std::string& candidate) const {
    constexpr int max_links = 40;
    namespace fs = std::filesystem;
    fs::path here = "/";
    std::string link;
    int links = 0;
    std::vector<fs::path> rest;  // in reverse order
    const auto follow = [&rest](const fs::path& path) {
      const std::vector<fs::path> parts(path.begin(), path.end());
      rest.insert(rest.end(), parts.rbegin(), parts.rend());
    };
    for (follow(candidate); !rest.empty();) {
      const fs::path next = here / rest.back();
      rest.pop_back();
      std::error_code error;
      const fs::path target = roots_.contains(here.string()) ? fs::read_symlink(next, error) : "";
      if (!target.empty() && links++ < max_links) {
        link = next.string();
        follow(target);
      } else {
        here = next.lexically_normal();
      }
    }
    return roots_.contains(here.string()) ? "" : link;
  }

  // The message does not reveal whether a file outside the roots exists, so that scenes cannot be
  // used to probe a machine.
  void explain() {
    result_.error = name_.parts.empty() ? "it is the name of a folder" : obstacle_;
    if (result_.error.empty()) {
      result_.error = "no such file";
      suggest();
      for (const std::string& path : result_.tried) {
        result_.notes.push_back("looked for " + from_scene(path));
      }
      if (result_.tried.empty()) {
        result_.notes.emplace_back("there is no folder to search; give one with --asset-root DIR");
      }
      for (const std::string& root : roots_.index().skipped()) {
        result_.notes.push_back(root + " has too many files to search by name");
      }
    }
    if (!roots_.options_.allow_outside) {
      result_.notes.emplace_back("files elsewhere need --asset-root DIR or --allow-outside");
    }
  }

  // Names a file only if the scene may open it, like all messages.
  void suggest() {
    if (roots_.suggestions_left_ == 0) {
      return;
    }
    --roots_.suggestions_left_;
    for (const std::string& path : roots_.index().find_similar(name_.parts.back())) {
      if (roots_.contains(canonical(path))) {
        result_.notes.push_back(
            fmt::format("did you mean {}?", escaped(from_scene(path), PATH_MAX)));
        return;
      }
    }
  }

  // The path relative to the scene, if it is nearby.
  std::string from_scene(const std::string& path) const {
    if (roots_.scene_folder_.empty()) {
      return path;
    }
    const std::string relative =
        std::filesystem::path(path).lexically_relative(roots_.scene_folder_).string();
    return relative.empty() || relative.starts_with("../../") ? path : relative;
  }

  AssetRoots& roots_;
  std::string_view written_;
  AssetName name_;
  ResolvedAsset result_;
  std::string obstacle_;
};

ResolvedAsset AssetRoots::resolve(const std::string& name) {
  if (const std::string_view why = reject_name(name); !why.empty()) {
    ResolvedAsset rejected;
    rejected.error = why;
    return rejected;
  }
  return AssetSearch(*this, name).run();
}

std::string AssetRoots::path_of(const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path found = resolve(name).path;
  const fs::path path =
      (fs::path(options_.scene_path).parent_path() / found.lexically_relative(scene_folder_))
          .lexically_normal();
  std::error_code error;
  return !found.empty() && fs::equivalent(path, found, error) ? path.string() : found.string();
}

Result<std::string> AssetRoots::read(const std::string& name) {
  ResolvedAsset asset = resolve(name);
  if (!asset.error.empty()) {
    return Error{std::move(asset.error), ErrorKind::environment, std::move(asset.notes)};
  }
  const Result<OpenFile> file = open_regular(asset.path, false, options_.max_bytes);
  if (!file) {
    return file.error();
  }
  if (opened_path(file->descriptor, asset.path) != asset.path) {
    return io_error(asset.path, "changed while it was opened");
  }
  return read_all(file->descriptor.get(), asset.path, file->size, options_.max_bytes);
}

}  // namespace scenefile
