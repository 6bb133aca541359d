#include "scenefile/viewer/live_trace.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

namespace scenefile::viewer {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string failure_of(RenderStatus status) {
  switch (status) {
    case RenderStatus::limit_reached:
      return "templates are nested deeper than can be traced";
    case RenderStatus::failed:
      return "out of memory while building the acceleration structure";
    case RenderStatus::complete:
    case RenderStatus::cancelled:
      break;
  }
  return {};
}

}  // namespace

/// One picture to trace.
struct LiveTrace::Job {
  RenderScene scene;
  std::shared_ptr<const void> keep;
  const Assets* assets = nullptr;
  RenderOptions options;
  std::function<void()> wake;

  std::atomic<bool> cancelled{false};
  std::atomic<bool> over{false};

  void put(TracedPicture picture) {
    {
      const std::lock_guard lock(mutex_);
      newest_ = std::move(picture);
    }
    wake();
  }
  std::optional<TracedPicture> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(newest_, std::nullopt);
  }

  void run();

 private:
  std::mutex mutex_;
  std::optional<TracedPicture> newest_;
};

void LiveTrace::Job::run() {
  const Clock::time_point start = Clock::now();
  const Rounding rounding = rounding_of(options.profile);
  double done = 0;
  RenderControl control;
  control.progress = [&](double share) {
    done = share;
    return !cancelled;
  };
  control.preview.interval_seconds = 0.15;
  control.preview.show = [&](const Image& image) {
    if (!cancelled) {
      put({quantize(image, rounding), done, false, seconds_since(start), {}});
    }
  };
  TracedPicture last;
  try {
    const RenderResult result = render(scene, *assets, options, std::move(control));
    last = {quantize(result.image, rounding), 1, true, seconds_since(start),
            failure_of(result.status)};
  } catch (const std::bad_alloc&) {
    last = {{}, 1, true, seconds_since(start), "out of memory while tracing"};
  }
  over = true;
  if (!cancelled) {
    put(std::move(last));
  }
}

/// Runs one job after another: a canceled job ends before the next begins, so that they do not
/// compete for processors.
class LiveTrace::Worker {
 public:
  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    ready_.notify_one();
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  void give(std::shared_ptr<Job> job) {
    {
      const std::lock_guard lock(mutex_);
      next_ = std::move(job);
    }
    if (!thread_.joinable()) {
      thread_ = std::thread([this] { work(); });
    }
    ready_.notify_one();
  }

 private:
  void work() {
    for (;;) {
      std::shared_ptr<Job> job;
      {
        std::unique_lock lock(mutex_);
        ready_.wait(lock, [&] { return ended_ || next_ != nullptr; });
        if (ended_) {
          return;
        }
        job = std::exchange(next_, nullptr);
      }
      if (!job->cancelled) {
        job->run();
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable ready_;
  std::shared_ptr<Job> next_;
  bool ended_ = false;
  std::thread thread_;
};

LiveTrace::LiveTrace() : worker_(std::make_unique<Worker>()) {}

LiveTrace::~LiveTrace() {
  stop();
}

void LiveTrace::start(RenderScene scene, std::shared_ptr<const void> keep, const Assets& assets,
                      const RenderOptions& options, std::function<void()> wake) {
  stop();
  job_ = std::make_shared<Job>();
  job_->scene = std::move(scene);
  job_->keep = std::move(keep);
  job_->assets = &assets;
  job_->options = options;
  job_->wake = std::move(wake);
  worker_->give(job_);
}

void LiveTrace::stop() {
  if (job_ != nullptr) {
    job_->cancelled = true;
    job_ = nullptr;
  }
}

bool LiveTrace::busy() const {
  return job_ != nullptr && !job_->over;
}

std::optional<TracedPicture> LiveTrace::take() {
  return job_ != nullptr ? job_->take() : std::nullopt;
}

}  // namespace scenefile::viewer
