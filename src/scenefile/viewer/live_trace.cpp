#include "scenefile/viewer/live_trace.h"

#include "scenefile/path/progressive.h"
#include "scenefile/path/tone.h"
#include "scenefile/trace/trace_scene.h"

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

// What mode path keeps between pictures.
struct KeptStructure {
  std::shared_ptr<const void> keep;
  Hidden hidden;
  std::optional<TraceScene> traced;
  double rate = 0;  // PathPasses::rate
};

}  // namespace

struct LiveTrace::Job : TraceRequest {
  explicit Job(TraceRequest request) : TraceRequest(std::move(request)) {}

  std::atomic<bool> begun{false};
  std::atomic<bool> cancelled{false};
  std::atomic<bool> discarded{false};  // then no picture is wanted
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

  void run(KeptStructure& kept);

 private:
  TracedPicture trace_rays(Clock::time_point start);
  TracedPicture trace_paths(Clock::time_point start, KeptStructure& kept);

  std::mutex mutex_;
  std::optional<TracedPicture> newest_;
};

TracedPicture LiveTrace::Job::trace_rays(Clock::time_point start) {
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
  RenderResult result = render(scene, *assets, options, std::move(control));
  TracedPicture last{quantize(result.image, rounding), 1, true, seconds_since(start),
                     failure_of(result.status)};
  last.linear = std::move(result.image);
  return last;
}

TracedPicture LiveTrace::Job::trace_paths(Clock::time_point start, KeptStructure& kept) {
  if (!kept.traced || kept.keep != keep || kept.hidden != hidden) {
    kept = {};
    kept.traced.emplace(scene, *assets, TraceSceneOptions{.threads = options.threads});
    kept.keep = keep;
    kept.hidden = hidden;
  }
  TracedPicture last;
  PathPasses passes;
  passes.noise = noise;
  passes.rate = kept.rate;
  passes.go_on = [&](bool first) { return !discarded && (first || !cancelled); };
  passes.show = [&](PathPass pass) {
    TracedPicture picture;
    if (pass.complete) {
      picture.linear = pass.image;
    }
    picture.picture =
        quantize(tone_mapped(std::move(pass.image), Tone::course, 0), Rounding::nearest);
    picture.seconds = seconds_since(start);
    picture.samples = static_cast<int>(pass.samples);
    picture.noise = pass.noise;
    if (pass.complete) {
      last = std::move(picture);
    } else if (!discarded) {
      put(std::move(picture));
    }
  };
  const RenderStatus status = render_progressively(*kept.traced, scene, options, passes);
  last.failed = failure_of(status);
  kept.rate = passes.rate;
  last.complete = true;
  return last;
}

void LiveTrace::Job::run(KeptStructure& kept) {
  begun = true;
  const Clock::time_point start = Clock::now();
  TracedPicture last;
  try {
    if (options.mode == Mode::path) {
      last = trace_paths(start, kept);
    } else {
      kept = {};
      last = trace_rays(start);
    }
  } catch (const std::bad_alloc&) {
    kept = {};
    last = {Texture(), 1, true, seconds_since(start), "out of memory while tracing"};
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
        job->run(kept_);
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable ready_;
  std::shared_ptr<Job> next_;
  bool ended_ = false;
  KeptStructure kept_;  // of the thread
  std::thread thread_;
};

LiveTrace::LiveTrace() : worker_(std::make_unique<Worker>()) {}

LiveTrace::~LiveTrace() {
  stop();
}

void LiveTrace::start(TraceRequest request) {
  if (job_ != nullptr) {
    job_->cancelled = true;
    if (job_->begun) {
      before_ = std::move(job_);
    }
  }
  job_ = std::make_shared<Job>(std::move(request));
  worker_->give(job_);
}

void LiveTrace::stop() {
  for (std::shared_ptr<Job>* const job : {&job_, &before_}) {
    if (*job != nullptr) {
      (*job)->cancelled = true;
      (*job)->discarded = true;
      job->reset();
    }
  }
}

bool LiveTrace::busy() const {
  return job_ != nullptr && !job_->over;
}

std::optional<TracedPicture> LiveTrace::take() {
  std::optional<TracedPicture> picture = job_ != nullptr ? job_->take() : std::nullopt;
  if (picture) {
    before_.reset();
  } else if (before_ != nullptr) {
    picture = before_->take();
  }
  return picture;
}

}  // namespace scenefile::viewer
