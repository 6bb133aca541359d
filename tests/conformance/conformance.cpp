// Renders every reference scene of a corpus and reports how close the pictures are.
//
//     scenefile_conformance CORPUS [PAGE_FOLDER [FILTER]]
//
// CORPUS/references.tsv lists scene, reference, mode and features. FILTER selects the rows whose
// reference contains it.

#include "page.h"
#include "run_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace scenefile::conformance {

namespace {

constexpr double threshold_db = 45;
constexpr double good_db = 60;

bool passes(const RowResult& r, const std::vector<Exception>& exceptions) {
  const Exception* exception = find_exception(exceptions, r.row.reference);
  return r.error.empty() &&
         r.difference.psnr_db >= (exception != nullptr ? exception->floor_db : threshold_db);
}

void print_row(const RowResult& r, const std::vector<Exception>& exceptions) {
  const Exception* exception = find_exception(exceptions, r.row.reference);
  const char* verdict = passes(r, exceptions) ? (exception != nullptr ? "known" : "ok") : "MISS";
  if (!r.error.empty()) {
    fmt::print("{:5} {}: {}\n", verdict, r.row.reference, r.error);
    return;
  }
  fmt::print("{:5} {:6.2f} dB  mean {:6.3f}  max {:3}  over 8 {:7.4f} %  {:6.2f} s  {}\n", verdict,
             r.difference.psnr_db, r.difference.mean, r.difference.max,
             100 * r.difference.share_over, r.cpu_seconds, r.row.reference);
}

long count_at(const std::vector<RowResult>& results, double db) {
  return std::count_if(results.begin(), results.end(), [&](const RowResult& r) {
    return r.error.empty() && r.difference.psnr_db >= db;
  });
}

int run(const std::string& corpus, const std::string& folder, const std::string& filter) {
  std::string error;
  const std::vector<Row> rows = read_references(corpus + "/references.tsv", error);
  const std::vector<Exception> exceptions = read_exceptions(SCENEFILE_EXCEPTIONS, error);
  if (!error.empty()) {
    fmt::print(stderr, "{}\n", error);
    return 3;
  }
  std::vector<RowResult> results;
  double cpu_seconds = 0;
  for (const Row& row : rows) {
    if (row.reference.find(filter) != std::string::npos) {
      results.push_back(run_row(corpus, row));
      cpu_seconds += results.back().cpu_seconds;
    }
  }
  std::stable_sort(results.begin(), results.end(), [](const RowResult& a, const RowResult& b) {
    return (a.error.empty() ? a.difference.psnr_db : -1) <
           (b.error.empty() ? b.difference.psnr_db : -1);
  });
  for (const RowResult& r : results) {
    print_row(r, exceptions);
  }
  if (!folder.empty()) {
    if (error = write_page(folder, results, exceptions); !error.empty()) {
      fmt::print(stderr, "{}\n", error);
      return 3;
    }
    fmt::print("{}/index.html shows them\n", folder);
  }
  const auto total = static_cast<long>(results.size());
  const long passed = std::count_if(results.begin(), results.end(),
                                    [&](const RowResult& r) { return passes(r, exceptions); });
  fmt::print("{} of {} at {} dB or better, {} at {} dB or better, {:.1f} CPU seconds\n",
             count_at(results, threshold_db), total, threshold_db, count_at(results, good_db),
             good_db, cpu_seconds);
  fmt::print("{} passed, {} failed\n", passed, total - passed);
  return passed == total && total != 0 ? 0 : 1;
}

}  // namespace

}  // namespace scenefile::conformance

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    fmt::print(stderr, "usage: scenefile_conformance CORPUS [PAGE_FOLDER [FILTER]]\n");
    return 2;
  }
  return scenefile::conformance::run(argv[1], argc > 2 ? argv[2] : "", argc > 3 ? argv[3] : "");
}
