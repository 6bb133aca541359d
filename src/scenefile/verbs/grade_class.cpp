#include "scenefile/verbs/grade_class.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/base/hash.h"
#include "scenefile/base/text.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/io/archive.h"
#include "scenefile/io/descriptor.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/verbs/class_files.h"
#include "scenefile/verbs/grade_files.h"
#include "scenefile/verbs/grade_paths.h"
#include "scenefile/verbs/grade_references.h"
#include "scenefile/verbs/load_file.h"
#include "scenefile/verbs/render_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

// The default threshold: float and double implementations agree to 40 dB or better.
constexpr double default_min_psnr_db = 40;
constexpr int passed_thumbnail_width = 128;

// A student, with the picture for each reference.
struct Student {
  std::string name;
  std::vector<FoundFile> pictures;
  std::vector<int> of_references = {};               // indices into the pictures; -1: none
  std::vector<std::vector<std::string>> notes = {};  // for each reference
  std::vector<std::string> unmatched = {};           // paths below the student's folder
  std::vector<IgnoredFile> ignored = {};
};

std::string thumbnail(const Texture& reference, const Texture& picture, const Texture& map,
                      int width) {
  const Texture heat = reduced(map, width);
  const Texture a = reduced(reference, width);
  const Texture b = reduced(picture, width);
  const std::array<const Texture*, 3> pictures{&a, &b, &heat};
  return *encode_image(to_float(side_by_side(pictures, 0)), ImageFormat::png8, Rounding::nearest);
}

// If no thresholds were given, the kind of difference decides: pictures with known mistakes fail at
// any PSNR, and pictures pass that only differ in ways that are not mistakes.
void follow_causes(const PictureComparison& compared, PictureResult& result) {
  const CauseReport& report = compared.causes;
  const bool mistake = std::any_of(report.claims.begin(), report.claims.end(),
                                   [](const Claim& c) { return c.cause != Cause::rounding; });
  if (mistake) {
    result.verdict = Verdict::differs;
    if (result.reasons.empty()) {
      result.reasons = {
          fmt::format("PSNR is {:.2f} dB, and a known mistake explains the difference",
                      compared.measures.difference.psnr_db)};
    }
  } else if (report.partial.empty() && !compared.other_size() &&
             (report.only_details || !report.notes.empty())) {
    result.verdict = Verdict::passed;
    result.reasons.clear();
  }
}

}  // namespace

struct ClassGrader::State {
 public:
  State(const GradeRequest& request, ClassReferences references,
        std::function<void(const char*)> entering)
      : request_(request),
        references_(std::move(references)),
        settings_(request.compare),
        by_causes_(request.compare.thresholds == Thresholds{}),
        entering_(std::move(entering)),
        class_archive_(is_folder(request.handed_in) ? std::string()
                                                    : follow_links(request.handed_in)) {
    if (by_causes_) {
      settings_.thresholds.min_psnr_db = default_min_psnr_db;
      settings_.look = LookForCauses::always;
    }
  }

  // Finds the pictures of all students.
  Result<void> find_pictures() {
    notes_ = references_.notes;
    note_missing_scenes();
    std::vector<std::string> others = request_.results;
    others.insert(others.end(), {request_.references, request_.scenes});
    ClassFiles found =
        find_class_files(request_.handed_in, references_.files, others, request_.one_student);
    ignored_ = std::move(found.ignored);
    for (const std::string& path : found.paths) {
      references_.inputs.push_back(input_file("submitted file", path));
    }
    std::size_t seen = 0;
    std::size_t matched = 0;
    for (StudentFiles& files : found.students) {
      Student& student = students_.emplace_back();
      student.name = std::move(files.name);
      student.pictures = std::move(files.pictures);
      student.ignored = std::move(files.ignored);
      seen += student.pictures.size();
      matched += match(student);
    }
    if (!found.one_student.empty()) {
      notes_.push_back(fmt::format("{}: {}", quoted(request_.handed_in, 400), found.one_student));
    }
    note_unused_map();
    thumbnail_width_ = pictures() > many_pictures ? 200 : 320;
    return matched != 0 ? Result<void>() : Error{nothing_matches(seen)};
  }

