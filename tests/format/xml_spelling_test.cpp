// The layout of a file does not change its meaning.

#include "format/reading.h"
#include "scenefile/format/codes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace scenefile::testing {
namespace {

struct Attribute {
  std::string name;
  std::string value;
};

struct Element {
  std::string name;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
};

// Writes with random layout.
class Writer {
 public:
  explicit Writer(std::vector<int> dice) : dice_(std::move(dice)) {}

  std::string write(const Element& element) {
    std::string text = "<";
    text += element.name;
    std::vector<Attribute> attributes = element.attributes;
    for (std::size_t i = attributes.size(); i > 1; --i) {
      std::swap(attributes[i - 1], attributes[static_cast<std::size_t>(roll(static_cast<int>(i)))]);
    }
    for (const Attribute& attribute : attributes) {
      const char quote = roll(2) == 0 ? '"' : '\'';
      text += blanks(1) + attribute.name + blanks(0) + "=" + blanks(0) + quote +
              value(attribute.value) + quote;
    }
    text += blanks(0);
    if (element.children.empty() && roll(2) == 0) {
      return text + "/>";
    }
    text += '>';
    text += between();
    for (const Element& child : element.children) {
      text += write(child) + between();
    }
    text += "</";
    text += element.name;
    text += blanks(0);
    return text += '>';
  }

 private:
  int roll(int sides) {
    at_ = (at_ + 1) % dice_.size();
    return dice_[at_] % sides;
  }
  std::string blanks(int least) {
    constexpr const char* kinds[] = {" ", "\n", "\r\n", "\t"};
    std::string text;
    for (int i = roll(3) + least; i > 0; --i) {
      text += kinds[roll(4)];
    }
    return text;
  }
  std::string between() {
    constexpr const char* kinds[] = {"", "<!-- x <y> & -->", "<?pi a?>", "<![CDATA[ ]]>"};
    return blanks(0) + kinds[roll(4)] + blanks(0);
  }
  std::string value(const std::string& plain) {
    std::string text;
    for (const char c : plain) {
      text += roll(5) == 0 ? fmt::format("&#{};", static_cast<int>(c)) : std::string(1, c);
    }
    return text;
  }

  std::vector<int> dice_;
  std::size_t at_ = 0;
};

Element leaf(std::string name, std::vector<Attribute> attributes) {
  return {std::move(name), std::move(attributes), {}};
}

Element vector_of(std::string name, int seed, const char* names = "xyz") {
  std::vector<Attribute> attributes;
  for (int i = 0; i < 3; ++i) {
    attributes.push_back(
        {std::string(1, names[i]), fmt::format("{}", (seed * 7 + i * 3) % 20 / 8.0 + 0.1)});
  }
  return leaf(std::move(name), std::move(attributes));
}

Element block(Element transform, Element object) {
  return {"transblock", {}, {std::move(transform), std::move(object)}};
}

Element scene_of(const std::vector<int>& seeds) {
  Element root{"object", {{"type", "tree"}, {"name", "root"}}, {}};
  for (const int seed : seeds) {
    Element cube{"object",
                 {{"type", "primitive"}, {"name", seed % 2 == 0 ? "cube" : "sphere"}},
                 {vector_of("diffuse", seed, "rgb")}};
    if (seed % 3 == 0) {
      cube.children.push_back(leaf("texture", {{"file", "a b.png"}, {"u", "2"}, {"v", "3"}}));
    }
    Element inner = block(vector_of("scale", seed), std::move(cube));
    if (seed % 5 == 0) {
      Element use{"object", {{"type", "master"}, {"name", "part"}}, {}};
      inner = block(vector_of("translate", seed), std::move(use));
    }
    Element tree{"object", {{"type", "tree"}, {"name", "t"}}, {std::move(inner)}};
    root.children.push_back(block(vector_of("translate", seed), std::move(tree)));
  }
  Element part{
      "object",
      {{"type", "tree"}, {"name", "part"}},
      {block(vector_of("scale", 1), {"object", {{"type", "primitive"}, {"name", "cone"}}, {}})}};
  Element light{"lightdata",
                {},
                {leaf("id", {{"v", "0"}}), vector_of("position", 3), vector_of("color", 4, "rgb"),
                 vector_of("function", 5, "abc")}};
  Element camera{"cameradata",
                 {},
                 {vector_of("pos", 1), vector_of("focus", 9), vector_of("up", 2),
                  leaf("heightangle", {{"v", "40"}})}};
  return {"scenefile", {}, {std::move(camera), std::move(light), std::move(part), std::move(root)}};
}

// The first finding that is not about the order of attributes; empty if there is none.
std::string other_finding(const Reading& reading) {
  for (const Diagnostic& d : reading.diagnostics.list()) {
    if (d.code != &"xml.attribute-order"_code) {
      return d.message;
    }
  }
  return {};
}

RC_GTEST_PROP(XmlSpelling, DoesNotChangeTheScene, ()) {
  const auto seeds = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000));
  const auto dice = *rc::gen::nonEmpty<std::vector<int>>(
      rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 60)));
  const Element scene = scene_of(seeds);
  const Reading plain = read(Writer({0}).write(scene));
  const std::string text = Writer(dice).write(scene);
  const Reading varied = read(text);
  RC_ASSERT(other_finding(plain).empty());
  if (const std::string finding = other_finding(varied); !finding.empty()) {
    RC_FAIL(finding + "\n" + text);
  }
  RC_ASSERT(varied.scene == plain.scene);
}

}  // namespace
}  // namespace scenefile::testing
