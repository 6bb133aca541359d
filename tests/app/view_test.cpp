// The window as a user sees it: the real program on a virtual screen.

#include "app/run_program.h"
#include "scenefile/asset/image_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::HasSubstr;
using ::testing::Not;

/// A separate X server with an unused display number.
class Screen {
 public:
  Screen() {
    int ends[2] = {-1, -1};
    if (::pipe(ends) != 0) {
      return;
    }
    server_ = ::fork();
    if (server_ == 0) {
      ::dup2(ends[1], 3);
      ::execlp("Xvfb", "Xvfb", "-displayfd", "3", "-screen", "0", "1000x800x24", "-nolisten", "tcp",
               static_cast<char*>(nullptr));
      ::_exit(127);
    }
    ::close(ends[1]);
    // The server writes the line in two parts.
    std::string digits;
    for (char c = 0; ::read(ends[0], &c, 1) == 1 && c != '\n';) {
      digits += c;
    }
    ::close(ends[0]);
    name_ = digits.empty() ? "" : ":" + digits;
  }
  ~Screen() {
    if (server_ > 0) {
      ::kill(server_, SIGTERM);
      ::waitpid(server_, nullptr, 0);
    }
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// Empty if Xvfb is not installed.
  const std::string& name() const { return name_; }

 private:
  pid_t server_ = -1;
  std::string name_;
};

// A sphere to the left of a cube, seen from the front.
const std::string scene = R"(<scenefile>
  <globaldata><ambientcoeff v="1"/><diffusecoeff v="1"/><specularcoeff v="1"/></globaldata>
  <cameradata> <!-- as it hangs -->
    <pos x="0" y="0" z="6"/>
    <look x="0" y="0" z="-1"/>
    <up x="0" y="1" z="0"/>
    <heightangle v="45"/>
  </cameradata>
  <lightdata><id v="0"/><color r="1" g="1" b="1"/><type v="directional"/><direction x="0" y="0" z="-1"/></lightdata>
  <object type="tree" name="root">
    <transblock>
      <translate x="-1" y="0" z="0"/>
      <object type="primitive" name="sphere"><diffuse r="1" g="0" b="0"/></object>
    </transblock>
    <transblock>
      <translate x="1" y="0" z="0"/>
      <object type="primitive" name="cube"><diffuse r="0" g="1" b="0"/></object>
    </transblock>
  </object>
</scenefile>
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

// Centers of the sphere and the cube in a window of 800x600.
constexpr int sphere_x = 455;
constexpr int cube_x = 675;
constexpr int middle_y = 299;

struct View : ProgramFolder {
  void SetUp() override {
    if (screen.name().empty()) {
      GTEST_SKIP() << "there is no Xvfb";
    }
  }

  ProgramRun view(std::vector<std::string> words) const {
    words.insert(words.begin(), "view");
    words.insert(words.end(), {"--window", "800x600"});
    // libwayland complains if there is no runtime folder, which is set at login.
    return run_program(
        words, {.environment = {"DISPLAY=" + screen.name(), "XDG_RUNTIME_DIR=/tmp",
                                "XDG_CONFIG_HOME=" + folder.path("config"), "LP_NUM_THREADS=2"}});
  }
  ProgramRun tour(const std::string& steps) const {
    return view({path, "--script", folder.write("tour.txt", steps)});
  }
  Texture picture(const std::string& name) const {
    Result<Texture> result = decode_image(folder.read(name));
    EXPECT_EQ(error_text(result), "") << name;
    return result ? *std::move(result) : Texture();
  }
  std::string shot(const std::string& name) const {
    return "screenshot " + folder.path(name) + "\n";
  }
  // 'r', 'g' or 'b' if one channel dominates, otherwise '.'.
  static char color_at(const Texture& picture, int x, int y) {
    const std::uint8_t* const p = picture.texel(x, y);
    for (int i = 0; i < 3; ++i) {
      if (p[i] > 100 && p[i] > 2 * p[(i + 1) % 3] && p[i] > 2 * p[(i + 2) % 3]) {
        return "rgb"[i];
      }
    }
    return '.';
  }
  // The number of pixels with exactly this color.
  static int count(const Texture& picture, int r, int g, int b) {
    int found = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
      found += picture.rgb[i] == r && picture.rgb[i + 1] == g && picture.rgb[i + 2] == b ? 1 : 0;
    }
    return found;
  }

  Screen screen;
  std::string path = folder.write("a.xml", scene);
};

