#include "scenefile/compare/find_picture.h"

#include "scenefile/compare/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace scenefile {

namespace {

constexpr int coarse_size = 112;       // the longer side in the first search, in pixels
constexpr std::size_t few_edges = 16;  // fewer edges are not evidence
constexpr float min_step = 8;          // smallest edge, in 1/255 over two pixels
constexpr double min_visible = 0.6;    // share of the edges that must not be cut off
constexpr double min_score = 0.5;
constexpr double max_other = 0.4;      // agreement of pictures of other scenes
constexpr double min_frame = 0.5;      // share of each side where colors change
constexpr double min_gain = 0.2;       // over the picture as a whole
constexpr double step_of_size = 1.03;  // between sizes in the first search

// The direction of the edge at each pixel, with twice its angle, so that opposite directions are
// the same; 0 where there is no edge.
struct Edges {
  int width = 0;
  int height = 0;
  std::vector<glm::vec2> direction;
  std::vector<float> strength;

  std::size_t index(int x, int y) const { return std::size_t(y) * width + x; }
};

Edges edges_of(const Texture& t) {
  Edges edges{t.width, t.height, {}, {}};
  edges.direction.resize(std::size_t(t.width) * t.height, glm::vec2(0));
  edges.strength.resize(edges.direction.size(), 0);
  for (int y = 1; y + 1 < t.height; ++y) {
    for (int x = 1; x + 1 < t.width; ++x) {
      glm::vec2 best(0);
      float most = 0;
      for (int c = 0; c < 3; ++c) {
        const glm::vec2 g(t.texel(x + 1, y)[c] - t.texel(x - 1, y)[c],
                          t.texel(x, y + 1)[c] - t.texel(x, y - 1)[c]);
        const float length = glm::length(g);
        if (length > most) {
          most = length;
          best = g;
        }
      }
      if (most >= min_step) {
        best /= most;
        edges.direction[edges.index(x, y)] = {best.x * best.x - best.y * best.y,
                                              2 * best.x * best.y};
        edges.strength[edges.index(x, y)] = most;
      }
    }
  }
  return edges;
}

// Some of the edges of a picture.
struct EdgePoint {
  int x;
  int y;
  glm::vec2 direction;
};

// The strongest edge of each cell of a grid, so that they are spread over the picture.
std::vector<EdgePoint> edge_points(const Edges& edges, int cells) {
  const int cell = std::max(2, std::max(edges.width, edges.height) / cells);
  std::vector<EdgePoint> points;
  for (int top = 0; top < edges.height; top += cell) {
    for (int left = 0; left < edges.width; left += cell) {
      float most = 0;
      EdgePoint best{};
      for (int y = top; y < std::min(edges.height, top + cell); ++y) {
        for (int x = left; x < std::min(edges.width, left + cell); ++x) {
          const std::size_t i = edges.index(x, y);
          if (edges.strength[i] > most) {
            most = edges.strength[i];
            best = {x, y, edges.direction[i]};
          }
        }
      }
      if (most > 0) {
        points.push_back(best);
      }
    }
  }
  return points;
}

// How well the edges agree with those of the picture, moved by `corner`: 1 if all do, about 0 by
// chance.
double agreement(const std::vector<EdgePoint>& points, const Edges& shown,
                 const glm::ivec2& corner) {
  float sum = 0;
  std::size_t visible = 0;
  for (const EdgePoint& p : points) {
    const int x = p.x + corner.x;
    const int y = p.y + corner.y;
    if (x >= 1 && y >= 1 && x + 1 < shown.width && y + 1 < shown.height) {
      ++visible;
      sum += glm::dot(p.direction, shown.direction[shown.index(x, y)]);
    }
  }
  const auto all = static_cast<double>(points.size());
  const auto seen = static_cast<double>(visible);
  return seen < min_visible * all ? -1 : static_cast<double>(sum) / seen;
}

// A picture in several sizes.
struct Candidate {
  double width = 0;  // of the whole reference, as a share of the shown picture's width
  glm::dvec2 corner{0};
  double score = -1;
};

bool is_better(const Candidate& a, const Candidate& b) {
  return a.score > b.score;
}

glm::ivec2 height_kept(const Texture& reference, int width) {
  return {width, std::max(1, static_cast<int>(std::lround(static_cast<double>(width) *
                                                          reference.height / reference.width)))};
}

std::vector<EdgePoint> points_at(const Texture& reference, int width, int cells) {
  const glm::ivec2 size = height_kept(reference, width);
  return edge_points(edges_of(scaled(reference, size.x, size.y)), cells);
}

// The picture in which edges are searched: at most `size` pixels wide and high.
Texture at_most(const Texture& picture, int size) {
  const int longer = std::max(picture.width, picture.height);
  if (longer <= size) {
    return picture;
  }
  const double by = static_cast<double>(size) / longer;
  return scaled(picture, std::max(1, static_cast<int>(std::lround(picture.width * by))),
                std::max(1, static_cast<int>(std::lround(picture.height * by))));
}

std::vector<Candidate> coarse_places(const Texture& reference, const Texture& small) {
  const Edges shown = edges_of(small);
  // Shares of the picture's width; 1 is the whole picture.
  std::vector<Candidate> found;
  for (double share = 0.3; share < 1.7; share *= step_of_size) {
    const glm::ivec2 size =
        height_kept(reference, static_cast<int>(std::lround(share * shown.width)));
    const std::vector<EdgePoint> points = points_at(reference, size.x, 20);
    if (points.size() < few_edges || size.x < 24 || size.y < 24) {
      continue;
    }
    Candidate best;
    const glm::ivec2 cut(static_cast<int>((1 - min_visible) * size.x),
                         static_cast<int>((1 - min_visible) * size.y));
    for (int y = -cut.y; y <= shown.height - size.y + cut.y; ++y) {
      for (int x = -cut.x; x <= shown.width - size.x + cut.x; ++x) {
        const double score = agreement(points, shown, {x, y});
        if (score > best.score) {
          best = {static_cast<double>(size.x) / shown.width,
                  glm::dvec2(x, y) / static_cast<double>(shown.width), score};
        }
      }
    }
    found.push_back(best);
  }
  std::sort(found.begin(), found.end(), is_better);
  found.resize(std::min<std::size_t>(found.size(), 6));
  return found;
}

// The best place near the candidate, with the picture at this size.
Candidate refined(const Texture& reference, const Edges& shown, const Candidate& from, int reach) {
  Candidate best;
  const int middle = static_cast<int>(std::lround(from.width * shown.width));
  const glm::ivec2 corner(glm::round(from.corner * static_cast<double>(shown.width)));
  for (int width = middle - reach; width <= middle + reach; ++width) {
    const std::vector<EdgePoint> points = points_at(reference, width, 40);
    for (int y = corner.y - reach; y <= corner.y + reach; ++y) {
      for (int x = corner.x - reach; x <= corner.x + reach; ++x) {
        const double score = agreement(points, shown, {x, y});
        if (score > best.score) {
          best = {static_cast<double>(width) / shown.width,
                  glm::dvec2(x, y) / static_cast<double>(shown.width), score};
        }
      }
    }
  }
  return best;
}

// The reference drawn as large as the whole picture, with the same height angle.
PicturePlace whole(const Texture& reference, const Texture& shown) {
  const int width = static_cast<int>(
      std::lround(static_cast<double>(shown.height) * reference.width / reference.height));
  return {{(shown.width - width) / 2, 0}, {width, shown.height}};
}

double score_of(const PicturePlace& place, const Texture& reference, const Texture& small,
                double by) {
  const int width = std::max(1, static_cast<int>(std::lround(place.size.x * by)));
  const glm::ivec2 corner(glm::round(glm::dvec2(place.corner) * by));
  const std::vector<EdgePoint> points = points_at(reference, width, 40);
  const Edges shown = edges_of(small);
  double best = -1;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      best = std::max(best, agreement(points, shown, corner + glm::ivec2(x, y)));
    }
  }
  return best;
}

