// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/command.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <ostream>
#include <thread>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "core/files/text_file.h"
#include "experiments/runner/identity.h"

namespace cvo {

Command Group(CLI::App& app, std::vector<Command> commands) {
  app.require_subcommand(1);
  return {&app, [commands = std::move(commands)] {
            for (const Command& command : commands) {
              if (command.app->parsed()) return command.run();
            }
            return 0;
          }};
}

std::string FiniteProblem(const std::string& text) {
  const std::optional<double> number = ParseDouble(text);
  return number ? "" : StrCat("found '", text, "', expected a finite number");
}

CLI::Validator OneOf(std::vector<std::string> names) {
  return {[names = std::move(names)](const std::string& text) -> std::string {
            if (std::find(names.begin(), names.end(), text) != names.end()) return "";
            return StrCat("found ", Quoted(text), DidYouMean(text, names), ", expected one of ",
                          Joined(names, ", "));
          },
          ""};
}

void RefuseFlags(const CLI::App& app, const std::vector<std::string>& flags,
                 const std::string& why) {
  for (const std::string& flag : flags) {
    const CLI::Option* option = app.get_option_no_throw(flag);
    if (option != nullptr && option->count() > 0) throw UsageError(StrCat(flag, ": ", why));
  }
}

std::string VersionText() {
  const reports::BuildInfo& build = ThisBuild();
  return StrCat("clustervo ", build.version, "\nbuild      ", build.identity, "\nestimator  ",
                build.estimator_sources, "\nevaluation ", build.evaluation_sources, "\ncommit     ",
                build.commit, "\ncompiler   ", build.compiler, ", ", build.build_type, ", ",
                build.flags, "\nlibraries  OpenCV ", build.libraries.opencv, ", Eigen ",
                build.libraries.eigen, "\nCPU level  ", build.cpu_level);
}

void AddQuiet(CLI::App& app, bool& quiet) {
  app.add_flag("-q,--quiet", quiet, "do not print progress to stderr");
}

int DefaultThreads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

void AddThreads(CLI::App& app, int& threads) {
  threads = DefaultThreads();
  app.add_option(
         "--threads", threads,
         "total number of threads, which does not affect the results; default: number of CPUs")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
}

CLI::Option* AddSeed(CLI::App& app, std::optional<std::uint64_t>& seed, const char* meaning) {
  const auto parse = [&seed](const std::string& text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
      throw CLI::ValidationError("--seed",
                                 "found '" + text + "', expected an integer in [0, 2^64)");
    }
    seed = value;
  };
  return app.add_option_function<std::string>("--seed", parse, meaning)->type_name("N");
}

namespace {

// A global, because a signal handler can access nothing else.
volatile std::sig_atomic_t stop_requested = 0;

void NoteSignal(int) { stop_requested = 1; }

void Handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

void TextTable::Add(std::vector<std::string> row) {
  Require(row.size() == rows_.front().size(), "TextTable::Add: one cell per column");
  rows_.push_back(std::move(row));
}

std::vector<std::string> TextTable::Lines() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const std::vector<std::string>& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], Width(row[i]));
  }
  std::vector<std::string> lines;
  for (const std::vector<std::string>& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(widths[i] - Width(row[i]) + 2, ' ');
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

void TextTable::Print(std::ostream& out) const {
  for (const std::string& line : Lines()) out << line << '\n';
}

std::string ReadableNumber(double value) { return FormatGeneral(value, 4); }

std::string FrameRateText(double frames_per_s) {
  const std::string number = ReadableNumber(frames_per_s);
  return number + (number == "1" ? " frame/s" : " frames/s");
}

Progress::Progress(bool quiet, std::string unit)
    : unit_(std::move(unit)), quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (terminal_ && !quiet_) std::fputs("\r\033[K", stderr);
}

void Progress::Report(std::size_t done, std::size_t total, const std::string& stage) {
  if (quiet_) return;
  if (stage != stage_) {
    stage_ = stage;
    start_ = Clock::now();
    shown_tenths_ = 0;
    Note(stage);
  }
  const std::size_t tenths = 10 * done / total;
  if (!terminal_ && tenths == shown_tenths_) return;
  shown_tenths_ = tenths;
  std::fprintf(stderr, terminal_ ? "\r%3zu %%  %s\033[K" : "%3zu %%  %s\n", 100 * done / total,
               Text(done, total).c_str());
}

void Progress::Note(const std::string& line) const {
  std::fprintf(stderr, "%s%s\n", terminal_ ? "\r\033[K" : "", Printable(line).c_str());
}

std::function<void(std::size_t, std::size_t)> Progress::Reporter() {
  return [this](std::size_t done, std::size_t total) { Report(done, total); };
}

namespace {

// "48 s", "3:07 min".
std::string DurationText(double seconds) {
  const long whole = std::lround(std::ceil(seconds));
  if (whole < 60) return StrCat(whole, " s");
  return StrCat(whole / 60, whole % 60 < 10 ? ":0" : ":", whole % 60, " min");
}

}  // namespace

std::string Progress::Text(std::size_t done, std::size_t total) const {
  const std::string counts = StrCat(done, "/", total, " ", unit_);
  if (done == 0) return counts + "  time left not known yet";
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = static_cast<double>(done) / std::max(elapsed_s, 1e-9);
  const bool slow = rate < 1.0;
  return StrCat(counts, "  ", FormatFixed(slow ? 60.0 * rate : rate, 1), " ", unit_,
                slow ? "/min  " : "/s  ", DurationText(static_cast<double>(total - done) / rate),
                " left");
}

void PrintNotice(const std::string& line) {
  if (::isatty(STDERR_FILENO)) std::fputs("\r\033[K", stderr);
  std::cerr << "clustervo: " << line << '\n';
}

StopSignal::StopSignal() {
  stop_requested = 0;
  Handle(NoteSignal);
}

StopSignal::~StopSignal() { Handle(SIG_DFL); }

bool StopSignal::Requested() const { return stop_requested != 0; }

}  // namespace cvo
