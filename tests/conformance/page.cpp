#include "page.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>

namespace scenefile::conformance {

namespace {

constexpr std::string_view head = R"(<!doctype html><meta charset="utf-8">
<title>Conformance with the course's pictures</title>
<style>body{font:14px sans-serif;background:#222;color:#ddd}img{width:320px;image-rendering:pixelated}
td{vertical-align:top;padding:4px}.miss{color:#f88}</style>
<table><tr><th>picture<th>ours<th>theirs<th>difference times 8</tr>
)";

Texture amplified_difference(const Texture& a, const Texture& b) {
  Texture difference = a;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    difference.rgb[i] = static_cast<std::uint8_t>(std::min(255, 8 * std::abs(a.rgb[i] - b.rgb[i])));
  }
  return difference;
}

std::string write_picture(const std::string& path, const Texture& picture) {
  const Result<std::string> bytes =
      encode_image(to_float(picture), ImageFormat::png8, Rounding::nearest);
  return bytes ? error_text(write_file(path, *bytes)) : bytes.error().text;
}

std::string html(std::string_view text) {
  std::string out;
  for (const char c : text) {
    out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return out;
}

}  // namespace

std::string write_page(const std::string& folder, const std::vector<RowResult>& results,
                       const std::vector<Exception>& exceptions) {
  std::filesystem::create_directories(folder);
  std::string page(head);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const RowResult& r = results[i];
    const Exception* exception = find_exception(exceptions, r.row.reference);
    const std::string reason = exception != nullptr ? exception->reason : "";
    if (!r.error.empty()) {
      fmt::format_to(std::back_inserter(page), "<tr><td class=miss>{}<br>{}</tr>\n",
                     html(r.row.reference), html(r.error));
      continue;
    }
    const std::pair<const char*, Texture> pictures[] = {
        {"ours", r.ours},
        {"theirs", r.theirs},
        {"difference", amplified_difference(r.ours, r.theirs)}};
    fmt::format_to(std::back_inserter(page), "<tr><td>{}<br>{:.2f} dB<br>{}", html(r.row.reference),
                   r.difference.psnr_db, html(reason));
    for (const auto& [kind, picture] : pictures) {
      const std::string name = fmt::format("{:03}-{}.png", i, kind);
      if (std::string error = write_picture(folder + "/" + name, picture); !error.empty()) {
        return error;
      }
      fmt::format_to(std::back_inserter(page), "<td><img src=\"{}\">", name);
    }
    page += "</tr>\n";
  }
  return error_text(write_file(folder + "/index.html", page + "</table>\n"));
}

}  // namespace scenefile::conformance