TEST_F(View, ScreenshotOfTheWindow) {
  const ProgramRun run = view({path, "--screenshot", folder.path("w.png"), "--frames", "3"});
  EXPECT_EQ(run.status, 0) << run.err;
  const Texture window = picture("w.png");
  EXPECT_EQ(window.width, 800);
  EXPECT_EQ(window.height, 600);
  EXPECT_EQ(color_at(window, sphere_x, middle_y), 'r');
  EXPECT_EQ(color_at(window, cube_x, middle_y), 'g');
  EXPECT_EQ(folder.read("a.xml"), scene);
  EXPECT_EQ(folder.list(), (std::vector<std::string>{"a.xml", "w.png"}));
}

TEST_F(View, ReloadsAndSurvivesBrokenFiles) {
  const std::string blue = folder.write(
      "blue.xml", replaced(scene, "r=\"1\" g=\"0\" b=\"0\"", "r=\"0\" g=\"0\" b=\"1\""));
  const std::string broken = folder.write("broken.xml", replaced(scene, "<diffuse", "<difuse"));
  const ProgramRun run =
      tour("settle\n" + shot("1.png") + "copy " + blue + " " + path + "\nsettle\n" + shot("2.png") +
           "copy " + broken + " " + path + "\nsettle\nframes 3\n" + shot("3.png"));
  EXPECT_EQ(run.status, 1) << "the last version is broken; " << run.err;
  EXPECT_EQ(color_at(picture("1.png"), sphere_x, middle_y), 'r');
  EXPECT_EQ(color_at(picture("2.png"), sphere_x, middle_y), 'b');
  const Texture last = picture("3.png");
  EXPECT_EQ(color_at(last, sphere_x + 40, middle_y - 60), 'b') << "the last good picture stays";
  // Pixels that letters cover completely: 18 with Debian 13's Dear ImGui.
  EXPECT_GT(count(last, 0xFF, 0x6B, 0x64), 10) << "the message is red";
  EXPECT_EQ(count(picture("2.png"), 0xFF, 0x6B, 0x64), 0);
}

TEST_F(View, QuitsInTheMiddleOfEverything) {
  for (const int frames : {1, 2, 4, 8, 16}) {
    const ProgramRun run = tour("key R\nframes " + std::to_string(frames) + "\nkey F5\nquit\n");
    EXPECT_THAT(run.err, ::testing::IsEmpty()) << frames;
    EXPECT_LE(run.status, 1) << frames;  // 1: nothing was drawn yet
  }
}

TEST_F(View, SelectsAndSavesTheView) {
  const std::string click =
      "click " + std::to_string(sphere_x) + " " + std::to_string(middle_y) + "\nframes 4\n";
  const ProgramRun run = tour(
      "settle\n" + click + shot("selected.png") +
      "move 565 299\nwheel 2\nframes 2\nkey C\nframes 2\nkey Ctrl+S\nsettle\n" + shot("saved.png"));
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_GT(count(picture("selected.png"), 0xDC, 0x88, 0x35), 5) << "a box around it";
  const std::string text = folder.read("a.xml");
  const std::size_t at = text.find("<pos");
  const std::size_t end = text.find("/>", at);
  EXPECT_EQ(text.substr(0, at), scene.substr(0, at));
  EXPECT_EQ(text.substr(end), scene.substr(scene.find("/>", at)));
  EXPECT_EQ(text.find("z=\"6\""), std::string::npos);
}

TEST_F(View, ComparesWithAReference) {
  const std::string reference = folder.path("reference.png");
  ASSERT_EQ(run_program({"render", path, "--size", "320x240", "-o", reference, "--quiet"}).status,
            0);
  const ProgramRun run =
      view({path, reference, "--script",
            folder.write("tour.txt", "settle\nframes 3\n" + shot("split.png") +
                                         "key M\nsettle\nframes 3\n" + shot("difference.png"))});
  EXPECT_EQ(run.status, 0) << run.err;
  const Texture split = picture("split.png");
  EXPECT_GT(count(split, 255, 255, 255), 300) << "the line of the split";
  // The reference is our own picture, so nothing differs.
  const Texture difference = picture("difference.png");
  EXPECT_EQ(color_at(split, sphere_x + 50, middle_y), 'r');
  EXPECT_EQ(color_at(difference, sphere_x + 50, middle_y), '.');
}

