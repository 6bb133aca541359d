// Enforces the table in ARCHITECTURE.md of which room may include which, by reading #include lines.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path source_root = SCENEFILE_ROOT;

// The rooms, or single headers, that each room may include.
const std::map<std::string, std::set<std::string>> may_know = {
    {"base", {}},
    {"scene", {"base"}},
    {"geometry", {"base"}},
    {"format", {"base", "scene"}},
    {"asset", {"base", "geometry"}},
    {"export", {"base", "geometry", "scene", "asset", "format/write_text.h"}},
    {"import",
     {"base", "geometry", "scene", "asset", "export/flat_mesh.h", "export/phong_pbr.h",
      "format/json_parser.h", "format/text_places.h"}},
    {"edit", {"base", "scene", "format"}},
    {"compare", {"base", "asset"}},
    {"io", {"base"}},
    {"mistakes", {"base", "scene", "geometry", "asset", "trace"}},
    {"grade", {"base", "scene", "geometry", "asset", "compare", "trace", "mistakes"}},
    {"gradebook", {"base", "compare", "mistakes"}},
    {"placement", {"base", "geometry", "asset", "scene/render_scene.h"}},
    {"trace", {"base", "geometry", "asset", "placement", "scene/render_scene.h"}},
    {"path", {"base", "geometry", "asset", "trace", "scene/render_scene.h"}},
    {"noise",
     {"base", "geometry", "asset", "trace", "path", "mistakes/cause.h", "scene/render_scene.h"}},
    {"view", {"base", "geometry", "asset", "scene/render_scene.h", "trace/render_options.h"}},
    {"explain", {"base", "scene", "geometry", "trace"}},
    {"verbs",
     {"base", "scene", "format", "asset", "geometry", "compare", "io", "placement", "trace", "path",
      "noise", "explain", "mistakes", "grade", "gradebook", "edit", "export/codes.h",
      "import/codes.h", "view/codes.h"}},
    {"lsp", {"base", "scene", "format", "asset", "edit", "verbs"}},
    {"viewer",
     {"base", "scene", "format", "geometry", "asset", "compare", "io", "placement", "trace", "path",
      "view", "explain", "edit"}},
};

// Each library except the standard library and glm is used by a single .cpp file. fmt is allowed in
// every .cpp; operating system headers only in io.
const std::map<std::string, std::string> third_party = {
    {"expat.h", "format/xml_judge.cpp"},     {"png.h", "asset/png_file.cpp"},
    {"jpeglib.h", "asset/jpeg_file.cpp"},    {"zlib.h", "asset/zlib_bytes.cpp"},
    {"isa-l/", "asset/isal_packer.cpp"},     {"openexr.h", "asset/exr_reader.cpp"},
    {"embree3/", "trace/embree_scenes.cpp"}, {"embree4/", "trace/embree_scenes.cpp"},
    {"tbb/", "trace/tbb_tasks.cpp"},         {"oneapi/", "trace/tbb_tasks.cpp"},
    {"EGL/", "view/headless.cpp"},           {"hwy/", "trace/wavefront.cpp"},
    {"GLFW/", "viewer/window.cpp"},          {"GL/", "viewer/gl_picture.cpp"},
    {"archive.h", "io/archive.cpp"},         {"archive_entry.h", "io/archive.cpp"},
};

struct Include {
  fs::path file;     ///< below the folder that was searched
  std::string name;  ///< between the brackets or quotes
};

std::vector<Include> includes_below(const fs::path& folder) {
  const std::regex line_pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> includes;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") {
      continue;
    }
    std::ifstream file(entry.path());
    std::smatch match;
    for (std::string line; std::getline(file, line);) {
      if (std::regex_search(line, match, line_pattern)) {
        includes.push_back({fs::relative(entry.path(), folder), match[1]});
      }
    }
  }
  return includes;
}

std::vector<Include> all_includes() {
  return includes_below(source_root / "src/scenefile");
}

