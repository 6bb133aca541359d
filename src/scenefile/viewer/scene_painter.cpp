#include "scenefile/viewer/scene_painter.h"

#include "scenefile/io/parallel.h"
#include "scenefile/view/headless.h"

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

namespace scenefile::viewer {

struct ScenePainter::Impl {
  Impl(PaintContext the_context, std::function<void()> the_wake)
      : context(std::move(the_context)), wake(std::move(the_wake)) {}

  void work();
  void paint_jobs();
  Painted paint(const PaintJob& job);

  const PaintContext context;
  const std::function<void()> wake;
  std::string renderer;

  mutable std::mutex mutex;
  std::condition_variable changed;
  std::promise<std::string> started;  // why it failed; empty: it did not
  bool ended = false;
  std::array<std::optional<PaintJob>, 2> next;  // by Painting
  bool painting = false;
  bool refining = false;  // the current job
  std::atomic<bool> interrupted{false};
  std::array<std::optional<Painted>, 2> newest;

  // Only used by the thread.
  std::unique_ptr<GlDevice> device;
  std::optional<Drawing> drawing;
  std::uint64_t version = 0;  // of `drawing`
  std::vector<std::string> notes;

  std::thread thread;
};

namespace {

// Whether the current context is of Mesa's software renderer.
bool is_software(GetProcAddress find) {
  const Result<std::unique_ptr<GlDevice>> device = GlDevice::create(find);
  return device && (*device)->renderer().find("llvmpipe") != std::string::npos;
}

}  // namespace

PaintContext own_threads(const PaintContext& otherwise) {
  const auto headless = std::make_shared<std::unique_ptr<HeadlessContext>>();
  const auto begin = [otherwise, headless]() -> Result<GetProcAddress> {
    const Result<GetProcAddress> find = otherwise.begin();
    if (!find || !is_software(*find)) {
      return find;
    }
    otherwise.end();
    Result<std::unique_ptr<HeadlessContext>> own = HeadlessContext::create();
    if (!own) {
      return otherwise.begin();
    }
    *headless = *std::move(own);
    return (*headless)->get_proc_address();
  };
  const auto end = [otherwise, headless] {
    if (*headless != nullptr) {
      headless->reset();
    } else {
      otherwise.end();
    }
  };
  return {begin, end};
}

Painted ScenePainter::Impl::paint(const PaintJob& job) {
  Painted painted;
  try {
    painted.recipe = job.recipe;
    if (!drawing || version != job.recipe.version) {
      Diagnostics found;
      drawing.reset();
      drawing.emplace(
          upload(*device, job.scene->ready.scene, job.scene->assets, job.upload, found));
      version = job.recipe.version;
      notes.clear();
      for (const Diagnostic& finding : found.list()) {
        notes.push_back(finding.message);
      }
    }
    painted.notes = notes;
    // Looking for interruptions takes time, and coarse pictures are soon done.
    const bool long_work = job.refines || job.recipe.coarseness == 0;
    device->interrupt_with(long_work ? [this] { return !interrupted; } : std::function<bool()>());
    const auto start = std::chrono::steady_clock::now();
    const Result<Image> image = draw_image(*device, *drawing, job.recipe.camera, job.recipe.options,
                                           job.recipe.width, job.recipe.height, &painted.stats);
    if (image) {
      painted.picture = quantize(*image, Rounding::nearest);
    } else {
      painted.notes.push_back(image.error().text);
    }
    painted.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  } catch (const std::bad_alloc&) {
    painted.notes.emplace_back("there is not enough memory to draw the scene");
  }
  return painted;
}

void ScenePainter::Impl::paint_jobs() {
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [&] { return ended || next[0] || next[1]; });
    if (ended) {
      return;
    }
    const std::size_t which = next[0] ? 0 : 1;
    PaintJob job = *std::exchange(next[which], std::nullopt);
    painting = true;
    refining = job.refines;
    interrupted = false;
    lock.unlock();
    Painted painted = paint(job);
    lock.lock();
    painting = false;
    if (!interrupted) {
      newest[which] = std::move(painted);
    } else if (which == 1 && !next[1]) {
      next[1] = std::move(job);
    }
    changed.notify_all();
    lock.unlock();
    job = {};  // may free a large scene, without the lock
    wake();
    lock.lock();
  }
}

void ScenePainter::Impl::work() {
  lower_thread_priority();
  const Result<GetProcAddress> find = context.begin();
  Result<std::unique_ptr<GlDevice>> made =
      find ? GlDevice::create(*find) : Result<std::unique_ptr<GlDevice>>(find.error());
  const std::string failed = error_text(made);
  if (made) {
    device = *std::move(made);
    renderer = device->renderer();
  }
  started.set_value(failed);
  if (device != nullptr) {
    paint_jobs();
  }
  drawing.reset();
  device.reset();
  context.end();
}

ScenePainter::ScenePainter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<ScenePainter>> ScenePainter::create(PaintContext context,
                                                           std::function<void()> wake) {
  auto impl = std::make_unique<Impl>(std::move(context), std::move(wake));
  Impl& shared = *impl;
  try {
    impl->thread = std::thread([&shared] { shared.work(); });
  } catch (const std::system_error&) {
    return Error{"no thread can be started to draw the scene"};
  }
  std::unique_ptr<ScenePainter> painter(new ScenePainter(std::move(impl)));
  if (const std::string failed = shared.started.get_future().get(); !failed.empty()) {
    return Error{failed};
  }
  return painter;
}

ScenePainter::~ScenePainter() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->ended = true;
    impl_->interrupted = true;
  }
  impl_->changed.notify_all();
  impl_->thread.join();
}

const std::string& ScenePainter::renderer() const {
  return impl_->renderer;
}

void ScenePainter::ask(PaintJob job, Painting which) {
  const std::lock_guard lock(impl_->mutex);
  if (which == Painting::shown && impl_->painting && impl_->refining) {
    impl_->interrupted = true;
  }
  impl_->next[static_cast<std::size_t>(which)] = std::move(job);
  impl_->changed.notify_all();
}

std::optional<Painted> ScenePainter::take(Painting which, bool wait) {
  std::unique_lock lock(impl_->mutex);
  if (wait) {
    impl_->changed.wait(lock, [&] { return !impl_->painting && !impl_->next[0]; });
  }
  return std::exchange(impl_->newest[static_cast<std::size_t>(which)], std::nullopt);
}

bool ScenePainter::busy() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->painting || impl_->next[0] || impl_->next[1];
}

}  // namespace scenefile::viewer
