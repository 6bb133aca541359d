#include "scenefile/import/read_mtl.h"

#include "scenefile/asset/obj_words.h"
#include "scenefile/base/number.h"

#include <algorithm>
#include <optional>

namespace scenefile {

namespace {

// The values of a material before it is known which of them count.
struct Draft {
  std::optional<glm::vec3> ambient;
  glm::vec3 diffuse{1};
  glm::vec3 specular{0};
  glm::vec3 filter{1};
  float exponent = 0;
  float ior = 1;
  float opacity = 1;
  int illumination = 2;
  std::string picture;
};

std::optional<float> number_of(std::string_view word) {
  const ParsedNumber parsed = parse_number(word);
  return parsed.error == NumberError::none ? std::optional(static_cast<float>(parsed.value))
                                           : std::nullopt;
}

void read_number(ObjWords& words, float least, float most, float& value) {
  if (const auto number = number_of(words.next_word())) {
    value = std::clamp(*number, least, most);
  }
}

// A single number is a gray. Skips spectra and CIE colors.
std::optional<glm::vec3> read_color(ObjWords& words) {
  const auto r = number_of(words.next_word());
  if (!r) {
    return std::nullopt;
  }
  const auto g = number_of(words.next_word());
  const auto b = number_of(words.next_word());
  return glm::clamp(glm::vec3(*r, g.value_or(*r), b.value_or(*r)), glm::vec3(0), glm::vec3(1e6f));
}

// The name may contain spaces; options and their values come before it.
std::string read_picture(ObjWords& words) {
  std::string name;
  bool options = false;
  for (std::string_view word = words.next_word(); !word.empty(); word = words.next_word()) {
    options = options || word.starts_with('-');
    name = options || name.empty() ? std::string(word) : name + " " + std::string(word);
  }
  return name;
}

MtlMaterial finish(const Draft& draft) {
  MtlMaterial result;
  result.picture = draft.picture;
  Material& m = result.material;
  m.ambient = draft.ambient.value_or(glm::vec3(0));
  if (m.ambient == glm::vec3(1)) {
    m.ambient = 0.1f * draft.diffuse;
  }
  m.diffuse = draft.diffuse;
  if (draft.illumination >= 2 && draft.exponent > 0) {
    m.specular = draft.specular;
    m.shininess = draft.exponent;
  }
  const bool mirror = draft.illumination >= 3 && draft.illumination <= 7 && draft.illumination != 4;
  if (mirror) {
    m.reflective = draft.specular;
  }
  if (draft.opacity < 1) {
    m.transparent = (1 - draft.opacity) * draft.filter;
    m.ior = draft.ior == 1 ? 0 : draft.ior;
  }
  return result;
}

}  // namespace

void read_mtl(std::string_view text, std::map<std::string, MtlMaterial, std::less<>>& materials) {
  ObjWords words(text);
  std::string name;
  bool named = false;
  Draft draft;
  const auto leave = [&] {
    if (named) {
      materials.try_emplace(name, finish(draft));
    }
  };
  const auto color = [&](auto& value) {
    if (const auto read = read_color(words)) {
      value = *read;
    }
  };
  while (words.next_statement()) {
    const std::string_view keyword = words.next_word();
    if (keyword == "newmtl") {
      leave();
      name = words.next_word();
      named = true;
      draft = {};
    } else if (keyword == "Ka") {
      color(draft.ambient);
    } else if (keyword == "Kd") {
      color(draft.diffuse);
    } else if (keyword == "Ks") {
      color(draft.specular);
    } else if (keyword == "Tf") {
      color(draft.filter);
    } else if (keyword == "Ns") {
      read_number(words, 0, 1e6f, draft.exponent);
    } else if (keyword == "Ni") {
      read_number(words, 0.1f, 10, draft.ior);
    } else if (keyword == "d") {
      read_number(words, 0, 1, draft.opacity);
    } else if (keyword == "Tr") {
      float through = 0;
      read_number(words, 0, 1, through);
      draft.opacity = 1 - through;
    } else if (keyword == "illum") {
      float model = 2;
      read_number(words, 0, 10, model);
      draft.illumination = static_cast<int>(model);
    } else if (keyword == "map_Kd") {
      draft.picture = read_picture(words);
    }
  }
  leave();
}

}  // namespace scenefile