std::string room_of(const fs::path& file) {
  return file.begin()->string();
}

TEST(IncludeLaw, RoomsKnowOnlyTheRoomsBelowThem) {
  const std::string prefix = "scenefile/";
  for (const Include& i : all_includes()) {
    if (!i.name.starts_with(prefix)) {
      continue;
    }
    const std::string target = i.name.substr(prefix.size());
    const std::string from = room_of(i.file);
    ASSERT_TRUE(may_know.contains(from)) << from << " is in no row of the table";
    const std::set<std::string>& known = may_know.at(from);
    const std::string to = room_of(target);
    EXPECT_TRUE(to == from || known.contains(to) || known.contains(target))
        << i.file << " includes " << i.name;
    EXPECT_TRUE(fs::exists(source_root / "src" / i.name)) << i.file << " includes " << i.name;
  }
}

// Two types with one name in one namespace break programs that link both rooms, in ways that no
// compiler reports.
TEST(Names, OfTypesInHeadersAreUniqueInTheirNamespace) {
  const std::regex type_pattern(R"(^(?:struct|class|enum class) (\w+)(?!\w|::)[^;]*$)");
  const std::regex space_pattern(R"(^namespace (\w+(?:::\w+)*) \{)");
  std::map<std::string, fs::path> first;
  for (const auto& entry : fs::recursive_directory_iterator(source_root / "src/scenefile")) {
    const std::string name = entry.path().filename();
    if (!name.ends_with(".h") || name.ends_with("-inl.h")) {  // those are in many namespaces
      continue;
    }
    std::ifstream file(entry.path());
    std::string space;
    std::smatch match;
    for (std::string line; std::getline(file, line);) {
      if (std::regex_search(line, match, space_pattern)) {
        space = match[1];
      } else if (std::regex_search(line, match, type_pattern)) {
        const auto [one, is_new] = first.emplace(space + "::" + match[1].str(), entry.path());
        EXPECT_TRUE(is_new) << one->first << " is in " << one->second << " and " << entry.path();
      }
    }
  }
  EXPECT_GT(first.size(), 300u);
}

// A room's CMakeLists.txt lists the headers that are installed.
std::set<std::string> installed_headers() {
  const std::regex list_pattern(R"(HEADERS\s+([^)]*?)\s(PUBLIC|PRIVATE|PROGRAM_ONLY))");
  const std::regex header_pattern(R"([\w/]+\.h)");
  std::set<std::string> headers;
  for (const auto& [room, known] : may_know) {
    std::ifstream file(source_root / "src/scenefile" / room / "CMakeLists.txt");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::smatch list;
    if (text.find("PROGRAM_ONLY") != std::string::npos ||
        !std::regex_search(text, list, list_pattern)) {
      continue;
    }
    const std::string names = list[1];
    for (std::sregex_iterator name(names.begin(), names.end(), header_pattern), end; name != end;
         ++name) {
      headers.insert(room + "/" + name->str());
    }
  }
  return headers;
}

TEST(IncludeLaw, InstalledHeadersIncludeInstalledHeaders) {
  const std::string prefix = "scenefile/";
  const std::set<std::string> installed = installed_headers();
  EXPECT_TRUE(installed.contains("base/diagnostics.h"));
  EXPECT_TRUE(installed.contains("verbs/load_scene.h"));
  for (const Include& i : all_includes()) {
    if (installed.contains(i.file.generic_string()) && i.name.starts_with(prefix)) {
      EXPECT_TRUE(installed.contains(i.name.substr(prefix.size())))
          << i.file << " is installed and includes " << i.name;
    }
  }
}

TEST(IncludeLaw, OneThirdPartyLibraryInOneFile) {
  for (const Include& i : all_includes()) {
    for (const auto& [library, home] : third_party) {
      if (i.name.starts_with(library)) {
        EXPECT_EQ(i.file.generic_string(), home) << "includes " << i.name;
      }
    }
  }
}