// The share of the border of a rectangle where the colors change.
class Borders {
 public:
  explicit Borders(const Texture& t) : width_(t.width), height_(t.height) {
    down_.resize(std::size_t(width_ + 1) * (height_ + 1));
    across_.resize(down_.size());
    const auto step = [&](int x0, int y0, int x1, int y1) {
      int most = 0;
      for (int c = 0; c < 3; ++c) {
        most = std::max(most, std::abs(int{t.texel(x0, y0)[c]} - int{t.texel(x1, y1)[c]}));
      }
      return most > 4 ? 1 : 0;
    };
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        down_[at(x, y + 1)] = down_[at(x, y)] + (x > 0 ? step(x - 1, y, x, y) : 0);
        across_[at(x + 1, y)] = across_[at(x, y)] + (y > 0 ? step(x, y - 1, x, y) : 0);
      }
    }
  }
  // The share of the pixels left of x, from y0 to y1, with another color than their neighbor.
  double left_of(int x, int y0, int y1) const {
    return x <= 0 || x >= width_
               ? 1
               : static_cast<double>(down_[at(x, y1)] - down_[at(x, y0)]) / (y1 - y0);
  }
  double above(int y, int x0, int x1) const {
    return y <= 0 || y >= height_
               ? 1
               : static_cast<double>(across_[at(x1, y)] - across_[at(x0, y)]) / (x1 - x0);
  }
  // The smallest share of the four sides.
  double least(const glm::ivec2& low, const glm::ivec2& high) const {
    return std::min({left_of(low.x, low.y, high.y), left_of(high.x, low.y, high.y),
                     above(low.y, low.x, high.x), above(high.y, low.x, high.x)});
  }

 private:
  std::size_t at(int x, int y) const { return std::size_t(y) * (width_ + 1) + x; }
  int width_;
  int height_;
  std::vector<int> down_;
  std::vector<int> across_;
};