TEST_F(View, ReferenceAndMineAreComparedAsByDiff) {
  const std::string reference = folder.path("reference.png");
  const std::string mine = folder.path("mine.png");
  const std::string dark =
      folder.write("b.xml", replaced(scene, "r=\"0\" g=\"1\" b=\"0\"", "r=\"0\" g=\".5\" b=\"0\""));
  for (const auto& [from, to] : {std::pair(path, reference), std::pair(dark, mine)}) {
    ASSERT_EQ(run_program(
                  {"render", from, "--size", "320x240", "-o", to, "--quiet", "--profile", "course"})
                  .status,
              0);
  }
  const ProgramRun run =
      view({path, "--reference", reference, "--mine", mine, "--script",
            folder.write("tour.txt",
                         "settle\nkey Y\nframes 4\nclick 444 299\nsettle\nkey Ctrl+C\n"
                         "frames 2\ncopied " +
                             folder.path("copied.txt") +
                             "\nkey Y\nkey Shift+X\n"
                             "settle\nframes 3\n" +
                             shot("side.png"))});
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string copied = folder.read("copied.txt");
  EXPECT_THAT(copied, HasSubstr("reference: reference.png has "));
  EXPECT_THAT(copied, HasSubstr("mine: mine.png has "));
  // Without a profile, both find out how the reference was drawn.
  EXPECT_THAT(copied, HasSubstr("reference: as drawn with --profile course"));
  const std::string said = run_program({"diff", reference, mine, "--scene", path}).out;
  const std::size_t at = said.find("cause: ");
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_THAT(copied, HasSubstr(said.substr(at, said.find('\n', at) - at)));
  // The cubes are green and half as green, one above the other.
  const Texture side = picture("side.png");
  const auto green = [&](int y) { return int(side.texel(620, y)[1]); };
  EXPECT_NEAR(green(165), 2 * green(435), 6);
  EXPECT_GT(green(435), 50);
  EXPECT_EQ(view({path, mine, "--mine", mine}).status, 2);
  EXPECT_THAT(view({path, "--mine", folder.path("none.png")}).err, HasSubstr("no such file"));
}

// With the default profile and a lens, hardly a pixel has the color of the ray through its center.
TEST_F(View, OurOwnPictureIsTheReference) {
  const std::string lens = folder.write(
      "lens.xml", replaced(scene, "<heightangle v=\"45\"/>",
                           "<heightangle v=\"45\"/><aperture v=\"1\"/><focallength v=\"3\"/>"));
  const std::string ours = folder.path("ours.png");
  ASSERT_EQ(run_program({"render", lens, "--size", "160x120", "-o", ours, "--quiet"}).status, 0);
  const ProgramRun run =
      view({lens, ours, "--script",
            folder.write("tour.txt",
                         "settle\nkey Y\nframes 4\nclick 444 299\nsettle\nkey Ctrl+C\n"
                         "frames 2\ncopied " +
                             folder.path("copied.txt") + "\n")});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(folder.read("copied.txt"), HasSubstr("reference: ours.png has "));
}

TEST_F(View, TheWindowIsCompleteWhileOpenGlIsCompared) {
  const std::string reference = folder.path("reference.png");
  ASSERT_EQ(run_program({"render", path, "--size", "320x240", "-o", reference, "--quiet"}).status,
            0);
  const ProgramRun run = view({path, reference, "--screenshot", folder.path("w.png")});
  EXPECT_EQ(run.status, 0) << run.err;
  const Texture window = picture("w.png");
  const std::uint8_t* const corner = window.texel(window.width - 3, window.height - 3);
  EXPECT_EQ(std::vector<int>(corner, corner + 3), (std::vector<int>{0x20, 0x22, 0x26}))
      << "the status line reaches the corner";
  EXPECT_GT(count(window, 255, 255, 255), 300) << "the line of the split";
}

TEST_F(View, KeysAndPanels) {
  const ProgramRun run =
      tour("settle\nkey 3\nframes 2\n" + shot("normals.png") + "key 1\nkey F1\nframes 4\n" +
           shot("help.png") + "key Escape\nkey Tab\nframes 4\n" + shot("alone.png"));
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(color_at(picture("normals.png"), cube_x, middle_y), '.');
  EXPECT_GT(count(picture("help.png"), 0x3A, 0x3F, 0x47), 2000) << "the keys of the help";
  EXPECT_EQ(color_at(picture("alone.png"), 400 - 120, 300), 'r') << "the picture shows the window";
}

