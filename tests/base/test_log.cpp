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
    log.beginStage("factor");
    log.line("line");
    log.detail("detail");
    log.endStage("factor");
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
    const Log log(stream, Verbosity::Normal, true, true, std::chrono::milliseconds(20));
    log.beginStage("factor");
    ASSERT_TRUE(terminal.waitFor("  factor ... 0 s"));
    log.line("done");
    log.endStage("factor");
  }
  const std::string all = terminal.text(), drawn = "\x1b[2m  factor ... 0 s\x1b[0m", erase = "\r\x1b[K";
  EXPECT_EQ(all.rfind(drawn, 0), 0u) << all;
  EXPECT_NE(all.find(erase + "done\n"), std::string::npos) << all;
  EXPECT_NE(all.substr(all.size() - drawn.size()), drawn) << "the last one is erased, too: " << all;
}

TEST(Log, ErasesTheLineWhenAStageEnds)
{
  Terminal terminal;
  std::ostream stream(&terminal);
  const Log log(stream, Verbosity::Normal, true, true, std::chrono::milliseconds(20));
  log.beginStage("factor");
  ASSERT_TRUE(terminal.waitFor("  factor ... 0 s"));
  log.endStage("factor");
  const std::string erase = "\r\x1b[K", all = terminal.text();
  EXPECT_EQ(all.substr(all.size() - erase.size()), erase);
}

TEST(Log, ShowsHowFarAStageIs)
{
  Terminal terminal;
  std::ostream stream(&terminal);
  const Log log(stream, Verbosity::Normal, true, false, std::chrono::milliseconds(20));
  log.tell(Depth::Level, {"level", 2});
  log.beginStage("couple");
  log.tell(Depth::Step, Progress::falling("sweep", 3, "eps_tau", 0.5, 0.1));
  EXPECT_TRUE(terminal.waitFor("  level 2, couple, sweep 3, eps_tau 0.5 (until 0.1) ... 0 s\n"));
}

TEST(Log, StaysSilentForEverWithoutPatience)
{
  Terminal pipe;
  std::ostream stream(&pipe);
  const Log log(stream, Verbosity::Normal, true, false, std::chrono::milliseconds(0));
  log.beginStage("factor");
  log.line("line");
  EXPECT_EQ(pipe.text(), "line\n");
}

TEST(Log, CanBeSilent)
{
  silentLog().line("nowhere");
  silentLog().beginStage("nowhere");
  silentLog().endStage("nowhere");
}

TEST(Log, SaysOnAPipeThatALongStageGoesOn)
{
  Terminal pipe;
  std::ostream stream(&pipe);
  {
    const Log log(stream, Verbosity::Normal, true, false, std::chrono::milliseconds(20));
    log.beginStage("factor");
    EXPECT_TRUE(pipe.waitFor("  factor ... 0 s\n  factor ... 0 s\n")) << "again and again";
    log.endStage("factor");
    log.line("line");
  }
  EXPECT_EQ(pipe.text().find('\x1b'), std::string::npos);
  EXPECT_EQ(pipe.text().substr(pipe.text().size() - 5), "line\n");
}