  std::size_t students() const { return students_.size(); }
  const std::string& student(std::size_t index) const { return students_[index].name; }
  std::size_t pictures() const { return students_.size() * references_.all.size(); }
  std::string key_of(std::size_t index) {
    const Student& student = students_[index];
    Hash name;
    name.add(student.name);
    Hash pictures;
    const std::vector<Result<std::string>> archived = read_archived_of(index);
    for (std::size_t i = 0; i < references_.all.size(); ++i) {
      // The names of files appear in results.
      const FoundFile* const file = picture_of(student, i);
      pictures.add(file == nullptr ? std::string() : path_in_class(*file));
      if (file != nullptr && !file->entries.empty()) {
        pictures.add(archived[i] ? *archived[i] : archived[i].error().text);
      } else if (file != nullptr && !is_link(file->path)) {
        add_number(pictures, file_fingerprint(file->path));
      }
      for (const std::string& note : student.notes[i]) {
        pictures.add(note);
      }
    }
    for (const std::string& path : student.unmatched) {
      pictures.add(path);
    }
    return fmt::format("references={:x} student={:x} pictures={:x} thumbnails={}",
                       references_.fingerprint.value(), name.value(), pictures.value(),
                       thumbnail_width_);
  }

  Result<StudentResult> run(std::size_t index, const std::function<bool(double)>& go_on) {
    const Student& student = students_[index];
    const auto all = static_cast<double>(references_.all.size());
    double done = 0;
    bool stopped = false;
    const auto tell = [&](double part) {
      stopped = stopped || (go_on && !go_on((done + part) / all));
      return !stopped;
    };
    StudentResult result;
    result.name = student.name;
    result.unmatched = student.unmatched;
    std::vector<Result<std::string>> archived = read_archived_of(index);
    for (std::size_t i = 0; i < references_.all.size(); ++i) {
      result.pictures.push_back(
          grade(references_.all[i], picture_of(student, i), std::move(archived[i]), tell));
      std::vector<std::string>& notes = result.pictures.back().notes;
      notes.insert(notes.end(), student.notes[i].begin(), student.notes[i].end());
      ++done;
      if (!tell(0)) {
        return Error{"interrupted", ErrorKind::cancelled};
      }
    }
    return result;
  }

  const std::vector<UsedFile>& inputs() const { return references_.inputs; }
  const std::vector<std::string>& notes() const { return notes_; }

  Gradebook empty_book() const {
    Gradebook book;
    book.name = name_of_class(request_.handed_in);
    book.notes = notes_;
    book.ignored = ignored_;
    for (const Student& student : students_) {
      book.ignored.insert(book.ignored.end(), student.ignored.begin(), student.ignored.end());
    }
    return book;
  }

 private:
  void enter(const char* phase) const {
    if (entering_) {
      entering_(phase);
    }
  }

  // Most causes need scenes. If there are some, names may be wrong.
  void note_missing_scenes() {
    std::vector<std::string> without;
    for (const ClassReference& reference : references_.all) {
      if (!reference.scene) {
        without.push_back(escaped(reference.name));
      }
    }
    if (without.size() == references_.all.size() && request_.scenes.empty()) {
      notes_.emplace_back(
          "no reference has a scene: most mistakes cannot be named; --scenes DIR names the folder "
          "of the scenes");
    } else if (!without.empty()) {
      constexpr std::size_t most = 4;
      const std::size_t more = without.size() - std::min(without.size(), most);
      without.resize(without.size() - more);
      notes_.push_back(
          fmt::format("no scene has the name of {}{}: most mistakes in {} pictures "
                      "cannot be named",
                      fmt::join(without, ", "), more > 0 ? fmt::format(" and {} more", more) : "",
                      without.size() + more == 1 ? "its" : "their"));
    }
  }