// A rectangle of exactly the reference's size, inside a frame.
std::optional<PicturePlace> framed(const Texture& reference, const Texture& shown) {
  const glm::ivec2 size(reference.width, reference.height);
  const glm::ivec2 room = glm::ivec2(shown.width, shown.height) - size;
  if (room.x < 0 || room.y < 0 || room == glm::ivec2(0)) {
    return std::nullopt;
  }
  const Borders borders(shown);
  std::optional<PicturePlace> best;
  double most = 0.9;
  for (int y = 0; y <= room.y; ++y) {
    for (int x = 0; x <= room.x; ++x) {
      const double share = borders.least({x, y}, glm::ivec2(x, y) + size);
      if (share > most) {
        most = share;
        best = PicturePlace{{x, y}, size};
      }
    }
  }
  return best;
}

// The mean difference of the pictures at the place, by every 7th pixel.
double difference_at(const PicturePlace& place, const Texture& reference, const Texture& shown) {
  const Texture there =
      scaled(cut_out(shown, place.corner, place.size), reference.width, reference.height);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < there.rgb.size(); i += 7) {
    sum += std::abs(int{there.rgb[i]} - int{reference.rgb[i]});
    ++count;
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, count));
}

// The place, with each side that is inside the picture moved to the strongest change of colors near
// it, which is the frame. nullopt if there is no frame: the picture only shows more of the scene.
std::optional<PicturePlace> within_frame(const PicturePlace& place, const Texture& shown) {
  const Borders borders(shown);
  const glm::ivec2 limit(shown.width, shown.height);
  const glm::ivec2 low = glm::clamp(place.corner, glm::ivec2(0), limit - 1);
  const glm::ivec2 high = glm::clamp(place.corner + place.size, low + 1, limit);
  const int reach = 2 + std::max(place.size.x, place.size.y) / 80;
  bool framed = true;
  const auto snapped = [&](int from, int most, auto share) {
    int best = from;
    double largest = from <= 0 || from >= most ? 1 : share(from);
    for (int step = 1; step <= reach; ++step) {
      for (const int side : {from - step, from + step}) {
        if (side > 0 && side < most && share(side) > largest + 0.02) {
          largest = share(side);
          best = side;
        }
      }
    }
    framed = framed && largest >= min_frame;
    return best;
  };
  const auto column = [&](int x) { return borders.left_of(x, low.y, high.y); };
  const auto row = [&](int y) { return borders.above(y, low.x, high.x); };
  const glm::ivec2 corner(place.corner.x < 0 ? place.corner.x : snapped(low.x, limit.x, column),
                          place.corner.y < 0 ? place.corner.y : snapped(low.y, limit.y, row));
  const glm::ivec2 end = place.corner + place.size;
  const glm::ivec2 size = glm::ivec2(end.x > limit.x ? end.x : snapped(high.x, limit.x, column),
                                     end.y > limit.y ? end.y : snapped(high.y, limit.y, row)) -
                          corner;
  if (!framed) {
    return std::nullopt;
  }
  const double aspects =
      static_cast<double>(size.x) * place.size.y / (double(size.y) * place.size.x);
  return std::abs(aspects - 1) < 0.01 ? PicturePlace{corner, size} : place;
}

// If the place has nearly the size of the reference, it probably has its size: the best place
// nearby.
Candidate of_same_size(const Texture& reference, const Texture& shown, const Candidate& found) {
  const double width = found.width * shown.width;
  if (std::abs(width - reference.width) > 0.012 * reference.width) {
    return found;
  }
  const std::vector<EdgePoint> points = points_at(reference, reference.width, 60);
  const Edges edges = edges_of(shown);
  const glm::ivec2 corner(glm::round(found.corner * static_cast<double>(shown.width)));
  const int reach = 3 + static_cast<int>(std::abs(width - reference.width));
  Candidate best;
  for (int y = corner.y - reach; y <= corner.y + reach; ++y) {
    for (int x = corner.x - reach; x <= corner.x + reach; ++x) {
      const double score = agreement(points, edges, {x, y});
      if (score > best.score) {
        best = {static_cast<double>(reference.width) / shown.width,
                glm::dvec2(x, y) / static_cast<double>(shown.width), score};
      }
    }
  }
  return best.score > 0.8 * found.score ? best : found;
}

