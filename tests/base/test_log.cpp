#include <chrono>
#include <condition_variable>
#include <mutex>
#include <sstream>

#include <gtest/gtest.h>

#include "ndframe/base/log.hpp"

using namespace ndframe;

namespace
{

std::string written(Verbosity verbosity, bool speaks, bool terminal)
{
  std::ostringstream stream;
  {
    const Log log(stream, verbosity, speaks, terminal);
    log.startLive("factor");
    log.line("line");
    log.detail("detail");
    log.stopLive();
  }
  return stream.str();
}

/// A stream that can be waited for.
class Terminal : public std::streambuf
{
public:
  bool waitFor(const std::string& what)
  {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::minutes(1), [&] { return text_.find(what) != std::string::npos; });
  }
  std::string text() const { return text_; }

protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override
  {
    const std::lock_guard lock(mutex_);
    text_.append(text, static_cast<std::size_t>(size));
    changed_.notify_all();
    return size;
  }
  int overflow(int c) override
  {
    const char letter = static_cast<char>(c);
    xsputn(&letter, 1);
    return c;
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string text_;
};

} // namespace

TEST(Log, SaysWhatTheVerbosityAsksFor)
{
  EXPECT_EQ(written(Verbosity::Quiet, true, false), "");
  EXPECT_EQ(written(Verbosity::Normal, true, false), "line\n");
  EXPECT_EQ(written(Verbosity::Verbose, true, false), "line\ndetail\n");
}

TEST(Log, OfAnotherRankIsSilent)
{
  EXPECT_EQ(written(Verbosity::Verbose, false, true), "");
}

TEST(Log, DrawsNothingLiveForAShortStage)
{
  EXPECT_EQ(written(Verbosity::Normal, true, true), written(Verbosity::Normal, true, false));
}

TEST(Log, DrawsALongStageOnATerminalAndErasesItBeforeTheNextLine)
{
  Terminal terminal;
  std::ostream stream(&terminal);
  {
    const Log log(stream, Verbosity::Normal, true, true);
    log.startLive("factor");
    ASSERT_TRUE(terminal.waitFor("  factor ..."));
    log.line("done");
    log.stopLive();
  }
  EXPECT_EQ(terminal.text(), "  factor ...\r\x1b[Kdone\n");
}

TEST(Log, CanBeSilent)
{
  silentLog().line("nowhere");
  silentLog().startLive("nowhere");
  silentLog().stopLive();
}

TEST(Log, SaysOnAPipeThatALongStageGoesOn)
{
  Terminal pipe;
  std::ostream stream(&pipe);
  {
    const Log log(stream, Verbosity::Normal, true, false, std::chrono::milliseconds(20));
    log.startLive("factor");
    EXPECT_TRUE(pipe.waitFor("  factor ... 0 s\n  factor ... 0 s\n")) << "again and again";
    log.stopLive();
    log.line("line");
  }
  EXPECT_EQ(pipe.text().find('\x1b'), std::string::npos);
  EXPECT_EQ(pipe.text().substr(pipe.text().size() - 5), "line\n");
}