  void note_unused_map() {
    for (const NamePair& pair : request_.map) {
      if (std::none_of(students_.begin(), students_.end(), [&](const Student& student) {
            return std::any_of(
                student.pictures.begin(), student.pictures.end(),
                [&](const FoundFile& file) { return is_named(file, pair.handed_in); });
          })) {
        notes_.push_back(fmt::format("the map assigns {} to a reference, but no student has it",
                                     quoted(pair.handed_in, 400)));
      }
    }
  }

  // Matches the pictures of a student with the references. Returns how many match.
  std::size_t match(Student& student) const {
    const std::vector<FoundFile>& pictures = student.pictures;
    PictureMatches matches = match_pictures(references_.files, pictures, request_.map);
    student.notes.resize(references_.files.size());
    const std::vector<std::string> names = reference_names(references_.files);
    for (const UnusedPicture& unused : matches.unused) {
      const std::string path = path_below(pictures[unused.picture]);
      if (unused.reference < 0) {
        student.unmatched.push_back(path);
      }
      std::string reason = "no reference has its name";
      if (unused.reference >= 0) {
        const auto r = static_cast<std::size_t>(unused.reference);
        const FoundFile& graded = pictures[static_cast<std::size_t>(matches.pictures[r])];
        const FoundFile& other = pictures[unused.picture];
        // A folder and an archive of the same student may contain the same paths.
        const bool alike = path_below(graded) == path;
        const std::string taken = alike ? path_in_class(graded) : path_below(graded);
        student.notes[r].push_back(fmt::format("two pictures match: {} was graded, {} was not",
                                               taken, alike ? path_in_class(other) : path));
        reason = fmt::format("{} is used for {}", taken, names[r]);
      } else if (!unused.several.empty()) {
        reason = "its name fits several references:";
        for (std::size_t i = 0; i < std::min<std::size_t>(unused.several.size(), 4); ++i) {
          reason += (i == 0 ? " " : ", ") + names[unused.several[i]];
        }
        reason += unused.several.size() > 4 ? " and others" : "";
      }
      student.ignored.push_back(
          {path_in_class(pictures[unused.picture]), student.name, std::move(reason)});
    }
    for (std::size_t r = 0; r < matches.pictures.size(); ++r) {
      const int picture = matches.pictures[r];
      if (picture >= 0 && pictures[static_cast<std::size_t>(picture)].late) {
        student.notes[r].emplace_back("handed in late, as the name of the file says");
      }
    }
    student.of_references = std::move(matches.pictures);
    return static_cast<std::size_t>(std::count_if(student.of_references.begin(),
                                                  student.of_references.end(),
                                                  [](int picture) { return picture >= 0; }));
  }

  // Null if there is none.
  static const FoundFile* picture_of(const Student& student, std::size_t reference) {
    const int picture = student.of_references[reference];
    return picture < 0 ? nullptr : &student.pictures[static_cast<std::size_t>(picture)];
  }

  // The bytes of the pictures that are in archives, for each reference; of others, an error. The
  // archive of a class is read for several students at once: each time, all of it is read.
  std::vector<Result<std::string>> read_archived_of(std::size_t student) {
    constexpr std::size_t together = 16;
    const bool of_class = !class_archive_.empty();
    if (batch_.empty() || student < batch_start_ || student >= batch_start_ + batch_.size()) {
      batch_start_ = student;
      batch_.assign(of_class ? std::min(together, students_.size() - student) : 1,
                    std::vector<Result<std::string>>(references_.all.size(), Error{}));
      std::vector<FoundFile> files;
      std::vector<Result<std::string>*> places;
      for (std::size_t s = 0; s < batch_.size(); ++s) {
        for (std::size_t i = 0; i < references_.all.size(); ++i) {
          if (const FoundFile* const file = picture_of(students_[student + s], i);
              file != nullptr && !file->entries.empty()) {
            files.push_back(*file);
            places.push_back(&batch_[s][i]);
          }
        }
      }
      std::vector<Result<std::string>> read =
          read_archived(files, of_class ? class_archive_budget : ArchiveBudget());
      for (std::size_t i = 0; i < places.size(); ++i) {
        *places[i] = std::move(read[i]);
      }
    }
    return batch_[student - batch_start_];
  }