// Whether as much is cut off on opposite sides, at another size than the reference's: probably this
// is a picture with another height angle.
bool is_zoomed(const PicturePlace& place, const Texture& reference, const Texture& shown) {
  const glm::ivec2 off =
      glm::abs(2 * place.corner + place.size - glm::ivec2(shown.width, shown.height));
  return place.corner.x < 0 && place.corner.y < 0 && std::max(off.x, off.y) <= 6 &&
         place.size.x != reference.width;
}

bool inside(const PicturePlace& place, const Texture& shown) {
  const glm::ivec2 end = place.corner + place.size;
  return place.corner.x >= 0 && place.corner.y >= 0 && end.x <= shown.width &&
         end.y <= shown.height;
}

}  // namespace

std::optional<PicturePlace> find_picture(const Texture& reference, const Texture& shown) {
  if (std::min(reference.width, reference.height) < 48 ||
      std::min(shown.width, shown.height) < 48) {
    return std::nullopt;
  }
  if (const std::optional<PicturePlace> place = framed(reference, shown)) {
    return place;
  }
  std::vector<Candidate> candidates = coarse_places(reference, at_most(shown, coarse_size));
  if (candidates.empty()) {
    return std::nullopt;
  }
  const int longer = std::max(shown.width, shown.height);
  // In larger pictures, noise hides edges, and the best place nearby is needed, not its score.
  const double coarse_score = candidates.front().score;
  for (int size = 2 * coarse_size;; size *= 2) {
    const Edges edges = edges_of(at_most(shown, size));
    for (Candidate& candidate : candidates) {
      candidate = refined(reference, edges, candidate, 2);
    }
    std::sort(candidates.begin(), candidates.end(), is_better);
    candidates.resize(std::min<std::size_t>(candidates.size(), size >= 4 * coarse_size ? 1 : 3));
    if (size >= longer) {
      break;
    }
  }
  const Candidate best = of_same_size(reference, shown, candidates.front());
  PicturePlace place;
  place.size = height_kept(reference, static_cast<int>(std::lround(best.width * shown.width)));
  place.corner = glm::ivec2(glm::round(best.corner * static_cast<double>(shown.width)));
  const Texture small = at_most(shown, 2 * coarse_size);
  const double by = static_cast<double>(small.width) / shown.width;
  const double score = std::max(coarse_score, score_of(place, reference, small, by));
  const double gain = score - score_of(whole(reference, shown), reference, small, by);
  if (score < min_score || gain < min_gain || is_zoomed(place, reference, shown)) {
    return std::nullopt;
  }
  return within_frame(place, shown);
}

std::optional<PicturePlace> picture_next_to(const PicturePlace& place, const Texture& reference,
                                            const Texture& shown) {
  if (!inside(place, shown)) {
    return std::nullopt;
  }
  const std::vector<EdgePoint> points = points_at(reference, place.size.x, 40);
  const Edges edges = edges_of(shown);
  std::optional<PicturePlace> best;
  double most = min_score;
  const auto look = [&](const glm::ivec2& corner) {
    const PicturePlace other{corner, place.size};
    if (inside(other, shown)) {
      const double score = agreement(points, edges, corner);
      if (score > most) {
        most = score;
        best = other;
      }
    }
  };
  for (int across = 0; across < shown.width; ++across) {
    if (std::abs(across - place.corner.x) >= place.size.x) {
      look({across, place.corner.y});
    }
  }
  for (int down = 0; down < shown.height; ++down) {
    if (std::abs(down - place.corner.y) >= place.size.y) {
      look({place.corner.x, down});
    }
  }
  return best && difference_at(place, reference, shown) < difference_at(*best, reference, shown)
             ? best
             : std::nullopt;
}

bool have_other_outlines(const Texture& a, const Texture& b) {
  const Texture small_a = at_most(a, 2 * coarse_size);
  const Texture small_b = at_most(b, 2 * coarse_size);
  const PicturePlace all{{0, 0}, {small_a.width, small_a.height}};
  const auto alike = [&](const Texture& of, const Texture& in) {
    return edge_points(edges_of(of), 40).size() < few_edges ? 1 : score_of(all, of, in, 1);
  };
  return alike(small_a, small_b) < max_other && alike(small_b, small_a) < max_other;
}

Texture cut_out(const Texture& picture, const glm::ivec2& corner, const glm::ivec2& size) {
  Texture part;
  part.width = size.x;
  part.height = size.y;
  part.rgb.reserve(std::size_t{3} * size.x * size.y);
  for (int y = 0; y < size.y; ++y) {
    const std::uint8_t* row = picture.texel(corner.x, corner.y + y);
    part.rgb.insert(part.rgb.end(), row, row + std::ptrdiff_t{3} * size.x);
  }
  return part;
}

}  // namespace scenefile