TEST(IncludeLaw, OneReaderAndOneWriterOfJson) {
  for (const Include& i : all_includes()) {
    if (i.name.starts_with("rapidjson/")) {
      const std::string file = i.file.generic_string();
      EXPECT_TRUE(file == "format/json_parser.cpp" || file == "verbs/json_writer.cpp") << file;
    }
  }
}

TEST(IncludeLaw, OfVerbsOnlyLoadingAndClassesOpenFiles) {
  const std::set<std::string> openers{"load_file",   "carry_files",     "class_files",
                                      "list_class",  "grade_class",     "grade_files",
                                      "grade_paths", "grade_references"};
  for (const Include& i : all_includes()) {
    if (room_of(i.file) == "verbs" && i.name.starts_with("scenefile/io/")) {
      EXPECT_TRUE(openers.contains(i.file.stem().string())) << i.file << " includes " << i.name;
    }
  }
}

TEST(IncludeLaw, ImGuiOnlyInThePanelsOfTheWindow) {
  for (const Include& i : all_includes()) {
    if (i.name.starts_with("imgui") || i.name.starts_with("backends/")) {
      const std::string file = i.file.generic_string();
      EXPECT_TRUE(file == "viewer/window.cpp" ||
                  (file.starts_with("viewer/gui") && file.ends_with(".cpp")))
          << file << " includes " << i.name;
    }
  }
}

TEST(IncludeLaw, HeadersShowNoLibraryButGlm) {
  const std::regex standard(R"(^[a-z_]+$)");
  for (const Include& i : all_includes()) {
    if (i.file.extension() == ".h") {
      EXPECT_TRUE(i.name.starts_with("scenefile/") || i.name.starts_with("glm/") ||
                  i.name == "immintrin.h" || std::regex_match(i.name, standard))
          << i.file << " includes " << i.name;
    }
  }
}

TEST(IncludeLaw, TheProgramKeepsItsLibrariesInOneFileEach) {
  const std::map<std::string, std::string> homes = {
      {"CLI/", "options.cpp"}, {"rapidjson/", ""}, {"expat.h", ""}, {"png.h", ""}};
  for (const Include& i : includes_below(source_root / "app")) {
    for (const auto& [library, home] : homes) {
      EXPECT_TRUE(!i.name.starts_with(library) || i.file == home) << i.file << ": " << i.name;
    }
    if (i.file.extension() == ".h") {
      EXPECT_FALSE(i.name.starts_with("fmt/")) << i.file;
    }
  }
}

TEST(IncludeLaw, OperatingSystemOnlyInIo) {
  const std::regex system(
      R"(^(unistd|fcntl|dirent|signal|poll|sys/.*)\.h$|^(csignal|filesystem)$)");
  for (const Include& i : all_includes()) {
    if (std::regex_match(i.name, system)) {
      EXPECT_EQ(room_of(i.file), "io") << i.file << " includes " << i.name;
    }
  }
}

TEST(IncludeLaw, PortableRoomsUseNothingThatOldCompilersLack) {
  const std::set<std::string> portable = {"base",    "scene",  "format", "geometry", "asset",
                                          "compare", "export", "import", "placement"};
  const std::set<std::string> lacking = {"format", "expected", "source_location",
                                         "ranges", "thread",   "mutex",
                                         "future", "fstream",  "print"};
  for (const Include& i : all_includes()) {
    if (portable.contains(room_of(i.file))) {
      EXPECT_FALSE(lacking.contains(i.name)) << i.file << " includes " << i.name;
      // The single user for floating point; older standard libraries also support integers.
      EXPECT_TRUE(i.name != "charconv" || i.file == "base/number.cpp" ||
                  i.file == "format/read_config.cpp" || i.file == "format/write_text.cpp" ||
                  i.file == "asset/read_obj.cpp" || i.file == "asset/obj_corner.cpp" ||
                  i.file == "asset/pnm_file.cpp")
          << i.file;
    }
  }
}

}  // namespace