  // Below the folder of the class, with the names of archives.
  std::string path_in_class(const FoundFile& file) const {
    std::string path = file.path == class_archive_ ? "" : without_folder(file.path);
    for (const std::string& entry : file.entries) {
      path += (path.empty() ? "" : "/") + entry;
    }
    return path;
  }

  // The error if no picture of the class has a matching name: what was expected and what exists.
  std::string nothing_matches(std::size_t seen) const {
    if (seen == 0) {
      std::vector<IgnoredFile> files = ignored_;
      for (const Student& student : students_) {
        files.insert(files.end(), student.ignored.begin(), student.ignored.end());
      }
      return fmt::format("{} contains no pictures{}", quoted(request_.handed_in, 400),
                         files.empty() ? ""
                                       : fmt::format("; {}: {}", escaped(files.front().path),
                                                     escaped(files.front().reason)));
    }
    const auto with_one =
        std::find_if(students_.begin(), students_.end(),
                     [](const Student& student) { return !student.unmatched.empty(); });
    const std::string name = escaped(references_.all.front().name);
    return fmt::format(
        "no picture in {} has the name of a reference in {}: looked for {}.png, {}_gen.png, "
        "FOLDER_{}.png and so on, in all folders; found {}, for example. --map assigns other names",
        quoted(request_.handed_in, 400), quoted(request_.references, 400), name, name, name,
        quoted(with_one->unmatched.front(), 400));
  }

  // The text without the folder of the class, which is not for the reports of students.
  std::string without_folder(std::string text) const {
    if (text.starts_with(request_.handed_in)) {
      text.erase(0, request_.handed_in.size());
      text.erase(0, text.find_first_not_of('/'));
    }
    return text;
  }