TEST_F(View, TheKeyboardInTheFields) {
  const std::string enter = "settle\nclick 675 299\nframes 4\nkey Enter\nframes 4\n";
  const ProgramRun run =
      tour(enter + "key Up\nkey 3\nframes 4\n" + shot("up.png") + "key Escape\nkey 3\nframes 4\n" +
           shot("normals.png") +
           "key 1\nkey Enter\nframes 4\nclick 150 560\nframes 4\nkey Up\nkey Up\n" + "frames 4\n" +
           shot("sphere.png"));
  EXPECT_EQ(run.status, 0) << run.err;
  const auto marked = [&](const std::string& name) {  // left of the middle
    const Texture window = picture(name);
    int found = 0;
    for (int y = 0; y < window.height; ++y) {
      for (int x = 300; x < 560; ++x) {
        const std::uint8_t* const p = window.texel(x, y);
        found += p[0] == 0xDC && p[1] == 0x88 && p[2] == 0x35 ? 1 : 0;
      }
    }
    return found > 5;
  };
  EXPECT_FALSE(marked("up.png")) << "the fields got the key";
  EXPECT_EQ(color_at(picture("up.png"), sphere_x, middle_y), 'r') << "and this one";
  EXPECT_EQ(color_at(picture("normals.png"), sphere_x, middle_y), 'b') << "its normal";
  EXPECT_TRUE(marked("sphere.png")) << "the keyboard is back after a click in the panel";
}

// Presses these keys one after the other.
std::string keys(const std::string& names) {
  std::string steps;
  std::istringstream words(names);
  for (std::string name; words >> name;) {
    steps += "key " + name + "\nframes 4\n";
  }
  return steps;
}

TEST_F(View, DeleteInTheFieldsKeepsTheObject) {
  const std::string kept = folder.path("kept.xml");
  const ProgramRun run =
      tour("settle\nclick 675 299\nframes 4\n" + keys("Enter Delete Down Down Delete Ctrl+S") +
           "copy " + path + " " + kept + "\n" + keys("Escape Delete Ctrl+S"));
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(folder.read("kept.xml"), scene);
  EXPECT_THAT(folder.read("a.xml"), Not(HasSubstr("cube")));
}

