#include "scenefile/io/interrupt.h"

#include "io/temp_folder.h"
#include "scenefile/io/file.h"
#include "scenefile/io/temporary.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

using testing_support::TempFolder;

TEST(HandleSignals, EndsWithTheStatusOfTheSignal) {
  for (const auto& [signal, status] :
       {std::pair(SIGINT, 130), {SIGTERM, 143}, {SIGHUP, 143}, {SIGXCPU, 4}}) {
    EXPECT_EXIT(
        {
          handle_signals();
          std::raise(signal);
        },
        ::testing::ExitedWithCode(status), "");
  }
}

TEST(HandleSignals, TheTimeoutWorksIfTheParentBlockedItsSignal) {
  EXPECT_EXIT(
      {
        sigset_t alarm;
        sigemptyset(&alarm);
        sigaddset(&alarm, SIGALRM);
        ::sigprocmask(SIG_BLOCK, &alarm, nullptr);
        handle_signals();
        end_after(0.01, "too late");
        ::sleep(10);
      },
      ::testing::ExitedWithCode(4), "too late");
}

void allow_cpu_seconds(rlim_t seconds) {
  rlimit limit{};
  limit.rlim_cur = seconds;
  limit.rlim_max = seconds;
  ::setrlimit(RLIMIT_CPU, &limit);
}

TEST(HandleSignals, TheLimitOnCpuTimeIsReportedBeforeItKills) {
  EXPECT_EXIT(
      {
        allow_cpu_seconds(2);
        handle_signals();
        while (std::clock() >= 0) {
        }
      },
      ::testing::ExitedWithCode(4), "limit on CPU time");
}

using ThreeFiles = std::array<Temporary, 3>;  // EXPECT_EXIT takes no commas

// A temporary file that exists.
void begin(Temporary& temporary, const TempFolder& folder) {
  temporary.choose(folder.path());
  std::ofstream(temporary.path()) << "half";
}

TEST(HandleSignals, RemovesTemporaryFiles) {
  const TempFolder folder;
  folder.write("other");
  EXPECT_EXIT(
      {
        handle_signals();
        ThreeFiles halves;
        for (Temporary& half : halves) {
          begin(half, folder);
        }
        std::raise(SIGTERM);
      },
      ::testing::ExitedWithCode(143), "");
  EXPECT_EQ(folder.list(), std::vector<std::string>{"other"});
}

TEST(HandleSignals, LeavesAFinishedFile) {
  const TempFolder folder;
  EXPECT_EXIT(
      {
        handle_signals();
        ThreeFiles halves;
        begin(halves[0], folder);
        begin(halves[1], folder);
        begin(halves[2], folder);
        halves[1].keep();
        std::raise(SIGTERM);
      },
      ::testing::ExitedWithCode(143), "");
  EXPECT_EQ(folder.list().size(), 1U);
}

TEST(Temporary, IsRemovedUnlessKept) {
  const TempFolder folder;
  for (int i = 0; i < 200; ++i) {  // more than a signal finds at a time
    Temporary half;
    begin(half, folder);
  }
  EXPECT_TRUE(folder.list().empty());
  std::array<Temporary, 100> many;
  for (Temporary& half : many) {
    begin(half, folder);
  }
  EXPECT_EQ(folder.list().size(), 100U);
}

TEST(HandleSignals, KeepsIgnoredSignalsIgnored) {
  EXPECT_EXIT(
      {
        std::signal(SIGINT, SIG_IGN);
        handle_signals();
        std::raise(SIGINT);
        std::_Exit(0);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(EndAfter, EndsWithTheMessageAndRemovesTheTemporary) {
  const TempFolder folder;
  EXPECT_EXIT(
      {
        handle_signals();
        Temporary half;
        begin(half, folder);
        end_after(0.01, "too slow");
        while (true) {
        }
      },
      ::testing::ExitedWithCode(4), "^too slow\n$");
  EXPECT_TRUE(folder.list().empty());
}

TEST(DeferredSignals, TheFirstWaitsAndTheSecondEnds) {
  EXPECT_EXIT(
      {
        handle_signals();
        const DeferredSignals deferred;
        std::raise(SIGTERM);
        if (DeferredSignals::pending() != SIGTERM) {
          std::_Exit(1);
        }
        std::raise(SIGINT);
      },
      ::testing::ExitedWithCode(130), "");
}

TEST(DeferredSignals, NotForLongerThanASecond) {
  EXPECT_EXIT(
      {
        handle_signals();
        const DeferredSignals deferred;
        std::raise(SIGINT);
        while (true) {
        }
      },
      ::testing::ExitedWithCode(130), "");
}

TEST(DeferredSignals, OnlyWhileItLives) {
  EXPECT_EXIT(
      {
        handle_signals();
        { const DeferredSignals deferred; }
        std::raise(SIGINT);
      },
      ::testing::ExitedWithCode(130), "");
}

TEST(DeferredSignals, CanBeNested) {
  EXPECT_EXIT(
      {
        handle_signals();
        const DeferredSignals outer;
        { const DeferredSignals inner; }
        std::raise(SIGINT);
        std::_Exit(DeferredSignals::pending() == SIGINT ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

// The signal is sent as soon as the temporary file exists; if it comes too late, the write has
// succeeded.
TEST(DeferredSignals, AWriteIsFinishedAndReported) {
  const TempFolder folder;
  const std::string file = folder.path("output");
  const std::string bytes(std::size_t{8} << 20, 'x');
  const pid_t child = ::fork();
  if (child == 0) {
    handle_signals();
    ::_exit(write_file(file, bytes) ? 0 : 3);
  }
  const auto entries = [&] {
    return std::distance(std::filesystem::directory_iterator(folder.path(".")), {});
  };
  while (entries() == 0) {
  }
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(folder.read("output") == bytes);
  EXPECT_EQ(entries(), 1);
}

}  // namespace

}  // namespace scenefile