  // `file`: null if there is no picture. `archived`: its bytes, if it is in an archive.
  PictureResult grade(ClassReference& reference, const FoundFile* file,
                      Result<std::string> archived,
                      const std::function<bool(double)>& go_on) const {
    PictureResult result;
    result.name = reference.name;
    if (file == nullptr) {
      result.verdict = Verdict::missing;
      result.reasons = {"there is no picture with that name"};
      return result;
    }
    // A link could point to the reference, or to another student's work.
    if (file->entries.empty() && is_link(file->path)) {
      result.verdict = Verdict::unreadable;
      result.reasons = {"a symbolic link was submitted, not a picture"};
      return result;
    }
    enter("reading a picture");
    const Result<std::string> bytes =
        file->entries.empty() ? read_file(file->path, Limits{}.file_bytes) : std::move(archived);
    if (!bytes) {
      result.verdict = Verdict::unreadable;
      result.reasons = {without_folder(bytes.error().text)};
      return result;
    }
    Hash hash;
    hash.add(*bytes);
    result.fingerprint = hash.value();
    Result<DecodedPicture> picture =
        decode_picture_file(*bytes, path_in_class(*file), request_.layer);
    if (!picture) {
      result.verdict = Verdict::unreadable;
      result.reasons = {picture.error().text};
      return result;
    }
    if (picture->transparent) {
      result.notes.emplace_back(transparent_text);
    }
    if (reference.path) {
      grade_path(reference, *picture, result, go_on);
      return result;
    }
    if (result.fingerprint == reference.fingerprint) {
      result.notes.emplace_back("this file is the reference, byte for byte");
    }
    DecodedPicture right = reference.picture;
    round_alike(right, *picture);
    const Texture& shown = picture->texture;
    if (const ClassReference* other = shown_instead(references_, reference, shown)) {
      result.verdict = Verdict::differs;
      result.measures = measure(right.texture, shown, settings_.pixel_threshold);
      result.reasons = {fmt::format("it is the picture of {}", other->name)};
      add_thumbnail(right.texture, shown, result);
      return result;
    }
    enter("comparing the pictures");
    if (reference.ways.empty() && reference.scene && reference.scene->usable() &&
        !reference.ways_to_try.empty()) {
      reference.ways =
          ways_drawn(reference.picture.texture, *reference.scene, reference.ways_to_try);
    }
    CompareSettings settings = settings_;
    settings.ways = reference.ways;
    settings.ways_fit = true;
    settings.lossy = picture->jpeg;
    const PictureComparison compared = compare_pictures(
        right, *picture, reference.scene ? &*reference.scene : nullptr, settings, go_on);
    result.measures = compared.measures;
    result.reasons = compared.broken;
    if (compared.right_at_other_size) {
      result.reasons.emplace_back("apart from its size, the picture is right");
    }
    result.causes = compared.causes.claims;
    result.rivals = compared.causes.rivals;
    result.partial = compared.causes.partial;
    for (const Claim& note : compared.causes.notes) {
      result.notes.push_back(no_mistake_text(note.what));
    }
    result.verdict = compared.broken.empty() ? Verdict::passed : Verdict::differs;
    if (by_causes_ && compared.measures.comparable && !compared.equal_in_8_bits) {
      follow_causes(compared, result);
    }
    if (picture->not_finite > 0) {
      result.notes.push_back(not_finite_text(*picture));
    }
    if (result.verdict == Verdict::differs && !compared.scene_fits() && result.causes.empty()) {
      result.reasons.push_back(
          fmt::format("our picture of the scene differs from the reference in {:.0f} % of the "
                      "pixels, so most mistakes cannot be named",
                      100 * compared.causes.share_scene_unlike));
    }
    if (result.verdict == Verdict::differs && settings.lossy) {
      result.reasons.emplace_back("it is a JPEG, which changes colors: a PNG is needed");
    }
    add_thumbnail(compared.reference_of(right.texture), compared.test_of(shown), result);
    return result;
  }

  // Without a result if `go_on` returns false.
  void grade_path(ClassReference& reference, const DecodedPicture& picture, PictureResult& result,
                  const std::function<bool(double)>& go_on) const {
    const RenderOptions& options = *reference.path;
    const Texture& shown = picture.texture;
    result.path_traced = true;
    result.measures.size = {shown.width, shown.height};
    result.measures.right_size = {options.width, options.height};
    result.verdict = Verdict::differs;
    if (!result.measures.same_size()) {
      result.reasons = {fmt::format("the size is {}x{}, expected {}x{}", shown.width, shown.height,
                                    options.width, options.height)};
      return;
    }
    if (!reference.truth) {
      enter("drawing the truth");
      PathTruth truth;
      const RenderStatus drawn =
          draw_truth(*reference.scene, options, request_.seconds, go_on, truth);
      if (const std::optional<Error> error = render_error(drawn)) {
        result.reasons = {error->text};
        return;
      }
      reference.truth = std::move(truth);
    }
    enter("comparing the pictures");
    PathVerdict verdict;
    const RenderStatus judged = judge_by_truth(*reference.scene, options, request_.seconds, go_on,
                                               picture, *reference.truth, verdict);
    if (const std::optional<Error> error = render_error(judged)) {
      result.reasons = {error->text};
      return;
    }
    set_result(verdict, result);
    if (picture.not_finite > 0) {
      result.notes.push_back(not_finite_text(picture));
    }
    if (request_.thumbnails) {
      add_thumbnail(truth_picture(*reference.truth), shown,
                    significance_picture(*reference.truth, verdict), result);
    }
  }