TEST_F(View, FilesAreChosenFromMenus) {
  folder.write("meshes/box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("oak.png", *encode_image(Image(2, 2), ImageFormat::png8, Rounding::nearest));
  // The last entry of what can be added is a group, that of the fields a texture.
  const ProgramRun run =
      tour("settle\nclick 675 299\nframes 4\n" + keys("Insert Right Up Right Enter") + "settle\n" +
           keys("Insert Up Up Right Enter") + "settle\n" + keys("Ctrl+S") + "settle\n");
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string text = folder.read("a.xml");
  EXPECT_THAT(text, HasSubstr(R"(name="cube"><diffuse r="0" g="1" b="0"/><texture )"
                              R"(file="oak.png" u="1" v="1"/><blend v="1"/>)"));
  EXPECT_THAT(text, HasSubstr(R"(name="mesh" filename="meshes/box.obj")"));
  // The shape is below two rows of buttons, and the last one is a mesh.
  const ProgramRun again =
      tour("settle\nclick 455 299\nframes 4\n" + keys("Enter Down Down Space Up Right Enter") +
           "settle\n" + keys("Ctrl+S") + "settle\n");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(folder.read("a.xml"),
            replaced(text, "name=\"sphere\"", "name=\"mesh\" filename=\"meshes/box.obj\""));
}

TEST_F(View, OpensScenesFromAPanel) {
  folder.write("b.xml", "<scenefile>");
  // The first click is on b.xml. The line that says what is wrong moves a.xml to its place.
  const ProgramRun run = run_program(
      {"view", "--window", "800x600", "--script",
       folder.write("tour.txt", "settle\nframes 4\n" + shot("panel.png") +
                                    "click 320 140\nsettle\nframes 4\n" + shot("broken.png") +
                                    "click 320 140\nsettle\nframes 4\n" + shot("scene.png"))},
      {.environment = {"DISPLAY=" + screen.name(), "XDG_RUNTIME_DIR=/tmp",
                       "XDG_STATE_HOME=" + folder.path("state")},
       .folder = folder.path("")});
  EXPECT_EQ(run.status, 0) << run.err;
  const Texture panel = picture("panel.png");
  EXPECT_EQ(count(panel, 0xFF, 0x6B, 0x64), 0);
  EXPECT_GT(count(picture("broken.png"), 0xFF, 0x6B, 0x64), 10) << "the message is red";
  EXPECT_EQ(color_at(picture("scene.png"), sphere_x, middle_y), 'r');
}

TEST_F(View, ExplainsAClickedPixelAndItsCause) {
  const std::string mine = folder.path("mine.png");
  // The cube is black in the other picture.
  const std::string without =
      folder.write("b.xml", replaced(scene, "r=\"0\" g=\"1\" b=\"0\"", "r=\"0\" g=\"0\" b=\"0\""));
  ASSERT_EQ(run_program({"render", without, "--size", "320x240", "-o", mine, "--quiet", "--profile",
                         "course"})
                .status,
            0);
  const ProgramRun run =
      view({path, mine, "--profile", "course", "--script",
            folder.write("tour.txt",
                         "settle\nkey Y\nframes 4\nclick 444 299\nsettle\nkey Ctrl+C\n"
                         "frames 2\ncopied " +
                             folder.path("copied.txt") + "\n" + shot("readout.png"))});
  EXPECT_EQ(run.status, 0) << run.err;
  const std::string copied = folder.read("copied.txt");
  EXPECT_THAT(copied, HasSubstr("of 320x240"));
  EXPECT_THAT(copied, HasSubstr("sphere"));
  EXPECT_THAT(copied, HasSubstr("diffuse"));
  EXPECT_THAT(copied, HasSubstr("mine: mine.png has"));
  EXPECT_THAT(copied, Not(HasSubstr("yours"))) << "the pictures say more than one pixel";
  // The words of diff for the same two pictures.
  const std::string ours = folder.path("ours.png");
  run_program({"render", path, "--size", "320x240", "-o", ours, "--quiet", "--profile", "course"});
  const std::string said =
      run_program({"diff", ours, mine, "--scene", path, "--profile", "course"}).out;
  const std::size_t at = said.find("worst: ");
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_THAT(copied, HasSubstr(said.substr(at, said.find('\n', at) - at)));
}

TEST_F(View, JudgesPathTracedPictures) {
  const std::string mine = folder.path("mine.pfm");
  ASSERT_EQ(run_program({"render", path, "--size", "64x48", "--mode", "path", "--samples", "64",
                         "-o", mine, "--quiet"})
                .status,
            0);
  const ProgramRun run =
      view({path, mine, "--mode", "path", "--time", "1", "--script",
            folder.write("tour.txt",
                         "settle\nkey Y\nframes 4\nclick 444 299\nsettle\nkey Ctrl+C\n"
                         "frames 2\ncopied " +
                             folder.path("copied.txt") + "\n")});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(folder.read("copied.txt"), HasSubstr("right within its noise"));
}

// Whether `part` is somewhere in `whole`, bit for bit.
bool contains(const Texture& whole, const Texture& part) {
  for (int y = 0; y + part.height <= whole.height; ++y) {
    for (int x = 0; x + part.width <= whole.width; ++x) {
      int row = 0;
      while (row < part.height &&
             std::equal(part.texel(0, row), part.texel(0, row) + 3 * part.width,
                        whole.texel(x, y + row))) {
        ++row;
      }
      if (row == part.height) {
        return true;
      }
    }
  }
  return false;
}

TEST_F(View, TracesPathsAndExplainsThem) {
  folder.write("box.mtl", "newmtl lamp\nKe 6 5 4\nnewmtl wall\nKd .7 .6 .5\n");
  folder.write("box.obj",
               "mtllib box.mtl\nusemtl wall\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
               "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
               "f 1 2 3 4\nf 1 5 6 2\nf 1 4 8 5\nf 2 6 7 3\nusemtl lamp\nf 4 3 7 8\n");
  const std::string box = folder.write(
      "box.xml",
      R"(<scenefile><cameradata><pos x="0" y="0" z="3"/><look x="0" y="0" z="-1"/><up x="0" y="1" z="0"/>
<heightangle v="45"/></cameradata><object type="tree" name="root"><transblock>
<object type="primitive" name="mesh" filename="box.obj"/></transblock></object></scenefile>)");
  const ProgramRun run =
      view({box, "--samples", "3", "--script",
            folder.write("tour.txt", "key Y\nframes 4\nsettle\n" + shot("traced.png") +
                                         "click 460 300\nsettle\nkey Ctrl+C\nframes 2\ncopied " +
                                         folder.path("copied.txt") + "\n" + shot("readout.png"))});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string copied = folder.read("copied.txt");
  int x = 0, y = 0, width = 0, height = 0;
  ASSERT_EQ(std::sscanf(copied.c_str(), "pixel %d,%d of %dx%d", &x, &y, &width, &height), 4)
      << copied;
  const std::string size = fmt::format("{}x{}", width, height);
  ASSERT_EQ(run_program({"render", box, "--samples", "3", "--size", size, "-o",
                         folder.path("rendered.png"), "--quiet"})
                .status,
            0);
  EXPECT_TRUE(contains(picture("traced.png"), picture("rendered.png")));
  const std::string explained =
      run_program({"explain", box, "--samples", "3", "--size", size, "--pixel",
                   fmt::format("{},{}", x, y), "--mode", "path"})
          .out;
  const std::size_t first = explained.find("sample");
  ASSERT_NE(first, std::string::npos) << explained;
  EXPECT_THAT(copied, HasSubstr(explained.substr(first))) << "the same text";
  EXPECT_THAT(view({path, "--profile", "realtime", "--samples", "4"}).err,
              HasSubstr("leave --samples out"));
}

TEST_F(View, AFileThatDoesNotExistIsANewScene) {
  const std::string fresh = folder.path("new.xml");
  EXPECT_THAT(view({fresh, "--screenshot", folder.path("n.png")}).err, HasSubstr("no such file"))
      << "a picture of an empty scene helps nobody";
  const ProgramRun run =
      view({fresh, "--script", folder.write("tour.txt", "settle\nkey C\nkey Ctrl+S\nsettle\n")});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(folder.read("new.xml"), HasSubstr("<scenefile>"));
}

TEST_F(View, ReportsErrors) {
  folder.write("empty/readme.txt");
  EXPECT_THAT(view({folder.path("none/none.xml")}).err, HasSubstr("no such file"));
  EXPECT_THAT(view({path, folder.path("none.png")}).err, HasSubstr("no such file"));
  EXPECT_THAT(view({folder.path("empty")}).err, HasSubstr("no scene in this folder"));
  const ProgramRun run = tour("settle\njump\n");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("line 2: this is not a step"));
  EXPECT_THAT(tour("settle\ncopy none.xml b.xml\n").err, HasSubstr("the script, line 2: none.xml"));
  EXPECT_THAT(view({path, "--frames", "5"}).err, HasSubstr("--frames requires --screenshot"));
  const ProgramRun broken =
      view({folder.write("b.xml", "<scenefile>"), "--screenshot", folder.path("b.png")});
  EXPECT_EQ(broken.status, 1);
  EXPECT_THAT(broken.err, HasSubstr("could not show the scene"));
  const ProgramRun nowhere = view({path, "--screenshot", folder.path("none/b.png")});
  EXPECT_EQ(nowhere.status, 3);
  EXPECT_EQ(nowhere.err.find("script"), std::string::npos) << nowhere.err;
}