  void add_thumbnail(const Texture& reference, const Texture& picture,
                     PictureResult& result) const {
    if (request_.thumbnails) {
      add_thumbnail(reference, picture, heat_map(reference, picture), result);
    }
  }

  // Those of pictures that passed are smaller.
  void add_thumbnail(const Texture& reference, const Texture& picture, const Texture& map,
                     PictureResult& result) const {
    result.png =
        thumbnail(reference, picture, map,
                  result.verdict == Verdict::passed ? passed_thumbnail_width : thumbnail_width_);
  }

  const GradeRequest& request_;
  ClassReferences references_;
  CompareSettings settings_;
  bool by_causes_;  // the kind of difference decides, not only a threshold
  std::function<void(const char*)> entering_;
  std::vector<Student> students_;
  std::vector<IgnoredFile> ignored_;  // of unknown students
  std::vector<std::string> notes_;
  std::string class_archive_;  // its path; empty: the class is a folder
  // The bytes of pictures in archives, of some students and of each reference.
  std::size_t batch_start_ = 0;
  std::vector<std::vector<Result<std::string>>> batch_;
  int thumbnail_width_ = 320;
};

ClassGrader::ClassGrader(std::unique_ptr<State> state) : state_(std::move(state)) {}
ClassGrader::ClassGrader(ClassGrader&& other) noexcept = default;
ClassGrader::~ClassGrader() = default;

Result<ClassGrader> ClassGrader::open(const GradeRequest& request, const LoadShownScene& load_scene,
                                      const std::function<void(const char* phase)>& entering) {
  const bool archive = is_archive_name(request.handed_in) && stamp_of(request.handed_in).exists;
  if (!archive && !is_folder(request.handed_in)) {
    return Error{
        fmt::format("{} is not a readable folder or archive", quoted(request.handed_in, 400))};
  }
  for (const std::string& folder : {request.references, request.scenes}) {
    if (!folder.empty() && !is_folder(folder)) {
      return Error{fmt::format("{} is not a readable folder", quoted(folder, 400))};
    }
  }
  Result<ClassReferences> references = load_references(request, load_scene, entering);
  if (!references) {
    return references.error();
  }
  auto state = std::make_unique<State>(request, *std::move(references), entering);
  if (const Result<void> found = state->find_pictures(); !found) {
    return found.error();
  }
  return ClassGrader(std::move(state));
}

std::size_t ClassGrader::students() const {
  return state_->students();
}

const std::string& ClassGrader::student(std::size_t index) const {
  return state_->student(index);
}

std::size_t ClassGrader::pictures() const {
  return state_->pictures();
}

std::string ClassGrader::key_of(std::size_t student) {
  return state_->key_of(student);
}

Result<StudentResult> ClassGrader::grade(std::size_t student,
                                         const std::function<bool(double done)>& go_on) {
  return state_->run(student, go_on);
}

const std::vector<UsedFile>& ClassGrader::inputs() const {
  return state_->inputs();
}
const std::vector<std::string>& ClassGrader::notes() const {
  return state_->notes();
}

Gradebook ClassGrader::empty_book() const {
  return state_->empty_book();
}

Result<Gradebook> grade_class(const GradeRequest& request, const LoadShownScene& load_scene,
                              const std::function<bool(double)>& go_on,
                              const std::function<void(const char* phase)>& entering) {
  Result<ClassGrader> grader = ClassGrader::open(request, load_scene, entering);
  if (!grader) {
    return grader.error();
  }
  Gradebook book = grader->empty_book();
  for (std::size_t s = 0; s < grader->students(); ++s) {
    Result<StudentResult> student = grader->grade(s, [&](double done) {
      return !go_on ||
             go_on((static_cast<double>(s) + done) / static_cast<double>(grader->students()));
    });
    if (!student) {
      return student.error();
    }
    book.students.push_back(*std::move(student));
  }
  find_identical_files(book);
  return book;
}

}  // namespace scenefile