TEST_F(View, AnEmptyScriptEndsImmediately) {
  const ProgramRun run = tour("# nothing\n");
  EXPECT_EQ(run.status, 0) << run.err;
}

struct ViewWithoutItsProgram : ProgramFolder {};

TEST_F(ViewWithoutItsProgram, IsReported) {
  const std::string alone = folder.path("scenefile");
  std::filesystem::copy_file(SCENEFILE_PROGRAM, alone);
  const std::string path = std::string(SCENEFILE_SCENES) + "/hello.xml";
  const ProgramRun run = run_program({"view", path}, {.program = alone});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr(folder.path("scenefile-window")));
  EXPECT_THAT(run.err, HasSubstr("cannot be started: No such file"));
  const ProgramRun wrong = run_program({"view", path, "--frames", "none"}, {.program = alone});
  EXPECT_EQ(wrong.status, 2) << "the command line is read before";
  EXPECT_EQ(run_program({"info", path}, {.program = alone}).status, 0);
}

TEST(ViewWithoutScreen, IsReported) {
  const std::string path = std::string(SCENEFILE_SCENES) + "/hello.xml";
  const ProgramRun run =
      run_program({"view", path}, {.environment = {"DISPLAY=", "WAYLAND_DISPLAY="}});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("no window can be opened"));
  EXPECT_THAT(run.err, HasSubstr("scenefile render"));
}

}  // namespace

}  // namespace scenefile
